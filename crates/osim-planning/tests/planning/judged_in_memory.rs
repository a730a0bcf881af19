//! A change of numbers is judged by a model in memory, which is not read from a file. The findings are those of the model in the file.

use std::collections::BTreeMap;
use std::path::Path;

use osim_inspect::series::ContactBody;
use osim_inspect::{
    ChangeableValues, FindingWithRemedy, InspectOptions, all_findings, check_model, model_findings,
};
use osim_model::files::{Files, OpenModel};
use osim_model::messages::Verb;
use osim_model::{
    FileId, Finding, FindingCode, Force, Model, Selection, Severity, Sphere, Value as Number, YesQuestion,
};
use osim_patch::Plan;
use osim_planning::scene::Scene;
use osim_planning::{PreparedChange, prepare};
use osim_requests::Request;
use serde_json::{Value, json};

use crate::add_and_remove::documents::{ChangedFiles, Document, all_files, models};

const MODEL: &str = "model.osim";

/// Requests that change only numbers of contacts: gentle changes, and changes that make a model wrong. `first` is the name of a force.
fn calls(first: &str) -> Vec<Value> {
    let rescale = |kg: f64| json!({"verb": "rescale", "target_mass": kg, "contacts_mass": 62});
    let with = |mut call: Value, fields: Value| {
        call.as_object_mut().unwrap().extend(fields.as_object().unwrap().clone());
        call
    };
    let set = |property: &str, value: Value| json!({"verb": "set", "set": {property: value}});
    vec![
        rescale(75.0),
        rescale(0.02),
        rescale(40_000.0),
        with(rescale(90.0), json!({"target_gravity": 1.62})),
        with(rescale(90.0), json!({"select": [first]})),
        with(rescale(90.0), json!({"mass": 90})),
        with(rescale(90.0), json!({"keep": ["radius"]})),
        with(rescale(90.0), json!({"no_note": true})),
        set("radius", json!("x0.5")),
        set("radius", json!("x3")),
        set("radius", json!(5.0)),
        with(set("radius", json!("x1.7")), json!({"select": [first]})),
        set("stiffness", json!("x0.001")),
        set("stiffness", json!("x1000")),
        with(set("stiffness", json!(3e6)), json!({"select": [first]})),
        set("dissipation", json!(9.0)),
        set("static_friction", json!(80.0)),
        set("transition_velocity", json!(3.0)),
        set("constant_contact_force", json!("x100")),
        set("hertz_smoothing", json!(2.0)),
        json!({"verb": "design", "indentation": 0.3, "restitution": 0.5, "impact_speed": 0.5, "spheres": 4, "mass": 70}),
        json!({"verb": "transfer", "from": "falisse2022"}),
        json!({"verb": "note", "contacts_mass": 61.5, "stance_limbs": 2}),
    ]
}

/// Numbers of comparisons: all plans, refused requests, plans that make a model worse, and models.
#[derive(Debug, Default)]
struct Compared {
    plans: usize,
    refused: usize,
    worse: usize,
    models: usize,
}

/// Each model gets every third request of the list; the next two models get the others.
const EVERY_THIRD_CALL: usize = 3;

#[test]
fn numbers_are_judged_as_in_the_file() {
    let files = all_files();
    let mut compared = Compared::default();
    for (number, document) in models(&files).into_iter().enumerate() {
        let files_with_changes = ChangedFiles { files: &files, own: BTreeMap::new() };
        // The same on what was written: it has a note.
        let Some(bytes) = try_some(&files_with_changes, &document.name, number, &mut compared) else {
            continue;
        };
        let files_with_changes = ChangedFiles { files: &files, own: BTreeMap::from([(MODEL.into(), bytes)]) };
        try_some(&files_with_changes, MODEL, number + 1, &mut compared);
    }
    let Compared { plans, refused, worse, models } = compared;
    assert!(plans > 2000 && refused > 0 && worse > 1000 && models > 2000, "{compared:?}");
}

