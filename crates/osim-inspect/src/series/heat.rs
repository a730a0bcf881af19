//! Computes the points of heat maps: a quantity over stiffness and dissipation.

use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::{Contact, ContactValues, DomainError, Law, Spheres, equilibrium, limits, restitution};
use osim_model::files::Failure;
use osim_model::messages::{Input, phrase};
use osim_requests::options::FallOptions;
use osim_requests::{Positive, QuantityChoice};

use crate::series::{CarriedWeight, ContactBody, Point, SphereKind, impact_speed};

/// A quantity over stiffness (x, N/m²) and dissipation (y, s/m).
#[derive(Debug, Clone, PartialEq)]
pub struct HeatSeries {
    /// Values of E₁* along the horizontal axis of the heat map, N/m².
    pub x: Vec<f64>,
    /// Values of α along the vertical axis of the heat map, s/m.
    pub y: Vec<f64>,
    /// A row of values for each α; `None` if the quantity has no value at this point.
    pub values: Vec<Vec<Option<f64>>>,
    /// The limit of the quantity, if it has one.
    pub limit: Option<f64>,
    /// E₁* and α of the body before any variation.
    pub present: (f64, f64),
    /// The quantity along the only parameter that changes it; `None` if both parameters change it.
    pub profile: Option<Profile>,
}

/// A parameter that the heat map varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeatParameter {
    Stiffness,
    Dissipation,
}

/// A quantity along the only parameter that changes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    pub along: HeatParameter,
    /// The quantity over the parameter, at more values than the grid of the heat map has.
    pub points: Vec<Point>,
    /// The point for the present parameter of the body; `None` if the quantity has no value at this point.
    pub present: Option<Point>,
}

/// A profile has this many times as many values as the grid.
const PROFILE_STEPS: u32 = 8;
/// Quantities whose relative difference is no more than this are the same.
const SAME_QUANTITY: f64 = 1e-9;

/// The only kind of sphere of a body.
///
/// # Errors
/// The body has several kinds.
fn only_kind(body: &ContactBody) -> Result<&SphereKind, Failure> {
    match body.kinds.as_slice() {
        [kind] => Ok(kind),
        kinds => {
            let message = phrase![
                "its spheres have {} different contacts, and a heat map shows one: choose its force with {}";
                kinds.len().to_string(), Input::Select.with_placeholder("GLOB")
            ];
            Err(Failure::outside(&body.name, "plot", message))
        }
    }
}

/// Computes the quantity for the only contact of a body. The functions `x` and `y` make the axes from the present E₁* and α.
///
/// # Errors
/// The body has several contacts, its weight is not known, or its contact has no dissipation to multiply.
pub fn heat(
    body: &ContactBody,
    quantity: QuantityChoice,
    fall: &FallOptions,
    x: impl FnOnce(f64) -> Vec<f64>,
    y: impl FnOnce(f64) -> Vec<f64>,
) -> Result<HeatSeries, Failure> {
    let kind = only_kind(body)?;
    let present = (kind.contact.plane_strain_modulus(), kind.contact.dissipation());
    let (x, y) = (x(present.0), y(present.1));
    if y.first() == Some(&0.0) {
        let message = phrase![
            "its contacts have no dissipation that could be multiplied: give values like ",
            Input::Dissipation.with_value("0.1..4/25"),
        ];
        return Err(Failure::outside(&body.name, "plot", message));
    }
    let sweep = HeatSweep::new(body, kind, quantity, fall)?;
    let row = |dissipation: &f64| x.iter().map(|stiffness| sweep.value(*stiffness, *dissipation)).collect();
    let values: Vec<Vec<Option<f64>>> = y.iter().map(row).collect();
    let limit = sweep.limit_of_quantity();
    let profile = only_parameter(&values).map(|along| sweep.profile(along, (&x, &y), present));
    Ok(HeatSeries { x, y, values, limit, present, profile })
}

/// The only parameter that changes the values; `None` if both parameters change them, or none does.
fn only_parameter(values: &[Vec<Option<f64>>]) -> Option<HeatParameter> {
    let same = |a: &Option<f64>, b: &Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME_QUANTITY * a.abs(),
        (None, None) => true,
        _ => false,
    };
    let rows_alike = values.windows(2).all(|rows| rows[0].iter().zip(&rows[1]).all(|(a, b)| same(a, b)));
    let columns_alike = values.iter().all(|row| row.windows(2).all(|pair| same(&pair[0], &pair[1])));
    match (rows_alike, columns_alike) {
        (true, false) => Some(HeatParameter::Stiffness),
        (false, true) => Some(HeatParameter::Dissipation),
        _ => None,
    }
}

