//! Places, soles and factors that are probably in another unit.

use osim_model::feet::Sole;
use osim_model::messages::{Input, four_significant, phrase, readable, shown};
use osim_model::{Anatomy, JointDistances, Model, NeedsAnswer, Question, probable_units};
use osim_requests::BodyScale;

/// A sphere is at most this many times as far from the joints of its body as the longest distance between joints around it.
/// Published ones are closer than half of that distance; in centimetres they would be some tens of times as far.
const FAR: f64 = 3.0;
/// What is usual, as a part of that distance: the ball of a human foot and its shank.
const USUAL: f64 = 0.4;
/// The foot's length over what is usual for its sole below the bones: 0.26 m and 13 mm.
const PADS: f64 = 20.0;
/// Bones of a giraffe are 38 times as long as those of a mouse: the cube root of 1190 kg over 0.0209 kg.
const LARGEST_SCALE: f64 = 50.0;

/// The joints of a model's bodies, and how far they are apart.
pub(crate) struct Bones {
    anatomy: Option<Anatomy>,
    distances: JointDistances,
}

/// How far a place is from its bones.
pub(crate) struct Distance {
    from_joints_m: f64,
    longest_m: f64,
}

impl Bones {
    /// Those of `model`.
    #[must_use]
    pub(crate) fn of(model: &Model) -> Self {
        Self { anatomy: Anatomy::of(model).ok(), distances: model.joint_distances().clone() }
    }

    /// How far a place is from the nearest joint of `body`, or its origin; `None` if it is not known how large the bones are.
    pub(crate) fn distance(&self, body: &str, place_m: [f64; 3]) -> Option<Distance> {
        let longest_m = self.distances.around_body(body)?;
        let anatomy = self.anatomy.as_ref()?;
        let above = anatomy.joint_above(body).map(|joint| joint.in_child_m);
        let below = anatomy.joints_below(body).map(|joint| joint.in_parent_m);
        let apart =
            |joint: [f64; 3]| joint.iter().zip(place_m).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        let from_joints_m = below.chain(above).chain([[0.0; 3]]).map(apart).fold(f64::INFINITY, f64::min);
        Some(Distance { from_joints_m, longest_m })
    }
}

impl Distance {
    /// In distances between joints.
    pub(crate) fn times(&self) -> f64 {
        self.from_joints_m / self.longest_m
    }

    /// What is asked of a place so far away; `at` is where it is in its table.
    pub(crate) fn place_slip(&self, at: &str, name: &str, body: &str) -> Option<NeedsAnswer> {
        if self.times() <= FAR {
            return None;
        }
        let units = probable_units(self.times() / USUAL);
        let units: Vec<String> = units
            .iter()
            .map(|(unit, per_metre)| format!("divide them by {per_metre} if they are in {unit}"))
            .collect();
        let text = format!(
            "{at}{} would be {} m from the nearest joint of {}, and the joints of its body and of those next to it are at most {} m \
             apart: places are in m{}{}",
            shown(name),
            four_significant(self.from_joints_m),
            shown(body),
            four_significant(self.longest_m),
            if units.is_empty() { "" } else { ", " },
            units.join(", or ")
        );
        Some(NeedsAnswer::Other { question: Question::ImplausiblePlace, text: text.into() })
    }
}

/// What is asked where a sole is farther below the bones than the foot is long.
pub(crate) fn pad_slip(sole: &Sole, pad_m: f64) -> Option<NeedsAnswer> {
    let length_m = sole.footprint.length_m;
    if pad_m <= length_m {
        return None;
    }
    let units = probable_units(pad_m * PADS / length_m);
    let units: Vec<String> = units
        .iter()
        .map(|(unit, per_metre)| format!("{} if it is in {unit}", readable(pad_m / per_metre)))
        .collect();
    let write = if units.is_empty() { "" } else { ", write " };
    let bodies: Vec<String> = sole.bodies.iter().map(|body| shown(body).to_string()).collect();
    let text = phrase![
        Input::Pad.being(readable(pad_m)),
        format!(
            " is more than the length of the foot of {}, {} m: it is in m{write}{}",
            bodies.join(", "),
            four_significant(length_m),
            units.join(", or ")
        ),
    ];
    Some(NeedsAnswer::Other { question: Question::ImplausiblePlace, text })
}

/// What is asked where a body would be scaled as no two animals differ.
pub(crate) fn scale_slip(scales: &[BodyScale]) -> Option<NeedsAnswer> {
    let usual = 1.0 / LARGEST_SCALE..=LARGEST_SCALE;
    let factors = scales.iter().flat_map(|scale| scale.factors.map(|factor| (scale, factor)));
    let (scale, factor) = factors.into_iter().find(|(_, factor)| !usual.contains(factor))?;
    let percent = match factor > LARGEST_SCALE {
        true => format!("; if it is in percent, write {}", readable(factor / 100.0)),
        false => String::new(),
    };
    let text = phrase![
        Input::BodyScale.being(scale.to_string()),
        format!(
            " makes a bone {} times as long as the reference's: between a mouse and a giraffe it is 38 times{percent}",
            readable(factor)
        ),
    ];
    Some(NeedsAnswer::Other { question: Question::ImplausibleScale, text })
}
