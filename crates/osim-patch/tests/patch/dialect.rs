//! Tests of forces of Moco 0.1 to 0.3, which contain their sphere and half-space as elements.

use osim_model::{FaultKind, ForceKind, Model, Property, Selection, SetId, Sphere};
use osim_patch::{Convert, Converted, convert};

use crate::given::{fixture, given_fixture};

const SPHERE_IN_FORCE: &str = "format/moco_sphere_in_force.osim";

fn sphere_in_force() -> String {
    String::from_utf8(fixture(SPHERE_IN_FORCE)).unwrap()
}

fn converted_model(text: &str, to: ForceKind) -> Result<Converted, osim_model::Fault> {
    let model = Model::parse(text).unwrap();
    convert(&model, &Selection::default().apply_to_all(&model).unwrap(), &Convert::new(to))
}

/// The fixture with a second force like the first, on the same half-space.
fn two_feet() -> String {
    let text = sphere_in_force();
    let from = text.find("\t\t\t\t<SmoothSphereHalfSpaceForce").unwrap();
    let end = "</SmoothSphereHalfSpaceForce>\n";
    let to = text.find(end).unwrap() + end.len();
    let second =
        text[from..to].replace("contact_heel_r", "contact_toe_r").replace("0.01 -0.02", "0.18 -0.02");
    format!("{}{second}{}", &text[..to], &text[to..])
}

#[test]
fn sphere_and_plane_become_members_of_the_geometry_set() {
    for to in [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley] {
        let made = converted_model(&two_feet(), to).unwrap();
        let model = made.rebuilt.model();
        assert!(!model.spheres().iter().any(Sphere::is_inside_force));
        let places: Vec<_> = model
            .spheres()
            .iter()
            .map(|own| (own.path.as_str(), own.location_m, own.radius_m().unwrap()))
            .collect();
        assert_eq!(
            places,
            [
                ("/contactgeometryset/contact_heel_r_sphere", [0.01, -0.02, 0.003], 0.0325),
                ("/contactgeometryset/contact_toe_r_sphere", [0.18, -0.02, 0.003], 0.0325),
            ]
        );
        // Forces that press on one plane share it.
        let [floor] = &model.half_spaces()[..] else { panic!("not one plane") };
        assert_eq!(
            (floor.path.as_str(), floor.normal.map(|normal| normal.y)),
            ("/contactgeometryset/floor", Some(1.0))
        );
        for force in model.forces() {
            assert_eq!(force.kind, to);
            let stiffness = force.checked(SetId::FIRST, Property::Stiffness).unwrap();
            assert_eq!(stiffness, Some(1_234_567.8));
        }
    }
}

#[test]
fn names_that_are_taken_get_a_number() {
    let taken = "<ContactGeometrySet name=\"contactgeometryset\"><objects><ContactHalfSpace name=\"floor\"><socket_frame>/ground\
                 </socket_frame></ContactHalfSpace></objects></ContactGeometrySet>";
    let made = converted_model(
        &sphere_in_force().replace("\t</Model>", &format!("\t\t{taken}\n\t</Model>")),
        ForceKind::SmoothSphereHalfSpace,
    );
    let made = made.unwrap();
    let model = made.rebuilt.model();
    let plane = model.planes_of(&model.forces()[0]);
    assert_eq!(plane[0].path, "/contactgeometryset/floor_2");
}

#[test]
fn elements_of_the_first_version_keep_their_meaning() {
    let first = sphere_in_force().replace("constant_contact_force>", "derivative_smoothing>");
    let model = Model::parse(first.as_str()).unwrap();
    let constant =
        |model: &Model| model.forces()[0].checked(SetId::FIRST, Property::ConstantContactForce).unwrap();
    assert_eq!(constant(&model), Some(1.5e-5));
    let made = converted_model(&first, ForceKind::SmoothSphereHalfSpace).unwrap();
    assert_eq!(constant(made.rebuilt.model()), Some(1.5e-5));
    // It took the place in a frame for a place of the body.
    let offset = "<components><PhysicalOffsetFrame name=\"sole\"><socket_parent>..</socket_parent><translation>0 1 0</translation>\
                  </PhysicalOffsetFrame></components></Body>";
    let on_frame = |text: &str| {
        text.replace("</Body>", offset)
            .replace("_frame>/bodyset/calcn_r</socket_sphere", "_frame>/bodyset/calcn_r/sole</socket_sphere")
    };
    let fault = converted_model(&on_frame(&first), ForceKind::SmoothSphereHalfSpace).unwrap_err();
    assert!(fault.to_string().contains("ignored where frame /bodyset/calcn_r/sole is"), "{fault}");
    assert!(converted_model(&on_frame(&sphere_in_force()), ForceKind::SmoothSphereHalfSpace).is_ok());
}

#[test]
fn a_plane_without_orientation_is_a_floor_except_in_the_first_version() {
    let orientation =
        "<contact_half_space_orientation>0 0 -1.5707963267948966</contact_half_space_orientation>";
    let silent = sphere_in_force().replace(orientation, "");
    let normal = |text: &str| {
        let model = Model::parse(text).unwrap();
        model.planes_of(&model.forces()[0])[0].normal.unwrap().to_array()
    };
    let [x, y, z] = normal(&silent);
    assert!(x.abs() < 1e-15 && (y - 1.0).abs() < 1e-15 && z == 0.0, "{x} {y} {z}");
    assert_eq!(normal(&silent.replace("constant_contact_force>", "derivative_smoothing>")), [-1.0, 0.0, 0.0]);
}

#[test]
fn only_transfer_refuses_a_sphere_inside_its_force() {
    given_fixture(SPHERE_IN_FORCE).rescaled_to(8.0 * 61.5).sets(Property::Radius, 1, 0.065);
    let outcome = given_fixture(SPHERE_IN_FORCE).taking_preset("falisse2022", 2.0);
    let fault = outcome
        .is_refused("refused", &["/forceset/contact_heel_r keeps its sphere inside itself", "convert"]);
    assert!(matches!(fault.kind, FaultKind::SphereInsideForce { .. }));
}
