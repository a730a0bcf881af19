//! Prints, for the oracle, where spheres and joints of feet are at the default pose.
//!
//! `scene MODEL` gives a line of JSON for each foot, in the frame in which it is drawn.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a helper of tests"
)]

use osim_model::feet::{DefaultPose, FloorPlace, Foot, FootBodies, FootFrame};
use osim_model::{Anatomy, Model, SphereId};

fn main() {
    let path = std::env::args().nth(1).unwrap();
    let model = Model::parse(std::fs::read(path).unwrap()).unwrap();
    let anatomy = Anatomy::of(&model).unwrap();
    let pose = DefaultPose::of(&model);
    let moving: Vec<SphereId> =
        model.spheres().iter().filter(|sphere| !sphere.fixed).map(|sphere| sphere.id).collect();
    let bodies = FootBodies::find(&model, &anatomy, &moving, &model.force_ids(), &pose);
    for foot in Foot::all(&model, &anatomy, &bodies, &pose) {
        let spheres = foot.spheres.iter().map(|sphere| {
            let (name, centre, radius) = (&sphere.name, sphere.centre_m.to_array(), sphere.radius_m);
            format!("{{\"name\": {name:?}, \"centre\": {centre:?}, \"radius\": {radius:?}}}")
        });
        let joints = foot.joints.iter().map(|joint| {
            let (name, at) = (&joint.name, joint.at_m.to_array());
            format!("{{\"name\": {name:?}, \"at\": {at:?}}}")
        });
        let floor = match foot.floor {
            FloorPlace::At(height) => format!("{height:?}"),
            _ => "null".to_owned(),
        };
        println!(
            "{{\"name\": {:?}, \"in_ground\": {}, \"spheres\": [{}], \"joints\": [{}], \"floor\": {floor}, \"lowest\": {:?}}}",
            foot.name,
            foot.frame == FootFrame::Ground,
            spheres.collect::<Vec<_>>().join(", "),
            joints.collect::<Vec<_>>().join(", "),
            foot.lowest_m().unwrap_or(0.0),
        );
    }
}
