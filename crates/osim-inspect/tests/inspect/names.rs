//! The meaning of paths in models whose objects have odd names. The expected paths are those of the real OpenSim 4.6; tests/oracle/names.py
//! makes many more.

use osim_inspect::model_findings;
use osim_model::{FindingCode, Model};

use crate::random::{Random, seeds};

/// The text of a model with a foot called `foot`, a sphere of 0.0325 m and a floor. `behind` is added after its sets.
fn foot_model(version: u32, foot: &str, sphere: &str, geometry: &str, behind: &str) -> String {
    let (ground, frame) = match version {
        30000 => ("<body_name>ground</body_name>".to_owned(), format!("<body_name>{foot}</body_name>")),
        _ => {
            let frame = format!("<socket_frame>/bodyset/{foot}</socket_frame>");
            ("<socket_frame>/ground</socket_frame>".to_owned(), frame)
        }
    };
    format!(
        "<OpenSimDocument Version=\"{version}\"><Model name=\"m\"><BodySet><objects><Body name=\"{foot}\"><mass>1</mass></Body>\
         </objects></BodySet><ForceSet><objects><HuntCrossleyForce name=\"press\"><HuntCrossleyForce::ContactParametersSet \
         name=\"contact_parameters\"><objects><HuntCrossleyForce::ContactParameters><geometry>{geometry}</geometry><stiffness>1e6\
         </stiffness></HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet>\
         </HuntCrossleyForce></objects></ForceSet><ContactGeometrySet><objects><ContactHalfSpace name=\"floor\">{ground}\
         </ContactHalfSpace><ContactSphere name=\"{sphere}\">{frame}<radius>0.0325</radius></ContactSphere></objects>\
         </ContactGeometrySet>{behind}</Model></OpenSimDocument>"
    )
}

/// Path, body and radius of the sphere that the force presses, and the codes of the findings.
#[track_caller]
fn pressed_sphere(text: &str) -> (String, Option<String>, f64, Vec<FindingCode>) {
    let model = Model::parse(text).unwrap();
    let [sphere] = model.forces()[0].spheres()[..] else { panic!("not one sphere: {text}") };
    let sphere = model.sphere(sphere).unwrap();
    let codes = [FindingCode::ConnecteeByName, FindingCode::DuplicateNames, FindingCode::RefusedName];
    let found =
        model_findings(&model).iter().map(osim_model::Finding::code).filter(|code| codes.contains(code));
    (sphere.path.clone(), sphere.body.clone(), sphere.radius_m().unwrap(), found.collect())
}

#[test]
fn a_sphere_may_have_the_name_of_a_set() {
    for name in ["contactgeometryset", "forceset", "bodyset", "ground", "heel.r", "...", "m", "press"] {
        for list in [
            format!("floor {name}"),
            format!("{name} floor"),
            format!("floor /contactgeometryset/{name}"),
            format!("floor ./contactgeometryset/../contactgeometryset/./{name}"),
            format!("floor nothing/../contactgeometryset//{name}"),
        ] {
            let read = pressed_sphere(&foot_model(40000, "foot", name, &list, ""));
            assert_eq!(
                read,
                (format!("/contactgeometryset/{name}"), Some("foot".to_owned()), 0.0325, vec![]),
                "{list}"
            );
        }
    }
    for (version, foot) in [(40000, "bodyset"), (40000, "forceset"), (40000, "ground"), (30000, "bodyset")] {
        let read = pressed_sphere(&foot_model(version, foot, "heel", "floor heel", ""));
        assert_eq!(read.1.as_deref(), Some(foot), "{version}");
        assert!(read.3.is_empty(), "{version} {foot}: {:?}", read.3);
    }
}

#[test]
fn objects_in_components_come_before_objects_in_sets() {
    let other = "<components><ContactSphere name=\"contactgeometryset\"><socket_frame>/bodyset/foot</socket_frame><radius>0.5</radius>\
                 </ContactSphere></components>";
    // In a list, OpenSim looks in the model first.
    let (path, _, radius, found) =
        pressed_sphere(&foot_model(40000, "foot", "heel", "floor contactgeometryset", other));
    assert_eq!((path.as_str(), radius), ("/contactgeometryset", 0.5));
    // Its set has another path now, so that OpenSim finds no floor either.
    assert!(
        found.contains(&FindingCode::DuplicateNames) && found.contains(&FindingCode::ConnecteeByName),
        "{found:?}"
    );
    let text = foot_model(40000, "foot", "heel", "floor heel", other);
    let paths: Vec<String> =
        Model::parse(text).unwrap().spheres().iter().map(|sphere| sphere.path.clone()).collect();
    assert_eq!(paths, ["/contactgeometryset_0/heel", "/contactgeometryset"]);
}

#[test]
fn old_documents_have_no_blanks_in_names() {
    let (path, _, _, found) = pressed_sphere(&foot_model(30000, "foot", " heel", "floor heel", ""));
    assert_eq!((path.as_str(), found), ("/contactgeometryset/heel", vec![]));
    // Their joints call bodies by their names, blanks and all, and OpenSim refuses that.
    let model = Model::parse(foot_model(30000, " foot", "heel", "floor heel", "")).unwrap();
    let found = model_findings(&model);
    assert!(found.iter().any(|finding| finding.code() == FindingCode::RefusedName), "{found:?}");
}

