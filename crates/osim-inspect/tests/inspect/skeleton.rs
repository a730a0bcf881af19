//! Spheres of feet on ground, scenery beside them, and the cause of bones that are not mirror images.

use osim_inspect::model_findings;
use osim_model::{Finding, FindingCode, Model, Severity};

const HUMAN: &str = include_str!("../../../../fixtures/check/known_contacts.osim");

fn findings_of_text(text: &str) -> Vec<Finding> {
    model_findings(&Model::parse(text).unwrap()).to_vec()
}

/// The model with the spheres `names` on `frame`.
fn with_spheres_on(frame: &str, names: &[&str]) -> String {
    names.iter().fold(HUMAN.to_owned(), |text, name| {
        let start = text.find(&format!("<ContactSphere name=\"{name}\">")).unwrap();
        let (before, sphere) = text.split_at(start);
        let body = sphere.split("<socket_frame>").nth(1).unwrap().split('<').next().unwrap();
        format!("{before}{}", sphere.replacen(body, frame, 1))
    })
}

/// The spheres of feet on ground in `text`, in which the sphere s1_r is called `name`.
fn found_if_called(text: &str, name: &str) -> Vec<String> {
    let text = text.replace("\"s1_r\"", &format!("\"{name}\"")).replace("/s1_r<", &format!("/{name}<"));
    let found = findings_of_text(&text).into_iter().find(|one| one.code() == FindingCode::FootSphereOnGround);
    found.map(|found| found.spheres).unwrap_or_default()
}

#[test]
fn spheres_of_feet_on_ground_are_found_with_any_name() {
    let all =
        ["s1_r", "s2_r", "s3_r", "s4_r", "s5_r", "s6_r", "s1_l", "s2_l", "s3_l", "s4_l", "s5_l", "s6_l"];
    for names in [&all[..1], &["s1_r", "s1_l"], &all] {
        assert_eq!(found_if_called(&with_spheres_on("/ground", names), "s1_r"), names);
    }
    let one = with_spheres_on("/ground", &["s1_r"]);
    for name in ["heel", "RightHeel"] {
        assert_eq!(found_if_called(&one, name), [name]);
    }
    assert_eq!(found_if_called(&with_spheres_on("/ground", &all), "c"), [&["c"], &all[1..]].concat());
    for name in ["kerb", "floor_marker_r", "foot_plate_l", "stepping_stone_r"] {
        assert!(found_if_called(&one, name).is_empty(), "{name}");
    }
}

/// In a planar model both legs are joined to one place, in the middle of the pelvis.
#[test]
fn legs_that_are_joined_to_one_place_beside_the_middle_are_found() {
    let (left, right) = ("<translation>0 -0.9 -0.1<", "<translation>0 -0.9 0.1<");
    for (left_at, right_at, is_copied) in
        [("0.05 -0.9 0.1", "0.05 -0.9 0.1", true), ("0.05 -0.9 0", "0.05 -0.9 0", false)]
    {
        let text = HUMAN.replace(left, &format!("<translation>{left_at}<"));
        let found = findings_of_text(&text.replace(right, &format!("<translation>{right_at}<")));
        let found = found.into_iter().find(|one| one.code() == FindingCode::LeftRightBones);
        let expected = is_copied.then_some("calcn_l and calcn_r are joined to the same place of pelvis");
        assert_eq!(found.map(|found| found.message.to_string()).as_deref(), expected);
    }
}