#[test]
fn rules_find_the_same_without_what_only_people_read() {
    let files = all_files();
    let (mut compared, mut found, mut is_weak) = (0, 0, false);
    let weak = include_str!("../../../../fixtures/check/within_limits.osim");
    let weak = weak.replace("<hunt_crossley_smoothing>52<", "<hunt_crossley_smoothing>0.1<");
    let weak = Document { name: "weak_at_rest.osim".to_owned(), bytes: weak.into_bytes() };
    for document in models(&files).into_iter().chain([weak]) {
        let Ok(model) = Model::parse(document.bytes) else { continue };
        let mut options = InspectOptions::default();
        for kg in [None, Some(900.0)] {
            options.masses.model_kg = kg;
            let of = |inspected| {
                check_model(&options, &model, &inspected, &[], ChangeableValues::ASSUME_ALL).findings
            };
            let all = of(options.inspect(document.name.as_str(), &model, None));
            assert_eq!(
                of(options.inspect_for_rules(document.name.as_str(), &model)),
                all,
                "{}",
                document.name
            );
            if kg.is_none() {
                assert_each_is_found_alone(&options, &model, &document.name);
            }
            compared += 1;
            found += all.len();
            is_weak |= all.iter().any(|one| one.code() == FindingCode::WeakAtRest);
        }
    }
    assert!(compared > 400 && found > 1000 && is_weak, "{compared}, {found}, {is_weak}");
}

/// Each finding about a model is found where rules are applied for this finding alone.
fn assert_each_is_found_alone(options: &InspectOptions, model: &Model, name: &str) {
    let all = all_findings(options, model, &options.inspect_for_rules(name, model));
    for one in &all {
        let alone = options.inspect_to_compare(name, model, std::slice::from_ref(one));
        let alike = |findings: &[FindingWithRemedy]| -> Vec<_> {
            findings.iter().filter(|other| other.code() == one.code()).cloned().collect()
        };
        assert_eq!(alike(&all_findings(options, model, &alone)), alike(&all), "{name}");
    }
}

/// Tries every third request on the model `name`. Returns the bytes that one of the requests would write.
fn try_some(files: &ChangedFiles<'_>, name: &str, number: usize, compared: &mut Compared) -> Option<Vec<u8>> {
    let model = Model::parse(files.read(Path::new(name)).ok()?).ok()?;
    let first = model.forces().first().map_or("none", |force| force.name.as_str());
    let calls = calls(first).into_iter().skip(number % EVERY_THIRD_CALL).step_by(EVERY_THIRD_CALL);
    let yes: Vec<&str> = YesQuestion::ALL.iter().map(|question| question.as_str()).collect();
    let mut written = None;
    for mut call in calls {
        call["models"] = json!([name]);
        for yes in [&[], yes.as_slice()] {
            call["yes"] = json!(yes);
            let what = format!("{name}: {call}");
            let request = Request::from_json(call.to_string().as_bytes()).expect(&what);
            let Ok(change) = prepare(request, files) else { continue };
            let Ok(opened) = change.open(Path::new(name), files) else { continue };
            if let Some(plan) = compare_with_the_run(&change, &opened, files, compared, &what) {
                written = written.or_else(|| plan.patched(&opened.model, FileId::MAIN).ok());
                break;
            }
        }
    }
    written
}

