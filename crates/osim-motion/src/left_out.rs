//! What OpenSim leaves out of a force with several pairs.

use std::collections::HashMap;

use osim_model::ForceId;

use crate::states::ContactStates;

/// Pairs that OpenSim may leave out: once one pair of a `HuntCrossleyForce` would pull, Simbody leaves out those of the same force that
/// come after it, in an order of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LeftOut {
    /// In how many frames a pair would pull while others of its force push.
    pub frames: usize,
    /// The most that these others push in such a frame, N.
    pub most_n: f64,
}

impl LeftOut {
    /// What may be left out along `states`; `None` where nothing is.
    #[must_use]
    pub fn of(states: &ContactStates) -> Option<Self> {
        let mut found = Self { frames: 0, most_n: 0.0 };
        for frame in 0..states.frames() {
            // For each force: whether a pair would pull, and what the others push, N.
            let mut forces: HashMap<ForceId, (bool, f64)> = HashMap::new();
            let all = states.pairs.iter().zip(states.frame(frame));
            for (pair, state) in all.filter(|(pair, _)| pair.applies && pair.smoothing.is_none()) {
                let (pulls, pushed_n) = forces.entry(pair.force).or_default();
                *pulls |= state.indentation_m > 0.0 && state.normal_force_n <= 0.0;
                *pushed_n += state.normal_force_n;
            }
            let lost = forces.values().filter(|(pulls, pushed_n)| *pulls && *pushed_n > 0.0);
            let most_n = lost.map(|(_, pushed_n)| *pushed_n).fold(0.0, f64::max);
            if most_n > 0.0 {
                found.frames += 1;
                found.most_n = found.most_n.max(most_n);
            }
        }
        (found.frames > 0).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use osim_model::Model;

    use super::*;
    use crate::recording::{Recording, RecordingOptions};
    use crate::table::Table;

    /// A body of two spheres, 1 m behind and 1 m ahead of its joint, in one force, with a dissipation of 2 s/m.
    fn see_saw() -> Model {
        let sphere = |name: &str, x: i32| {
            format!(
                "<ContactSphere name=\"{name}\"><socket_frame>/bodyset/b</socket_frame><location>{x} 0 0</location><radius>0.03</radius>\
                 </ContactSphere>"
            )
        };
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects><Body name=\"b\"><mass>1</mass></Body></objects></BodySet><JointSet>\
             <objects><PlanarJoint name=\"j\"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/b\
             </socket_child_frame><coordinates><Coordinate name=\"turn\"/><Coordinate name=\"x\"/><Coordinate name=\"y\"/></coordinates>\
             </PlanarJoint></objects></JointSet><ContactGeometrySet><objects>{}{}<ContactHalfSpace name=\"floor\"><socket_frame>/ground\
             </socket_frame><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace></objects></ContactGeometrySet><ForceSet>\
             <objects><HuntCrossleyForce name=\"f\"><contact_parameters><HuntCrossleyForce::ContactParametersSet><objects>\
             <HuntCrossleyForce::ContactParameters><geometry>back front floor</geometry><stiffness>1e6</stiffness><dissipation>2\
             </dissipation></HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></contact_parameters>\
             </HuntCrossleyForce></objects></ForceSet></Model></OpenSimDocument>",
            sphere("back", -1),
            sphere("front", 1)
        );
        Model::parse(text).unwrap()
    }

    fn turning(rad_s: f64) -> Option<LeftOut> {
        let names = ["turn", "x", "y"]
            .map(|name| format!("/jointset/j/{name}/value\t/jointset/j/{name}/speed"))
            .join("\t");
        let text = format!("inDegrees=no\nendheader\ntime\t{names}\n0\t0\t{rad_s}\t0\t0\t0.02\t0\n");
        let model = see_saw();
        let table = Table::read(text.as_bytes()).unwrap();
        let recording = Recording::of(&model, &table, &RecordingOptions::default()).unwrap();
        LeftOut::of(&ContactStates::of(&model, &recording, &model.force_ids(), [0.0; 3]).unwrap())
    }

    #[test]
    fn a_pair_that_would_pull_is_seen() {
        // Both are 1 cm deep. At 1 rad/s the one ahead leaves at 1 m/s, faster than 2/(3α) = 1/3 m/s, and the one behind goes in:
        // 4/3 E √R x^(3/2) (1 + 3/2 · 2 · 1) with E = 1e6/2^(3/2): 81.65 N times 4.
        let found = turning(1.0).unwrap();
        assert_eq!(found.frames, 1);
        assert!((found.most_n - 326.6).abs() < 0.01, "{found:?}");
        // At 0.3 rad/s both push.
        assert_eq!(turning(0.3), None);
    }
}
