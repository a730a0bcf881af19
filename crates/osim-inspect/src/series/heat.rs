//! A quantity over stiffness and dissipation.

use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::{Contact, ContactValues, DomainError, Law, Spheres, equilibrium, limits, restitution};
use osim_model::files::Failure;
use osim_model::messages::{Input, phrase};
use osim_requests::{DropHeight, HeatQuantity, PlotRequest, Positive};

use crate::series::body::{Body, SphereKind};
use crate::series::curves::impact_speed;
use crate::series::sampling::Point;

#[derive(Debug, Clone, PartialEq)]
pub struct HeatRequest {
    pub quantity: HeatQuantity,
    /// From how high the body falls.
    pub height: DropHeight,
    /// How long it is followed, s; `None`: until well after the impact.
    pub duration_s: Option<f64>,
}

impl From<&PlotRequest> for HeatRequest {
    fn from(request: &PlotRequest) -> Self {
        Self {
            quantity: request.heat.quantity.quantity(),
            height: request.fall.height.get(),
            duration_s: request.fall.duration.map(Positive::get),
        }
    }
}

/// A quantity over stiffness (x, N/m²) and dissipation (y, s/m).
#[derive(Debug, Clone, PartialEq)]
pub struct HeatSeries {
    /// E₁*.
    pub x: Vec<f64>,
    /// α.
    pub y: Vec<f64>,
    /// A row for each α; `None` where there is no answer.
    pub values: Vec<Vec<Option<f64>>>,
    /// The limit of the law, in the units of the quantity, where it has one.
    pub limit: Option<f64>,
    /// The body's own E₁* and α.
    pub now: (f64, f64),
    /// Where only one of the two changes the quantity: the quantity along it.
    pub profile: Option<Profile>,
}

/// Which parameter changes.
///
/// Exhaustive: code that draws it needs an axis for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// E₁*.
    Stiffness,
    /// α.
    Dissipation,
}

/// A quantity along the one parameter that changes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    pub along: Parameter,
    /// The quantity over it, at more values than the grid has.
    pub points: Vec<Point>,
    /// The body's own value; `None` where there is no answer.
    pub now: Option<Point>,
}

/// Values between two neighbours of a grid along which a curve is drawn.
const FINER: u32 = 8;
/// Quantities that differ by less, relative to themselves, are the same.
const SAME: f64 = 1e-9;

/// The one contact of a body.
///
/// # Errors
/// It has several.
fn only_kind(body: &Body) -> Result<&SphereKind, Failure> {
    match body.kinds.as_slice() {
        [kind] => Ok(kind),
        kinds => {
            let message = phrase![
                format!(
                    "its spheres have {} different contacts, and a sweep is about one: choose it with ",
                    kinds.len()
                ),
                Input::Select.with_placeholder("GLOB"),
            ];
            Err(Failure::outside(&body.name, "plot", message))
        }
    }
}

/// The quantity for the one contact of a body; `x` and `y` make axes of its own E₁* and α.
///
/// # Errors
/// The body has several contacts, its weight is not known, or its contact has no dissipation to multiply.
pub fn heat(
    body: &Body,
    request: &HeatRequest,
    x: impl FnOnce(f64) -> Vec<f64>,
    y: impl FnOnce(f64) -> Vec<f64>,
) -> Result<HeatSeries, Failure> {
    let kind = only_kind(body)?;
    let now = (kind.contact.plane_strain_modulus(), kind.contact.dissipation());
    let (x, y) = (x(now.0), y(now.1));
    if y.first() == Some(&0.0) {
        let message = phrase![
            "its contacts have no dissipation that could be multiplied: give values like ",
            Input::Dissipation.with_value("0.1..4/25"),
        ];
        return Err(Failure::outside(&body.name, "plot", message));
    }
    let swept = Swept::new(body, kind, request)?;
    let row = |dissipation: &f64| x.iter().map(|stiffness| swept.value(*stiffness, *dissipation)).collect();
    let values: Vec<Vec<Option<f64>>> = y.iter().map(row).collect();
    let limit = swept.limit();
    let profile = only_parameter(&values).map(|along| swept.profile(along, (&x, &y), now));
    Ok(HeatSeries { x, y, values, limit, now, profile })
}

