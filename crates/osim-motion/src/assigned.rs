//! Which foot is on which plate.

use osim_feet::dot;
use osim_model::Side;

use crate::feet::Foot;
use crate::plates::Plate;
use crate::stance::ON_BW;
use crate::states::ContactStates;
use crate::wrench::Wrench;

/// What says which foot a plate measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AssignedBy {
    /// The body that its load is applied to.
    Loads,
    /// The side in the name of its columns.
    Name,
    /// The foot that is nearest to its centre of pressure, frame by frame.
    Nearest,
    /// There is one foot.
    OnlyFoot,
}

/// What was made of one plate.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
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
#[non_exhaustive]
pub struct Measured {
    /// For each plate, what was made of it.
    pub uses: Vec<PlateUse>,
    /// For each foot and frame; `None` where a plate that it may be on has no data.
    pub feet: Vec<Vec<Option<Wrench>>>,
    /// For each frame, all plates together.
    pub total: Vec<Option<Wrench>>,
    /// Whether all plates of a foot have points: else its centre of pressure is not known.
    pub has_points: Vec<bool>,
}

impl Measured {
    /// What `plates` measured under `feet`. A foot is nearest to a force above a part of `weight_n`.
    #[must_use]
    pub fn of(plates: &[Plate], feet: &[Foot], states: &ContactStates, weight_n: f64) -> Self {
        let uses: Vec<PlateUse> = plates.iter().map(|plate| used(plate, feet)).collect();
        let frames = states.frames();
        let mut measured = Self {
            feet: vec![vec![Some(Wrench::default()); frames]; feet.len()],
            total: vec![Some(Wrench::default()); frames],
            has_points: vec![true; feet.len()],
            uses,
        };
        for (plate, usage) in plates.iter().zip(measured.uses.clone()) {
            measured.take(plate, &usage, feet, states, weight_n);
        }
        measured
    }

    fn take(
        &mut self,
        plate: &Plate,
        usage: &PlateUse,
        feet: &[Foot],
        states: &ContactStates,
        weight_n: f64,
    ) {
        for (frame, &time_s) in states.time_s.iter().enumerate() {
            let wrench = plate.at(time_s);
            add(&mut self.total, frame, wrench);
            match (usage.foot, usage.by) {
                (Some(foot), _) => self.add_to(foot, frame, wrench),
                (None, Some(AssignedBy::Nearest)) => match wrench {
                    None => (0..feet.len()).for_each(|foot| self.add_to(foot, frame, None)),
                    Some(wrench) => {
                        if let Some(foot) = nearest(&wrench, feet, states, frame, ON_BW * weight_n) {
                            self.add_to(foot, frame, Some(wrench));
                        }
                    }
                },
                _ => {}
            }
        }
        if !plate.has_points {
            for (foot, has_points) in self.has_points.iter_mut().enumerate() {
                *has_points &= usage.foot.is_some_and(|own| own != foot);
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

fn used(plate: &Plate, feet: &[Foot]) -> PlateUse {
    let of = |foot: Option<usize>, by| PlateUse {
        plate: plate.name.clone(),
        foot,
        by: foot.is_some().then_some(by),
    };
    let of_side = |side: Side| feet.iter().position(|foot| foot.side == Some(side));
    if let Some(body) = &plate.body {
        let own = feet.iter().position(|foot| foot.bodies.contains(body));
        // A load on another body of the limb, such as the tibia, has the limb's side.
        return of(own.or_else(|| of_side(Side::of_name(body)?)), AssignedBy::Loads);
    }
    if let Some(side) = Side::of_name(&plate.name) {
        return of(of_side(side), AssignedBy::Name);
    }
    match feet.len() {
        1 => of(Some(0), AssignedBy::OnlyFoot),
        _ if plate.has_points => {
            PlateUse { plate: plate.name.clone(), foot: None, by: Some(AssignedBy::Nearest) }
        }
        _ => PlateUse { plate: plate.name.clone(), foot: None, by: None },
    }
}

/// The foot whose lowest sphere is nearest to where the force acts, along its plane; `None` where there is hardly a force.
fn nearest(
    wrench: &Wrench,
    feet: &[Foot],
    states: &ContactStates,
    frame: usize,
    least_n: f64,
) -> Option<usize> {
    let all = states.frame(frame);
    let mut best: Option<(f64, usize)> = None;
    for (index, foot) in feet.iter().enumerate() {
        let own = foot.pairs.iter().filter_map(|&pair| all.get(pair));
        let lowest = own.max_by(|a, b| a.indentation_m.total_cmp(&b.indentation_m))?;
        let centre = wrench.centre_of_pressure(lowest.normal, lowest.point_m, least_n)?;
        let away: [f64; 3] = std::array::from_fn(|i| centre.point_m[i] - lowest.centre_m[i]);
        let up = dot(away, lowest.normal);
        let distance = dot(away, away) - up * up;
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, index));
        }
    }
    best.map(|(_, index)| index)
}
