//! Tests of planes with the spheres that press on them, and of movements of bodies. The expected numbers were computed by hand.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::f64::consts::{FRAC_PI_2, PI};

use osim_model::feet::{ContactPlane, DefaultPose, Movements, PlaneSurface};
use osim_model::{DVec3, Model, Rotation};

/// A ball over a platform, each on a joint of its own. `platform` is the XML of the platform's joint; `plane` and `forces` are the XML of
/// the geometry.
fn model_with_platform(platform: &str, plane: &str, forces: &str) -> Model {
    let text = format!(
        "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><gravity>0 -10 0</gravity><BodySet><objects><Body name=\"platform\">\
         <mass>1</mass></Body><Body name=\"ball\"><mass>1</mass></Body><Body name=\"handle\"><mass>1</mass></Body></objects>\
         </BodySet><JointSet><objects>{platform}<FreeJoint name=\"b\"><socket_parent_frame>/ground</socket_parent_frame>\
         <socket_child_frame>/bodyset/ball</socket_child_frame></FreeJoint><WeldJoint name=\"w\"><socket_parent_frame>\
         /bodyset/platform</socket_parent_frame><socket_child_frame>/bodyset/handle</socket_child_frame></WeldJoint></objects>\
         </JointSet><ForceSet><objects>{forces}</objects></ForceSet><ContactGeometrySet><objects>{plane}{}{}{}</objects>\
         </ContactGeometrySet></Model></OpenSimDocument>",
        sphere_xml("ball"),
        sphere_xml("platform"),
        sphere_xml("handle"),
    );
    Model::parse(text).unwrap()
}

fn sphere_xml(body: &str) -> String {
    format!(
        "<ContactSphere name=\"{body}_s\"><socket_frame>/bodyset/{body}</socket_frame><location>0 0 0</location><radius>0.1</radius>\
         </ContactSphere>"
    )
}

fn half_space_xml(frame: &str, place: &str, orientation: &str) -> String {
    format!(
        "<ContactHalfSpace name=\"floor\"><socket_frame>{frame}</socket_frame><location>{place}</location><orientation>{orientation}\
         </orientation></ContactHalfSpace>"
    )
}

/// A pin joint about z, 2 m along x, at this angle, rad.
fn pin_joint(angle: &str) -> String {
    format!(
        "<PinJoint name=\"p\"><socket_parent_frame>f</socket_parent_frame><socket_child_frame>/bodyset/platform</socket_child_frame>\
         <coordinates><Coordinate name=\"tilt\"><default_value>{angle}</default_value></Coordinate></coordinates><frames>\
         <PhysicalOffsetFrame name=\"f\"><socket_parent>/ground</socket_parent><translation>2 0 0</translation>\
         </PhysicalOffsetFrame></frames></PinJoint>"
    )
}

/// The XML of a force between the floor and all three spheres.
const FORCE_ON_ALL_GEOMETRY: &str = "<HuntCrossleyForce name=\"all\"><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>\
                   <HuntCrossleyForce::ContactParameters><geometry>floor ball_s platform_s handle_s</geometry>\
                   <stiffness>1e6</stiffness></HuntCrossleyForce::ContactParameters></objects>\
                   </HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>";

fn planes_of_model(model: &Model) -> Vec<ContactPlane> {
    ContactPlane::all(model, &model.force_ids(), &DefaultPose::of(model))
}

#[track_caller]
fn surface_of_only_plane(model: &Model) -> PlaneSurface {
    let found = planes_of_model(model);
    let [one] = found.as_slice() else { panic!("{found:?}") };
    one.surface.unwrap()
}

#[track_caller]
fn assert_near(value: impl Into<DVec3>, expected: [f64; 3]) {
    let value = value.into();
    assert!(value.abs_diff_eq(expected.into(), 1e-15), "{value:?}, expected {expected:?}");
}

#[test]
fn a_floor_on_a_platform_turns_with_it() {
    // −x of the half-space is y of the platform, which is turned by 0.3 about z, 2 m along x; its surface is 0.5 above its origin.
    let model = model_with_platform(
        &pin_joint("0.3"),
        &half_space_xml("/bodyset/platform", "0 0.5 0", "0 0 -1.5707963267948966"),
        FORCE_ON_ALL_GEOMETRY,
    );
    let surface = surface_of_only_plane(&model);
    let (sine, cosine) = (0.3_f64.sin(), 0.3_f64.cos());
    assert_near(surface.normal, [-sine, cosine, 0.0]);
    assert_near(surface.point_m, [2.0 - 0.5 * sine, 0.5 * cosine, 0.0]);
    assert!((surface.tilt_rad - 0.3).abs() < 1e-15);
    // Up in the platform, turned back by 0.3.
    let level = Rotation::body_fixed_xyz(surface.level_orientation).to_body([-1.0, 0.0, 0.0]);
    assert_near(level, [sine, cosine, 0.0]);
    assert_eq!(planes_of_model(&model)[0].body.as_deref(), Some("platform"));
}