fn compare_with_the_run(
    change: &PreparedChange,
    opened: &OpenModel,
    files: &dyn Files,
    compared: &mut Compared,
    what: &str,
) -> Option<Plan> {
    let in_memory = change.plan(opened, files);
    let by_file = change.plan_with_result(opened, files, Plan::changed_model);
    let (plan, changed) = match (in_memory, by_file) {
        (Ok(plan), Ok((by_file, changed))) => {
            assert_eq!(plan, by_file, "{what}");
            (plan, changed)
        }
        (Err(failure), Err(by_file)) => {
            assert_eq!(failure, by_file, "{what}");
            compared.refused += usize::from(failure.code == "wrong-afterwards");
            return None;
        }
        (plan, by_file) => panic!("{what}: {plan:?}, by the file {by_file:?}"),
    };
    compared.plans += 1;
    let is_worse = |one: &Finding| {
        one.severity >= Severity::Warning && one.message.to_string().starts_with("in the new model: ")
    };
    compared.worse += plan.findings.iter().filter(|one| is_worse(one)).count();
    if let Some(changed) = &changed {
        assert_same_findings(change, &plan, changed, what);
    }
    if let (Some(renumbered), Some(changed)) = (plan.with_contact_numbers(&opened.model), changed) {
        assert_eq!(seen_contacts(&renumbered), seen_contacts(&changed), "{what}");
        let pictures = |model| pictures(model, &change.options, opened);
        assert_eq!(pictures(&renumbered), pictures(&changed), "{what}");
        compared.models += 1;
    }
    Some(plan)
}

/// Asserts that the findings of the change are those of `check RESULT --mass M`.
fn assert_same_findings(change: &PreparedChange, plan: &Plan, changed: &Model, what: &str) {
    if plan.note().is_none() {
        // Only the run knows what the contacts are made for.
        return;
    }
    let mut options = change.options.clone();
    // Forces that were not chosen are judged, too.
    let all = Selection::default();
    options.selection = if all.apply(changed).is_ok() { all } else { options.selection };
    options.masses.contacts_mass_kg = None;
    options.stance.gravity_m_s2 = change.target_gravity_m_s2.or(options.stance.gravity_m_s2);
    if let Some(masses) = plan.masses.as_ref().filter(|_| change.verb == Verb::Rescale) {
        options.masses.model_kg = Some(masses.target_mass_kg);
    }
    let inspected = options.inspect(MODEL, changed, None);
    let found = check_model(&options, changed, &inspected, &[], ChangeableValues::ASSUME_ALL).findings;
    for one in &found {
        let said = plan
            .findings
            .iter()
            .any(|said| (said.code(), &said.place, said.severity) == (one.code(), &one.place, one.severity));
        assert!(said, "{what}: {} {}", one.code(), one.message);
    }
    for said in plan.findings.iter().filter(|said| said.had_before) {
        assert!(found.iter().any(|one| one.code() == said.code()), "{what}: {}", said.code());
    }
}

/// A text with everything that pictures show of a model.
fn pictures(model: &Model, options: &InspectOptions, opened: &OpenModel) -> String {
    let failed = |fault| opened.failure(fault);
    let body = ContactBody::from_inspected_model(String::new(), model, options, &failed);
    let curves = body.ok().map(|body| (body.kinds, body.weight.ok()));
    format!("{:?} {curves:?}", Scene::of(model, options))
}

/// A text with everything about the contacts of a model except their positions in the file.
fn seen_contacts(model: &Model) -> String {
    let number =
        |number: &Number| (number.property, number.number.to_bits(), number.origin, number.fault.clone());
    let sphere = |sphere: &Sphere| {
        let place = sphere.location_m.map(f64::to_bits);
        let mounted = (sphere.frame.clone(), sphere.body.clone(), sphere.fixed);
        (sphere.path.clone(), number(&sphere.radius), place, mounted)
    };
    let force = |force: &Force| {
        let values = force.sets.iter().flat_map(|set| &set.values).chain([&force.transition_velocity]);
        let sets: Vec<_> =
            force.sets.iter().map(|set| (set.number, set.spheres.clone(), set.inherited)).collect();
        (force.path.clone(), force.applies, sets, values.map(number).collect::<Vec<_>>())
    };
    let findings: Vec<Finding> =
        model_findings(model).iter().map(|one| one.clone().with_position(None)).collect();
    let spheres: Vec<_> = model.spheres().iter().map(sphere).collect();
    let forces: Vec<_> = model.forces().iter().map(force).collect();
    let of_note = (&model.note, model.doubt_about_note());
    format!("{spheres:?} {forces:?} {findings:?} {of_note:?} {:?}", model.gravity_m_s2)
}
