//! Tests of texts that OpenSim reads by its own rules. The results were observed in OpenSim 4.6; `tests/oracle/test_words.py` checks them
//! again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{Document, Model};

const ONE_FOOT: &str = include_str!("../data/one_foot.osim");
const STIFFNESS_ELEMENT: &str = "<stiffness>1000000</stiffness>";

fn foot_with(more: &str) -> String {
    assert!(ONE_FOOT.contains(STIFFNESS_ELEMENT));
    ONE_FOOT.replace(STIFFNESS_ELEMENT, &format!("{more}{STIFFNESS_ELEMENT}"))
}

#[track_caller]
fn assert_applies(text: &str, expected: bool) {
    assert_eq!(Model::parse(text).unwrap().forces()[0].applies, expected, "{text}");
}

#[test]
fn a_force_is_on_or_off_as_opensim_reads_the_flag() {
    for off in
        ["FALSE", "0.0", "00", "-0", "0abc", "<!-- x -->false<!-- y -->", "<![CDATA[ false]]>", "\u{b}false"]
    {
        assert_applies(&foot_with(&format!("<appliesForce>{off}</appliesForce>")), false);
    }
    for on in ["1abc", "yes", "", "\u{a0}false", "false&#32;", "false,"] {
        assert_applies(&foot_with(&format!("<appliesForce>{on}</appliesForce>")), true);
    }
}

#[test]
fn a_flag_with_a_comment_inside_is_refused_with_its_line() {
    let text = foot_with("<appliesForce>fa<!-- x -->lse</appliesForce>");
    let fault = Model::parse(text.as_str()).unwrap_err();
    assert_eq!(fault.code(), "broken-text", "{fault}");
    assert_eq!(fault.position.map(|place| place.line), Some(line_of(&text, "<appliesForce>")));
}

fn line_of(text: &str, part: &str) -> usize {
    text.lines().position(|line| line.contains(part)).unwrap() + 1
}

#[test]
fn in_old_documents_the_first_of_both_flags_counts() {
    let both = |first: &str, second: &str| foot_with(&format!("{first}{second}")).replace("40000", "30505");
    let (on, off) = ("<appliesForce>true</appliesForce>", "<appliesForce>false</appliesForce>");
    let disabled = |text: &str| format!("<isDisabled>{text}</isDisabled>");
    assert_applies(&both(on, &disabled("true")), true);
    assert_applies(&both(&disabled("true"), on), false);
    assert_applies(&both(&disabled("what"), off), true);
    assert_applies(&both(&disabled("2"), ""), false);
    assert_applies(&both(&disabled("true false"), ""), true);
}

#[test]
fn a_location_is_three_words() {
    let location = |text: &str| {
        let radius = "<radius>0.03</radius>";
        let text = ONE_FOOT.replace(radius, &format!("{radius}<location>{text}</location>"));
        Model::parse(text).map(|model| model.spheres()[0].location_m)
    };
    assert_eq!(location("0.1, 0.2\u{b}0.3").unwrap(), [0.1, 0.2, 0.3]);
    for default in ["0.1,0.2,0.3", "(0.1 0.2 0.3)", "0.1 0.2", "0.1\u{a0}0.2 0.3", "0.1 0.2 0.3&#32;"] {
        assert_eq!(location(default).unwrap(), [0.0; 3], "{default}");
    }
    assert_eq!(location("0.1 <!-- x --> 0.2 0.3").unwrap_err().code(), "broken-text");
}

#[test]
fn file_attributes_are_used_where_opensim_uses_them() {
    let included = |inside: &str| {
        let text = format!(
            "<OpenSimDocument Version='40000' file='x'><Model file='x'>{inside}</Model></OpenSimDocument>"
        );
        let document = Document::parse(text).unwrap();
        document.included_files().into_iter().map(|(_, file)| file).collect::<Vec<_>>()
    };
    assert_eq!(included("<ForceSet file='a.xml'/><ForceSet file='b.xml'/>"), ["a.xml"]);
    assert_eq!(included("<ForceSet/><ForceSet file='b.xml'/>"), [""; 0]);
    assert_eq!(included("<components><Body file=' c.xml'/></components>"), [" c.xml"]);
    for ignored in [
        "<ForceSet file=''/>",
        "<gravity file='x'/>",
        "<ForceSet><objects file='x'><HuntCrossleyForce file='x'><stiffness file='x'/></HuntCrossleyForce></objects></ForceSet>",
        "<BodySet><objects><Body file='x'><mass file='x'>1</mass></Body></objects><groups file='x'/></BodySet>",
        "<defaults file='x'><ContactSphere file='x'/></defaults>",
        "<components file='x'/><Unknown file='x'/>",
    ] {
        assert_eq!(included(ignored), [""; 0], "{ignored}");
    }
}

/// OpenSim 4.6 refuses each of these models ("is not a value element"), but reads a comment behind the text.
#[test]
fn a_path_or_a_place_with_something_inside_is_refused() {
    let whole = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
    for tag in ["socket_frame", "socket_sphere", "socket_half_space", "socket_parent_frame", "mass_center"] {
        let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
        let Some((before, rest)) = whole.split_once(&open) else { panic!("{tag}") };
        let (text, after) = rest.split_once(&close).unwrap();
        let (first, last) = text.split_at(text.len() - 1);
        for inside in ["<!-- c -->", "<?p x?>"] {
            let model = format!("{before}{open}{first}{inside}{last}{close}{after}");
            assert_eq!(Model::parse(model).unwrap_err().code(), "broken-text", "{tag} {inside}");
        }
        let model = format!("{before}{open}{text}<!-- c -->{close}{after}");
        assert!(Model::parse(model).is_ok(), "{tag}");
        // OpenSim reads the first of a name and no other.
        let twice = format!("{before}{open}{text}{close}{open}{first}<!-- c -->{last}{close}{after}");
        assert!(Model::parse(twice).is_ok(), "{tag}");
    }
}
