//! Figures of feet from the right and from above.

use std::collections::{HashMap, HashSet};

use contact_plots::{Ball, Block, Level, LevelKind, Outline, Point, Scene, SceneNames, Spot, State, View};
use osim_model::feet::{FeetFault, FloorPlace, Foot, FootFrame, FootSphere, silhouette};
use osim_model::messages::{Dialect, Input, counted, four_significant, listed, phrase, shown};
use osim_model::{DVec2, DVec3, least_and_most};
use osim_planning::ModelFeet;

/// A figure with the last of `states` with its bones and names, and with the spheres of the first state that differ from it.
pub fn feet(states: &[ModelFeet], title: Option<&str>) -> Scene {
    let (Some(now), before) = (states.last(), states.iter().nth_back(1)) else { return Scene::default() };
    let mut others: HashMap<&str, &Foot> = HashMap::new();
    for other in before.into_iter().flat_map(|before| &before.feet) {
        others.entry(&other.name).or_insert(other);
    }
    let blocks = now.feet.iter().map(|foot| block_of_foot(foot, others.get(foot.name.as_str()).copied()));
    let whose = before.map_or_else(|| now.name.clone(), |before| format!("{} and {}", before.name, now.name));
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
            misplaced: misplaced.to_owned(),
            spot: "joint".to_owned(),
            outline: "bone".to_owned(),
            ground: "floor".to_owned(),
            lowest: String::new(),
        },
    }
}

/// The part of the figure about one foot; `other` is this foot in another state.
fn block_of_foot(foot: &Foot, other: Option<&Foot>) -> Block {
    let before = other.map(|other| (other, foot.origin_m - other.origin_m));
    let name = if foot.name.is_empty() { "ground" } else { foot.name.as_str() };
    let side = foot.side.map(|side| format!(", {}", side.as_str())).unwrap_or_default();
    Block {
        title: format!("{name}{side}"),
        remarks: remarks_on_foot(foot, before),
        views: [ViewSide::Right, ViewSide::Above].map(|from| view_of_foot(foot, before, from)).into(),
    }
}

/// The largest number of names, and of heights, that a remark lists.
const MOST_NAMES_LISTED: usize = 12;

/// A shift of a foot by less than this, m, is not mentioned.
const SMALL_SHIFT_M: f64 = 1e-6;

fn remarks_on_foot(foot: &Foot, before: Option<(&Foot, DVec3)>) -> Vec<String> {
    let mut remarks = Vec::new();
    if let FootFrame::Body { name, fault } = &foot.frame {
        remarks.push(format!("Drawn in the frame of {name}: {fault}."));
    }
    if !foot.unplaced.is_empty() {
        remarks.push(format!(
            "Not drawn, as the default pose of a joint cannot be calculated: {}.",
            listed(&foot.unplaced, MOST_NAMES_LISTED)
        ));
    }
    if let Some((_, shift)) = before
        && shift.abs().cmpgt(DVec3::splat(SMALL_SHIFT_M)).any()
    {
        remarks.push(format!("Both are drawn with the origin of {} in one place.", foot.name));
    }
    if let Some((first, last)) = foot.sphere_extent() {
        let percent = |share: f64| format!("{:.0} %", 100.0 * share).replace('-', "−");
        remarks.push(match foot.spheres.len() {
            1 => format!("The centre is at {} of the bones' length.", percent(first)),
            _ => format!("Centres are at {} to {} of the bones' length.", percent(first), percent(last)),
        });
    }
    remarks.extend(remark_on_floor(foot));
    remarks
}

/// The remark that says why the floor is not drawn.
fn remark_on_floor(foot: &Foot) -> Option<String> {
    let metres = |value: f64| format!("{} m", four_significant(value)).replace('-', "−");
    match &foot.floor {
        FloorPlace::At(height) if foot.is_near_height(*height) => None,
        FloorPlace::At(height) => {
            let lowest = foot.lowest_m()?;
            let off = (height - lowest).abs();
            let way = if *height < lowest { "below" } else { "above" };
            Some(format!("The floor is {} {way} the lowest place, too far to be drawn.", metres(off)))
        }
        FloorPlace::Several(heights) => {
            let heights: Vec<String> = heights.iter().map(|height| metres(*height)).collect();
            Some(format!("Floors are at {}; none is drawn.", listed(&heights, MOST_NAMES_LISTED)))
        }
        FloorPlace::None if !foot.spheres.is_empty() => Some("The model has no level floor.".to_owned()),
        _ => None,
    }
}

