//! Findings about one model alone, in the order of the table of rules. What OpenSim makes of odd numbers was seen in OpenSim 4.6;
//! `tests/oracle/test_words.py` compares with OpenSim again.

use osim_inspect::model_findings;
use osim_model::{Companion, Document, FindingCode, Model, Severity};

const FOOT: &str = include_str!("../../../osim-model/tests/data/one_foot.osim");

/// The text of the model `file` in the folder `format/` of the fixtures.
#[track_caller]
fn fixture(file: &str) -> String {
    let path = format!("{}/../../fixtures/format/{file}.osim", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn codes_of(model: &Model) -> Vec<&'static str> {
    model_findings(model).iter().map(|finding| finding.code().as_str()).collect()
}

#[track_caller]
fn codes_of_fixture(file: &str) -> Vec<&'static str> {
    codes_of(&Model::parse(fixture(file)).unwrap())
}

#[test]
fn traps_are_named_with_their_codes() {
    for (file, code) in [
        ("dead_derivative_smoothing", "dead-derivative-smoothing"),
        ("left_out_stiffness", "default-stiffness"),
        ("shared_sphere", "sphere-in-two-forces"),
        ("one_force_for_all", "several-spheres-one-force"),
        ("unequal_stiffness", "left-right-differ"),
        ("unequal_radii", "left-right-close"),
        ("not_hertz", "not-hertz"),
        ("elastic_foundation", "not-hertz"),
        ("moco_sphere_in_force", "moco-dialect"),
        ("same_force_name_twice", "duplicate-names"),
        ("same_sphere_name_twice", "duplicate-names"),
        ("terrain_on_ground", "terrain"),
        ("terrain_welded", "terrain"),
    ] {
        let codes = codes_of_fixture(file);
        assert!(codes.contains(&code), "{file}: {codes:?}");
    }
    assert_eq!(codes_of_fixture("left_out_smoothing"), [""; 0]);
}

/// As the knees of OpenSim's dynamic_walker_example_model, of -1.75 to 0 rad and set to 0.03 rad: no angle in degrees.
#[test]
fn a_default_value_that_is_a_little_outside_its_range_is_a_remark() {
    let outside = include_str!("../../../../fixtures/check/default_outside_range.osim");
    for (value, clamped, severity) in [
        ("-1.2", "false", Severity::Remark),
        ("-1.21", "false", Severity::Warning),
        ("-1.2", "true", Severity::Error),
    ] {
        let value = format!("<clamped>{clamped}</clamped><default_value>{value}<");
        let model = Model::parse(outside.replacen("<default_value>-10<", &value, 1)).unwrap();
        let found = model_findings(&model);
        let found = found.iter().find(|one| one.code() == FindingCode::DefaultOutsideRange).unwrap();
        assert_eq!(found.severity, severity, "{value}");
    }
}

#[test]
fn a_body_that_cannot_be_is_outside_the_domain() {
    let human = include_str!("../../../../fixtures/check/known_contacts.osim");
    let far = "mass_center of /bodyset/pelvis is 150 m from a joint, expected at most 10 m";
    for (old, new, expected) in [
        ("<mass_center>0 0 0<", "<mass_center>0 150 0<", far),
        ("<mass>60<", "<mass>352125<", "mass of /bodyset/pelvis is 352125 kg, expected at most 100000 kg"),
        ("<inertia>1 1 1 ", "<inertia>1 -1 1 ", "inertia of /bodyset/pelvis is -1, expected 0 or more"),
    ] {
        let model = Model::parse(human.replacen(old, new, 1)).unwrap();
        let mut found = model_findings(&model).iter();
        let found = found.find(|finding| finding.code() == FindingCode::OutOfDomain).unwrap();
        assert_eq!(found.message.to_string(), expected);
    }
    // All that are in another unit are one cause, as angles are.
    for (tag, numbers, code) in [
        ("mass_center", ["0 150 0", "0 20 0"], FindingCode::OutOfDomain),
        ("orientation", ["0 0 90", "0 0 45"], FindingCode::AngleInDegrees),
    ] {
        let text = numbers.iter().fold(human.to_owned(), |text, new| {
            text.replacen(&format!("<{tag}>0 0 0<"), &format!("<{tag}>{new}<"), 1)
        });
        let model = Model::parse(text).unwrap();
        let odd: Vec<_> = model_findings(&model).iter().filter(|one| one.code() == code).collect();
        assert_eq!((odd.len(), odd[0].places.len()), (1, 2));
    }
    // A platform is no part of an animal.
    let platform = "<Body name=\"stand\"><mass>352125</mass></Body><Body name=\"pelvis\">";
    let weld = "<WeldJoint name=\"under\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>\
                /bodyset/stand</socket_child_frame></WeldJoint><FreeJoint name=\"ground_pelvis\">";
    let text = human.replacen("<Body name=\"pelvis\">", platform, 1);
    let model = Model::parse(text.replacen("<FreeJoint name=\"ground_pelvis\">", weld, 1)).unwrap();
    assert!(model_findings(&model).iter().all(|finding| finding.code() != FindingCode::OutOfDomain));
}