#[test]
fn only_spheres_that_move_against_a_plane_press_on_it() {
    let names = |model: &Model| -> Vec<String> {
        let found = planes_of_model(model);
        let spheres = found.iter().flat_map(|plane| &plane.spheres);
        spheres.map(|&id| model.sphere(id).unwrap().name.clone()).collect()
    };
    let level = "0 0 -1.5707963267948966";
    // Neither the platform's own sphere nor that of the handle, which is welded to it.
    let carried = model_with_platform(
        &pin_joint("0"),
        &half_space_xml("/bodyset/platform", "0 0 0", level),
        FORCE_ON_ALL_GEOMETRY,
    );
    assert_eq!(names(&carried), ["ball_s"]);
    let on_ground = model_with_platform(
        &pin_joint("0"),
        &half_space_xml("/ground", "0 0 0", level),
        FORCE_ON_ALL_GEOMETRY,
    );
    assert_eq!(names(&on_ground), ["ball_s", "platform_s", "handle_s"]);
    // A platform that is welded to ground, and what is welded to it, are terrain.
    let welded = "<WeldJoint name=\"p\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/platform\
                  </socket_child_frame></WeldJoint>";
    assert_eq!(
        names(&model_with_platform(
            welded,
            &half_space_xml("/ground", "0 0 0", level),
            FORCE_ON_ALL_GEOMETRY
        )),
        ["ball_s"]
    );
    let off = FORCE_ON_ALL_GEOMETRY.replace(
        "<HuntCrossleyForce::ContactParametersSet",
        "<appliesForce>false</appliesForce><HuntCrossleyForce::ContactParametersSet",
    );
    assert!(
        planes_of_model(&model_with_platform(
            &pin_joint("0"),
            &half_space_xml("/ground", "0 0 0", level),
            &off
        ))
        .is_empty()
    );
}

#[test]
fn a_plane_inside_a_force_of_early_moco_is_a_plane() {
    let force = "<SmoothSphereHalfSpaceForce name=\"heel\"><socket_sphere_frame>/bodyset/ball</socket_sphere_frame>\
                 <socket_half_space_frame>/ground</socket_half_space_frame><contact_sphere_radius>0.1</contact_sphere_radius>\
                 <contact_half_space_location>0 0.25 0</contact_half_space_location><contact_half_space_orientation>0 0 \
                 1.5707963267948966</contact_half_space_orientation><stiffness>1e6</stiffness></SmoothSphereHalfSpaceForce>";
    let model = model_with_platform(&pin_joint("0"), "", force);
    let surface = surface_of_only_plane(&model);
    // Upside down: the turn has the other sign.
    assert_near(surface.normal, [0.0, -1.0, 0.0]);
    assert_eq!((surface.point_m, surface.tilt_rad), (DVec3::new(0.0, 0.25, 0.0), PI));
    assert_near(surface.level_orientation, [0.0, 0.0, -FRAC_PI_2]);
    let planes = planes_of_model(&model);
    assert_eq!((planes[0].name.as_str(), planes[0].spheres.len()), ("heel", 1));
    assert_eq!(planes[0].orientations[0].tag, "contact_half_space_orientation");
}

#[test]
fn joints_say_how_bodies_move() {
    let leg = |locked: &str| {
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><BodySet><objects><Body name=\"pelvis\"/><Body name=\"shank\"/>\
             <Body name=\"foot\"/><Body name=\"chair\"/></objects></BodySet><JointSet><objects>\
             <FreeJoint name=\"g\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/pelvis\
             </socket_child_frame></FreeJoint>\
             <PinJoint name=\"knee\"><socket_parent_frame>/bodyset/pelvis</socket_parent_frame><socket_child_frame>/bodyset/shank\
             </socket_child_frame><coordinates><Coordinate name=\"knee\"/></coordinates></PinJoint>\
             <SliderJoint name=\"spring\"><socket_parent_frame>/bodyset/shank</socket_parent_frame><socket_child_frame>/bodyset/foot\
             </socket_child_frame><coordinates><Coordinate name=\"spring\">{locked}</Coordinate></coordinates></SliderJoint>\
             <WeldJoint name=\"c\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/chair\
             </socket_child_frame></WeldJoint></objects></JointSet></Model></OpenSimDocument>"
        );
        Movements::of(&Model::parse(text).unwrap())
    };
    let of = |movements: &Movements, one, other| {
        movements.between(one, other).map(|free| (free.turns, free.slides))
    };
    let leg_free = leg("");
    assert_eq!(of(&leg_free, "pelvis", "shank"), Some((true, false)));
    assert_eq!(of(&leg_free, "foot", "pelvis"), Some((true, true)));
    assert_eq!(of(&leg_free, "shank", "shank"), Some((false, false)));
    // Only through ground.
    assert_eq!(of(&leg_free, "chair", "foot"), None);
    assert!(leg_free.can_move("foot") && !leg_free.can_move("chair"));
    assert_eq!(leg_free.top("foot"), "pelvis");
    assert_eq!(of(&leg("<locked>true</locked>"), "foot", "pelvis"), Some((true, false)));
}