/// Spheres whose places in two states differ by less than this, m, are drawn once.
const SAME_PLACE_M: f64 = 1e-9;
const MM_PER_M: f64 = 1e3;

/// The side from which a foot is seen.
#[derive(Clone, Copy, PartialEq)]
enum ViewSide {
    Right,
    Above,
}

/// A foot from one side; `before` is the foot in another state, with the shift to draw it at the same place.
fn view_of_foot(foot: &Foot, before: Option<(&Foot, DVec3)>, from: ViewSide) -> View {
    let [forward, up, right] = foot.axes.names();
    let place = if foot.frame == FootFrame::Ground { "in ground" } else { "in the body" };
    let side = from == ViewSide::Right;
    let mut view = View {
        title: if side { "from the right" } else { "from above" }.to_owned(),
        x_label: format!("{forward} {place} (mm)"),
        y_label: format!("{} (mm)", if side { up } else { right }),
        y_down: !side,
        ..View::default()
    };
    if let Some((other, shift)) = before {
        add_state_before(&mut view, foot, other, shift, from);
    }
    let on_view = |point: DVec3| projected_on_view(foot, point, from);
    view.outlines.extend(foot_outlines(foot, DVec3::ZERO, from, State::Now));
    view.balls.extend(foot.spheres.iter().map(|sphere| Ball {
        name: sphere.name.clone(),
        centre: on_view(sphere.centre_m),
        radius: MM_PER_M * sphere.radius_m,
        state: State::Now,
        misplaced: sphere.misplaced,
    }));
    view.spots.extend(foot.joints.iter().map(|joint| Spot {
        name: joint.name.clone(),
        at: on_view(joint.at_m),
        state: State::Now,
    }));
    if side {
        view.levels = level_lines(foot, up);
    }
    view
}

/// Adds the spheres and bones of the other state that differ from this state.
fn add_state_before(view: &mut View, foot: &Foot, other: &Foot, shift: DVec3, from: ViewSide) {
    let moved = |point: DVec3| point + shift;
    let drawn = SortedSpheres::new(&foot.spheres);
    let differs = |sphere: &&FootSphere| !drawn.contains(moved(sphere.centre_m), sphere.radius_m);
    view.balls.extend(other.spheres.iter().filter(differs).map(|sphere| Ball {
        name: String::new(),
        centre: projected_on_view(foot, moved(sphere.centre_m), from),
        radius: MM_PER_M * sphere.radius_m,
        state: State::Before,
        misplaced: false,
    }));
    let (here, there) = (
        foot_outlines(foot, DVec3::ZERO, from, State::Before),
        foot_outlines(other, shift, from, State::Before),
    );
    let close = |a: &Outline, b: &Outline| {
        let near = |(p, q): (&Point, &Point)| (p.0 - q.0).hypot(p.1 - q.1) <= MM_PER_M * SAME_PLACE_M;
        a.points.len() == b.points.len() && a.points.iter().zip(&b.points).all(near)
    };
    view.outlines.extend(there.into_iter().filter(|there| !here.iter().any(|here| close(here, there))));
}

/// Spheres sorted along the axis on which they are farthest apart, for a fast search.
struct SortedSpheres<'f> {
    axis: usize,
    spheres: Vec<&'f FootSphere>,
}

impl<'f> SortedSpheres<'f> {
    /// Sorts the spheres of a foot.
    fn new(spheres: &'f [FootSphere]) -> Self {
        let spread = |axis: usize| {
            let (least, most) = least_and_most(spheres.iter().map(|sphere| sphere.centre_m[axis]));
            most - least
        };
        let axis = (0..3).max_by(|&a, &b| spread(a).total_cmp(&spread(b))).unwrap_or(0);
        let mut spheres: Vec<&FootSphere> = spheres.iter().collect();
        spheres.sort_by(|a, b| a.centre_m[axis].total_cmp(&b.centre_m[axis]));
        Self { axis, spheres }
    }

    fn contains(&self, centre_m: DVec3, radius_m: f64) -> bool {
        let off = |sphere: &FootSphere, axis: usize| sphere.centre_m[axis] - centre_m[axis];
        let first = self.spheres.partition_point(|sphere| off(sphere, self.axis) < -SAME_PLACE_M);
        let from = self.spheres.get(first..).unwrap_or_default();
        from.iter().take_while(|sphere| off(sphere, self.axis) <= SAME_PLACE_M).any(|sphere| {
            (0..3).all(|axis| off(sphere, axis).abs() <= SAME_PLACE_M)
                && (sphere.radius_m - radius_m).abs() <= SAME_PLACE_M
        })
    }
}

