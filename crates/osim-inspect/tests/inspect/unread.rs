//! What OpenSim refuses or ignores is reported. What OpenSim makes of such models was seen in OpenSim 4.6, as the fixtures' table says.

use osim_inspect::model_findings;
use osim_model::{Finding, FindingCode, Model};

const TWO_FEET: &str = include_str!("../../../../fixtures/format/v40000.osim");
const CODES_OF_UNREAD_PARTS: [FindingCode; 7] = [
    FindingCode::ConnecteeByName,
    FindingCode::SocketNowhere,
    FindingCode::BodyWithoutJoint,
    FindingCode::OtherVersion,
    FindingCode::MisplacedObject,
    FindingCode::IgnoredContacts,
    FindingCode::UnknownName,
];

/// The findings in question about the model in which the first `old` is `new`.
#[track_caller]
fn findings(old: &str, new: &str) -> Vec<Finding> {
    assert!(TWO_FEET.contains(old), "{old}");
    let model = Model::parse(TWO_FEET.replacen(old, new, 1)).unwrap();
    model_findings(&model)
        .iter()
        .filter(|finding| CODES_OF_UNREAD_PARTS.contains(&finding.code()))
        .cloned()
        .collect()
}

#[test]
fn each_kind_is_reported_once_at_its_place() {
    let (hip, floor) = ("/jointset/hip_r", "<ContactHalfSpace name=\"floor\">");
    let sphere = "<ContactSphere name=\"ball\"><socket_frame>/bodyset/pelvis</socket_frame></ContactSphere>";
    let force = "<HuntCrossleyForce name=\"contact_r\">";
    let set = "<ForceSet name=\"forceset\">";
    let body = "<Body name=\"copy\"><mass>1</mass></Body><Body name=\"pelvis\">";
    for (old, new, code, place) in [
        (
            ">/bodyset/calcn_r</socket_child",
            ">calcn_r</socket_child",
            FindingCode::ConnecteeByName,
            Some(hip),
        ),
        (
            ">/bodyset/calcn_r</socket_child",
            ">/bodyset/talus_r</socket_child",
            FindingCode::SocketNowhere,
            Some(hip),
        ),
        (">/bodyset/calcn_r</socket_child", "></socket_child", FindingCode::SocketNowhere, Some(hip)),
        (
            "<socket_parent>/bodyset/pelvis<",
            "<socket_parent>pelvis<",
            FindingCode::ConnecteeByName,
            Some("/jointset/hip_r/pelvis_offset"),
        ),
        (
            "<socket_parent>/bodyset/pelvis</socket_parent>",
            "",
            FindingCode::SocketNowhere,
            Some("/jointset/hip_r/pelvis_offset"),
        ),
        (
            "<translation>0 -0.9 0.1</translation>",
            "<translaton>0 -0.9 0.1</translaton>",
            FindingCode::UnknownName,
            Some("/jointset/hip_r/pelvis_offset"),
        ),
        (
            "<JointSet name=\"jointset\">",
            "<JointSet name=\"jointset\"><components><PinJiont name=\"hip\"/></components>",
            FindingCode::UnknownName,
            Some("/jointset"),
        ),
        ("<Body name=\"pelvis\">", body, FindingCode::BodyWithoutJoint, Some("/bodyset/copy")),
        ("40000", "30000", FindingCode::OtherVersion, None),
        (force, &format!("{sphere}{force}"), FindingCode::MisplacedObject, Some("/forceset/ball")),
        (
            set,
            "<ForceSet><objects/></ForceSet><ForceSet name=\"forceset\">",
            FindingCode::IgnoredContacts,
            None,
        ),
        (
            "<groups />\n\t\t</ContactGeometrySet>",
            &format!("{sphere}</ContactGeometrySet>"),
            FindingCode::IgnoredContacts,
            None,
        ),
        (
            "<dissipation>2.25</dissipation>",
            "<Dissipation>2.25</Dissipation>",
            FindingCode::UnknownName,
            None,
        ),
        (
            floor,
            &format!("<ContactSpere name=\"ball\"/>{floor}"),
            FindingCode::UnknownName,
            Some("/contactgeometryset/ball"),
        ),
        (
            force,
            &format!("{force}<isDisabled>true</isDisabled>"),
            FindingCode::UnknownName,
            Some("/forceset/contact_r"),
        ),
    ] {
        let found = findings(old, new);
        let [finding] = &found[..] else { panic!("{new}: {found:?}") };
        assert_eq!(finding.code(), code, "{new}");
        if place.is_some() {
            assert_eq!(finding.place.as_deref(), place, "{new}");
        }
        assert!(finding.position.is_some(), "{new}");
    }
}

