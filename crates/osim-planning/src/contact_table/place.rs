//! The place of a contact from a table on its body.

use osim_model::DVec3;
use osim_model::feet::{DefaultPose, PoseFault};

/// A frame coincides with ground if its origin and the tips of its axes are at most this far from those of ground, m.
const SAME_FRAME_M: f64 = 1e-9;
/// The global and the local place of a contact agree if their distance is at most this, m.
const SAME_PLACE_M: f64 = 1e-3;

/// The place of a contact as its table gives it, m.
#[derive(Debug, Clone, PartialEq)]
pub enum TablePlace {
    /// A place in the frame of the body.
    OfBody([f64; 3]),
    /// A place from MuSkeMo: in its global frame, in a local frame of the contact, or in both.
    Exported { global_m: Option<[f64; 3]>, local_m: Option<[f64; 3]> },
}

/// The place of a contact in the frame of its body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaceOnBody {
    /// The centre of the contact in the frame of its body, m.
    pub location_m: [f64; 3],
    /// Whether the table gave the place in ground, so that it was converted to the body's frame at the default pose.
    pub from_default_pose: bool,
}

/// The reason why the place of a contact on its body is not known.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaceFault {
    /// The default pose of the body is not known.
    Pose(PoseFault),
    /// The global and the local place have this distance in the model, m.
    Disagree(f64),
    /// Only the global place is given, and nobody confirmed that it was measured at the default pose.
    OnlyGlobal,
}

impl TablePlace {
    /// The place in the frame of `body`. If MuSkeMo exported the table, this is the global place if the body's frame coincides with ground
    /// at the default pose (MuSkeMo's global mode), else the local place. A place that is only given in ground is converted to the body's
    /// frame if `at_default_pose` says that it was measured at the default pose.
    ///
    /// # Errors
    /// Two places that differ by more than 1 mm, a global one alone, or a body whose place is not known.
    pub fn on_body<'p>(
        &self,
        body: &str,
        pose: impl FnOnce() -> &'p DefaultPose,
        at_default_pose: bool,
    ) -> Result<PlaceOnBody, PlaceFault> {
        let as_given = |location_m| PlaceOnBody { location_m, from_default_pose: false };
        let (global, local) = match *self {
            Self::OfBody(place) => return Ok(as_given(place)),
            Self::Exported { global_m: None, local_m: None } => return Err(PlaceFault::OnlyGlobal),
            Self::Exported { global_m: None, local_m: Some(local) } => return Ok(as_given(local)),
            Self::Exported { global_m: Some(global), local_m } => (global, local_m),
        };
        let frame = pose().placement(body).map_err(PlaceFault::Pose)?;
        let apart = local.map(|local| frame.point(local).distance(global.into()));
        if let Some(apart) = apart.filter(|apart| *apart > SAME_PLACE_M) {
            return Err(PlaceFault::Disagree(apart));
        }
        let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let is_ground = |point: DVec3| frame.point(point).distance(point) <= SAME_FRAME_M;
        match local {
            _ if points.into_iter().all(is_ground) => Ok(as_given(global)),
            Some(local) => Ok(as_given(local)),
            None if at_default_pose => {
                Ok(PlaceOnBody { location_m: frame.inverse().point(global).into(), from_default_pose: true })
            }
            None => Err(PlaceFault::OnlyGlobal),
        }
    }
}

#[cfg(test)]
mod tests {
    use osim_model::Model;

    use super::*;

    /// A pose in which `foot` is 1 m above ground, turned by a quarter turn about z, so that its x points up; and `bone` is at the origin
    /// of ground.
    fn pose_of_foot_and_bone() -> DefaultPose {
        let joint = |body: &str, place: &str, turn: &str| {
            format!(
                "<WeldJoint name=\"{body}_j\"><socket_parent_frame>at</socket_parent_frame>\
                 <socket_child_frame>/bodyset/{body}</socket_child_frame><frames><PhysicalOffsetFrame name=\"at\">\
                 <socket_parent>/ground</socket_parent><translation>{place}</translation>\
                 <orientation>{turn}</orientation></PhysicalOffsetFrame></frames></WeldJoint>"
            )
        };
        let text = format!(
            "<OpenSimDocument Version=\"40000\"><Model><BodySet><objects><Body name=\"foot\"/><Body name=\"bone\"/>\
             </objects></BodySet><JointSet><objects>{}{}</objects></JointSet></Model></OpenSimDocument>",
            joint("foot", "0 1 0", "0 0 1.5707963267948966"),
            joint("bone", "0 0 0", "0 0 0"),
        );
        DefaultPose::of(&Model::parse(text).unwrap())
    }

    fn place_in_table(global: Option<[f64; 3]>, local: Option<[f64; 3]>) -> TablePlace {
        TablePlace::Exported { global_m: global, local_m: local }
    }

    #[track_caller]
    fn is_at(found: Result<PlaceOnBody, PlaceFault>, at: [f64; 3], from_default_pose: bool) {
        let found = found.unwrap();
        assert!(DVec3::from(found.location_m).distance(at.into()) < 1e-15, "{found:?}");
        assert_eq!(found.from_default_pose, from_default_pose);
    }

    #[test]
    fn a_body_in_ground_has_global_places_and_another_one_local_ones() {
        let pose = pose_of_foot_and_bone();
        let point = Some([0.1, 0.2, 0.3]);
        is_at(place_in_table(point, None).on_body("bone", || &pose, false), [0.1, 0.2, 0.3], false);
        // x of the foot is y of ground, y is -x, and its origin is 1 m up.
        let seen = Some([-0.2, 1.1, 0.3]);
        is_at(place_in_table(seen, point).on_body("foot", || &pose, false), [0.1, 0.2, 0.3], false);
        is_at(place_in_table(seen, None).on_body("foot", || &pose, true), [0.1, 0.2, 0.3], true);
        is_at(place_in_table(None, point).on_body("foot", || &pose, false), [0.1, 0.2, 0.3], false);
        is_at(TablePlace::OfBody([0.1, 0.2, 0.3]).on_body("foot", || &pose, false), [0.1, 0.2, 0.3], false);
    }

    #[test]
    fn places_that_differ_or_are_global_alone_are_refused() {
        let pose = pose_of_foot_and_bone();
        let point = Some([0.1, 0.2, 0.3]);
        assert_eq!(place_in_table(point, None).on_body("foot", || &pose, false), Err(PlaceFault::OnlyGlobal));
        for (body, global) in [("foot", [-0.2, 1.1, 0.302]), ("bone", [0.1, 0.2, 0.302])] {
            let fault = place_in_table(Some(global), point).on_body(body, || &pose, true).unwrap_err();
            assert!(
                matches!(fault, PlaceFault::Disagree(apart) if (apart - 0.002).abs() < 1e-12),
                "{fault:?}"
            );
        }
        let nowhere = place_in_table(point, None).on_body("hand", || &pose, true);
        assert!(matches!(nowhere, Err(PlaceFault::Pose(_))), "{nowhere:?}");
    }
}
