//! Bodies with random scale factors: spheres that follow them have the places and radii that follow from the factors.

use std::path::Path;

use osim_model::files::{CompanionPaths, InMemory};
use osim_planning::{open_with, prepare};
use osim_requests::Request;
use serde_json::json;

use crate::random::{Random, seeds};

const FEET: [&str; 2] = ["calcn_r", "calcn_l"];

struct Sphere {
    name: String,
    body: usize,
    place: [f64; 3],
    radius: f64,
}

/// The text of a model with a pelvis and two feet scaled by `factors`. The spheres stay at their places.
fn scaled_model(factors: &[[f64; 3]; 3], hips: &[[f64; 3]; 2], spheres: &[Sphere], mass: f64) -> String {
    let triple = |values: [f64; 3]| values.map(|value| value.to_string()).join(" ");
    let body = |(name, factors): (&str, &[f64; 3])| {
        format!(
            "<Body name=\"{name}\"><attached_geometry><Mesh name=\"bone\"><scale_factors>{}</scale_factors>\
             <mesh_file>{name}.vtp</mesh_file></Mesh></attached_geometry><mass>{}</mass></Body>",
            triple(*factors),
            mass / 3.0
        )
    };
    let bodies: String = ["pelvis", FEET[0], FEET[1]].into_iter().zip(factors).map(body).collect();
    let hip = |(foot, place): (&str, &[f64; 3])| {
        let place = std::array::from_fn(|axis| place[axis] * factors[0][axis]);
        format!(
            "<PinJoint name=\"hip_{foot}\"><socket_parent_frame>offset</socket_parent_frame><socket_child_frame>/bodyset/{foot}\
             </socket_child_frame><frames><PhysicalOffsetFrame name=\"offset\"><socket_parent>/bodyset/pelvis</socket_parent>\
             <translation>{}</translation></PhysicalOffsetFrame></frames></PinJoint>",
            triple(place)
        )
    };
    let hips: String = FEET.into_iter().zip(hips).map(hip).collect();
    let geometry = |sphere: &Sphere| {
        format!(
            "<ContactSphere name=\"{}\"><socket_frame>/bodyset/{}</socket_frame><location>{}</location><radius>{}</radius></ContactSphere>",
            sphere.name,
            FEET[sphere.body],
            triple(sphere.place),
            sphere.radius
        )
    };
    let force = |sphere: &Sphere| {
        format!(
            "<SmoothSphereHalfSpaceForce name=\"push_{0}\"><socket_sphere>/contactgeometryset/{0}</socket_sphere>\
             <socket_half_space>/contactgeometryset/floor</socket_half_space><stiffness>1e6</stiffness></SmoothSphereHalfSpaceForce>",
            sphere.name
        )
    };
    format!(
        "<OpenSimDocument Version=\"40000\"><Model name=\"m\"><gravity>0 -9.8 0</gravity><BodySet><objects>{bodies}</objects></BodySet>\
         <JointSet><objects><FreeJoint name=\"root\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/pelvis\
         </socket_child_frame></FreeJoint>{hips}</objects></JointSet><ContactGeometrySet><objects><ContactHalfSpace name=\"floor\">\
         <socket_frame>/ground</socket_frame><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace>{}</objects>\
         </ContactGeometrySet><ForceSet><objects>{}</objects></ForceSet></Model></OpenSimDocument>",
        spheres.iter().map(geometry).collect::<String>(),
        spheres.iter().map(force).collect::<String>(),
    )
}

/// A random scale factor between a third and three; sometimes it is exactly 1.
fn random_factor(random: &mut Random) -> f64 {
    if random.integer_below(5) == 0 { 1.0 } else { 3_f64.powf(2.0 * random.fraction() - 1.0) }
}

#[test]
fn spheres_follow_their_bodies() {
    let one = [[1.0; 3]; 3];
    for seed in seeds() {
        let mut random = Random::of(seed);
        let mut factors = one;
        for body in &mut factors {
            let alike = random_factor(&mut random);
            let is_alike = random.integer_below(2) == 0;
            *body = std::array::from_fn(|_| if is_alike { alike } else { random_factor(&mut random) });
        }
        let hips =
            [0.1, -0.1].map(|side| [0.02 * random.fraction() + 0.01, -0.9 + 0.1 * random.fraction(), side]);
        let radius = 0.01 + 0.05 * random.fraction();
        let count = 1 + random.index(3);
        let mut spheres = Vec::new();
        for (body, side) in ["r", "l"].into_iter().enumerate() {
            for number in 0..count {
                let place = [
                    0.2 * random.fraction() - 0.05,
                    -0.03 * random.fraction(),
                    0.08 * random.fraction() - 0.04,
                ];
                spheres.push(Sphere { name: format!("s{number}_{side}"), body, place, radius });
            }
        }
        let (old, new) = (30.0 + 50.0 * random.fraction(), 20.0 + 100.0 * random.fraction());
        let mut files = InMemory::default();
        files.add("generic.osim", scaled_model(&one, &hips, &spheres, old).into_bytes());
        let scaled = scaled_model(&factors, &hips, &spheres, new);
        files.add("scaled.osim", scaled.clone().into_bytes());
        let by_mass = random.integer_below(2) == 0;
        let mut call = json!({"verb": "transfer", "models": ["scaled.osim"], "from": "generic.osim", "follow_bodies": true, "yes": ["implausible-radius"]});
        if !by_mass {
            call["radius"] = json!("follow");
        }
        let change = prepare(Request::from_json(call.to_string().as_bytes()).unwrap(), &files);
        let change = change.unwrap_or_else(|error| panic!("seed {seed}: {error:?}\n{scaled}"));
        let opened = open_with(Path::new("scaled.osim"), CompanionPaths::default(), &files).unwrap();
        let plan = change.plan_alone(&opened.model);
        let plan = plan.unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{scaled}"));
        let changed = plan.changed_model(&opened.model).unwrap();
        for (sphere, read) in spheres.iter().zip(changed.spheres()) {
            let own = factors[sphere.body + 1];
            let near =
                |found: f64, expected: f64| (found - expected).abs() <= 1e-9 * expected.abs().max(1e-3);
            let ratio = if by_mass { new / old } else { own.iter().product::<f64>() };
            let radius = sphere.radius * ratio.cbrt();
            assert!(
                near(read.radius.number, radius),
                "seed {seed}, {}: {} {radius}",
                sphere.name,
                read.radius.number
            );
            for (axis, factor) in own.iter().enumerate() {
                // The lowest point of a sphere whose radius follows the mass stays on the scaled sole.
                let expected = if by_mass && axis == 1 {
                    (sphere.place[axis] - sphere.radius) * factor + radius
                } else {
                    sphere.place[axis] * factor
                };
                let found = read.location_m[axis];
                assert!(near(found, expected), "seed {seed}, {}: {found} {expected}\n{scaled}", sphere.name);
            }
        }
    }
}
