//! Feet from the side and from above.

mod notes;
mod views;

use std::collections::HashMap;

use contact_plots::{Block, Paper, Scene, SceneNames, scene};
use osim_model::feet::{FloorPlace, Foot, FootFrame};
use osim_model::files::Failure;
use osim_model::messages::{four_significant, harmless, listed};
use osim_planning::ModelFeet;

pub use notes::{feet_notes, missing_meshes};
use views::views;

/// The last of `states` with its bones and names, and the spheres of the first where they are others.
#[must_use]
pub fn feet(states: &[ModelFeet], title: Option<&str>) -> Scene {
    let (Some(now), before) = (states.last(), earlier(states)) else { return Scene::default() };
    let mut others: HashMap<&str, &Foot> = HashMap::new();
    for other in before.into_iter().flat_map(|before| &before.feet) {
        others.entry(&other.name).or_insert(other);
    }
    let blocks = now.feet.iter().map(|foot| block(foot, others.get(foot.name.as_str()).copied()));
    let whose = match before {
        Some(before) => format!("{} and {}", before.name, now.name),
        None => now.name.clone(),
    };
    let of_state = |state: &ModelFeet| match before {
        Some(_) => format!("sphere, {}", state.name),
        None => "sphere".to_owned(),
    };
    let misplaced = "sphere that is where it should not be";
    Scene {
        title: title.map_or_else(|| format!("Feet: {whose}"), str::to_owned),
        description: format!(
            "Feet of {whose} from the right and from above, to one scale: joints, outlines of bones whose meshes are at hand, \
             contact spheres in their true size, a line under the lowest of them, and the floor where it is near."
        ),
        blocks: blocks.collect(),
        names: SceneNames {
            now: of_state(now),
            before: before.map(of_state).unwrap_or_default(),
            astray: misplaced.to_owned(),
            spot: "joint".to_owned(),
            outline: "bone".to_owned(),
            ground: "floor".to_owned(),
            lowest: String::new(),
        },
    }
}

/// The same as an SVG document; `name` is whose figure it is, where it cannot be drawn.
///
/// # Errors
/// It was not drawn: a number is not finite.
pub fn feet_svg(states: &[ModelFeet], name: &str, title: Option<&str>) -> Result<String, Failure> {
    // Names of spheres are labels: what a picture cannot show would make it unreadable.
    let drawn = scene(&feet(states, title), Paper::default()).map(|svg| harmless(&svg).into_owned());
    drawn.map_err(|error| Failure::outside(name, "plot", error.to_string()))
}

/// The first of two states.
fn earlier(states: &[ModelFeet]) -> Option<&ModelFeet> {
    states.split_last().and_then(|(_, before)| before.last())
}

/// `other` is the same foot in another state.
fn block(foot: &Foot, other: Option<&Foot>) -> Block {
    let shift = other.map(|other| shift(other, foot));
    let name = if foot.name.is_empty() { "ground" } else { foot.name.as_str() };
    let title = match foot.side {
        Some(side) => format!("{name}, {}", side.as_str()),
        None => name.to_owned(),
    };
    Block { title, remarks: remarks(foot, other.zip(shift)), views: views(foot, other.zip(shift)) }
}

/// From where another model has the foot to where this one has it, m.
fn shift(other: &Foot, foot: &Foot) -> [f64; 3] {
    std::array::from_fn(|i| foot.origin_m[i] - other.origin_m[i])
}

/// Names and heights that a remark lists; more are counted.
const LISTED: usize = 12;

/// A foot that is moved by less than this is where it was, m.
const STAYS_M: f64 = 1e-6;

fn remarks(foot: &Foot, before: Option<(&Foot, [f64; 3])>) -> Vec<String> {
    let mut remarks = Vec::new();
    if let FootFrame::Body { name, fault } = &foot.frame {
        remarks.push(format!("Drawn in the frame of {name}: {fault}."));
    }
    if !foot.unplaced.is_empty() {
        remarks.push(format!(
            "Not drawn, as the default pose of a joint cannot be calculated: {}.",
            listed(&foot.unplaced, LISTED)
        ));
    }
    if let Some((_, shift)) = before
        && shift.iter().any(|value| value.abs() > STAYS_M)
    {
        remarks.push(format!("Both are drawn with the origin of {} in one place.", foot.name));
    }
    if let Some((first, last)) = foot.reach() {
        let percent = |share: f64| format!("{:.0} %", 100.0 * share).replace('-', "−");
        remarks.push(match foot.spheres.len() {
            1 => format!("The centre is at {} of the bones' length.", percent(first)),
            _ => format!("Centres are at {} to {} of the bones' length.", percent(first), percent(last)),
        });
    }
    remarks.extend(floor_in_words(foot));
    remarks
}

/// Why the floor is not drawn, in words.
fn floor_in_words(foot: &Foot) -> Option<String> {
    let metres = |value: f64| format!("{} m", four_significant(value)).replace('-', "−");
    match &foot.floor {
        FloorPlace::At(height) if foot.is_near(*height) => None,
        FloorPlace::At(height) => {
            let lowest = foot.lowest_m()?;
            let off = (height - lowest).abs();
            let way = if *height < lowest { "below" } else { "above" };
            Some(format!("The floor is {} {way} the lowest place, too far to be drawn.", metres(off)))
        }
        FloorPlace::Several(heights) => {
            let heights: Vec<String> = heights.iter().map(|height| metres(*height)).collect();
            Some(format!("Floors are at {}; none is drawn.", listed(&heights, LISTED)))
        }
        FloorPlace::None if !foot.spheres.is_empty() => Some("The model has no level floor.".to_owned()),
        _ => None,
    }
}