fn projected_on_view(foot: &Foot, point: DVec3, from: ViewSide) -> Point {
    let [forward, up, right] = foot.axes.coordinates(point);
    (MM_PER_M * forward, MM_PER_M * if from == ViewSide::Right { up } else { right })
}

fn foot_outlines(foot: &Foot, shift: DVec3, from: ViewSide, state: State) -> Vec<Outline> {
    let line = |points: &Vec<DVec3>| {
        let points = points.iter().map(|&point| DVec2::from(projected_on_view(foot, point + shift, from)));
        silhouette(&points.collect::<Vec<_>>()).into_iter().map(DVec2::into).collect()
    };
    let lines = foot.bones.iter().map(|bone| Outline { points: line(&bone.points_m), state });
    lines.filter(|outline| !outline.points.is_empty()).collect()
}

/// The line under the lowest sphere, and the line of the floor, if the floor is near.
fn level_lines(foot: &Foot, up: &str) -> Vec<Level> {
    let mut levels = Vec::new();
    // Rounded to thousandths of a millimetre, so that rounding errors of 0 are shown as 0.
    let rounded = |value: f64| (1e6 * value).round() / 1e3 + 0.0;
    let mm = |value: f64| format!("{up} = {} mm", four_significant(rounded(value))).replace('-', "−");
    if let Some(lowest) = foot.lowest_m().filter(|_| !foot.spheres.is_empty()) {
        let name = format!("lowest bottom, {}", mm(lowest));
        levels.push(Level { name, at: MM_PER_M * lowest, kind: LevelKind::Lowest });
    }
    if let FloorPlace::At(height) = foot.floor
        && foot.is_near_height(height)
    {
        let name = format!("floor, {}", mm(height));
        levels.push(Level { name, at: MM_PER_M * height, kind: LevelKind::Ground });
    }
    levels
}

/// Lines about each state: what is drawn, which spheres are in wrong places, and which bones are missing.
pub(super) fn feet_remarks(states: &[ModelFeet], dialect: &dyn Dialect) -> String {
    states.iter().map(|state| remarks_on_state(state, dialect)).collect()
}

fn remarks_on_state(state: &ModelFeet, dialect: &dyn Dialect) -> String {
    let name = &state.name;
    let spheres: usize = state.feet.iter().map(|foot| foot.spheres.len()).sum();
    let in_ground = state.feet.iter().all(|foot| foot.frame == FootFrame::Ground);
    let pose = if in_ground { ", at the default pose" } else { "" };
    let mut text = format!(
        "{name}: {} {}, {}{pose}\n",
        state.feet.len(),
        if state.feet.len() == 1 { "foot" } else { "feet" },
        counted(spheres, "sphere")
    );
    if let Some(finding) = &state.misplaced {
        text.push_str(&format!(
            "{name}: {}: {}\n",
            finding.code().as_str(),
            finding.message.spelled(dialect)
        ));
    }
    if let Some(missing) = missing_bones_in_words(state, dialect) {
        text.push_str(&format!("{name}: {missing}\n"));
    }
    text
}

/// The sentence about bones that are not drawn.
fn missing_bones_in_words(state: &ModelFeet, dialect: &dyn Dialect) -> Option<String> {
    let names = names_of_missing_meshes(state);
    let mut reasons: Vec<String> = Vec::new();
    if !names.is_empty() {
        let text = phrase![
            "no bones are drawn of {}: name the folder of the meshes with {}";
            listed(&names, MOST_NAMES_LISTED), Input::GeometryDir.with_placeholder("DIR")
        ];
        reasons.push(text.spelled(dialect));
    }
    let others = state.missing.iter().filter(|fault| !matches!(fault, FeetFault::MeshMissing { .. }));
    reasons.extend(others.map(|fault| shown(&fault.to_string()).to_string()));
    (!reasons.is_empty()).then(|| reasons.join("; "))
}

/// Names of meshes that were not found, each once, as the model spells them.
pub(crate) fn names_of_missing_meshes(state: &ModelFeet) -> Vec<String> {
    let mut known = HashSet::new();
    let missing = state.missing.iter().filter_map(|fault| match fault {
        FeetFault::MeshMissing { mesh, .. } => Some(shown(mesh).to_string()),
        _ => None,
    });
    missing.filter(|name| known.insert(name.clone())).collect()
}