#[test]
fn spheres_of_feet_on_a_body_that_is_welded_to_ground_are_found() {
    let body = "<Body name=\"stand\"><mass>0</mass></Body><Body name=\"pelvis\">";
    let joint = "<JointSet name=\"jointset\">\n<objects><WeldJoint name=\"stand\"><socket_parent_frame>/ground</socket_parent_frame>\
                 <socket_child_frame>/bodyset/stand</socket_child_frame></WeldJoint>";
    let text = with_spheres_on("/bodyset/stand", &["s1_r"]).replacen("<Body name=\"pelvis\">", body, 1);
    let (before, joints) = text.split_once("<JointSet name=\"jointset\">").unwrap();
    let text = format!("{before}{joint}{}", joints.split_once("<objects>").unwrap().1);
    let found = findings_of_text(&text)
        .into_iter()
        .find(|one| one.code() == FindingCode::FootSphereOnGround)
        .unwrap();
    assert_eq!(
        found.message.to_string(),
        "s1_r belongs to a foot, and is on stand, which is welded to ground"
    );
}

#[test]
fn a_leg_on_another_part_of_the_trunk_than_the_other_leg_is_odd() {
    let torso = "<Body name=\"torso\"><mass>1</mass></Body><Body name=\"pelvis\">";
    let back = "<PinJoint name=\"back\"><socket_parent_frame>/bodyset/pelvis</socket_parent_frame>\
                <socket_child_frame>/bodyset/torso</socket_child_frame></PinJoint><PinJoint name=\"leg_r\">";
    let text = HUMAN.replacen("<Body name=\"pelvis\">", torso, 1);
    let text = text.replacen("<PinJoint name=\"leg_r\">", back, 1);
    let odd_parents = |text: &str| -> Vec<Option<String>> {
        let odd = findings_of_text(text).into_iter().filter(|one| one.code() == FindingCode::OddParent);
        odd.map(|one| one.place).collect()
    };
    assert!(odd_parents(&text).is_empty());
    let on_torso = text.replacen("<socket_parent>/bodyset/pelvis<", "<socket_parent>/bodyset/torso<", 1);
    assert_eq!(odd_parents(&on_torso), [Some("/jointset/leg_r".to_owned())]);
    // The ends of a joint were exchanged: OpenSim hangs the toes on ground.
    let ends = [">calcn_r_offset<", ">/bodyset/toes_r</socket_child_frame"];
    let exchanged = HUMAN.replacen(ends[0], ">/bodyset/toes_r<", 1);
    let exchanged = exchanged.replacen(ends[1], ">calcn_r_offset</socket_child_frame", 1);
    assert_eq!(odd_parents(&exchanged), [Some("/jointset/mtp_r".to_owned())]);
    // A foot is the root of the whole model: OpenSim joins it to ground by a FreeJoint.
    let (before, after) = HUMAN.split_once("<FreeJoint").unwrap();
    let (joints, leg) = after.split_once("</FreeJoint>").unwrap().1.split_once("\"leg_l\">").unwrap();
    let leg = leg.replacen(">pelvis_offset<", ">/bodyset/calcn_l<", 1);
    let leg = leg.replacen(">/bodyset/calcn_l</socket_child_frame", ">pelvis_offset</socket_child_frame", 1);
    assert!(odd_parents(&format!("{before}{joints}\"leg_l\">{leg}")).is_empty());
}

#[test]
fn a_joint_whose_place_cannot_be_read_has_one_finding() {
    let [place, unreadable] = ["0.16341 -0.00183 -0.00099", "0.16341,-0.00183,-0.00099"];
    let (before, after) = HUMAN.rsplit_once(place).unwrap();
    let codes = |place: &str| -> Vec<FindingCode> {
        findings_of_text(&format!("{before}{place}{after}")).iter().map(Finding::code).collect()
    };
    assert!(codes("0 0 0").contains(&FindingCode::LeftRightBones));
    let found = codes(unreadable);
    assert!(
        found.contains(&FindingCode::OddNumber) && !found.contains(&FindingCode::LeftRightBones),
        "{found:?}"
    );
}