#[test]
fn one_finding_names_all_objects_of_a_class() {
    let bare = TWO_FEET.replace("<socket_frame>/bodyset/", "<socket_frame>");
    let model = Model::parse(bare).unwrap();
    let found: Vec<&Finding> =
        model_findings(&model).iter().filter(|one| one.code() == FindingCode::ConnecteeByName).collect();
    let [finding] = found[..] else { panic!("{found:?}") };
    assert_eq!((finding.details.len(), finding.place.as_deref()), (4, Some("/contactgeometryset/heel_r")));
    assert!(finding.message.to_string().ends_with("; 3 others of this class, too"), "{}", finding.message);
}

/// In OpenSim 4.6 an ellipsoid is then at 0 0 0, or the force has no value.
#[test]
fn places_of_ellipsoids_and_nan_of_spheres_are_errors() {
    let ellipsoid = include_str!("../../../../fixtures/shapes/ellipsoid.osim");
    for (text, old, new, code) in [
        (ellipsoid, "<location>0.01 -0.02 0.003<", "<location>0.01,-0.02,0.003<", FindingCode::OddNumber),
        (ellipsoid, "<orientation>0 0 0<", "<orientation>0 nan 0<", FindingCode::NotFinite),
        (
            TWO_FEET,
            "<orientation>0 0 0</orientation>\n\t\t\t\t\t<radius>",
            "<orientation>0 inf 0</orientation><radius>",
            FindingCode::NotFinite,
        ),
    ] {
        assert!(text.contains(old), "{old}");
        let model = Model::parse(text.replacen(old, new, 1)).unwrap();
        let found = model_findings(&model).iter().find(|one| one.code() == code);
        assert_eq!(found.and_then(|one| one.place.as_deref()), Some("/contactgeometryset/heel_r"), "{new}");
    }
}

#[test]
fn what_opensim_reads_is_not_reported() {
    let force = "<HuntCrossleyForce name=\"contact_r\">";
    for (old, new) in [
        (">/bodyset/calcn_r</socket_child", "> ../../bodyset/calcn_r </socket_child"),
        ("40000", "40600"),
        (force, &format!("{force}<isDisabled>false</isDisabled>")),
        (force, &format!("<CoordinateLimitForce name=\"limit\"/>{force}")),
        ("<ContactSphere name=\"heel_r\">", "<!-- <ContactSpere/> --><ContactSphere name=\"heel_r\">"),
        ("<dissipation>2.25</dissipation>", "<damping>1</damping><dissipation>2.25</dissipation>"),
    ] {
        assert_eq!(findings(old, new), [], "{new}");
    }
}

#[test]
fn exchanged_empty_and_misspelt_names_are_described() {
    let text = include_str!("../../../../fixtures/check/within_limits.osim");
    let (sphere, plane) = ("/contactgeometryset/heel_r<", "/contactgeometryset/floor<");
    let exchanged = text.replace(sphere, "@").replace(plane, sphere).replace('@', plane);
    let empty =
        text.replacen("<socket_frame>/bodyset/calcn_r</socket_frame>", "<socket_frame></socket_frame>", 1);
    let misspelt =
        text.replace("<ContactSphere ", "<ContactSpere ").replace("</ContactSphere>", "</ContactSpere>");
    for (text, words) in [
        (exchanged, "the sockets of sphere and half-space are exchanged"),
        (empty, "is empty"),
        (misspelt, "OpenSim does not read the ContactSpere that '/contactgeometryset/heel_r' names, in line"),
    ] {
        let fault = Model::parse(text).unwrap_err();
        assert_eq!(fault.code(), "unresolved");
        assert!(fault.to_string().contains(words), "{fault}");
    }
}

#[test]
fn an_element_that_names_a_body_takes_no_path() {
    let text = include_str!("../../../../fixtures/format/v30000.osim");
    let path = text.replace("<body_name>calcn_r<", "<body_name>/bodyset/calcn_r<");
    assert_ne!(path, text);
    let codes = |text: &str| -> Vec<FindingCode> {
        model_findings(&Model::parse(text).unwrap()).iter().map(Finding::code).collect()
    };
    assert!(codes(&path).contains(&FindingCode::ConnecteeByName));
    assert!(!codes(text).contains(&FindingCode::ConnecteeByName));
}
