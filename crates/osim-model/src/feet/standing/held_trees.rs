//! Joint trees whose root cannot move along gravity, and what holds it.

use foldhash::{HashMap, HashSet, HashSetExt};

use super::lift::{JointTree, LiftingCoordinateSearch, NotLifted, ParentJoint};
use crate::feet::couplers::{CoordinateState, Couplers, is_enforced};
use crate::feet::default_pose::DefaultPose;
use crate::model::{Model, Side};

/// The joint trees of `bodies` that cannot move along gravity: the topmost body of each, and what holds it in words.
pub fn held_roots<'b>(model: &Model, bodies: impl Iterator<Item = &'b str>) -> Vec<(String, String)> {
    let (tree, pose) = (JointTree::of(model.joints()), DefaultPose::of(model));
    let search = LiftingCoordinateSearch::of(model, &pose);
    let components = model.components();
    let constraints = model.constraints_to_ground().into_iter();
    let enforced =
        constraints.filter(|(id, _)| is_enforced(components.document_of(*id), components.element(*id)));
    let constraints: HashMap<_, _> = enforced.map(|(id, body)| (body, components.name(id))).collect();
    let mut tops = HashSet::new();
    let first_of_tree =
        bodies.filter_map(|body| Some((tree.top(body).filter(|top| tops.insert(*top))?, body)));
    let held = first_of_tree.filter_map(|(top, body)| {
        let mut path = tree.path_to_ground(body);
        let is_of_leg = |above: &&ParentJoint<'_>| above.body != top && Side::of_name(above.body).is_some();
        let trunk = path.split_off(path.iter().take_while(is_of_leg).count());
        let constraint = trunk.iter().find_map(|above| constraints.get(above.body));
        let fixed = constraint.map(|name| format!("{name} fixes it to ground"));
        Some((top.to_owned(), fixed.or_else(|| what_holds_root(model, &search, &trunk))?))
    });
    held.collect()
}

/// What keeps the bodies below `path` from moving along gravity; `None` if a coordinate is free to.
fn what_holds_root(
    model: &Model,
    search: &LiftingCoordinateSearch<'_>,
    path: &[ParentJoint<'_>],
) -> Option<String> {
    match search.find(path, model.up()).err()? {
        NotLifted::Locked { coordinate } => Some(format!("{coordinate} is locked")),
        NotLifted::Driven { coordinate } => {
            let couplers = Couplers::of(model).couplers;
            let coupler = couplers.iter().find(|coupler| coupler.dependent == coordinate);
            // What follows another coordinate moves with it.
            let is_constant =
                coupler.and_then(|one| one.value_and_slope(0.0)).is_none_or(|(_, slope)| slope == 0.0);
            is_constant.then(|| format!("a function sets {coordinate}"))
        }
        _ => {
            let root = path.last()?.joint;
            let is_free = |coordinate| search.states.state_of(root, coordinate) == CoordinateState::Free;
            let is_fixed = !root.coordinates.iter().any(is_free)
                && (!root.coordinates.is_empty() || root.class == "WeldJoint");
            is_fixed.then(|| format!("{} ({}) cannot move", root.name, root.class))
        }
    }
}
