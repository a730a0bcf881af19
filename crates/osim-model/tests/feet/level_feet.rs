//! Tests of feet whose sphere bottoms are made level, with results computed by hand. `tests/oracle/test_level.py` compares with OpenSim
//! itself.

use osim_model::Model;
use osim_model::feet::{LevelledSphere, NotLevelled, levelled_spheres};

/// A foot at 0.5 m with two spheres: a heel of radius 0.04 m with its bottom at 0.44 m, and a toe of radius 0.03 m with its bottom at 0.5
/// m. The toe's frame is turned by a right angle about z (its x is the foot's y). The floor is turned by `slope` about z.
fn foot_model(body: &str, slope: f64) -> Model {
    let turned = slope - std::f64::consts::FRAC_PI_2;
    let force = |sphere: &str| {
        format!(
            "<SmoothSphereHalfSpaceForce name=\"force_{sphere}\"><socket_sphere>/contactgeometryset/{sphere}</socket_sphere>\
             <socket_half_space>/contactgeometryset/floor</socket_half_space></SmoothSphereHalfSpaceForce>"
        )
    };
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model><gravity>0 -10 0</gravity><BodySet><objects><Body name=\"{body}\"><mass>1</mass>\
         <components><PhysicalOffsetFrame name=\"toes\"><socket_parent>..</socket_parent><translation>0.2 0 0</translation>\
         <orientation>0 0 1.5707963267948966</orientation></PhysicalOffsetFrame></components></Body></objects></BodySet>\
         <JointSet><objects><CustomJoint name=\"j\"><socket_parent_frame>/ground</socket_parent_frame>\
         <socket_child_frame>/bodyset/{body}</socket_child_frame><coordinates><Coordinate name=\"height\"><default_value>0.5\
         </default_value></Coordinate></coordinates><SpatialTransform><TransformAxis name=\"translation1\"><coordinates>height\
         </coordinates><axis>0 1 0</axis><LinearFunction><coefficients>1 0</coefficients></LinearFunction></TransformAxis>\
         </SpatialTransform></CustomJoint></objects></JointSet>\
         <ContactGeometrySet><objects>\
         <ContactHalfSpace name=\"floor\"><socket_frame>/ground</socket_frame><orientation>0 0 {turned}</orientation></ContactHalfSpace>\
         <ContactSphere name=\"heel\"><socket_frame>/bodyset/{body}</socket_frame><location>0 -0.02 0</location><radius>0.04</radius>\
         </ContactSphere>\
         <ContactSphere name=\"toe\"><socket_frame>/bodyset/{body}/toes</socket_frame><location>0.03 0 0</location><radius>0.03</radius>\
         </ContactSphere></objects></ContactGeometrySet><ForceSet><objects>{}{}</objects></ForceSet></Model></OpenSimDocument>",
        force("heel"),
        force("toe")
    );
    Model::parse(text).unwrap()
}

fn levelled_spheres_of(model: &Model) -> Result<Vec<LevelledSphere>, NotLevelled> {
    levelled_spheres(model, &model.force_ids())
}

#[track_caller]
fn assert_toe(model: &Model, expected: [f64; 3]) {
    let moved = levelled_spheres_of(model).unwrap();
    let [toe] = moved.as_slice() else { panic!("{moved:?}") };
    assert_eq!(model.sphere(toe.sphere).unwrap().name, "toe");
    let close = toe.location_m.iter().zip(expected).all(|(is, wanted)| (is - wanted).abs() < 1e-15);
    assert!(close, "{:?}, expected {expected:?}", toe.location_m);
}

#[test]
fn the_higher_sphere_comes_down_in_its_own_frame() {
    // The foot's y is the frame's x: 0.03 - 0.06.
    assert_toe(&foot_model("foot_r", 0.0), [-0.03, 0.0, 0.0]);
}

#[test]
fn on_a_slope_the_higher_sphere_comes_down_along_the_normal() {
    let (sin, cos) = (0.03_f64.sin(), 0.03_f64.cos());
    // Along n = (-sin, cos, 0) the heel is at 0.48 cos - 0.04 and the toe, which is at (0.2, 0.53), at 0.53 cos - 0.2 sin - 0.03; n is
    // (cos, sin, 0) in the frame.
    let down = 0.05 * cos - 0.2 * sin + 0.01;
    assert_toe(&foot_model("foot_r", 0.03), [0.03 - down * cos, -down * sin, 0.0]);
}

#[test]
fn a_foot_that_leans_is_not_made_level() {
    // 0.06 rad are 3.4 degrees.
    let Err(fault) = levelled_spheres_of(&foot_model("foot_r", 0.06)) else { panic!("it is made level") };
    assert!(matches!(fault, NotLevelled::Leans { .. }));
    let said = fault.to_string();
    assert!(
        said.starts_with("the foot of limb foot_r is tilted by 3.4 degrees at the default pose (heel)"),
        "{said}"
    );
}

#[test]
fn spheres_without_known_limbs_are_not_made_level() {
    let Err(fault) = levelled_spheres_of(&foot_model("block", 0.0)) else { panic!("it is made level") };
    assert!(matches!(fault, NotLevelled::NoLimbs { .. }), "{fault}");
}