#[test]
fn a_constant_contact_force_of_zero_gives_a_finding() {
    let zero =
        FOOT.replace("<dissipation>", "<constant_contact_force>0</constant_contact_force><dissipation>");
    assert!(codes_of(&Model::parse(zero).unwrap()).contains(&"zero-constant-contact-force"));
}

#[test]
fn derivative_smoothing_is_alive_where_the_force_keeps_its_sphere() {
    let first = fixture("moco_sphere_in_force").replace("constant_contact_force>", "derivative_smoothing>");
    assert!(first.contains("<derivative_smoothing>"));
    assert!(!codes_of(&Model::parse(first).unwrap()).contains(&"dead-derivative-smoothing"));
}

/// Moco's example model has the number that OpenSim 4.6 takes by default.
#[test]
fn derivative_smoothing_is_a_remark_where_opensim_takes_its_number() {
    let text = fixture("dead_derivative_smoothing");
    let (own, default) = ("<constant_contact_force>1.5e-05<", "<constant_contact_force>1e-05<");
    assert!(text.contains(own) && text.contains("<derivative_smoothing>1e-05<"));
    let cases = [(text.clone(), Severity::Warning), (text.replace(own, default), Severity::Remark)];
    for (text, severity) in cases {
        let model = Model::parse(text).unwrap();
        let mut found = model_findings(&model).iter();
        let found = found.find(|finding| finding.code().as_str() == "dead-derivative-smoothing");
        assert_eq!(found.unwrap().severity, severity);
    }
}

#[test]
fn defaults_that_hold_contacts_are_named() {
    for file in ["defaults_smooth", "defaults_contact_parameters", "defaults_sphere_radius"] {
        assert!(codes_of_fixture(file).contains(&"contact-defaults"), "{file}");
    }
}

#[test]
fn a_set_in_a_file_beside_its_model_has_the_same_findings() {
    for file in ["v40000", "floor_of_its_own", "frame_on_body", "connectee_relative"] {
        let text = fixture(file);
        let alone = Model::parse(text.as_str()).unwrap();
        let (start, end) = (text.find("<ForceSet").unwrap(), text.find("</ForceSet>").unwrap());
        let set =
            format!("<OpenSimDocument Version=\"40000\">{}</ForceSet></OpenSimDocument>", &text[start..end]);
        // As geometry or as the model that it belongs to, and as both.
        for times in [1, 2] {
            let beside = Companion { document: Document::parse(text.as_str()).unwrap(), included_by: None };
            let read = Model::read_with(Document::parse(set.as_str()).unwrap(), vec![beside; times]).unwrap();
            assert_eq!(codes_of(&read), codes_of(&alone), "{file}, {times} times");
        }
    }
}

/// The findings about the numbers `text` in the place of a model's only sphere, or in its gravity if `tag` is gravity.
fn codes_and_messages(tag: &str, text: &str) -> Vec<(&'static str, String)> {
    let (radius, gravity) = ("<radius>0.03</radius>", "<gravity>0 -9.81 0</gravity>");
    let element = format!("<{tag}>{text}</{tag}>");
    let model = match tag {
        "gravity" => FOOT.replace(gravity, &element),
        _ => FOOT.replace(radius, &format!("{radius}{element}")),
    };
    let read = Model::parse(model.as_str()).unwrap();
    let odd = model_findings(&read)
        .iter()
        .filter(|finding| ["odd-number", "not-finite"].contains(&finding.code().as_str()));
    odd.map(|finding| {
        let before = &model[..model.find(&element).unwrap()];
        let at = finding.position.unwrap();
        let of_element = (before.lines().count(), before.lines().last().unwrap().len() + 1);
        assert_eq!((at.line, at.column), of_element);
        (finding.code().as_str(), finding.message.to_string())
    })
    .collect()
}

