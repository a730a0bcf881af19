//! Which bodies are one foot.

use crate::model::{Model, Side, without_side};
use foldhash::HashMap;

use crate::feet::bone::Bone;

/// Joints between a body and the one it is found to belong to, at most.
const MOST_JOINTS: usize = 64;

/// The bodies of one foot.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FootBodies {
    pub bodies: Vec<String>,
    pub side: Option<Side>,
    /// The highest body of that side above them: where the limb begins.
    pub limb: String,
}

impl FootBodies {
    /// Which of `feet` is that of the other side.
    pub(super) fn pair_in(&self, feet: &[Self]) -> Option<usize> {
        let names = |foot: &Self| {
            let mut names: Vec<String> = foot.bodies.iter().map(|body| without_side(body)).collect();
            names.sort();
            names
        };
        let side = self.side?;
        feet.iter()
            .position(|foot| foot.side.is_some_and(|other| other != side) && names(foot) == names(self))
    }
}

/// The bodies of `bones` as feet, in the order in which the first of each is listed.
pub(super) fn foot_bodies(model: &Model, bones: &[Bone]) -> Vec<FootBodies> {
    let parents = parents(model);
    let mut listed: Vec<&str> = Vec::new();
    for bone in bones {
        if !listed.contains(&bone.body.as_str()) {
            listed.push(&bone.body);
        }
    }
    let mut feet: Vec<(String, FootBodies)> = Vec::new();
    for body in &listed {
        let top = top_of(body, &listed, &parents);
        match feet.iter_mut().find(|(known, _)| *known == top) {
            Some((_, foot)) => foot.bodies.push((*body).to_owned()),
            None => feet.push((
                top,
                FootBodies { bodies: vec![(*body).to_owned()], side: None, limb: limb_of(body, &parents) },
            )),
        }
    }
    let sided = |(_, mut foot): (String, FootBodies)| {
        let mut sides = foot.bodies.iter().map(|body| Side::of_name(body));
        let first = sides.next().flatten();
        foot.side = first.filter(|_| sides.all(|side| side == first));
        foot
    };
    feet.into_iter().map(sided).collect()
}

/// The body on which each hangs.
fn parents(model: &Model) -> HashMap<String, String> {
    let joints = model.joints().iter();
    joints.filter_map(|joint| Some((joint.child.clone()?, joint.parent.clone()?))).collect()
}

/// The highest body above `body`, itself included, that is listed, or that is of the same side and has other bodies that are
/// listed below it.
fn top_of(body: &str, listed: &[&str], parents: &HashMap<String, String>) -> String {
    let way = way_up(body, parents);
    let shared = |above: &str| {
        let below = |other: &&&str| **other != body && way_up(other, parents).iter().any(|at| at == above);
        listed.iter().any(|other| below(&other))
    };
    let side = Side::of_name(body);
    let belongs = |above: &&String| {
        listed.contains(&above.as_str()) || (side.is_some() && Side::of_name(above) == side && shared(above))
    };
    way.iter().rev().find(belongs).cloned().unwrap_or_else(|| body.to_owned())
}

/// The highest body above `body` that is of its side.
fn limb_of(body: &str, parents: &HashMap<String, String>) -> String {
    let side = Side::of_name(body);
    let way = way_up(body, parents);
    let of_side = way.iter().rev().find(|above| side.is_some() && Side::of_name(above) == side);
    of_side.cloned().unwrap_or_else(|| body.to_owned())
}

/// The body itself and those above it.
fn way_up(body: &str, parents: &HashMap<String, String>) -> Vec<String> {
    let mut way = vec![body.to_owned()];
    while let Some(parent) = way.last().and_then(|body| parents.get(body))
        && way.len() <= MOST_JOINTS
    {
        way.push(parent.clone());
    }
    way
}
