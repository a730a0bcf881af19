//! Which foot is on which plate.

use osim_model::Side;

use crate::comparison::percentile;
use crate::feet::{Foot, OFF_BW, ON_BW};
use crate::plates::Plate;
use crate::states::{ContactState, ContactStates};
use crate::wrench::Wrench;

/// What says which foot a plate measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AssignedBy {
    /// The body that its load is applied to.
    Loads,
    /// The side in the name of its columns.
    Name,
    /// The foot that is nearest to its centre of pressure, frame by frame, of those that it may be under.
    Nearest,
    OnlyFoot,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlateUse {
    /// What its columns begin with.
    pub plate: String,
    /// Its foot, by its place among the feet; `None` where that changes from frame to frame, or where it has none.
    pub foot: Option<usize>,
    /// What says so; `None` where nothing does: the plate counts in the total alone.
    pub by: Option<AssignedBy>,
}

/// What the plates measured under each foot, in the frames of a recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// For each plate, what was made of it.
    pub uses: Vec<PlateUse>,
    /// For each foot and frame; `None` where a plate that it may be on has no data or no known foot, or where it stands beside the plates.
    pub feet: Vec<Vec<Option<Wrench>>>,
    /// For each foot, in how many frames it seems to stand beside the plates.
    pub beside: Vec<usize>,
    /// For each frame, all plates together; `None` where one has no data, or a foot stands beside them.
    pub total: Vec<Option<Wrench>>,
    /// Whether all plates of a foot have points: else its centre of pressure is not known.
    pub has_points: Vec<bool>,
}

impl Measured {
    /// What `plates` measured under `feet`. A foot is nearest to a force above a part of `weight_n`.
    pub fn of(plates: &[Plate], feet: &[Foot], states: &ContactStates, weight_n: f64) -> Self {
        let uses: Vec<PlateUse> = plates.iter().map(|plate| used(plate, feet)).collect();
        let frames = states.frames();
        let mut measured = Self {
            feet: vec![vec![Some(Wrench::default()); frames]; feet.len()],
            total: vec![Some(Wrench::default()); frames],
            beside: vec![0; feet.len()],
            has_points: vec![true; feet.len()],
            uses,
        };
        for (plate, usage) in plates.iter().zip(measured.uses.clone()) {
            measured.take(plate, &usage, feet, states, weight_n);
        }
        measured.forget_beside(feet, states, weight_n);
        measured
    }

    /// What is under a foot that stands beside the plates is not known.
    fn forget_beside(&mut self, feet: &[Foot], states: &ContactStates, weight_n: f64) {
        for ((foot, series), count) in feet.iter().zip(&mut self.feet).zip(&mut self.beside) {
            let beside = beside(states, foot, series, weight_n);
            for ((own, total), _) in
                series.iter_mut().zip(&mut self.total).zip(beside).filter(|(_, is_beside)| *is_beside)
            {
                (*own, *total) = (None, None);
                *count += 1;
            }
        }
    }

    fn take(
        &mut self,
        plate: &Plate,
        usage: &PlateUse,
        feet: &[Foot],
        states: &ContactStates,
        weight_n: f64,
    ) {
        let may_be_on = candidates(plate, feet);
        for (frame, &time_s) in states.time_s.iter().enumerate() {
            let wrench = plate.at(time_s);
            add(&mut self.total, frame, wrench);
            match (usage.by, wrench) {
                (Some(AssignedBy::Nearest), Some(wrench)) => {
                    let least_n = ON_BW * weight_n;
                    if let Some(foot) = nearest(&wrench, feet, &may_be_on, states, frame, least_n) {
                        self.add_to(foot, frame, Some(wrench));
                    }
                }
                // What is under a foot is not known where a plate has no data, or nobody knows its foot.
                (Some(AssignedBy::Nearest), None) | (None, _) => {
                    may_be_on.iter().for_each(|&foot| self.add_to(foot, frame, None));
                }
                (Some(_), _) => may_be_on.iter().for_each(|&foot| self.add_to(foot, frame, wrench)),
            }
        }
        for foot in may_be_on {
            if let Some(has_points) = self.has_points.get_mut(foot) {
                *has_points &= plate.has_points;
            }
        }
    }

