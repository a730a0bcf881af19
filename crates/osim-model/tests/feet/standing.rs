//! Tests of bodies that stand on floors, computed by hand with (1) and E* = stiffness/2^(3/2) (A.4). `tests/oracle/test_standing.py`
//! compares with OpenSim itself.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::feet::{LiftingCoordinate, NotLifted, RestLaw, RestOnFloor, Standing};
use osim_model::{Model, SphereId};

/// E* = 375,000 N/m2: a sphere of radius 0.04 m at a depth of 0.01 m carries 4/3 E* 0.2 m^1/2 0.001 m^3/2 = 100 N.
const STIFFNESS: f64 = 375_000.0 * 2.0 * std::f64::consts::SQRT_2;

/// A coordinate of a joint that moves a body against its parent along one axis.
struct Slider<'c> {
    coordinate: &'c str,
    axis: &'c str,
    more: &'c str,
}

const VERTICAL_SLIDER: Slider<'_> =
    Slider { coordinate: "height", axis: "0 1 0", more: "<default_value>0.5</default_value>" };

fn body_xml(name: &str, mass: f64) -> String {
    format!("<Body name=\"{name}\"><mass>{mass}</mass></Body>")
}

fn frame_element(body: &str) -> String {
    if body == "ground" { "/ground".into() } else { format!("/bodyset/{body}") }
}

fn joint_xml(parent: &str, child: &str, moves: &[Slider<'_>]) -> String {
    let coordinates =
        moves.iter().map(|one| format!("<Coordinate name=\"{}\">{}</Coordinate>", one.coordinate, one.more));
    let axes = moves.iter().enumerate().map(|(number, one)| {
        format!(
            "<TransformAxis name=\"translation{}\"><coordinates>{}</coordinates><axis>{}</axis><LinearFunction><coefficients>1 0\
             </coefficients></LinearFunction></TransformAxis>",
            number + 1, one.coordinate, one.axis
        )
    });
    format!(
        "<CustomJoint name=\"{parent}_{child}\"><socket_parent_frame>{}</socket_parent_frame><socket_child_frame>{}\
         </socket_child_frame><coordinates>{}</coordinates><SpatialTransform>{}</SpatialTransform></CustomJoint>",
        frame_element(parent),
        frame_element(child),
        coordinates.collect::<String>(),
        axes.collect::<String>()
    )
}

/// A sphere of radius 0.04 m at a height in its body.
fn sphere_xml(name: &str, body: &str, height: f64) -> String {
    format!(
        "<ContactSphere name=\"{name}\"><socket_frame>{}</socket_frame><location>0 {height} 0</location><radius>0.04</radius>\
         </ContactSphere>",
        frame_element(body)
    )
}

/// A floor through the origin of a body. Its normal is turned about z from up by `slope`.
fn floor_xml(name: &str, body: &str, slope: f64) -> String {
    let turned = slope - std::f64::consts::FRAC_PI_2;
    format!(
        "<ContactHalfSpace name=\"{name}\"><socket_frame>{}</socket_frame><orientation>0 0 {turned}</orientation></ContactHalfSpace>",
        frame_element(body)
    )
}

fn force_xml(name: &str, surfaces: &str) -> String {
    format!(
        "<HuntCrossleyForce name=\"{name}\"><HuntCrossleyForce::ContactParametersSet><objects>\
         <HuntCrossleyForce::ContactParameters><geometry>{surfaces}</geometry><stiffness>{STIFFNESS}</stiffness>\
         <dissipation>1</dissipation></HuntCrossleyForce::ContactParameters></objects>\
         </HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>"
    )
}

struct ModelParts {
    bodies: String,
    joints: String,
    surfaces: String,
    forces: String,
    constraints: String,
}

impl ModelParts {
    fn model(&self) -> Model {
        let Self { bodies, joints, surfaces, forces, constraints } = self;
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model><gravity>0 -10 0</gravity><BodySet><objects>{bodies}</objects></BodySet>\
             <JointSet><objects>{joints}</objects></JointSet><ContactGeometrySet><objects>{surfaces}</objects></ContactGeometrySet>\
             <ForceSet><objects>{forces}</objects></ForceSet><ConstraintSet><objects>{constraints}</objects></ConstraintSet></Model>\
             </OpenSimDocument>"
        );
        Model::parse(text).unwrap()
    }

    fn standing(&self) -> Vec<Standing> {
        let model = self.model();
        Standing::all(&model, &model.force_ids()).unwrap()
    }

    fn only_standing(&self) -> Standing {
        let mut all = self.standing();
        assert_eq!(all.len(), 1);
        all.remove(0)
    }
}