#[test]
fn a_location_or_gravity_that_opensim_misreads_is_reported() {
    for plain in ["0 -9.8 0", "1, 2, 3", "+1 .5 1e-3", " 1\u{b}2 3 "] {
        assert_eq!(
            (codes_and_messages("location", plain), codes_and_messages("gravity", plain)),
            (vec![], vec![]),
            "{plain}"
        );
    }
    // Of these OpenSim reads nothing, and takes its default.
    for text in ["0,-9.8,0", "(0 -9.8 0)", "0 -9.8", "0 1 2 3", "0\u{a0}1 2", "0 1 x", "", "0 1 2&#32;"] {
        let (location, gravity) = (codes_and_messages("location", text), codes_and_messages("gravity", text));
        assert_eq!((location.len(), gravity.len()), (1, 1), "{text}");
        assert_eq!((location[0].0, gravity[0].0), ("odd-number", "odd-number"), "{text}");
        assert!(location[0].1.ends_with("which OpenSim reads as 0 0 0"), "{}", location[0].1);
        assert!(gravity[0].1.ends_with("which OpenSim reads as 0 -9.80665 0"), "{}", gravity[0].1);
    }
    // Of these it reads something.
    for (text, read) in [("0,5 1 2", "0 1 2"), ("1x 2 3", "1 2 3"), ("1 2 3 4 5 6", "1 2 3")] {
        let said =
            format!("location of /contactgeometryset/heel_r is '{text}', which OpenSim reads as {read}");
        assert_eq!(codes_and_messages("location", text), [("odd-number", said)]);
        assert_eq!(codes_and_messages("gravity", text).len(), 1);
    }
    let said = "location of /contactgeometryset/heel_r is 1 NaN 3".to_owned();
    assert_eq!(codes_and_messages("location", "1 nan 3"), [("not-finite", said)]);
    assert_eq!(
        codes_and_messages("gravity", "0 -inf 0"),
        [("not-finite", "gravity of the model is 0 -inf 0".to_owned())]
    );
}

#[test]
fn an_odd_location_in_defaults_is_reported_for_each_sphere_without_a_location() {
    let defaults = |location: &str| {
        format!(
            "<Model name=\"one_foot\"><defaults><ContactSphere name=\"default\">\
             <location>{location}</location></ContactSphere></defaults>"
        )
    };
    let model = |location: &str, own: &str| {
        let text = FOOT.replace("<Model name=\"one_foot\">", &defaults(location));
        let text = text.replace("<radius>0.03</radius>", &format!("<radius>0.03</radius>{own}"));
        let odd = |model: &Model| {
            model_findings(model).iter().filter(|one| one.code().as_str() == "odd-number").count()
        };
        Model::parse(text).map(|model| (odd(&model), model.spheres()[0].location_m)).unwrap()
    };
    assert_eq!(model("7,8,9", ""), (1, [0.0; 3]));
    assert_eq!(model("7,8,9", "<location>1 2 3</location>"), (0, [1.0, 2.0, 3.0]));
    assert_eq!(model("7 8 9", "<location>1,2,3</location>"), (1, [7.0, 8.0, 9.0]));
}

#[test]
fn a_number_that_is_written_twice_is_reported_if_the_two_differ() {
    let found = |element: &str, second: &str| {
        let mut text = fixture("v40000");
        let end = text.find(element).unwrap() + element.len();
        text.insert_str(end, second);
        let twice = Model::parse(text).unwrap();
        let odd = model_findings(&twice).iter().filter(|one| one.code().as_str() == "odd-number");
        odd.map(|one| one.message.to_string()).collect::<Vec<_>>()
    };
    for (element, second, what) in [
        ("<radius>0.0325</radius>", "<radius>0.065</radius>", "radius of /contactgeometryset/heel_r"),
        ("<mass>50.25</mass>", "<mass>62</mass>", "mass of /bodyset/pelvis"),
        ("<gravity>0 -9.81 0</gravity>", "<gravity>0 -1.62 0</gravity>", "gravity of the model"),
        (
            "<dissipation>2.25</dissipation>",
            "<dissipation>2</dissipation>",
            "dissipation of /forceset/contact_r/contact_parameters",
        ),
    ] {
        assert_eq!(
            found(element, second),
            [format!("{what} is written twice, and OpenSim reads the first: take one of them out")]
        );
        assert_eq!(found(element, element), [""; 0]);
        assert_eq!(found(element, &element.replace("</", "e0</")), [""; 0]);
    }
}