    fn add_to(&mut self, foot: usize, frame: usize, wrench: Option<Wrench>) {
        if let Some(series) = self.feet.get_mut(foot) {
            add(series, frame, wrench);
        }
    }
}

fn add(series: &mut [Option<Wrench>], frame: usize, wrench: Option<Wrench>) {
    if let Some(sum) = series.get_mut(frame) {
        *sum = sum.zip(wrench).map(|(sum, wrench)| sum.and(&wrench));
    }
}

/// The feet that a plate may be under: the one whose body its load is applied to, those of the side that its load or its columns name, or all.
fn candidates(plate: &Plate, feet: &[Foot]) -> Vec<usize> {
    let those = |is_one: &dyn Fn(&Foot) -> bool| -> Vec<usize> {
        feet.iter().enumerate().filter(|(_, foot)| is_one(foot)).map(|(index, _)| index).collect()
    };
    let of_side = |side: Side| those(&|foot| foot.side == Some(side));
    if let Some(body) = &plate.body {
        let own = those(&|foot| foot.bodies.contains(body));
        // A load on another body of the limb, such as the tibia, has the limb's side.
        return if own.is_empty() { Side::of_name(body).map(of_side).unwrap_or_default() } else { own };
    }
    Side::of_name(&plate.name).map_or_else(|| those(&|_| true), of_side)
}

fn used(plate: &Plate, feet: &[Foot]) -> PlateUse {
    let (foot, by) = match candidates(plate, feet).as_slice() {
        &[only] if plate.body.is_some() => (Some(only), Some(AssignedBy::Loads)),
        &[only] if Side::of_name(&plate.name).is_some() => (Some(only), Some(AssignedBy::Name)),
        &[only] => (Some(only), Some(AssignedBy::OnlyFoot)),
        [_, _, ..] if plate.has_points => (None, Some(AssignedBy::Nearest)),
        _ => (None, None),
    };
    PlateUse { plate: plate.name.clone(), foot, by }
}

/// Of some feet, the one with the sphere that is nearest to where the force acts; `None` where there is hardly a force. A foot that swings past one that
/// stands is higher, whatever the view from above says.
fn nearest(
    wrench: &Wrench,
    feet: &[Foot],
    of: &[usize],
    states: &ContactStates,
    frame: usize,
    least_n: f64,
) -> Option<usize> {
    let all = states.frame(frame);
    let mut best: Option<(f64, usize)> = None;
    for (index, foot) in of.iter().filter_map(|&index| Some((index, feet.get(index)?))) {
        for &pair in &foot.pairs {
            let (state, radius_m) = (all.get(pair)?, states.pairs.get(pair)?.radius_m);
            let centre = wrench.centre_of_pressure(state.normal, state.on_surface_m(radius_m), least_n)?;
            let distance = centre.point_m.distance_squared(state.centre_m);
            if best.is_none_or(|(least, _)| distance < least) {
                best = Some((distance, index));
            }
        }
    }
    best.map(|(_, index)| index)
}

/// A foot that moves up or down faster than this does not stand, m/s.
const STILL_M_S: f64 = 0.2;
/// A plate with more than this part of body weight has a foot on it.
const LOADED_BW: f64 = 0.5;
/// A foot on a plate is lower than in this part of the frames in which it stands there.
const LEAST_PART: f64 = 0.05;