#[test]
fn a_name_that_opensim_refuses_is_reported() {
    for name in [" heel", "heel/r", "heel*", "heel+", "heel\\r", ".", ".."] {
        let text = foot_model(40000, "foot", "heel", "floor heel", "")
            .replace("name=\"press\"", &format!("name=\"{name}\""));
        assert_eq!(pressed_sphere(&text).3, [FindingCode::RefusedName], "{name}");
    }
}

/// Names of objects: names of sets and classes, and odd names. They have no blanks and slashes, because not every version keeps these.
const ODD_NAMES: [&str; 24] = [
    "bodyset",
    "jointset",
    "forceset",
    "contactgeometryset",
    "componentset",
    "default",
    "frames",
    "objects",
    "geometry",
    "m",
    "BodySet",
    "ContactSphere",
    "contactsphere",
    "body",
    "heel.r",
    "...",
    ".heel",
    "heel,r",
    "a&b",
    "<a>",
    "h\u{e9}el",
    "heel_0",
    "heel*",
    "1",
];

fn xml_text(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The text of a model in document version `version`: two feet with these names and a sphere each. `list` writes an entry in a list of
/// geometry.
fn two_feet(
    version: u32,
    feet: [&str; 2],
    spheres: [&str; 2],
    floor: &str,
    list: impl Fn(&str) -> String,
) -> String {
    let frame = |body: Option<&str>| {
        let path = body.map_or_else(|| "ground".to_owned(), |body| format!("bodyset/{}", xml_text(body)));
        match version {
            30000 => format!("<body_name>{}</body_name>", body.map_or_else(|| "ground".to_owned(), xml_text)),
            30505 => format!(
                "<connectors><Connector_PhysicalFrame_ name=\"frame\"><connectee_name>../../{path}</connectee_name>\
                 </Connector_PhysicalFrame_></connectors>"
            ),
            30516 => format!("<socket_frame_connectee_name>../../{path}</socket_frame_connectee_name>"),
            _ => format!("<socket_frame>/{path}</socket_frame>"),
        }
    };
    let bodies = feet.map(|foot| format!("<Body name=\"{}\"><mass>1</mass></Body>", xml_text(foot)));
    let geometry = [0, 1].map(|side| {
        format!(
            "<ContactSphere name=\"{}\">{}<radius>0.0{}</radius></ContactSphere>",
            xml_text(spheres[side]),
            frame(Some(feet[side])),
            side + 3
        )
    });
    let forces = spheres.map(|sphere| {
        format!(
            "<HuntCrossleyForce name=\"{0}\"><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>\
             <HuntCrossleyForce::ContactParameters><geometry>{1} {2}</geometry><stiffness>1e6</stiffness>\
             </HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>",
            xml_text(sphere),
            xml_text(&list(floor)),
            xml_text(&list(sphere))
        )
    });
    format!(
        "<OpenSimDocument Version=\"{version}\"><Model name=\"m\"><BodySet><objects>{}</objects></BodySet><ForceSet><objects>{}\
         </objects></ForceSet><ContactGeometrySet><objects><ContactHalfSpace name=\"{}\">{}</ContactHalfSpace>{}</objects>\
         </ContactGeometrySet></Model></OpenSimDocument>",
        bodies.concat(),
        forces.concat(),
        xml_text(floor),
        frame(None),
        geometry.concat()
    )
}

/// Each force presses the sphere that it names, and that sphere is on its own foot, whatever the names of all objects are.
#[test]
fn each_force_presses_the_sphere_of_its_name_for_random_names() {
    for seed in seeds() {
        let mut random = Random::of(seed);
        let version = [30000, 30505, 30516, 40000][random.index(4)];
        let mut pair = |plain: [&'static str; 2]| {
            let names =
                plain.map(|name| if random.integer_below(3) == 0 { name } else { random.one_of(&ODD_NAMES) });
            if names[0] == names[1] { plain } else { names }
        };
        let (feet, spheres) = (pair(["foot_r", "foot_l"]), pair(["heel_r", "heel_l"]));
        let floor = [pair(["floor", "plane"])[0], "ground_plane"];
        let floor = if spheres.contains(&floor[0]) { floor[1] } else { floor[0] };
        let style = random.integer_below(if version == 30000 { 1 } else { 4 });
        let text = two_feet(version, feet, spheres, floor, |name| match style {
            0 => name.to_owned(),
            1 => format!("/contactgeometryset/{name}"),
            2 => format!("contactgeometryset/{name}"),
            _ => format!("nothing/../contactgeometryset//./{name}"),
        });
        let model =
            Model::parse(text.as_str()).unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{text}"));
        for side in [0, 1] {
            let [sphere] = model.forces()[side].spheres()[..] else {
                panic!("seed {seed}: not one sphere\n{text}")
            };
            let sphere = model.sphere(sphere).unwrap();
            assert_eq!(sphere.path, format!("/contactgeometryset/{}", spheres[side]), "seed {seed}\n{text}");
            assert_eq!(sphere.body.as_deref(), Some(feet[side]), "seed {seed}\n{text}");
            assert_eq!(sphere.radius_m().unwrap(), [0.03, 0.04][side], "seed {seed}\n{text}");
            assert_eq!(model.forces()[side].sets[0].half_spaces, 1, "seed {seed}\n{text}");
        }
        let by_name =
            model_findings(&model).iter().filter(|found| found.code() == FindingCode::ConnecteeByName);
        assert_eq!(by_name.count(), 0, "seed {seed}\n{text}");
    }
}
