//! Tests of the conversion of forces to the other class, one force for each sphere.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{Force, ForceKind, Model, Property, Selection, SetId};
use osim_patch::{Convert, Converted, convert};

const BOTH_CLASSES: [ForceKind; 2] = [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley];

/// A model with `forces`, a foot with a sphere, a floor and a wall.
fn foot_document(forces: &str) -> String {
    document_of_parts(40000, "", forces, GEOMETRY)
}

const GEOMETRY: &str = r#"
				<ContactHalfSpace name="floor"><socket_frame>/ground</socket_frame><location>0 0 0</location><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace>
				<ContactHalfSpace name="wall"><socket_frame>/ground</socket_frame><location>0.5 0 0</location></ContactHalfSpace>
				<ContactSphere name="heel"><socket_frame>/bodyset/foot_r</socket_frame><location>0 0 0</location><radius>0.032</radius></ContactSphere>"#;

fn document_of_parts(version: u32, defaults: &str, forces: &str, geometry: &str) -> String {
    format!(
        r#"<OpenSimDocument Version="{version}">
	<Model name="foot">{defaults}
		<BodySet name="bodyset">
			<objects>
				<Body name="foot_r">
					<mass>1</mass>
				</Body>
			</objects>
		</BodySet>
		<ForceSet name="forceset">
			<objects>{forces}
			</objects>
		</ForceSet>
		<ContactGeometrySet name="contactgeometryset">
			<objects>{geometry}
			</objects>
		</ContactGeometrySet>
	</Model>
</OpenSimDocument>
"#
    )
}

fn material_xml(geometry: &str, stiffness: &str, dissipation: &str, friction: &str) -> String {
    format!(
        "<HuntCrossleyForce::ContactParameters><geometry>{geometry}</geometry><stiffness>{stiffness}</stiffness>\
         <dissipation>{dissipation}</dissipation><static_friction>{friction}</static_friction>\
         </HuntCrossleyForce::ContactParameters>"
    )
}

fn hunt_crossley_force(name: &str, own: &str, materials: &[String]) -> String {
    format!(
        "\n\t\t\t\t<HuntCrossleyForce name=\"{name}\">{own}<HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\">\
         <objects>{}</objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>",
        materials.concat()
    )
}

#[track_caller]
fn convert_text(text: &str, to: ForceKind) -> Converted {
    let model = Model::parse(text).unwrap();
    let selected = Selection::default().apply_to_all(&model).unwrap();
    convert(&model, &selected, &Convert::new(to)).unwrap()
}

/// The force between `heel` and the half-space `plane`.
#[track_caller]
fn force_against<'m>(model: &'m Model, plane: &str) -> &'m Force {
    let meets = |force: &&Force| {
        force.sets.iter().flat_map(|set| model.half_spaces_of(set)).any(|own| own.name == plane)
    };
    model.forces().iter().find(meets).unwrap_or_else(|| panic!("no force meets {plane}"))
}

#[track_caller]
fn value_of(force: &Force, property: Property) -> f64 {
    force.checked(SetId::FIRST, property).unwrap().unwrap()
}

#[test]
fn each_half_space_has_its_own_material() {
    let floor = ("heel floor", "1e6", "2", "0.8");
    let wall = ("wall", "3e6", "0", "0.2");
    // Simbody: k = E^(2/3) of each surface, s = k of the other over the sum of both; k s^1.5 is that of the pair, and two equal
    // surfaces of E* make 2^-1.5 E*. Here k_sphere = 1e4, k_wall = 3e6^(2/3) = 20800.838, so E* = (2 * 1e4 * 20800.838 /
    // 30800.838)^1.5 = 1569720.9, c = 2 * 20800.838 / 30800.838 = 1.3506670, and 2 * 0.8 * 0.2 / (0.8 + 0.2) = 0.32.
    for (first, second) in [(floor, wall), (wall, floor)] {
        let materials = [first, second].map(|(geometry, k, c, mu)| material_xml(geometry, k, c, mu));
        for to in BOTH_CLASSES {
            let made = convert_text(&foot_document(&hunt_crossley_force("foot", "", &materials)), to);
            let model = made.rebuilt.model();
            let own = force_against(model, "floor");
            assert_eq!(
                (value_of(own, Property::Stiffness), value_of(own, Property::Dissipation)),
                (1e6, 2.0)
            );
            assert_eq!(value_of(own, Property::StaticFriction), 0.8);
            let other = force_against(model, "wall");
            for (property, wanted) in [
                (Property::Stiffness, 1_569_720.9),
                (Property::Dissipation, 1.350_667_0),
                (Property::StaticFriction, 0.32),
            ] {
                let found = value_of(other, property);
                assert!((found / wanted - 1.0).abs() < 1e-7, "{to:?} {property}: {found}, expected {wanted}");
            }
            assert_eq!(made.findings.len(), 1);
        }
    }
}