/// A foot with spheres at these heights in the foot, joined to ground by `joints`.
fn foot_on_spheres(mass: f64, heights: &[f64], joints: String) -> ModelParts {
    let names: Vec<String> = (0..heights.len()).map(|number| format!("s{number}")).collect();
    let spheres: String =
        names.iter().zip(heights).map(|(name, height)| sphere_xml(name, "foot", *height)).collect();
    ModelParts {
        bodies: body_xml("foot", mass),
        joints,
        surfaces: spheres + &floor_xml("floor", "ground", 0.0),
        forces: force_xml("contact", &format!("{} floor", names.join(" "))),
        constraints: String::new(),
    }
}

fn foot_on_vertical_slider(mass: f64, heights: &[f64]) -> ModelParts {
    foot_on_spheres(mass, heights, joint_xml("ground", "foot", &[VERTICAL_SLIDER]))
}

fn resting_on_all_spheres(standing: &Standing) -> RestOnFloor {
    let all: Vec<SphereId> = standing.spheres.iter().map(|over| over.sphere).collect();
    standing.rest_on_floor(&all, 1.0).unwrap().unwrap()
}

fn lift_of(standing: &Standing) -> &LiftingCoordinate {
    standing.lift.as_ref().unwrap()
}

fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-13
}

#[test]
fn one_sphere_carries_100_n_at_0_01_m() {
    let standing = foot_on_vertical_slider(10.0, &[-0.1]).only_standing();
    assert_eq!((standing.top.as_str(), standing.mass_kg, standing.load_n), ("foot", Some(10.0), Some(100.0)));
    assert!(is_close(standing.spheres[0].gap_m, 0.5 - 0.1 - 0.04) && standing.spheres[0].tilt_rad < 1e-12);
    assert_eq!((lift_of(&standing).coordinate.as_str(), lift_of(&standing).default_m), ("height", 0.5));
    let rest = resting_on_all_spheres(&standing);
    assert!(is_close(rest.spheres[0].relative_indentation, 0.25), "{rest:?}");
    assert!((rest.spheres[0].force_n - 100.0).abs() < 1e-10 && rest.is_carried());
    assert!(is_close(standing.coordinate_at(rest.down_m).unwrap(), 0.14 - 0.01), "{rest:?}");
    assert!(is_close(standing.coordinate_at(standing.spheres[0].gap_m).unwrap(), 0.14));
}

/// Depths of x = 0.01 m and 0.0025 m: x^(3/2) is 0.001 and 0.000125, which carry 100 and 12.5 N.
#[test]
fn the_lower_of_two_spheres_carries_more_weight() {
    let standing = foot_on_vertical_slider(11.25, &[-0.1, -0.1 + 0.0075]).only_standing();
    let rest = resting_on_all_spheres(&standing);
    let [low, high] = rest.spheres[..] else { panic!("two") };
    assert!((low.force_n - 100.0).abs() < 1e-9 && (high.force_n - 12.5).abs() < 1e-9, "{rest:?}");
    assert!(is_close(low.relative_indentation, 0.25) && is_close(high.relative_indentation, 0.0625));
    assert!(low.touches() && high.touches());
}

#[test]
fn a_sphere_above_the_floor_carries_nothing_until_it_is_the_only_one() {
    let standing = foot_on_vertical_slider(10.0, &[-0.1, -0.08]).only_standing();
    let both = resting_on_all_spheres(&standing);
    assert!(
        is_close(both.spheres[0].relative_indentation, 0.25)
            && is_close(both.spheres[1].relative_indentation, -0.25)
    );
    assert!(both.spheres[1].force_n == 0.0 && !both.spheres[1].touches());
    let high = standing.spheres[1].sphere;
    let alone = standing.rest_on_floor(&[high], 1.0).unwrap().unwrap();
    assert!(is_close(alone.down_m, both.down_m + 0.02) && alone.spheres.len() == 1);
    // Half of the weight on one of two limbs: x goes with F^(2/3).
    let half = standing.rest_on_floor(&[high], 0.5).unwrap().unwrap();
    assert!(is_close(half.spheres[0].relative_indentation, 0.25 * 0.5_f64.powf(2.0 / 3.0)));
    let hertz = standing.rest_under(&[high], 100.0, RestLaw::Hertz).unwrap().unwrap();
    assert!(is_close(hertz.down_m, alone.down_m));
}

