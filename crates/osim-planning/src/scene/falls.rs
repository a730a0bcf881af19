//! How a body falls on its contacts, moment by moment.

use contact_scaling::drop_test::Sample;
use osim_inspect::series::{self, Body};
use osim_model::files::Failure;
use osim_requests::DropHeight;
use serde::Serialize;

/// A fall from a quarter of the radius, as in the paper's drop tests.
const HEIGHT: DropHeight = DropHeight::Radii(0.25);
/// Moments that are shown.
const MOMENTS: usize = 361;
/// More than enough for a body to come to rest that bounces as feet do, in √(R/g).
const TIMES: f64 = 12.0;

/// A body that falls on its contacts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Fall {
    /// Whose contacts.
    pub name: String,
    /// Time from one moment to the next, s.
    pub step_s: f64,
    /// √(Σ R²/n) of the spheres, m.
    pub radius_m: f64,
    /// Height of the spheres' bottoms over the ground at each moment, m; below 0 in contact.
    pub heights_m: Vec<f64>,
    /// Force of all spheres at each moment, body weights.
    pub forces_bw: Vec<f64>,
    /// Why it cannot be followed; then there are no moments.
    pub why_not: Option<String>,
}

impl Fall {
    /// The falls of `bodies`, followed for the same time.
    #[must_use]
    pub fn all(bodies: &[Body]) -> Vec<Self> {
        let radii = bodies.iter().filter_map(|body| {
            let weight = body.weight().ok()?;
            let largest = body.kinds.iter().map(|kind| kind.radius_m).fold(0.0, f64::max);
            Some((largest / weight.gravity_m_s2).sqrt())
        });
        let duration_s = TIMES * radii.fold(0.0, f64::max);
        bodies.iter().map(|body| Self::of(body, duration_s)).collect()
    }

    fn of(body: &Body, duration_s: f64) -> Self {
        let none = |failure: Failure| Self {
            name: body.name.clone(),
            step_s: 0.0,
            radius_m: 0.0,
            heights_m: Vec::new(),
            forces_bw: Vec::new(),
            why_not: Some(failure.message.to_string()),
        };
        let report = match series::dropped(body, HEIGHT, duration_s, MOMENTS) {
            Ok(report) => report,
            Err(failure) => return none(failure),
        };
        let of = |value: &dyn Fn(&Sample) -> f64| report.series.iter().map(value).collect();
        #[expect(clippy::cast_precision_loss, reason = "a few hundred")]
        let intervals = (MOMENTS - 1) as f64;
        Self {
            name: body.name.clone(),
            step_s: duration_s / intervals,
            radius_m: report.reference_radius_m,
            heights_m: of(&|sample| sample.height_m),
            forces_bw: of(&|sample| sample.force_n / report.body_weight_n),
            why_not: None,
        }
    }
}