const SMOOTH: &str = r#"
				<SmoothSphereHalfSpaceForce name="foot"><socket_sphere>/contactgeometryset/heel</socket_sphere><socket_half_space>/contactgeometryset/floor</socket_half_space>{own}<stiffness>1e6</stiffness></SmoothSphereHalfSpaceForce>"#;

/// Elements in `<defaults>` that switch forces of both classes off; up to version 30508 there are two spellings.
const SWITCHED_OFF_DEFAULTS: [(u32, &str); 3] = [
    (40000, "<appliesForce>false</appliesForce>"),
    (30000, "<appliesForce>false</appliesForce>"),
    (30000, "<isDisabled>true</isDisabled>"),
];

fn defaults_xml(own: &str) -> String {
    let object = |class: ForceKind| format!("<{0} name=\"default\">{own}</{0}>", class.as_str());
    format!("<defaults>{}</defaults>", BOTH_CLASSES.map(object).concat())
}

#[test]
fn converted_forces_act_as_before_with_any_defaults() {
    for (version, off) in SWITCHED_OFF_DEFAULTS {
        for to in BOTH_CLASSES {
            let geometry = match version {
                30000 => GEOMETRY
                    .replace("socket_frame>/bodyset/", "body_name>")
                    .replace("socket_frame>/", "body_name>")
                    .replace("socket_frame", "body_name"),
                _ => GEOMETRY.to_owned(),
            };
            for (own, acts) in [
                ("<appliesForce>true</appliesForce>", true),
                ("<appliesForce>false</appliesForce>", false),
                ("", false),
            ] {
                let force = match to {
                    ForceKind::HuntCrossley => SMOOTH.replace("{own}", own),
                    _ => hunt_crossley_force("foot", own, &[material_xml("heel floor", "1e6", "0", "0")]),
                };
                let made =
                    convert_text(&document_of_parts(version, &defaults_xml(off), &force, &geometry), to);
                let [force] = made.rebuilt.model().forces() else { panic!("one force") };
                assert_eq!((force.kind, force.applies), (to, acts), "{version} {off} {own}");
            }
        }
    }
}

#[test]
fn properties_absent_from_defaults_are_not_written() {
    for defaults in [
        "",
        "<defaults><HuntCrossleyForce name=\"default\"><transition_velocity>0.2</transition_velocity></HuntCrossleyForce></defaults>",
    ] {
        let force = SMOOTH.replace("{own}", "");
        let made =
            convert_text(&document_of_parts(40000, defaults, &force, GEOMETRY), ForceKind::HuntCrossley);
        let model = made.rebuilt.model();
        assert!(!String::from_utf8_lossy(model.document().bytes()).contains("appliesForce"));
        // The force that was there had OpenSim's.
        assert_eq!(model.forces()[0].transition_velocity.number, 0.01);
    }
}

#[test]
fn a_sphere_keeps_its_force_where_another_one_has_its_name() {
    // OpenSim looks for `heel` in the model itself first, and then in its geometry set.
    let other = "<components><ContactSphere name=\"heel\"><socket_frame>/bodyset/foot_r</socket_frame>\
                 <location>0 1 0</location><radius>0.5</radius></ContactSphere></components>";
    let text = foot_document(&SMOOTH.replace("{own}", ""));
    let two = text.replace("\t</Model>", &format!("\t\t{other}\n\t</Model>"));
    for (text, called) in [
        (text, "<geometry>heel floor</geometry>"),
        (two, "<geometry>/contactgeometryset/heel floor</geometry>"),
    ] {
        let made = convert_text(&text, ForceKind::HuntCrossley);
        let model = made.rebuilt.model();
        let written = String::from_utf8_lossy(model.document().bytes()).into_owned();
        assert!(written.contains(called), "{written}");
        let own = model.forces()[0].spheres();
        assert_eq!(model.sphere(own[0]).unwrap().path, "/contactgeometryset/heel");
    }
}