/// Adds values between neighbours, equally far apart in their logarithms.
fn refined_values(values: &[f64]) -> Vec<f64> {
    let between = values.windows(2).flat_map(|pair| {
        let ratio = pair[1] / pair[0];
        (0..PROFILE_STEPS).map(move |step| pair[0] * ratio.powf(f64::from(step) / f64::from(PROFILE_STEPS)))
    });
    between.chain(values.last().copied()).collect()
}

/// Computes the quantity for any stiffness and dissipation of the contact.
struct HeatSweep<'s> {
    kind: &'s SphereKind,
    quantity: QuantityChoice,
    /// The number n of spheres that carry the weight.
    sphere_count: f64,
    values: DropValues,
    impact_speed_m_s: f64,
}

impl<'s> HeatSweep<'s> {
    fn new(
        body: &ContactBody,
        kind: &'s SphereKind,
        quantity: QuantityChoice,
        fall: &FallOptions,
    ) -> Result<Self, Failure> {
        let &CarriedWeight { mass_kg, gravity_m_s2, sphere_count, .. } = body.weight()?;
        let height_m = fall.height.metres(kind.radius_m);
        let impact_speed_m_s = impact_speed(body, kind, fall.height)?;
        // Until well after the impact, even of a soft contact.
        let until = 10.0 * (kind.radius_m / gravity_m_s2).sqrt() + impact_speed_m_s / gravity_m_s2;
        let duration_s = fall.duration.map_or(until, Positive::get);
        let values = DropValues { mass_kg, gravity_m_s2, height_m, duration_s, samples: 2 };
        Ok(Self { kind, quantity, sphere_count, values, impact_speed_m_s })
    }

    /// The spheres of the body with another stiffness and dissipation.
    fn spheres_with(&self, plane_strain_modulus: f64, dissipation: f64) -> Result<Spheres, DomainError> {
        let smoothing = self.kind.contact.smoothing();
        let values = ContactValues { plane_strain_modulus, dissipation, smoothing };
        Spheres::new(Law::of(&Contact::new(values)?, self.kind.radius_m)?, self.sphere_count)
    }

    /// The quantity for these parameters; `None` if it has no value.
    fn value(&self, stiffness: f64, dissipation: f64) -> Option<f64> {
        let spheres = self.spheres_with(stiffness, dissipation).ok()?;
        match self.quantity {
            QuantityChoice::Indentation => {
                let load = self.values.mass_kg * self.values.gravity_m_s2;
                // By the Hertz law, which the limit is about; `check` and the manifest of a sweep also use it.
                let indentation = equilibrium::hertz_indentation(&[spheres], load).ok()?;
                Some(indentation / self.kind.radius_m)
            }
            QuantityChoice::Restitution => restitution::exact(dissipation, self.impact_speed_m_s).ok(),
            QuantityChoice::PeakForce => {
                let report = DropTest::new([spheres], self.values).ok()?.run().ok()?;
                Some(report.peak_force_bw())
            }
        }
    }

    /// The quantity along one parameter; the other parameter keeps its present value.
    fn profile(&self, along: HeatParameter, (x, y): (&[f64], &[f64]), present: (f64, f64)) -> Profile {
        let (grid, at_present, value): (_, _, &dyn Fn(f64) -> Option<f64>) = match along {
            HeatParameter::Stiffness => (x, present.0, &|stiffness| self.value(stiffness, present.1)),
            HeatParameter::Dissipation => (y, present.1, &|dissipation| self.value(present.0, dissipation)),
        };
        let point = |at: f64| Some((at, value(at)?));
        Profile {
            along,
            points: refined_values(grid).into_iter().filter_map(point).collect(),
            present: point(at_present),
        }
    }

    /// The limit of the quantity that the heat map shows, if it has one.
    fn limit_of_quantity(&self) -> Option<f64> {
        let speed = self.impact_speed_m_s;
        match self.quantity {
            QuantityChoice::Indentation => Some(limits::INDENTATION.value),
            QuantityChoice::Restitution => {
                // The limit is about (13), as in `check`; the values are exact. So convert it.
                let dissipation = restitution::dissipation(limits::RESTITUTION.value, speed).ok()?;
                restitution::exact(dissipation, speed).ok()
            }
            QuantityChoice::PeakForce => None,
        }
    }
}
