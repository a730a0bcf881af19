//! All questions of the program, as each front end asks them.

use osim_model::messages::Input;
use osim_model::{
    CountedSpheres, Fault, ForcesOfAnimal, GravityFor, MissingFact, NoteDoubt, RadiusChangeReason,
    UnknownFactors,
};
use osim_requests::spell::{CommandLine, JsonRequest, Page, Python};

/// An example of each question.
fn example_of_every_question() -> Vec<MissingFact> {
    let name = |name: &str| name.to_owned();
    vec![
        MissingFact::BodyMass { body: name("toes_r") },
        MissingFact::ModelMass { bodies: 3, kg: 0.0 },
        MissingFact::MassOfLoop,
        MissingFact::AlreadyFollowed,
        MissingFact::ContactsMass {
            noted_kg: Some(62.0),
            doubt: NoteDoubt::ValuesChanged,
            input: Input::ContactsMass,
        },
        MissingFact::ContactsGravity { doubt: NoteDoubt::Partial },
        MissingFact::Selection {
            trees: vec![
                ForcesOfAnimal { top: name("pelvis"), forces: name("heel_r, heel_l") },
                ForcesOfAnimal { top: name("ball"), forces: name("ball_floor") },
            ],
            input: Input::Select,
        },
        MissingFact::SphereCount {
            of: CountedSpheres::Reference,
            why: "left and right cannot be determined".into(),
        },
        MissingFact::SharedSphere {
            sphere: name("/contactgeometryset/heel_r"),
            changed: name("heel_floor_r"),
            left: vec![name("heel_ball")],
            can_choose: true,
            radius: RadiusChangeReason::Rule,
        },
        MissingFact::ReferenceContact { reference: name("human.osim"), unmatched: vec![name("toe_r")] },
        MissingFact::ReferenceContactOfForce { force: name("/forceset/foot_r") },
        MissingFact::ReferenceRadius { reference: name("human.osim"), unmatched: vec![name("toe_r")] },
        MissingFact::BodyFactors { body: name("calcn_r"), axes: vec!["x", "y", "z"] },
        MissingFact::Factors(UnknownFactors::NoSource { body: name("toes_r") }),
        MissingFact::MovedSpheres { model: name("scaled.osim"), spheres: vec![name("heel_r")] },
        MissingFact::Repetition { operation: name("set stiffness=x2") },
        MissingFact::Geometry,
        MissingFact::ForceSet,
        MissingFact::Load,
        MissingFact::Gravity { purpose: GravityFor::Weight },
        MissingFact::HeightRatio,
        MissingFact::NotedSizes,
        MissingFact::KnownContactsMass {
            title: "Falisse et al. (2022)".to_owned(),
            made_for_kg: 62.0,
            bodies_kg: 20.0,
            input: Input::ReferenceMass,
        },
    ]
}

/// Examples of questions whose advice depends on what the user wanted to do.
fn questions_by_purpose() -> Vec<MissingFact> {
    let shared = |radius, can_choose| MissingFact::SharedSphere {
        sphere: "/contactgeometryset/heel_r".to_owned(),
        changed: "heel_floor_r".to_owned(),
        left: vec!["heel_ball".to_owned()],
        can_choose,
        radius,
    };
    use GravityFor::{Compared, Contacts, Figures, ImpactSpeed, Load, Reference, Target};
    [Load, ImpactSpeed, Contacts, Reference, Target, Compared, Figures]
        .into_iter()
        .map(|purpose| MissingFact::Gravity { purpose })
        .chain([
            shared(RadiusChangeReason::Rule, false),
            MissingFact::Factors(UnknownFactors::Meshes {
                body: "calcn_r".to_owned(),
                meshes: [("foot.vtp".to_owned(), [1.1; 3]), ("talus.vtp".to_owned(), [1.2, 1.1, 1.1])],
            }),
            MissingFact::Factors(UnknownFactors::Sides {
                bodies: ["calcn_r".to_owned(), "calcn_l".to_owned()],
                factors: [[1.09; 3], [1.26, 1.22, 1.43]],
            }),
            MissingFact::Factors(UnknownFactors::OtherReference {
                body: "calcn_r".to_owned(),
                joint: "mtp_r".to_owned(),
                apart_m: 0.0123,
            }),
            shared(RadiusChangeReason::Bodies, true),
            shared(RadiusChangeReason::ContactStiffness, true),
            shared(RadiusChangeReason::Assignment, true),
        ])
        .collect()
}

/// The number of variants of `MissingFact` in the source.
fn count_of_declared_questions() -> usize {
    let source = include_str!("../../../osim-model/src/model/fault/missing_fact.rs");
    let (_, after) = source.split_once("pub enum MissingFact {").unwrap();
    let (variants, _) = after.split_once("\n}").unwrap();
    let is_variant = |line: &&str| {
        line.strip_prefix("    ").is_some_and(|line| line.starts_with(|c: char| c.is_ascii_uppercase()))
    };
    variants.lines().filter(is_variant).count()
}

#[test]
fn every_question_is_asked_in_the_words_of_each_front_end() {
    let examples = example_of_every_question();
    assert_eq!(examples.len(), count_of_declared_questions(), "a question is missing, or there twice");
    let mut review = String::new();
    for fact in examples.into_iter().chain(questions_by_purpose()) {
        let phrase = fact.phrase();
        let (command, python, page) =
            (phrase.spelled(&CommandLine), phrase.spelled(&Python), phrase.spelled(&Page));
        let json = phrase.spelled(&JsonRequest);
        for text in [&command, &python, &page] {
            assert!(!text.trim().is_empty() && !text.contains('`'), "{text}");
        }
        for text in [&python, &page, &json] {
            assert!(!text.contains("--"), "{text}");
        }
        assert!(!command.contains("the field") && !python.contains("the field"), "{command}\n{python}");
        for input in fact.inputs() {
            let option = format!("--{}", input.name().replace('_', "-"));
            assert!(command.contains(&option), "{option}: {command}");
            assert!(page.contains(&format!("“{}”", input.label())), "{}: {page}", input.label());
            assert!(python.contains(&format!("{}=", input.name())), "{}: {python}", input.name());
            let field = [format!("\"{}\": ", input.name()), format!("`{}`", input.name())];
            assert!(field.iter().any(|field| json.contains(field)), "{}: {json}", input.name());
        }
        let code = Fault::new(fact).code();
        review.push_str(&format!(
            "[{code}]\ncommand: {command}\npython:  {python}\npage:    {page}\nrequest: {json}\n\n"
        ));
    }
    insta::assert_snapshot!("missing_facts", review);
}