/// At a depth of 0.04 m, the radius, the sphere carries eight times the weight. No greater depth is allowed.
#[test]
fn a_sphere_sunk_to_its_centre_cannot_carry_the_load() {
    assert!(!resting_on_all_spheres(&foot_on_vertical_slider(80.001, &[-0.1]).only_standing()).is_carried());
    assert!(resting_on_all_spheres(&foot_on_vertical_slider(79.999, &[-0.1]).only_standing()).is_carried());
}

/// The normal leans by 0.6 and 0.8: the weight of 100 N has the part 80 N along it, and 1 m of height is 0.8 m along it.
#[test]
fn on_a_slope_the_part_along_the_normal_counts() {
    let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
    parts.surfaces = sphere_xml("s0", "foot", -0.1) + &floor_xml("floor", "ground", 0.6_f64.asin());
    let standing = parts.only_standing();
    assert!(
        is_close(standing.load_n.unwrap(), 80.0) && is_close(lift_of(&standing).rise, 0.8),
        "{standing:?}"
    );
    // The foot is upright, the floor is not.
    assert!(is_close(standing.spheres[0].tilt_rad, 0.6_f64.asin()));
    // Its centre is 0.4 m over the origin: 0.32 m from the plane.
    assert!(is_close(standing.spheres[0].gap_m, 0.32 - 0.04));
    let rest = resting_on_all_spheres(&standing);
    assert!(is_close(rest.spheres[0].relative_indentation * 0.04, 0.01 * 0.8_f64.powf(2.0 / 3.0)));
    let down = standing.coordinate_at(rest.down_m).unwrap() - 0.5;
    assert!(is_close(down * 0.8, -rest.down_m));
}

fn pin_xml(parent: &str, child: &str, angle_rad: f64) -> String {
    format!(
        "<PinJoint name=\"{parent}_{child}\"><socket_parent_frame>{}</socket_parent_frame><socket_child_frame>{}</socket_child_frame>\
         <coordinates><Coordinate name=\"{child}_angle\"><default_value>{angle_rad}</default_value></Coordinate></coordinates></PinJoint>",
        frame_element(parent),
        frame_element(child),
    )
}

/// A trunk on a foot, with the angles of both.
fn tilt_of_foot(trunk_rad: f64, foot_rad: f64) -> f64 {
    let joints = pin_xml("ground", "trunk", trunk_rad) + &pin_xml("trunk", "foot", foot_rad);
    let mut parts = foot_on_spheres(1.0, &[-0.1], joints);
    parts.bodies.push_str(&body_xml("trunk", 50.0));
    parts.only_standing().spheres[0].tilt_rad
}

#[test]
fn a_foot_of_a_body_that_lies_is_tilted() {
    for lying_rad in [1.5, -1.5] {
        assert!((tilt_of_foot(lying_rad, 0.0) - 1.5).abs() < 1e-12);
    }
    // A trunk that bends forward over a flat foot.
    assert!(tilt_of_foot(1.2, -1.2) < 1e-12);
    // A foot that hangs down from an upright trunk with its coordinate at 0.
    assert!((tilt_of_foot(0.0, 1.5) - (std::f64::consts::FRAC_PI_2 - 1.5)).abs() < 1e-12);
}

#[test]
fn a_coordinate_with_a_downward_axis_grows_when_the_body_sinks() {
    let down = Slider { coordinate: "depth", axis: "0 -1 0", more: "<default_value>-0.5</default_value>" };
    let standing = foot_on_spheres(10.0, &[-0.1], joint_xml("ground", "foot", &[down])).only_standing();
    assert_eq!(lift_of(&standing).rise, -1.0);
    assert!(is_close(standing.coordinate_at(resting_on_all_spheres(&standing).down_m).unwrap(), -0.13));
}

