//! Drop tests: a body falls on its spheres, with one vertical degree of freedom and the bottoms of all spheres at one height.
//!
//! The equation of motion is M ẍ = M g − Σ F_i(x, ẋ). x is the common indentation of the spheres; before contact it is minus
//! their height. It is the experiment of the paper's Table 1 and Fig. 4.
//!
//! ```
//! use contact_scaling::drop_test::DropTest;
//! use contact_scaling::falisse2022;
//!
//! let human = falisse2022();
//! let report = DropTest::of(&human.contact, &human.scale, 0.25, 2.0)?.run()?;
//! let x_hat = report.final_indentation_m / 0.032;
//! assert!((x_hat - 0.3396).abs() < 2e-4); // the smoothed law rests here, the Hertz law at 0.353
//! assert!(report.first_contact.is_some_and(|contact| contact.end.is_none())); // it never leaves the ground
//! # Ok::<(), contact_scaling::drop_test::DropError>(())
//! ```

mod integration;

use crate::error::{require_non_negative, require_positive, require_range};
use crate::{Contact, Law, Scale, Spheres, equilibrium, restitution};
pub use integration::{DropError, DropValues};
use integration::{FallingBody, RecordedDrop};

/// A drop test that can be run.
///
/// M, g and the duration are above 0, the height 0 or above, all finite; at least one sphere, at least two
/// samples: checked once, in [`DropTest::new`].
#[derive(Debug, Clone, PartialEq)]
pub struct DropTest {
    values: DropValues,
    spheres: Vec<Spheres>,
}

impl DropTest {
    /// The default number of samples in a series.
    pub const SAMPLES: usize = 1001;

    /// A drop test of a body on `spheres`. Spheres with the same law become one entry.
    ///
    /// # Errors
    /// [`DropError::Domain`] if a number is outside its domain, or if there is no sphere.
    pub fn new(spheres: impl IntoIterator<Item = Spheres>, values: DropValues) -> Result<Self, DropError> {
        require_positive("mass", values.mass_kg)?;
        require_positive("gravity", values.gravity_m_s2)?;
        require_non_negative("height", values.height_m)?;
        require_positive("duration", values.duration_s)?;
        require_range(values.samples >= 2, "number of samples", values.samples as f64, "at least 2")?;
        let mut groups: Vec<Spheres> = Vec::new();
        for one in spheres {
            match groups.iter_mut().find(|group| group.law() == one.law()) {
                Some(group) => *group = Spheres::new(*one.law(), group.count() + one.count())?,
                None => groups.push(one),
            }
        }
        require_range(!groups.is_empty(), "number of spheres", 0.0, "at least 1")?;
        Ok(Self { values, spheres: groups })
    }

    /// A drop test of a body of scale `scale` on n equal spheres, from a height in sphere radii (0.25 in the
    /// paper), for a duration in s (2 in the paper).
    ///
    /// # Errors
    /// As [`DropTest::new`].
    pub fn of(
        contact: &Contact,
        scale: &Scale,
        height_radii: f64,
        duration_s: f64,
    ) -> Result<Self, DropError> {
        let law = Law::of(contact, scale.radius_m())?;
        let values = DropValues {
            mass_kg: scale.mass_kg(),
            gravity_m_s2: scale.gravity_m_s2(),
            height_m: height_radii * scale.radius_m(),
            duration_s,
            samples: Self::SAMPLES,
        };
        Self::new([Spheres::new(law, scale.sphere_count())?], values)
    }

    /// Mass, gravity, height, duration and number of samples, by name.
    pub fn values(&self) -> DropValues {
        self.values
    }

    /// The spheres of the body; spheres with the same law are one entry.
    pub fn spheres(&self) -> &[Spheres] {
        &self.spheres
    }

    /// √(Σ R_i² / n), in m: the radius by which lengths are made dimensionless.
    pub fn reference_radius_m(&self) -> f64 {
        self.body().length_m
    }

    /// Computes the motion of the body from the release to the end of the duration.
    ///
    /// # Errors
    /// [`DropError::Integration`] if the contact is too stiff for the duration; [`DropError::Domain`] if no indentation
    /// carries the body weight.
    pub fn run(&self) -> Result<DropReport, DropError> {
        let body = self.body();
        let record = integration::integrate(&body, &self.values)?;
        DropReport::new(&body, &self.values, record)
    }

    fn body(&self) -> FallingBody<'_> {
        FallingBody::new(&self.spheres, self.values.mass_kg, self.values.gravity_m_s2)
    }
}

/// The state at one moment of a drop.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Sample {
    /// Time since the release, in s.
    pub time_s: f64,
    /// Height of the spheres' bottoms above the ground, in m; in contact it is −x, below 0.
    pub height_m: f64,
    /// Rate of the height, in m/s; negative while the body falls.
    pub speed_m_s: f64,
    /// Normal force of all spheres, in N.
    pub force_n: f64,
}

