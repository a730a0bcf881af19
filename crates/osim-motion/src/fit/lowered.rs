//! How the contacts of a foot get deeper where its spheres go down in their bodies.

use osim_model::Model;
use osim_model::feet::dot;

use crate::assigned::Measured;
use crate::feet::Foot;
use crate::recording::Recording;
use crate::sole::down_at_default_pose;
use crate::states::{ContactState, ContactStates, StatesError};

/// What one metre of a sphere down in its body adds to a contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct PerMetre {
    /// To its indentation.
    pub(super) indentation: f64,
    /// To the rate of that, 1/s.
    pub(super) rate_s: f64,
}

/// The contacts of a model along a recording as they are, and with each sphere moved by one metre along each axis of its body: where
/// a sphere is depends on its place in a straight line.
pub(super) struct Lowered<'s> {
    own: &'s ContactStates,
    along: [ContactStates; 3],
    /// Which way is down for each pair, in the body of its sphere.
    pub(super) down: Vec<[f64; 3]>,
}

impl<'s> Lowered<'s> {
    /// With what is `down` in another recording of the same model, or in this one.
    pub(super) fn of(
        model: &Model,
        recording: &Recording,
        own: &'s ContactStates,
        down: Option<&[[f64; 3]]>,
        (feet, measured): (&[Foot], &Measured),
    ) -> Result<Self, StatesError> {
        let by = |axis: [f64; 3]| own.displaced(model, recording, axis);
        let along = [by([1.0, 0.0, 0.0])?, by([0.0, 1.0, 0.0])?, by([0.0, 0.0, 1.0])?];
        let mut lowered = Self { own, along, down: down_at_default_pose(model, own)? };
        match down {
            Some(down) => lowered.down = down.to_vec(),
            None => lowered.turn_to_floor(feet, measured),
        }
        Ok(lowered)
    }

    /// Down is where the floor is while the plates measure a force, whatever the default pose.
    fn turn_to_floor(&mut self, feet: &[Foot], measured: &Measured) {
        for (foot, plates) in feet.iter().zip(&measured.feet) {
            for &pair in &foot.pairs {
                let mut sum = [0.0; 3];
                for (frame, plate) in plates.iter().enumerate() {
                    let force_n = plate.map_or(0.0, |plate| {
                        self.own.frame(frame).get(pair).map_or(0.0, |state| dot(plate.force_n, state.normal))
                    });
                    // What an axis of the body does to the indentation is how far it points into the floor.
                    let into = self.per_axis(frame, pair, |state| state.indentation_m);
                    sum.iter_mut().zip(into).for_each(|(sum, part)| *sum += force_n.max(0.0) * part);
                }
                let length = dot(sum, sum).sqrt();
                if let Some(down) = self.down.get_mut(pair).filter(|_| length > 0.0) {
                    *down = sum.map(|part| part / length);
                }
            }
        }
    }

    /// What one metre along each axis of its body does to a value of a contact.
    fn per_axis(&self, frame: usize, pair: usize, value: impl Fn(&ContactState) -> f64) -> [f64; 3] {
        let of = |states: &ContactStates| states.frame(frame).get(pair).map(&value);
        self.along.each_ref().map(|moved| of(moved).zip(of(self.own)).map_or(0.0, |(moved, own)| moved - own))
    }

    /// What one metre down adds to each contact of `foot` in the frames `kept`.
    pub(super) fn contacts(&self, foot: &Foot, kept: &[usize]) -> Vec<PerMetre> {
        let each = kept.iter().flat_map(|&frame| foot.pairs.iter().map(move |&pair| (frame, pair)));
        each.filter_map(|(frame, pair)| {
            let down = *self.down.get(pair)?;
            Some(PerMetre {
                indentation: dot(down, self.per_axis(frame, pair, |state| state.indentation_m)),
                rate_s: dot(down, self.per_axis(frame, pair, |state| state.rate_m_s)),
            })
        })
        .collect()
    }
}