#[test]
fn a_transition_velocity_without_a_number_is_also_found_in_the_older_class() {
    let older = include_str!("../../../../fixtures/table1/human_62kg_hunt_crossley.osim");
    let tag = "<transition_velocity>";
    let (before, rest) = older.split_once(tag).unwrap();
    let after = &rest[rest.find('<').unwrap()..];
    for (text, code) in [
        ("nan", "not-finite"),
        ("inf", "not-finite"),
        ("-1", "out-of-domain"),
        ("0.<!-- c -->17", "odd-number"),
        ("<x/>0.17", "odd-number"),
    ] {
        let model = Model::parse(format!("{before}{tag}{text}{after}")).unwrap();
        let found: Vec<_> = model_findings(&model).iter().map(|finding| finding.code().as_str()).collect();
        assert!(found.contains(&code), "{text}: {found:?}");
        assert!(code != "not-finite" || !found.contains(&"odd-transition-velocity"), "{text}: {found:?}");
    }
    let text = older.replace("dynamic_friction>0.80000000000000004<", "dynamic_friction>inf<");
    let codes = codes_of(&Model::parse(text).unwrap());
    assert!(codes.contains(&"not-finite"), "{codes:?}");
    assert!(!codes.iter().any(|code| ["large-friction", "dynamic-above-static"].contains(code)), "{codes:?}");
}

/// The codes and messages about odd texts in the fixture `v40000`, with `new` for the first text `old`.
fn odd_texts(old: &str, new: &str) -> Vec<(&'static str, String)> {
    let text = fixture("v40000");
    assert!(text.contains(old), "{old}");
    let read = Model::parse(text.replacen(old, new, 1)).unwrap();
    let codes = ["odd-number", "not-finite"];
    let odd = model_findings(&read).iter().filter(|finding| codes.contains(&finding.code().as_str()));
    odd.map(|finding| (finding.code().as_str(), finding.message.to_string())).collect()
}

#[test]
fn each_number_and_flag_on_which_a_pose_or_a_force_depends_is_compared_with_what_opensim_reads() {
    let frame = "/jointset/hip_r/pelvis_offset";
    let translation = "<translation>0 -0.9 0.1</translation>";
    let orientation = "<orientation>0 0 -1.5707963267948966</orientation>";
    let joint = "<PinJoint name=\"hip_r\">";
    let coordinate = |inside: &str| {
        format!("{joint}<coordinates><Coordinate name=\"angle\">{inside}</Coordinate></coordinates>")
    };
    let misread = [
        (
            translation,
            "<translation>0,-0.9,0.1</translation>",
            format!("translation of {frame} is '0,-0.9,0.1', which OpenSim reads as 0 0 0"),
        ),
        (
            translation,
            "<translation>0 \u{2212}0.9 0.1</translation>",
            format!("translation of {frame} is '0 \\u{{2212}}0.9 0.1', which OpenSim reads as 0 0 0"),
        ),
        (
            orientation,
            "<orientation>pi</orientation>",
            "orientation of /contactgeometryset/floor is 'pi', which OpenSim reads as 0 0 0".to_owned(),
        ),
        (
            "<inertia>1 1 1 0 0 0<",
            "<inertia>1 1 1<",
            "inertia of /bodyset/pelvis is '1 1 1', which OpenSim reads as 0 0 0 0 0 0".to_owned(),
        ),
        (
            "<mass_center>0 0 0<",
            "<mass_center>[0 0 0]<",
            "mass_center of /bodyset/pelvis is '[0 0 0]', which OpenSim reads as 0 0 0".to_owned(),
        ),
        (
            "<transition_velocity>",
            "<appliesForce>no</appliesForce><transition_velocity>",
            "appliesForce of /forceset/contact_r is 'no', which OpenSim reads as true".to_owned(),
        ),
        (
            joint,
            &coordinate("<default_value>0,1</default_value>"),
            "default_value of /jointset/hip_r/angle is '0,1', which OpenSim reads as 0".to_owned(),
        ),
        (
            joint,
            &coordinate("<range>0</range>"),
            "range of /jointset/hip_r/angle is '0', which OpenSim reads as -10 10".to_owned(),
        ),
        (
            joint,
            &coordinate("<locked>yes</locked>"),
            "locked of /jointset/hip_r/angle is 'yes', which OpenSim reads as false".to_owned(),
        ),
    ];
    for (old, new, message) in misread {
        assert_eq!(odd_texts(old, new), [("odd-number", message)], "{new}");
    }
    let not_finite = odd_texts(orientation, "<orientation>0 0 nan</orientation>");
    assert_eq!(
        not_finite,
        [("not-finite", "orientation of /contactgeometryset/floor is 0 0 NaN".to_owned())]
    );
    for (old, new) in [
        (translation, "<translation> 0\n-9.0e-1\t+0.1 </translation>".to_owned()),
        (translation, "<translation><!-- old -->0 -0.9 0.1</translation>".to_owned()),
        ("<transition_velocity>", "<appliesForce> True </appliesForce><transition_velocity>".to_owned()),
        ("<transition_velocity>", "<appliesForce>1</appliesForce><transition_velocity>".to_owned()),
        (joint, coordinate("<range>-inf inf</range><clamped>FALSE</clamped>")),
        // A sphere may be turned about its centre.
        (
            "<orientation>0 0 0</orientation>\n\t\t\t\t\t<radius>",
            "<orientation>0,0,0</orientation><radius>".to_owned(),
        ),
    ] {
        assert_eq!(odd_texts(old, &new), [], "{new}");
    }
}