/// The first contact with the ground: from the first crossing of height 0 to the second.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FirstContact {
    /// Time at which the bottoms reach the ground, in s.
    pub start_s: f64,
    /// Speed of the bottoms at `start_s`, in m/s: the ẋ⁻ of (13).
    pub impact_speed_m_s: f64,
    /// The lift-off at the end of the first contact; `None` if the body does not leave the ground again.
    pub end: Option<LiftOff>,
    /// Restitution of an impact without gravity at the impact speed, by the exact equation of the law; without unit.
    pub restitution_exact: f64,
    /// Restitution of the same impact by the approximation (13), without unit; `None` if (13) gives less than 0.
    pub restitution_approximate: Option<f64>,
}

/// The lift-off at the end of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LiftOff {
    /// Time from the start of the contact to its end, in s.
    pub contact_time_s: f64,
    /// Speed with which the bottoms leave the ground, in m/s.
    pub rebound_speed_m_s: f64,
}

/// The computed fall of a body on its contacts: peak force, rebound and restitution.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DropReport {
    /// The motion, at equal steps of time.
    pub series: Vec<Sample>,
    /// Body weight M g, in N.
    pub body_weight_n: f64,
    /// √(Σ R_i² / n), in m: the radius by which lengths are made dimensionless.
    pub reference_radius_m: f64,
    /// √(R / g), in s: the time by which times are made dimensionless.
    pub reference_time_s: f64,
    /// Indentation x at the end of the series, in m.
    pub final_indentation_m: f64,
    /// Indentation at equilibrium under body weight by the Hertz law (11), in m.
    pub hertz_indentation_m: f64,
    /// Indentation at equilibrium under body weight by the contact laws, in m; negative if a smoothed force holds the body
    /// above the ground.
    pub equilibrium_indentation_m: f64,
    /// Mean stiffness of a sphere at the equilibrium of the Hertz law (B.1), in N/m.
    pub hertz_stiffness_n_m: f64,
    /// Mean stiffness of a sphere at the equilibrium of the contact laws, in N/m; (C.9) at ẋ = 0 for a smoothed law.
    pub equilibrium_stiffness_n_m: f64,
    /// The largest normal force of all spheres, in N.
    pub peak_force_n: f64,
    /// The first contact; `None` if the bottoms never reach the ground.
    pub first_contact: Option<FirstContact>,
}

impl DropReport {
    /// The report of a computed fall, with its equilibria and its first contact.
    fn new(body: &FallingBody<'_>, values: &DropValues, record: RecordedDrop) -> Result<Self, DropError> {
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
            series: samples_of_fall(body, values, record),
        })
    }

    /// Largest normal force divided by body weight, without unit.
    pub fn peak_force_bw(&self) -> f64 {
        self.peak_force_n / self.body_weight_n
    }
}

/// The first contact in a recorded fall; `None` if the body does not touch the ground.
fn first_contact(body: &FallingBody<'_>, record: &RecordedDrop) -> Result<Option<FirstContact>, DropError> {
    let Some(&(start, impact)) = record.crossings.first() else { return Ok(None) };
    let impact_speed_m_s = impact * body.speed_m_s();
    let alpha = body.dissipation();
    let end = record.crossings.get(1).map(|&(end, rebound)| LiftOff {
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

/// The recorded states as samples in SI units.
fn samples_of_fall(body: &FallingBody<'_>, values: &DropValues, record: RecordedDrop) -> Vec<Sample> {
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

/// The largest differences between two drops in dimensionless form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Difference {
    /// Largest difference of height / R, without unit.
    pub height: f64,
    /// Largest difference of force / (M g), without unit.
    pub force: f64,
    /// The dimensionless time t / √(R/g) up to which both drops were compared.
    pub until: f64,
}

/// The largest differences between two drops at equal dimensionless times, up to the end of the shorter drop.
///
/// Both drops are computed again at common dimensionless times, with the larger of the two numbers of samples.
///
/// # Errors
/// As [`DropTest::run`].
pub fn compare(a: &DropTest, b: &DropTest) -> Result<Difference, DropError> {
    let until = dimensionless_duration(a).min(dimensionless_duration(b));
    let samples = a.values().samples.max(b.values().samples);
    let (a, b) = (run_until(a, until, samples)?, run_until(b, until, samples)?);
    let mut difference = Difference { height: 0.0, force: 0.0, until };
    for (p, q) in a.series.iter().zip(&b.series) {
        let height = p.height_m / a.reference_radius_m - q.height_m / b.reference_radius_m;
        let force = p.force_n / a.body_weight_n - q.force_n / b.body_weight_n;
        difference.height = difference.height.max(height.abs());
        difference.force = difference.force.max(force.abs());
    }
    Ok(difference)
}

/// The duration of a drop test in units of √(R/g).
fn dimensionless_duration(test: &DropTest) -> f64 {
    test.values().duration_s / test.body().time_s
}

fn run_until(test: &DropTest, until: f64, samples: usize) -> Result<DropReport, DropError> {
    let duration_s = until * test.body().time_s;
    let values = DropValues { duration_s, samples, ..test.values() };
    // The values are known to be valid.
    DropTest { values, spheres: test.spheres.clone() }.run()
}
