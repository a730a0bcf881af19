//! Texts that OpenSim reads in its own way. What it makes of each was seen in OpenSim 4.6; `tests/oracle/test_words.py` asks it again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{Document, Model};

const FOOT: &str = include_str!("../data/one_foot.osim");
const STIFFNESS: &str = "<stiffness>1000000</stiffness>";

fn with(more: &str) -> String {
    assert!(FOOT.contains(STIFFNESS));
    FOOT.replace(STIFFNESS, &format!("{more}{STIFFNESS}"))
}

#[track_caller]
fn applies(text: &str, expected: bool) {
    assert_eq!(Model::parse(text).unwrap().forces()[0].applies, expected, "{text}");
}

#[test]
fn a_force_is_on_or_off_as_opensim_reads_the_flag() {
    for off in
        ["FALSE", "0.0", "00", "-0", "0abc", "<!-- x -->false<!-- y -->", "<![CDATA[ false]]>", "\u{b}false"]
    {
        applies(&with(&format!("<appliesForce>{off}</appliesForce>")), false);
    }
    for on in ["1abc", "yes", "", "\u{a0}false", "false&#32;", "false,"] {
        applies(&with(&format!("<appliesForce>{on}</appliesForce>")), true);
    }
}

#[test]
fn a_flag_with_a_comment_inside_is_refused_where_it_is() {
    let text = with("<appliesForce>fa<!-- x -->lse</appliesForce>");
    let fault = Model::parse(text.as_str()).unwrap_err();
    assert_eq!(fault.code(), "broken-text", "{fault}");
    assert_eq!(fault.position.map(|place| place.line), Some(line_of(&text, "<appliesForce>")));
}

fn line_of(text: &str, part: &str) -> usize {
    text.lines().position(|line| line.contains(part)).unwrap() + 1
}

#[test]
fn of_both_flags_the_first_counts_in_old_documents() {
    let both = |first: &str, second: &str| with(&format!("{first}{second}")).replace("40000", "30505");
    let (on, off) = ("<appliesForce>true</appliesForce>", "<appliesForce>false</appliesForce>");
    let disabled = |text: &str| format!("<isDisabled>{text}</isDisabled>");
    applies(&both(on, &disabled("true")), true);
    applies(&both(&disabled("true"), on), false);
    applies(&both(&disabled("what"), off), true);
    applies(&both(&disabled("2"), ""), false);
    applies(&both(&disabled("true false"), ""), true);
}

#[test]
fn a_location_is_three_words() {
    let location = |text: &str| {
        let radius = "<radius>0.03</radius>";
        let text = FOOT.replace(radius, &format!("{radius}<location>{text}</location>"));
        Model::parse(text).map(|model| model.spheres()[0].location_m)
    };
    assert_eq!(location("0.1, 0.2\u{b}0.3").unwrap(), [0.1, 0.2, 0.3]);
    for default in ["0.1,0.2,0.3", "(0.1 0.2 0.3)", "0.1 0.2", "0.1\u{a0}0.2 0.3", "0.1 0.2 0.3&#32;"] {
        assert_eq!(location(default).unwrap(), [0.0; 3], "{default}");
    }
    assert_eq!(location("0.1 <!-- x --> 0.2 0.3").unwrap_err().code(), "broken-text");
}

/// The findings about numbers of the one sphere's location, or of gravity where `tag` is that.
fn found(tag: &str, text: &str) -> Vec<(&'static str, String)> {
    let (radius, gravity) = ("<radius>0.03</radius>", "<gravity>0 -9.81 0</gravity>");
    let element = format!("<{tag}>{text}</{tag}>");
    let model = match tag {
        "gravity" => FOOT.replace(gravity, &element),
        _ => FOOT.replace(radius, &format!("{radius}{element}")),
    };
    let findings = Model::parse(model.as_str()).unwrap().warnings;
    let odd = findings
        .into_iter()
        .filter(|finding| ["odd-number", "not-finite"].contains(&finding.code().as_str()));
    odd.map(|finding| {
        assert_eq!(finding.line, Some(line_of(&model, &element)));
        (finding.code().as_str(), finding.message.to_string())
    })
    .collect()
}

#[test]
fn a_location_or_gravity_that_opensim_reads_in_its_own_way_is_said() {
    for plain in ["0 -9.8 0", "1, 2, 3", "+1 .5 1e-3", " 1\u{b}2 3 "] {
        assert_eq!((found("location", plain), found("gravity", plain)), (vec![], vec![]), "{plain}");
    }
    // Of these OpenSim reads nothing, and takes its default.
    for text in ["0,-9.8,0", "(0 -9.8 0)", "0 -9.8", "0 1 2 3", "0\u{a0}1 2", "0 1 x", "", "0 1 2&#32;"] {
        let (location, gravity) = (found("location", text), found("gravity", text));
        assert_eq!((location.len(), gravity.len()), (1, 1), "{text}");
        assert_eq!((location[0].0, gravity[0].0), ("odd-number", "odd-number"), "{text}");
        assert!(location[0].1.ends_with("which OpenSim reads as 0 0 0"), "{}", location[0].1);
        assert!(gravity[0].1.ends_with("which OpenSim reads as 0 -9.80665 0"), "{}", gravity[0].1);
    }
    // Of these it reads something.
    for (text, read) in [("0,5 1 2", "0 1 2"), ("1x 2 3", "1 2 3"), ("1 2 3 4 5 6", "1 2 3")] {
        let said =
            format!("location of /contactgeometryset/heel_r is '{text}', which OpenSim reads as {read}");
        assert_eq!(found("location", text), [("odd-number", said)]);
        assert_eq!(found("gravity", text).len(), 1);
    }
    let said = "location of /contactgeometryset/heel_r is 1 NaN 3".to_owned();
    assert_eq!(found("location", "1 nan 3"), [("not-finite", said)]);
    assert_eq!(found("gravity", "0 -inf 0"), [("not-finite", "gravity of the model is 0 -inf 0".to_owned())]);
}

#[test]
fn an_odd_location_of_defaults_is_that_of_each_sphere_without_its_own() {
    let defaults = |location: &str| {
        format!(
            "<Model name=\"one_foot\"><defaults><ContactSphere name=\"default\">\
             <location>{location}</location></ContactSphere></defaults>"
        )
    };
    let model = |location: &str, own: &str| {
        let text = FOOT.replace("<Model name=\"one_foot\">", &defaults(location));
        let text = text.replace("<radius>0.03</radius>", &format!("<radius>0.03</radius>{own}"));
        let odd =
            |model: &Model| model.warnings.iter().filter(|one| one.code().as_str() == "odd-number").count();
        Model::parse(text).map(|model| (odd(&model), model.spheres()[0].location_m)).unwrap()
    };
    assert_eq!(model("7,8,9", ""), (1, [0.0; 3]));
    assert_eq!(model("7,8,9", "<location>1 2 3</location>"), (0, [1.0, 2.0, 3.0]));
    assert_eq!(model("7 8 9", "<location>1,2,3</location>"), (1, [7.0, 8.0, 9.0]));
}

#[test]
fn a_file_is_heeded_where_opensim_heeds_it() {
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

/// OpenSim 4.6 refuses each of these models ("is not a value element"), and reads a comment behind the text.
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

#[test]
fn a_transition_velocity_that_is_no_number_is_found_in_the_older_class_too() {
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
        let found: Vec<_> = model.warnings.iter().map(|finding| finding.code().as_str()).collect();
        assert!(found.contains(&code), "{text}: {found:?}");
    }
}