/// The coordinate below the cart moves only the foot; the cart stays above.
#[test]
fn the_load_is_the_weight_of_the_bodies_that_the_coordinate_moves() {
    let along = Slider { coordinate: "along", axis: "1 0 0", more: "" };
    let mut parts = foot_on_spheres(
        10.0,
        &[-0.1],
        joint_xml("ground", "cart", &[along]) + &joint_xml("cart", "foot", &[VERTICAL_SLIDER]),
    );
    parts.bodies.push_str(&body_xml("cart", 7.0));
    let standing = parts.only_standing();
    assert_eq!((standing.top.as_str(), standing.mass_kg), ("cart", Some(10.0)));
}

/// All bodies below the trunk count, also those on side branches: 1 + 2 + 4 + 8 + 16 kg.
#[test]
fn the_load_includes_all_bodies_below_the_joint() {
    let mut parts = foot_on_spheres(1.0, &[-0.1], String::new());
    parts.bodies = ["trunk 2", "arm 4", "leg 8", "head 16", "foot 1"]
        .map(|one| one.split_once(' ').map(|(name, mass)| body_xml(name, mass.parse().unwrap())).unwrap())
        .concat();
    parts.joints = joint_xml("ground", "trunk", &[VERTICAL_SLIDER]);
    for (above, below) in [("trunk", "arm"), ("trunk", "leg"), ("trunk", "head"), ("leg", "foot")] {
        parts.joints.push_str(&joint_xml(above, below, &[]));
    }
    assert_eq!(parts.only_standing().mass_kg, Some(31.0));
}

/// A platform, locked or free, does not lift the foot from itself, and its mass does not count.
#[test]
fn a_platform_under_a_foot_does_not_count_as_standing() {
    for more in ["<locked>true</locked>", ""] {
        let plate = Slider { coordinate: "plate_ty", axis: "0 1 0", more };
        let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
        parts.bodies.push_str(&body_xml("plate", 300.0));
        parts.joints.push_str(&joint_xml("ground", "plate", &[plate]));
        parts.surfaces = sphere_xml("s0", "foot", -0.1) + &floor_xml("floor", "plate", 0.0);
        let standing = parts.only_standing();
        assert_eq!((lift_of(&standing).coordinate.as_str(), standing.mass_kg), ("height", Some(10.0)));
        // A foot that is joined to the platform, too.
        parts.joints =
            joint_xml("ground", "plate", &[Slider { coordinate: "plate_ty", axis: "0 1 0", more }])
                + &joint_xml("plate", "foot", &[VERTICAL_SLIDER]);
        let standing = parts.only_standing();
        assert_eq!((lift_of(&standing).coordinate.as_str(), standing.mass_kg), ("height", Some(10.0)));
    }
}

#[test]
fn a_ball_stands_apart_from_the_foot() {
    let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
    parts.bodies.push_str(&body_xml("ball", 0.5));
    parts.joints.push_str(&joint_xml(
        "ground",
        "ball",
        &[Slider { coordinate: "ball_ty", axis: "0 1 0", more: "" }],
    ));
    parts.surfaces.push_str(&sphere_xml("ball_surface", "ball", 0.0));
    parts.forces.push_str(&force_xml("ball_contact", "ball_surface floor"));
    let all = parts.standing();
    let found: Vec<_> =
        all.iter().map(|one| (one.top.as_str(), one.mass_kg, lift_of(one).coordinate.as_str())).collect();
    assert_eq!(found, [("foot", Some(10.0), "height"), ("ball", Some(0.5), "ball_ty")]);
}