#[test]
fn joints_of_old_documents_take_commas_and_brackets() {
    let text = fixture("v30000");
    let location = "<location_in_parent>";
    let (before, rest) = text.split_once(location).unwrap();
    let after = &rest[rest.find('<').unwrap()..];
    for (new, count) in [("0,1,0", 0), ("(0 1 0)", 0), ("0 1", 1), ("0,5 1 2", 1), ("0 nan 0", 1), ("", 1)] {
        let model = Model::parse(format!("{before}{location}{new}{after}")).unwrap();
        let odd: Vec<_> =
            model_findings(&model).iter().filter(|one| one.code().as_str() == "odd-number").collect();
        assert_eq!(odd.len(), count, "{new}: {odd:?}");
        assert!(
            odd.iter().all(|one| one.message.to_string().ends_with("with which OpenSim refuses the model")),
            "{odd:?}"
        );
    }
}

#[test]
fn faults_of_one_cause_are_one_finding_with_all_elements() {
    let text = fixture("../table1/human_62kg_smooth_sphere");
    let (good, bad) = ("<dissipation>2</dissipation>", "<dissipation>-2</dissipation>");
    let model = Model::parse(text.replace(good, bad)).unwrap();
    let [finding] = model_findings(&model) else { panic!("{:?}", codes_of(&model)) };
    let paths: Vec<String> = model.forces().iter().map(|force| force.path.clone()).collect();
    assert_eq!((finding.code().as_str(), &finding.places, paths.len()), ("out-of-domain", &paths, 12));
    assert!(finding.message.to_string().ends_with(" (and 11 more)"), "{}", finding.message);
    assert_eq!(
        finding.details[11],
        format!("dissipation of {} is -2, expected a finite number, 0 or more", paths[11])
    );
    // Another number is another cause.
    let others = text.replacen(good, bad, 2).replace(good, "<dissipation>-3</dissipation>");
    let others = Model::parse(others).unwrap();
    let out_of_domain = model_findings(&others).iter().filter(|one| one.code() == finding.code());
    assert_eq!(out_of_domain.map(|one| one.places.len()).collect::<Vec<_>>(), [2, 10]);
    // Places that are misread each have a text of their own, and one cause.
    let places = text.replace("<location>", "<location>~[").replace("</location>", "]</location>");
    let places = Model::parse(places).unwrap();
    let misread = model_findings(&places).iter().filter(|one| one.code().as_str() == "odd-number");
    assert_eq!(misread.map(|one| one.places.len()).collect::<Vec<_>>(), [13]);
}