/// In which frames `foot` stands beside the plates: it comes as low as in half of the frames on a plate and as still, but without a force.
/// Frames before and after belong to it while the foot is as low as on plates. What it stands on then is not known.
pub(crate) fn beside(
    states: &ContactStates,
    foot: &Foot,
    plates: &[Option<Wrench>],
    weight_n: f64,
) -> Vec<bool> {
    let seen: Vec<Option<(f64, &ContactState)>> = plates
        .iter()
        .enumerate()
        .map(|(frame, plate)| {
            let deepest = deepest(states, foot, frame)?;
            Some((plate.as_ref()?.force_n.dot(deepest.normal), deepest))
        })
        .collect();
    let depth_m = |least_bw: f64, part: f64| {
        let loaded = seen.iter().flatten().filter(|(force_n, _)| *force_n > least_bw * weight_n);
        percentile(&loaded.map(|(_, state)| state.indentation_m).collect::<Vec<f64>>(), part)
    };
    let usual_m = depth_m(LOADED_BW, 0.5).unwrap_or(f64::INFINITY);
    let least_m = depth_m(ON_BW, LEAST_PART).unwrap_or(f64::INFINITY);
    let is_low = |one: &Option<(f64, &ContactState)>| {
        one.as_ref()
            .is_some_and(|(force_n, state)| *force_n < OFF_BW * weight_n && state.indentation_m >= least_m)
    };
    let stands = |one: &Option<(f64, &ContactState)>| {
        one.as_ref()
            .is_some_and(|(_, state)| state.indentation_m >= usual_m && state.rate_m_s.abs() < STILL_M_S)
    };
    let mut found = Vec::with_capacity(seen.len());
    for run in seen.chunk_by(|before, after| is_low(before) == is_low(after)) {
        let is_beside = run.first().is_some_and(is_low) && run.iter().any(stands);
        found.extend(std::iter::repeat_n(is_beside, run.len()));
    }
    found
}

fn deepest<'s>(states: &'s ContactStates, foot: &Foot, frame: usize) -> Option<&'s ContactState> {
    let own = foot.pairs.iter().filter_map(|&pair| states.frame(frame).get(pair));
    own.max_by(|a, b| a.indentation_m.total_cmp(&b.indentation_m))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;

    fn foot(name: &str, side: Side, body: &str) -> Foot {
        Foot { name: name.to_owned(), side: Some(side), pairs: Vec::new(), bodies: vec![body.to_owned()] }
    }

    /// What is made of the plate of `stem`, with or without points, which a load on `body` takes.
    fn taken(stem: &str, body: Option<&str>, feet: &[Foot]) -> (Option<usize>, Option<AssignedBy>) {
        let names: Vec<String> = ["v", "p"]
            .iter()
            .flat_map(|kind| ["x", "y", "z"].map(|axis| format!("{stem}{kind}{axis}")))
            .collect();
        let text = format!("endheader\ntime {}\n0 0 9 0 1 0 1\n", names.join(" "));
        let mut plates = Plate::all(&Table::read(text.as_bytes()).unwrap()).unwrap();
        plates[0].body = body.map(str::to_owned);
        let used = used(&plates[0], feet);
        (used.foot, used.by)
    }

    #[test]
    fn a_side_says_which_foot_where_it_has_one() {
        let two = [foot("right foot", Side::Right, "calcn_r"), foot("left foot", Side::Left, "calcn_l")];
        assert_eq!(taken("ground_force_l_", None, &two), (Some(1), Some(AssignedBy::Name)));
        assert_eq!(taken("ground_force_1_", None, &two), (None, Some(AssignedBy::Nearest)));
        assert_eq!(taken("ground_force_1_", Some("tibia_l"), &two), (Some(1), Some(AssignedBy::Loads)));
        assert_eq!(taken("ground_force_l_", None, &two[..1]), (None, None));
        assert_eq!(taken("ground_force_1_", None, &two[..1]), (Some(0), Some(AssignedBy::OnlyFoot)));
    }

    #[test]
    fn a_side_with_two_feet_says_nothing() {
        let horse = [foot("hind", Side::Right, "pes_r"), foot("fore", Side::Right, "manus_r")];
        assert_eq!(taken("ground_force_r_", None, &horse), (None, Some(AssignedBy::Nearest)));
        assert_eq!(taken("ground_force_1_", Some("manus_r"), &horse), (Some(1), Some(AssignedBy::Loads)));
        assert_eq!(taken("ground_force_1_", Some("radius_r"), &horse), (None, Some(AssignedBy::Nearest)));
        assert_eq!(taken("ground_force_1_", Some("torso"), &horse), (None, None));
    }
}