/// The parameter that alone changes the values; `None` where both do, or none.
fn only_parameter(values: &[Vec<Option<f64>>]) -> Option<Parameter> {
    let same = |a: &Option<f64>, b: &Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME * a.abs(),
        (None, None) => true,
        _ => false,
    };
    let rows_alike = values.windows(2).all(|rows| rows[0].iter().zip(&rows[1]).all(|(a, b)| same(a, b)));
    let columns_alike = values.iter().all(|row| row.windows(2).all(|pair| same(&pair[0], &pair[1])));
    match (rows_alike, columns_alike) {
        (true, false) => Some(Parameter::Stiffness),
        (false, true) => Some(Parameter::Dissipation),
        _ => None,
    }
}

/// The values with more between each two neighbours, equally far apart in their logarithms.
fn finer(values: &[f64]) -> Vec<f64> {
    let between = values.windows(2).flat_map(|pair| {
        let ratio = pair[1] / pair[0];
        (0..FINER).map(move |step| pair[0] * ratio.powf(f64::from(step) / f64::from(FINER)))
    });
    between.chain(values.last().copied()).collect()
}

/// What is computed for each cell.
struct Swept<'s> {
    kind: &'s SphereKind,
    quantity: HeatQuantity,
    /// n spheres carry M g.
    sphere_count: f64,
    values: DropValues,
    impact_speed_m_s: f64,
}

impl<'s> Swept<'s> {
    fn new(body: &'s Body, kind: &'s SphereKind, request: &HeatRequest) -> Result<Self, Failure> {
        let weight = body.weight()?;
        let height_m = request.height.metres(kind.radius_m);
        let impact_speed_m_s = impact_speed(body, kind, request.height)?;
        // Until well after the impact, even of a soft contact.
        let until =
            10.0 * (kind.radius_m / weight.gravity_m_s2).sqrt() + impact_speed_m_s / weight.gravity_m_s2;
        let values = DropValues {
            mass_kg: weight.mass_kg,
            gravity_m_s2: weight.gravity_m_s2,
            height_m,
            duration_s: request.duration_s.unwrap_or(until),
            samples: 2,
        };
        let sphere_count = weight.sphere_count;
        Ok(Self { kind, quantity: request.quantity, sphere_count, values, impact_speed_m_s })
    }

    fn spheres(&self, stiffness: f64, dissipation: f64) -> Result<Spheres, DomainError> {
        let values = ContactValues {
            plane_strain_modulus: stiffness,
            dissipation,
            smoothing: self.kind.contact.smoothing(),
        };
        Spheres::new(Law::of(&Contact::new(values)?, self.kind.radius_m)?, self.sphere_count)
    }

    /// The quantity; `None` where there is no answer.
    fn value(&self, stiffness: f64, dissipation: f64) -> Option<f64> {
        let spheres = self.spheres(stiffness, dissipation).ok()?;
        match self.quantity {
            HeatQuantity::Indentation => {
                let load = self.values.mass_kg * self.values.gravity_m_s2;
                // By the Hertz law, as `check` and the manifest of a sweep have it: the limit is that law's.
                let indentation = equilibrium::hertz_indentation(&[spheres], load).ok()?;
                Some(indentation / self.kind.radius_m)
            }
            HeatQuantity::Restitution => restitution::exact(dissipation, self.impact_speed_m_s).ok(),
            HeatQuantity::PeakForce => {
                let report = DropTest::new([spheres], self.values).ok()?.run().ok()?;
                Some(report.peak_force_bw())
            }
        }
    }

    /// The quantity along one parameter, the other as the body has it.
    fn profile(&self, along: Parameter, (x, y): (&[f64], &[f64]), now: (f64, f64)) -> Profile {
        let (grid, own, value): (_, _, &dyn Fn(f64) -> Option<f64>) = match along {
            Parameter::Stiffness => (x, now.0, &|stiffness| self.value(stiffness, now.1)),
            Parameter::Dissipation => (y, now.1, &|dissipation| self.value(now.0, dissipation)),
        };
        let point = |at: f64| Some((at, value(at)?));
        Profile { along, points: finer(grid).into_iter().filter_map(point).collect(), now: point(own) }
    }

    fn limit(&self) -> Option<f64> {
        let speed = self.impact_speed_m_s;
        match self.quantity {
            HeatQuantity::Indentation => Some(limits::INDENTATION.value),
            HeatQuantity::Restitution => {
                // The limit is one of (13), as `check` has it; the values are the law's own.
                let dissipation = restitution::dissipation(limits::RESTITUTION.value, speed).ok()?;
                restitution::exact(dissipation, speed).ok()
            }
            HeatQuantity::PeakForce => None,
        }
    }
}