#[test]
fn a_bone_that_is_far_from_its_own_joint_is_unlike_its_counterpart() {
    let frame = "<PhysicalOffsetFrame name=\"calcn_l_offset\">";
    let far = "<PhysicalOffsetFrame name=\"far\"><socket_parent>/bodyset/toes_l</socket_parent><translation>0 0.4 0</translation></PhysicalOffsetFrame>";
    let text = HUMAN.replacen(">/bodyset/toes_l</socket_child_frame>", ">far</socket_child_frame>", 1);
    let text = text.replacen(frame, &format!("{far}{frame}"), 1);
    let is_found =
        |text: &str| findings_of_text(text).iter().any(|one| one.code() == FindingCode::LeftRightBones);
    assert!(is_found(&text));
    // With its centre of mass there, too, only the origin of the body is elsewhere.
    let (before, toes) = text.split_once("<Body name=\"toes_l\">").unwrap();
    let toes = toes.replacen("<mass_center>0 0 0<", "<mass_center>0 0.4 0<", 1);
    assert!(!is_found(&format!("{before}<Body name=\"toes_l\">{toes}")));
}

/// As in OpenSim's Jumper: the Scale Tool scales the function of such a constraint, and leaves the default value.
#[test]
fn a_constraint_sets_the_place_of_a_joint() {
    let slider = HUMAN.replacen("<PinJoint name=\"leg_r\">", "<SliderJoint name=\"leg_r\">", 1);
    let slider = slider.replacen("</PinJoint>", "</SliderJoint>", 1);
    let text = [("leg_r", "0.5"), ("mtp_r", "0")].into_iter().fold(slider, |text, (joint, value)| {
        let (before, after) = text.split_once(&format!(" name=\"{joint}\">")).unwrap();
        let own = format!(
            "<coordinates><Coordinate name=\"q_{joint}\"><default_value>{value}</default_value></Coordinate></coordinates><frames>"
        );
        format!("{before} name=\"{joint}\">{}", after.replacen("<frames>", &own, 1))
    });
    let coupled = "<ConstraintSet><objects><CoordinateCouplerConstraint><coupled_coordinates_function><LinearFunction><coefficients>1 0\
                   </coefficients></LinearFunction></coupled_coordinates_function><independent_coordinate_names>q_mtp_r\
                   </independent_coordinate_names><dependent_coordinate_name>q_leg_r</dependent_coordinate_name>\
                   </CoordinateCouplerConstraint></objects></ConstraintSet><ForceSet";
    let coupled = text.replacen("<ForceSet", coupled, 1);
    let is_found =
        |text: &str| findings_of_text(text).iter().any(|one| one.code() == FindingCode::LeftRightBones);
    assert!(is_found(&text) && !is_found(&coupled));
}

/// As in OpenSim's ArmCurlingFullBody.osim, whose right arm hangs on the thorax without a scapula.
#[test]
fn arms_on_which_nothing_stands_may_be_unlike() {
    let joint = |name: &str, parent: &str, place: &str| {
        format!(
            "<PinJoint name=\"{name}\"><socket_parent_frame>place</socket_parent_frame><socket_child_frame>/bodyset/{name}</socket_child_frame>\
             <frames><PhysicalOffsetFrame name=\"place\"><socket_parent>/bodyset/{parent}</socket_parent><translation>{place}</translation>\
             </PhysicalOffsetFrame></frames></PinJoint>"
        )
    };
    for (upper, lower, right_at, is_found) in [
        ("humerus", "hand", "0 0.5 0.2", false),
        ("humerus", "hand", "0.7 0.1 -0.1", false),
        ("shank", "foot", "0 0.5 0.2", true),
        ("shank", "foot", "0.7 0.1 -0.1", true),
    ] {
        let (mut bodies, mut joints) = (String::new(), String::new());
        for (side, place) in [("r", right_at), ("l", "0.7 0.1 -0.1")] {
            let [above, below] = [upper, lower].map(|part| format!("{part}_{side}"));
            for name in [&above, &below] {
                bodies += &format!("<Body name=\"{name}\"><mass>1</mass></Body>");
            }
            joints += &joint(&above, "pelvis", place);
            joints += &joint(&below, &above, "0 -0.3 0");
        }
        let text = ["<Body name=\"pelvis\">", "<PinJoint name=\"leg_r\">"].into_iter().zip([bodies, joints]);
        let text = text.fold(HUMAN.to_owned(), |text, (at, new)| text.replacen(at, &format!("{new}{at}"), 1));
        let found = findings_of_text(&text);
        assert_eq!(found.iter().any(|one| one.code() == FindingCode::LeftRightBones), is_found, "{upper}");
    }
}