#[test]
fn a_body_that_no_coordinate_lifts_has_a_reason() {
    let why = |joints: String| foot_on_spheres(10.0, &[-0.1], joints).only_standing().lift.unwrap_err();
    let weld = "<WeldJoint name=\"w\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/foot\
                </socket_child_frame></WeldJoint>";
    // What a WeldJoint holds on ground is terrain.
    assert_eq!(why(joint_xml("ground", "foot", &[])), NotLifted::Welded);
    assert_eq!(why(weld.replace("Weld", "Pin")), NotLifted::Pinned);
    // Its axis is x.
    assert_eq!(why(weld.replace("Weld", "Slider")), NotLifted::Slides);
    let held = |more| why(joint_xml("ground", "foot", &[Slider { more, ..VERTICAL_SLIDER }]));
    assert_eq!(held("<locked>true</locked>"), NotLifted::Locked { coordinate: "height".into() });
    let prescribed = "<prescribed>true</prescribed><prescribed_function><Constant><value>0.5</value></Constant></prescribed_function>";
    assert_eq!(held(prescribed), NotLifted::Driven { coordinate: "height".into() });
    let along = Slider { coordinate: "along", axis: "1 0 0", more: "" };
    let mut coupled = foot_on_spheres(10.0, &[-0.1], joint_xml("ground", "foot", &[VERTICAL_SLIDER, along]));
    coupled.constraints = "<CoordinateCouplerConstraint name=\"c\"><coupled_coordinates_function><LinearFunction><coefficients>1 0\
                           </coefficients></LinearFunction></coupled_coordinates_function><independent_coordinate_names>along\
                           </independent_coordinate_names><dependent_coordinate_name>height</dependent_coordinate_name>\
                           </CoordinateCouplerConstraint>"
        .to_owned();
    assert_eq!(coupled.only_standing().lift, Err(NotLifted::Driven { coordinate: "height".into() }));
}

/// OpenSim makes the coordinates of a FreeJoint that the file does not contain: three that turn, then three that move.
#[test]
fn coordinates_missing_in_the_file_are_those_that_opensim_makes() {
    let free = "<FreeJoint name=\"free\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/foot\
                </socket_child_frame></FreeJoint>";
    let standing = foot_on_spheres(10.0, &[-0.1], free.to_owned()).only_standing();
    assert_eq!(lift_of(&standing).joint, "free");
    assert_eq!((lift_of(&standing).coordinate.as_str(), lift_of(&standing).default_m), ("_coord_4", 0.0));
}

#[test]
fn floors_of_two_directions_are_refused_and_walls_are_ignored() {
    let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
    parts.surfaces.push_str(&floor_xml("slope", "ground", 0.1));
    parts.forces.push_str(&force_xml("other", "s0 slope"));
    assert_eq!(parts.only_standing().lift, Err(NotLifted::SeveralFloors));
    let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
    parts.surfaces.push_str(&floor_xml("wall", "ground", 1.5));
    parts.forces.push_str(&force_xml("other", "s0 wall"));
    let standing = parts.only_standing();
    assert_eq!(lift_of(&standing).coordinate, "height");
    // What would press it on the wall carries nothing.
    assert!(is_close(resting_on_all_spheres(&standing).spheres[0].relative_indentation, 0.25));
}

/// A sphere on two planes of one force and on one plane of another. At a depth of 0.01 m, each plane carries 100 N.
#[test]
fn a_sphere_on_two_floors_is_carried_by_both() {
    let mut parts = foot_on_vertical_slider(20.0, &[-0.1]);
    parts.surfaces.push_str(&floor_xml("second", "ground", 0.0));
    parts.forces.push_str(&force_xml("other", "s0 second"));
    let rest = resting_on_all_spheres(&parts.only_standing());
    assert_eq!(rest.spheres.len(), 1);
    assert!(
        is_close(rest.spheres[0].relative_indentation, 0.25)
            && (rest.spheres[0].force_n - 200.0).abs() < 1e-9
    );
}

#[test]
fn a_body_at_an_unknown_place_is_an_error() {
    let model = foot_on_spheres(10.0, &[-0.1], String::new()).model();
    assert!(Standing::all(&model, &model.force_ids()).unwrap_err().to_string().contains("foot"));
}

/// If a mass cannot be read, heights are known, and the weight is not.
#[test]
fn without_a_mass_there_is_no_weight() {
    let mut parts = foot_on_vertical_slider(10.0, &[-0.1]);
    parts.bodies = parts.bodies.replace("<mass>10</mass>", "<mass>heavy</mass>");
    let standing = parts.only_standing();
    assert_eq!((standing.mass_kg, standing.load_n), (None, None));
    assert!(standing.rest_on_floor(&[standing.spheres[0].sphere], 1.0).is_none());
    assert!(is_close(standing.spheres[0].gap_m, 0.36));
}