#[test]
fn a_force_without_a_sphere_stays_as_it_is() {
    let floor_only = hunt_crossley_force("floor_only", "", &[material_xml("floor", "1e6", "2", "0.8")]);
    let text = foot_document(&format!(
        "{}{floor_only}",
        hunt_crossley_force("foot", "", &[material_xml("heel floor", "1e6", "2", "0.8")])
    ));
    let made = convert_text(&text, ForceKind::SmoothSphereHalfSpace);
    assert_eq!(made.without_sphere, ["/forceset/floor_only"]);
    let written = String::from_utf8_lossy(made.rebuilt.model().document().bytes()).into_owned();
    assert!(written.contains(floor_only.as_str()), "{written}");
    let touched: Vec<&str> = made.rebuilt.objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(touched, ["foot", "foot"]);
    assert!(made.renamed.is_empty());
}

#[test]
fn a_force_without_a_half_space_is_refused_with_the_way_out() {
    let text = foot_document(&hunt_crossley_force("kick", "", &[material_xml("heel", "1e6", "2", "0.8")]));
    let model = Model::parse(text).unwrap();
    let selected = Selection::default().apply_to_all(&model).unwrap();
    let fault = convert(&model, &selected, &Convert::new(ForceKind::SmoothSphereHalfSpace)).unwrap_err();
    assert_eq!(fault.code(), "refused");
    assert_eq!(fault.kind.phrase().inputs(), [osim_model::messages::Input::Exclude]);
    let said = fault.to_string();
    assert!(said.contains("/forceset/kick has no half-space") && said.contains("kick"), "{said}");
}

#[test]
fn a_pair_that_is_pressed_several_times_is_refused_by_name() {
    let heel = material_xml("heel", "1e6", "2", "0.8");
    let [floor, both] = ["floor", "heel floor"].map(|geometry| material_xml(geometry, "1e6", "2", "0.8"));
    let spellings: [(&[String], &str); 3] = [
        (&[both.clone(), both.clone()], "this pair 4 times"),
        (&[heel.clone(), floor.clone(), floor.clone()], "this pair 2 times"),
        (&[material_xml("heel heel wall floor", "1e6", "2", "0.8")], "this pair 2 times"),
    ];
    for (materials, says) in spellings {
        let text = foot_document(&hunt_crossley_force("foot", "", materials));
        let model = Model::parse(text).unwrap();
        let selected = Selection::default().apply_to_all(&model).unwrap();
        for to in BOTH_CLASSES {
            let said = convert(&model, &selected, &Convert::new(to)).unwrap_err().to_string();
            assert!(said.contains("/forceset/foot names heel") && said.contains(says), "{said}");
        }
    }
    // Each pair once.
    let once = foot_document(&hunt_crossley_force(
        "foot",
        "",
        &[heel, floor, material_xml("wall", "1e6", "2", "0.8")],
    ));
    assert_eq!(convert_text(&once, ForceKind::SmoothSphereHalfSpace).renamed[0].1.len(), 2);
}

#[test]
fn content_that_new_forces_do_not_have_is_described() {
    let own = "<!-- mine --><?pi my?><!--Material properties.--><components><A/></components><appliesForce>true</appliesForce><odd>7</odd>";
    let text =
        foot_document(&hunt_crossley_force("foot", own, &[material_xml("heel floor", "1e6", "2", "0.8")]));
    let text = text.replace("name=\"foot\"><!--", "name=\"foot\" author=\"me\"><!--");
    let made = convert_text(&text, ForceKind::SmoothSphereHalfSpace);
    let described =
        "the comment 'mine', the instruction <?pi my?>, the attribute author, <components>, <odd>";
    assert_eq!(made.dropped, [("/forceset/foot".to_owned(), described.to_owned())]);
    // Smoothing is dropped if it cannot be computed again: 300 1/m is that of a radius of 0.032 m.
    for (hertz, is_lost) in [("123", true), ("300", false)] {
        let smoothing = format!("<hertz_smoothing>{hertz}</hertz_smoothing>");
        let text = foot_document(&SMOOTH.replace("{own}", &smoothing));
        let made = convert_text(&text, ForceKind::HuntCrossley);
        let dropped: Vec<&str> = made.dropped.iter().map(|(_, what)| what.as_str()).collect();
        let expected: &[&str] = if is_lost { &["hertz_smoothing 123"] } else { &[] };
        assert_eq!(dropped, expected);
    }
}