#[test]
fn spheres_with_names_as_on_feet_are_found_on_the_pelvis() {
    let names = ["s1_r", "s3_r", "s1_l", "s3_l"];
    let found = |text: &str| {
        let is_severe = |one: &Finding| one.severity > Severity::Remark;
        let is_it = |one: &Finding| one.code() == FindingCode::SpheresMisplaced && is_severe(one);
        findings_of_text(text).into_iter().find(is_it).map(|found| found.spheres).unwrap_or_default()
    };
    let on_pelvis = with_spheres_on("/bodyset/pelvis", &names);
    assert_eq!(found(&on_pelvis), names);
    // Spheres with other names are meant to be there, and those at the height of a seat.
    let at_seat = names.iter().fold(on_pelvis.clone(), |text, name| {
        let (before, sphere) = text.split_at(text.find(&format!("<ContactSphere name=\"{name}\">")).unwrap());
        format!("{before}{}", sphere.replacen(" -0.01 ", " -0.12 ", 1))
    });
    assert!(found(&at_seat).is_empty());
    let on_seat = names.iter().fold(on_pelvis, |text, name| {
        let other = name.replace('s', "seat");
        let text = text.replace(&format!("\"{name}\""), &format!("\"{other}\""));
        text.replace(&format!("/{name}<"), &format!("/{other}<"))
    });
    assert!(found(&on_seat).is_empty());
}

/// OpenSim 4.6 adds a coordinate that an axis names to the joint, and refuses the joint if the coordinates then are not in the order of the
/// axes.
#[test]
fn an_axis_with_a_coordinate_that_its_joint_does_not_have_is_found() {
    let model = include_str!("../../../../fixtures/format/v40000.osim");
    let joint = |coordinates: &[&str], axes: &[&str]| {
        let coordinate = |name: &&str| format!("<Coordinate name=\"{name}\"/>");
        let axis = |name: &&str| format!("<TransformAxis><coordinates>{name}</coordinates></TransformAxis>");
        let coordinates: String = coordinates.iter().map(coordinate).collect();
        let axes: String = axes.iter().map(axis).collect();
        let joint = format!(
            "<CustomJoint name=\"hip_r\"><coordinates>{coordinates}</coordinates><SpatialTransform>{axes}</SpatialTransform>"
        );
        let text = model.replacen("<PinJoint name=\"hip_r\">", &joint, 1);
        let found = findings_of_text(&text.replacen("</PinJoint>", "</CustomJoint>", 1));
        let found = found.into_iter().find(|one| one.code() == FindingCode::SocketNowhere);
        found.map(|found| found.message.to_string()).unwrap_or_default()
    };
    let said = "an axis of /jointset/hip_r names the coordinate 'b', which the joint does not have";
    assert_eq!(joint(&["a", "c"], &["a", "b"]), said);
    assert_eq!(joint(&["c"], &["b", "c"]), said);
    for (coordinates, axes) in [(&["a", "b"], &["a", "b"]), (&["b", "a"], &["a", "b"])] {
        assert_eq!(joint(coordinates, axes), "");
    }
    assert_eq!(joint(&["a"], &["a", "", "a", "b"]), "");
    assert_eq!(joint(&["a"], &["a b"]), "");
    assert_eq!(joint(&["a"], &["b a"]), said);
    assert_eq!(joint(&[], &["b"]), "");
}
