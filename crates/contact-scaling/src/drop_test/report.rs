//! The results of a drop test.

use super::body::Body;
use super::error::DropError;
use super::motion::Record;
use super::values::DropValues;
use crate::{equilibrium, restitution};

/// One moment of a drop.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Sample {
    /// Time since the release, in s.
    pub time_s: f64,
    /// Height of the spheres' bottoms above the ground, in m; below 0 in contact, where it is −x.
    pub height_m: f64,
    /// Rate of the height, in m/s; below 0 while falling.
    pub speed_m_s: f64,
    /// Normal force of all spheres, in N.
    pub force_n: f64,
}

/// The first contact with the ground, from one crossing of height 0 to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FirstContact {
    /// When the bottoms reach the ground, in s.
    pub start_s: f64,
    /// How fast they do, in m/s: the ẋ⁻ of (13).
    pub impact_speed_m_s: f64,
    /// The end of this contact; `None` if the body never leaves the ground again.
    pub end: Option<Lift>,
    /// Restitution of an impact without gravity at this speed, by the law itself.
    pub restitution_exact: f64,
    /// The same by (13); `None` if the result is below 0.
    pub restitution_approximate: Option<f64>,
}

/// The end of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Lift {
    /// Time from the start of the contact to its end, in s.
    pub contact_time_s: f64,
    /// Speed with which the bottoms leave the ground, in m/s.
    pub rebound_speed_m_s: f64,
}

/// The result of a drop test.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DropReport {
    /// The motion, at equal steps of time.
    pub series: Vec<Sample>,
    /// Body weight M g, in N.
    pub body_weight_n: f64,
    /// The radius lengths are compared with, √(Σ R_i² / n), in m.
    pub reference_radius_m: f64,
    /// The time times are compared with, √(R / g), in s.
    pub reference_time_s: f64,
    /// Indentation x at the end of the series, in m.
    pub final_indentation_m: f64,
    /// Indentation at rest by the Hertz law (11), in m.
    pub hertz_indentation_m: f64,
    /// Indentation at rest by the laws themselves, in m; below 0 where smoothing holds the body above the ground.
    pub equilibrium_indentation_m: f64,
    /// Stiffness of one sphere (their mean) at rest by the Hertz law (B.1), in N/m.
    pub hertz_stiffness_n_m: f64,
    /// Stiffness of one sphere (their mean) at rest by the laws themselves, (C.9) at ẋ = 0 for a smoothed one, in N/m.
    pub equilibrium_stiffness_n_m: f64,
    /// The largest normal force of all spheres, in N.
    pub peak_force_n: f64,
    /// The first contact; `None` if the bottoms never reach the ground.
    pub first_contact: Option<FirstContact>,
}

impl DropReport {
    pub(super) fn new(body: &Body<'_>, values: &DropValues, record: Record) -> Result<Self, DropError> {
        let hertz = equilibrium::hertz_indentation(body.spheres, body.weight_n)?;
        let own = equilibrium::indentation(body.spheres, body.weight_n)?;
        let last = record.states.last().map_or(0.0, |state| state[0] * body.length_m);
        Ok(Self {
            body_weight_n: body.weight_n,
            reference_radius_m: body.length_m,
            reference_time_s: body.time_s,
            final_indentation_m: last,
            hertz_indentation_m: hertz,
            equilibrium_indentation_m: own,
            hertz_stiffness_n_m: body.mean(|s| s.law().hertz().stiffness(hertz)),
            equilibrium_stiffness_n_m: body.mean(|s| s.law().rest_stiffness(own)),
            peak_force_n: record.peak_force * body.weight_n,
            first_contact: first_contact(body, &record)?,
            series: series(body, values, record),
        })
    }

    /// Largest normal force over body weight.
    #[must_use]
    pub fn peak_force_bw(&self) -> f64 {
        self.peak_force_n / self.body_weight_n
    }
}

fn first_contact(body: &Body<'_>, record: &Record) -> Result<Option<FirstContact>, DropError> {
    let Some(&(start, impact)) = record.crossings.first() else { return Ok(None) };
    let impact_speed_m_s = impact * body.speed_m_s();
    let alpha = body.dissipation();
    let end = record.crossings.get(1).map(|&(end, rebound)| Lift {
        contact_time_s: (end - start) * body.time_s,
        rebound_speed_m_s: -rebound * body.speed_m_s(),
    });
    Ok(Some(FirstContact {
        start_s: start * body.time_s,
        impact_speed_m_s,
        end,
        restitution_exact: restitution::exact(alpha, impact_speed_m_s)?,
        restitution_approximate: restitution::approximate(alpha, impact_speed_m_s).ok(),
    }))
}

fn series(body: &Body<'_>, values: &DropValues, record: Record) -> Vec<Sample> {
    let last = (values.samples - 1) as f64;
    let sample = |(i, state): (usize, [f64; 2])| {
        let (x, rate) = (state[0] * body.length_m, state[1] * body.speed_m_s());
        Sample {
            time_s: values.duration_s * (i as f64 / last),
            height_m: 0.0 - x,
            speed_m_s: 0.0 - rate,
            force_n: body.force_n(x, rate),
        }
    };
    record.states.into_iter().enumerate().map(sample).collect()
}
