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
        (
            "<socket_frame>/bodyset/calcn_r</socket_frame>",
            "<body_name>calcn_r</body_name>",
            FindingCode::OtherVersion,
            None,
        ),
        (
            force,
            &format!("<ForceSet name=\"more\"><objects/></ForceSet>{force}"),
            FindingCode::MisplacedObject,
            Some("/forceset/more"),
        ),
        (force, &format!("{sphere}{force}"), FindingCode::MisplacedObject, Some("/forceset/ball")),
        (set, &format!("<PinJoint name=\"odd\"></PinJoint>{set}"), FindingCode::IgnoredContacts, None),
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
        (
            "<Body name=\"pelvis\">",
            &format!("{force}</HuntCrossleyForce><Body name=\"pelvis\">"),
            FindingCode::MisplacedObject,
            Some("/bodyset/contact_r"),
        ),
        (
            set,
            &format!("<ConstraintSet><objects>{force}</HuntCrossleyForce></objects></ConstraintSet>{set}"),
            FindingCode::MisplacedObject,
            Some("/constraintset/contact_r"),
        ),
        (
            "</Model>",
            "</Model><ForceSet><objects><HuntCrossleyForce name=\"late\"/></objects></ForceSet>",
            FindingCode::IgnoredContacts,
            None,
        ),
        (set, &marker("calcn_r"), FindingCode::ConnecteeByName, Some("/")),
        (set, &marker("../../../bodyset/calcn_r"), FindingCode::ConnecteeByName, Some("/")),
        (set, &marker(""), FindingCode::SocketNowhere, Some("/")),
        (
            force,
            &format!("{}{force}", point("../../bodyset/calcn_r", "/jointset/hip_r/_coord_0")),
            FindingCode::ConnecteeByName,
            Some("/forceset/spring"),
        ),
        (
            force,
            &format!(
                "<PathSpring name=\"spring\"><PathPoint><socket_parent_frame>/bodyset/femur</socket_parent_frame></PathPoint></PathSpring>{force}"
            ),
            FindingCode::SocketNowhere,
            Some("/forceset/spring"),
        ),
        (
            force,
            &format!(
                "<BushingForce name=\"b\"><socket_frame1>f</socket_frame1><socket_frame2>/ground</socket_frame2><frames><PhysicalOffsetFrame name=\"f\"><socket_parent>pelvis</socket_parent></PhysicalOffsetFrame></frames></BushingForce>{force}"
            ),
            FindingCode::ConnecteeByName,
            Some("/forceset/b/f"),
        ),
        (
            force,
            &format!("<BushingForce name=\"b\"><socket_frame2>/ground</socket_frame2></BushingForce>{force}"),
            FindingCode::SocketNowhere,
            Some("/forceset/b"),
        ),
        (
            force,
            &format!(
                "<CoordinateActuator name=\"a\"><Coordinate>_coord_0</Coordinate></CoordinateActuator>{force}"
            ),
            FindingCode::SocketNowhere,
            Some("/forceset/a"),
        ),
        (
            force,
            &format!("{}{force}", point("/bodyset/calcn_r", "/jointset/hip_r/knee")),
            FindingCode::SocketNowhere,
            Some("/forceset/spring"),
        ),
        (
            force,
            &format!("{}{force}", point("/bodyset/calcn_r", "_coord_0")),
            FindingCode::SocketNowhere,
            None,
        ),
        (
            "<Ground name=\"ground\" />",
            "<Ground name=\"ground\"><FrameGeometrys name=\"frame_geometry\"/></Ground>",
            FindingCode::UnknownName,
            Some("/ground"),
        ),
        (
            "<groups />\n\t\t</ForceSet>",
            "<groups><ObjectGroups/></groups></ForceSet>",
            FindingCode::UnknownName,
            Some("/forceset"),
        ),
        (
            "<JointSet name=\"jointset\">",
            "<ConstaintSet/><JointSet name=\"jointset\">",
            FindingCode::UnknownName,
            Some("/"),
        ),
        (set, &format!("<Components/>{set}"), FindingCode::UnknownName, Some("/")),
        (
            force,
            &format!(
                "<ElasticFoundationForce name=\"e\"><contact_parameters><ElasticFoundationForce::ContactParametersSet name=\"contact_parameters\"><objects><ElasticFoundationForce::ContactParameters><geometry>floor /contactgeometryset/toe_r toe</geometry></ElasticFoundationForce::ContactParameters></objects></ElasticFoundationForce::ContactParametersSet></contact_parameters></ElasticFoundationForce>{force}"
            ),
            FindingCode::SocketNowhere,
            Some("/forceset/e"),
        ),
        (
            force,
            &format!("<HuntCrossley name=\"other\"></HuntCrossley>{force}"),
            FindingCode::UnknownName,
            Some("/forceset/other"),
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

/// A path with a point on a frame, which follows a coordinate.
fn point(frame: &str, coordinate: &str) -> String {
    format!(
        "<PathSpring name=\"spring\"><path><GeometryPath name=\"path\"><PathPointSet><objects><ConditionalPathPoint name=\"p\"><socket_parent_frame>{frame}</socket_parent_frame><socket_coordinate>{coordinate}</socket_coordinate></ConditionalPathPoint></objects></PathPointSet></GeometryPath></path></PathSpring>"
    )
}

/// A set with a marker on a frame, before the forces.
fn marker(frame: &str) -> String {
    format!(
        "<MarkerSet><objects><Marker name=\"m\"><socket_parent_frame>{frame}</socket_parent_frame></Marker></objects></MarkerSet><ForceSet name=\"forceset\">"
    )
}

#[test]
fn what_opensim_reads_is_not_reported() {
    let force = "<HuntCrossleyForce name=\"contact_r\">";
    for (old, new) in [
        (">/bodyset/calcn_r</socket_child", "> ../../bodyset/calcn_r </socket_child"),
        ("40000", "40600"),
        (force, &format!("{force}<isDisabled>false</isDisabled>")),
        (
            force,
            &format!(
                "<CoordinateLimitForce name=\"limit\"><coordinate>_coord_0</coordinate></CoordinateLimitForce>{force}"
            ),
        ),
        (force, &format!("{}{force}", point("../../../../bodyset/calcn_r", "/jointset/hip_r/_coord_0"))),
        ("<ForceSet name=\"forceset\">", &marker("../../bodyset/calcn_r")),
        (
            "<mass>1.5<",
            "<attached_geometry><Mesh name=\"m\"><socket_frame>nothing</socket_frame></Mesh></attached_geometry><mass>1.5<",
        ),
        (
            force,
            &format!(
                "<BushingForce name=\"b\"><socket_frame1>f</socket_frame1><socket_frame2>/ground</socket_frame2><frames><PhysicalOffsetFrame name=\"f\"><socket_parent>/bodyset/pelvis</socket_parent></PhysicalOffsetFrame></frames></BushingForce>{force}"
            ),
        ),
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

/// OpenSim 4.6 refuses the documents with a later version, and reads those with the version before it.
#[test]
fn a_version_later_than_the_form_of_a_document_is_an_error() {
    let two_feet = TWO_FEET.replace("<groups />", "<groups><GeometryPath name=\"geometrypath\"/></groups>");
    for (text, own, last) in [
        (include_str!("../../../../fixtures/format/v30000.osim"), "30000", 30499),
        (include_str!("../../../../fixtures/format/v30505.osim"), "30505", 30507),
        (include_str!("../../../../fixtures/format/v30508.osim"), "30508", 30509),
        (include_str!("../../../../fixtures/format/v30516.osim"), "30516", 30516),
        (&two_feet, "40000", 40499),
    ] {
        let codes = |version: u32| -> Vec<FindingCode> {
            let text = text.replacen(own, &version.to_string(), 1);
            model_findings(&Model::parse(text).unwrap()).iter().map(Finding::code).collect()
        };
        assert!(!codes(last).contains(&FindingCode::OtherVersion), "{last}");
        assert!(codes(last + 1).contains(&FindingCode::OtherVersion), "{last}");
    }
    // Contact geometry of a later version, pasted.
    let text = include_str!("../../../../fixtures/format/v30000.osim");
    let frame = "<socket_frame>/bodyset/calcn_r</socket_frame>";
    let text = text.replace("<body_name>calcn_r</body_name>", frame);
    let pasted = model_findings(&Model::parse(text).unwrap()).iter().map(Finding::code).collect::<Vec<_>>();
    assert!(pasted.contains(&FindingCode::OtherVersion));
}

/// The first of both flags counts in OpenSim 4.6.
#[test]
fn a_flag_that_comes_second_is_an_error_if_it_says_otherwise() {
    let text = include_str!("../../../../fixtures/format/v30000.osim");
    let (off, on) = ("<appliesForce>false</appliesForce>", "<isDisabled>false</isDisabled>");
    assert!(text.contains(on));
    for (flags, is_found) in
        [(format!("{on}{off}"), true), (format!("{off}{on}"), false), (off.into(), false)]
    {
        let model = Model::parse(text.replacen(on, &flags, 1)).unwrap();
        let mut found = model_findings(&model).iter().filter(|one| one.code() == FindingCode::UnknownName);
        assert_eq!(found.next().is_some(), is_found, "{flags}");
    }
}

/// What OpenSim 4.6 makes of these texts was measured with one function after another in a joint.
#[test]
fn numbers_of_functions_and_names_in_joints_are_guarded() {
    let axis = |function: &str| {
        format!(
            "<CustomJoint name=\"hip_r\"><SpatialTransform><TransformAxis name=\"rotation1\">{function}</TransformAxis></SpatialTransform>"
        )
    };
    let polynomial =
        |text| format!("<PolynomialFunction><coefficients>{text}</coefficients></PolynomialFunction>");
    for (function, text) in [
        (polynomial("(0.2 -0.1)"), "OpenSim reads as 1"),
        (polynomial("0.2,-0.1"), "OpenSim reads as 0.2"),
        ("<Sine><phase>(0.2)</phase></Sine>".into(), "OpenSim reads as 0"),
        ("<GCVSpline><half_order>2abc</half_order></GCVSpline>".into(), "OpenSim refuses the model"),
        (
            "<PiecewiseConstantFunction><y>0 1;2</y></PiecewiseConstantFunction>".into(),
            "OpenSim refuses the model",
        ),
        (
            "<LinearFunction><coefficients>1</coefficients></LinearFunction>".into(),
            "has 1 numbers, expected 2",
        ),
        ("<cordinates>hip</cordinates>".into(), "coordinates is meant"),
        ("<LinearFuncton/>".into(), "LinearFunction is meant"),
        ("<function><Constants/></function>".into(), "Constant is meant"),
        ("<MultiplierFuncton/>".into(), "MultiplierFunction is meant"),
        ("<SimmSpline><x>0 1</x></SimmSpline>".into(), "has 2 numbers, and y 0"),
        (polynomial("0.2, -0.1"), ""),
        ("<GCVSpline><half_order>3</half_order></GCVSpline>".into(), ""),
    ] {
        let whole = TWO_FEET.replacen("<PinJoint name=\"hip_r\">", &axis(&function), 1);
        let model = Model::parse(whole.replacen("</PinJoint>", "</CustomJoint>", 1)).unwrap();
        let codes = [FindingCode::OddNumber, FindingCode::UnknownName];
        let found: Vec<_> = model_findings(&model).iter().filter(|one| codes.contains(&one.code())).collect();
        match text {
            "" => assert!(found.is_empty(), "{found:?}"),
            _ => assert!(found.len() == 1 && found[0].message.to_string().ends_with(text), "{found:?}"),
        }
    }
}

/// OpenSim 4.6 reads a JointSet from 30501 on; its model double_pendulum.osim is such a document. CustomJoint.cpp renames `coordinate` in
/// documents before 10901.
#[test]
fn older_forms_of_joints_are_right_in_their_versions() {
    let axis = "<OpenSimDocument Version=\"10900\"><Model name=\"m\"><BodySet><objects><Body name=\"pelvis\"><mass>1</mass><Joint>\
         <CustomJoint name=\"j\"><SpatialTransform><TransformAxis name=\"tilt\"><coordinate>tilt</coordinate></TransformAxis>\
         </SpatialTransform></CustomJoint></Joint></Body></objects></BodySet></Model></OpenSimDocument>";
    for (text, own, other, code, is_found) in [
        (
            include_str!("../../../../fixtures/format/v30505.osim"),
            "30505",
            "30501",
            FindingCode::OtherVersion,
            false,
        ),
        (
            include_str!("../../../../fixtures/format/v30505.osim"),
            "30505",
            "30500",
            FindingCode::OtherVersion,
            true,
        ),
        (axis, "10900", "10900", FindingCode::UnknownName, false),
        (axis, "10900", "10901", FindingCode::UnknownName, true),
    ] {
        let model = Model::parse(text.replacen(own, other, 1)).unwrap();
        assert_eq!(model_findings(&model).iter().any(|one| one.code() == code), is_found, "{other}");
    }
}

/// OpenSim 4.6 refuses a coordinate whose least value is infinite, or whose largest one is minus infinity.
#[test]
fn a_range_may_be_without_bounds() {
    for (range, is_fine) in [("-inf inf", true), ("-1 inf", true), ("inf 1", false), ("-1 -inf", false)] {
        let coordinate = format!("<Coordinate name=\"flexion\"><range>{range}</range></Coordinate>");
        let joint = format!("<coordinates>{coordinate}</coordinates></PinJoint>");
        let model = Model::parse(TWO_FEET.replacen("</PinJoint>", &joint, 1)).unwrap();
        let mut found = model_findings(&model).iter().filter(|one| one.code() == FindingCode::NotFinite);
        assert_eq!(found.next().is_none(), is_fine, "{range}");
    }
}

/// OpenSim 4.6 refuses a function of a controller that it cannot read, and a stop of a joint with a transition of 0.
#[test]
fn numbers_of_controllers_and_of_stops_of_joints_are_guarded() {
    let controller = "<ControllerSet name=\"controllerset\"><objects><PrescribedController name=\"c\"><Constant><value>@</value></Constant></PrescribedController></objects></ControllerSet>";
    let stop = "<CoordinateLimitForce name=\"c\"><coordinate>_coord_0</coordinate><transition>@</transition></CoordinateLimitForce>";
    for (before, object, place) in [
        ("<JointSet name=\"jointset\">", controller, "/controllerset/c"),
        ("<HuntCrossleyForce name=\"contact_r\">", stop, "/forceset/c"),
    ] {
        for (value, is_odd) in [("0,1", true), ("0.1", false)] {
            let new = format!("{}{before}", object.replace('@', value));
            let model = Model::parse(TWO_FEET.replacen(before, &new, 1)).unwrap();
            let found = model_findings(&model).iter().find(|one| one.code() == FindingCode::OddNumber);
            assert_eq!(found.and_then(|one| one.place.as_deref()), is_odd.then_some(place), "{value}");
        }
    }
}

/// OpenSim 4.6 gives both joints to the first body and refuses the model.
#[test]
fn a_body_that_was_pasted_twice_with_its_joint_has_none() {
    let text = include_str!("../../../../fixtures/format/v30000_two_feet.osim");
    let start = text.find("<Body name=\"calcn_r\">").unwrap();
    let end = start + text[start..].find("</Body>").unwrap() + "</Body>".len();
    let model = Model::parse(format!("{}{}", &text[..end], &text[start..])).unwrap();
    let found = model_findings(&model).iter().find(|one| one.code() == FindingCode::BodyWithoutJoint);
    assert_eq!(found.and_then(|one| one.place.as_deref()), Some("/bodyset/calcn_r_0"));
}
