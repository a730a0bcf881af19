//! The two views of a foot, in millimetres.

use contact_plots::{Ball, Level, LevelKind, Outline, Point, Spot, State, View};
use osim_model::feet::{FloorPlace, Foot, FootFrame, FootSphere, silhouette};
use osim_model::messages::four_significant;

/// Spheres that differ by less than this, in m, are drawn once.
const SAME_M: f64 = 1e-9;
const MM: f64 = 1e3;

/// From which side a foot is seen.
#[derive(Clone, Copy, PartialEq)]
enum From {
    Right,
    Above,
}

/// From the right and from above; `before` is another state, and by how much it is moved to be drawn here.
pub(super) fn views(foot: &Foot, before: Option<(&Foot, [f64; 3])>) -> Vec<View> {
    [From::Right, From::Above].map(|from| view(foot, before, from)).into()
}

fn view(foot: &Foot, before: Option<(&Foot, [f64; 3])>, from: From) -> View {
    let [forward, up, right] = foot.axes.names();
    let place = match &foot.frame {
        FootFrame::Ground => "in ground",
        _ => "in the body",
    };
    let side = from == From::Right;
    let mut view = View {
        title: if side { "from the right" } else { "from above" }.to_owned(),
        x_label: format!("{forward} {place} (mm)"),
        y_label: format!("{} (mm)", if side { up } else { right }),
        y_down: !side,
        ..View::default()
    };
    if let Some((other, shift)) = before {
        add_before(&mut view, foot, other, shift, from);
    }
    let seen = |point: [f64; 3]| seen(foot, point, from);
    view.outlines.extend(outlines(foot, [0.0; 3], from, State::Now));
    view.balls.extend(foot.spheres.iter().map(|sphere| Ball {
        name: sphere.name.clone(),
        centre: seen(sphere.centre_m),
        radius: MM * sphere.radius_m,
        state: State::Now,
        astray: sphere.misplaced,
    }));
    view.spots.extend(foot.joints.iter().map(|joint| Spot {
        name: joint.name.clone(),
        at: seen(joint.at_m),
        state: State::Now,
    }));
    if side {
        view.levels = levels(foot, up);
    }
    view
}

/// What another state has elsewhere: its spheres, and its bones where they are of another size.
fn add_before(view: &mut View, foot: &Foot, other: &Foot, shift: [f64; 3], from: From) {
    let moved = |point: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| point[i] + shift[i]) };
    let drawn = Drawn::of(&foot.spheres);
    let differs = |sphere: &&FootSphere| !drawn.has(moved(sphere.centre_m), sphere.radius_m);
    view.balls.extend(other.spheres.iter().filter(differs).map(|sphere| Ball {
        name: String::new(),
        centre: seen(foot, moved(sphere.centre_m), from),
        radius: MM * sphere.radius_m,
        state: State::Before,
        astray: false,
    }));
    let (here, there) =
        (outlines(foot, [0.0; 3], from, State::Before), outlines(other, shift, from, State::Before));
    let close = |a: &Outline, b: &Outline| {
        let near = |(p, q): (&Point, &Point)| (p.0 - q.0).hypot(p.1 - q.1) <= MM * SAME_M;
        a.points.len() == b.points.len() && a.points.iter().zip(&b.points).all(near)
    };
    view.outlines.extend(there.into_iter().filter(|there| !here.iter().any(|here| close(here, there))));
}

/// Spheres in the order along the axis on which they are farthest apart, so that one is found without looking at all.
struct Drawn<'f> {
    axis: usize,
    spheres: Vec<&'f FootSphere>,
}

impl<'f> Drawn<'f> {
    fn of(spheres: &'f [FootSphere]) -> Self {
        let spread = |axis: usize| {
            let along = || spheres.iter().map(|sphere| sphere.centre_m[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        };
        let axis = (0..3).max_by(|&a, &b| spread(a).total_cmp(&spread(b))).unwrap_or(0);
        let mut spheres: Vec<&FootSphere> = spheres.iter().collect();
        spheres.sort_by(|a, b| a.centre_m[axis].total_cmp(&b.centre_m[axis]));
        Self { axis, spheres }
    }

    fn has(&self, centre_m: [f64; 3], radius_m: f64) -> bool {
        let off = |sphere: &FootSphere, axis: usize| sphere.centre_m[axis] - centre_m[axis];
        let first = self.spheres.partition_point(|sphere| off(sphere, self.axis) < -SAME_M);
        let from = self.spheres.get(first..).unwrap_or_default();
        from.iter().take_while(|sphere| off(sphere, self.axis) <= SAME_M).any(|sphere| {
            (0..3).all(|axis| off(sphere, axis).abs() <= SAME_M)
                && (sphere.radius_m - radius_m).abs() <= SAME_M
        })
    }
}

fn seen(foot: &Foot, point: [f64; 3], from: From) -> Point {
    let [forward, up, right] = foot.axes.seen(point);
    (MM * forward, MM * if from == From::Right { up } else { right })
}

fn outlines(foot: &Foot, shift: [f64; 3], from: From, state: State) -> Vec<Outline> {
    let line = |points: &Vec<[f64; 3]>| {
        let moved = points.iter().map(|point| std::array::from_fn(|i| point[i] + shift[i]));
        silhouette(&moved.map(|point| seen(foot, point, from)).collect::<Vec<_>>())
    };
    let lines = foot.bones.iter().map(|bone| Outline { points: line(&bone.points_m), state });
    lines.filter(|outline| !outline.points.is_empty()).collect()
}

/// The line under the lowest sphere, and the floor where it is near.
fn levels(foot: &Foot, up: &str) -> Vec<Level> {
    let mut levels = Vec::new();
    // A thousandth of a millimetre: what rounding leaves of 0 is 0.
    let rounded = |value: f64| (1e6 * value).round() / 1e3 + 0.0;
    let mm = |value: f64| format!("{up} = {} mm", four_significant(rounded(value))).replace('-', "−");
    if let Some(lowest) = foot.lowest_m().filter(|_| !foot.spheres.is_empty()) {
        let name = format!("lowest bottom, {}", mm(lowest));
        levels.push(Level { name, at: MM * lowest, kind: LevelKind::Lowest });
    }
    if let FloorPlace::At(height) = foot.floor
        && foot.is_near(height)
    {
        let name = format!("floor, {}", mm(height));
        levels.push(Level { name, at: MM * height, kind: LevelKind::Ground });
    }
    levels
}
