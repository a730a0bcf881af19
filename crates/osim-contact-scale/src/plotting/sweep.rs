//! A quantity over stiffness and dissipation.

use anyhow::anyhow;
use contact_plots::{HeatLimit, HeatMap};
use contact_scaling::drop_test::{DropTest, DropValues};
use contact_scaling::{Contact, ContactValues, DomainError, Law, Spheres, equilibrium, limits, restitution};

use super::body::{Body, Kind};
use super::series::impact_speed;
use crate::args::{Length, PlotArgs, Quantity};
use crate::failure::Failure;

/// Colours over E₁* and α for the one contact of a body.
///
/// # Errors
/// The body has several contacts, its weight is not known, or its contact has no dissipation to multiply.
pub(crate) fn map(body: &Body, args: &PlotArgs) -> Result<HeatMap, Failure> {
    let [kind] = body.kinds.as_slice() else {
        return Err(body.failure(&anyhow!(
            "its spheres have {} different contacts, and a sweep is about one: choose it with --select GLOB",
            body.kinds.len()
        )));
    };
    let now = (kind.contact.plane_strain_modulus(), kind.contact.dissipation());
    let x = args.sweep.stiffness.values(now.0);
    let y = args.sweep.dissipation.values(now.1);
    if y.first() == Some(&0.0) {
        return Err(body.failure(&anyhow!(
            "its contacts have no dissipation that could be multiplied: give values like --dissipation 0.1..4/25"
        )));
    }
    let swept = Swept::new(body, kind, args)?;
    let row = |dissipation: &f64| x.iter().map(|stiffness| swept.value(*stiffness, *dissipation)).collect();
    Ok(HeatMap {
        title: args.title.clone().unwrap_or_else(|| format!("{}: {}", swept.title(), body.name)),
        description: format!(
            "{} of {} as a colour, over stiffness E₁* and dissipation α, both on logarithmic axes.",
            swept.label(),
            body.name
        ),
        x_label: "stiffness E₁* (N/m²)".to_owned(),
        y_label: "dissipation α (s/m)".to_owned(),
        values: y.iter().map(row).collect(),
        x,
        y,
        value_label: swept.label().to_owned(),
        limit: swept.limit(),
        mark: Some((format!("{} now", body.name), now)),
    })
}

/// What is computed for each cell.
struct Swept<'s> {
    kind: &'s Kind,
    quantity: Quantity,
    /// n spheres carry M g.
    sphere_count: f64,
    values: DropValues,
    impact_speed_m_s: f64,
}

impl<'s> Swept<'s> {
    fn new(body: &'s Body, kind: &'s Kind, args: &PlotArgs) -> Result<Self, Failure> {
        let weight = body.weight()?;
        let height_m = match args.fall.height {
            Length::Metres(metres) => metres,
            Length::Radii(radii) => radii * kind.radius_m,
        };
        let impact_speed_m_s = impact_speed(body, kind, args.fall.height)?;
        // Until well after the impact, even of a soft contact.
        let until =
            10.0 * (kind.radius_m / weight.gravity_m_s2).sqrt() + impact_speed_m_s / weight.gravity_m_s2;
        let values = DropValues {
            mass_kg: weight.mass_kg,
            gravity_m_s2: weight.gravity_m_s2,
            height_m,
            duration_s: args.fall.duration.unwrap_or(until),
            samples: 2,
        };
        let sphere_count = weight.sphere_count;
        Ok(Self { kind, quantity: args.sweep.quantity, sphere_count, values, impact_speed_m_s })
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
            Quantity::Indentation => {
                let load = self.values.mass_kg * self.values.gravity_m_s2;
                // By the Hertz law, as `check` and the manifest of a sweep have it: the limit is that law's.
                let indentation = equilibrium::hertz_indentation(&[spheres], load).ok()?;
                Some(indentation / self.kind.radius_m)
            }
            Quantity::Restitution => restitution::exact(dissipation, self.impact_speed_m_s).ok(),
            Quantity::PeakForce => {
                let report = DropTest::new([spheres], self.values).ok()?.run().ok()?;
                Some(report.peak_force_bw())
            }
        }
    }

    fn title(&self) -> &'static str {
        match self.quantity {
            Quantity::Indentation => "Indentation at rest",
            Quantity::Restitution => "Restitution",
            Quantity::PeakForce => "Peak force of the drop",
        }
    }

    fn label(&self) -> &'static str {
        match self.quantity {
            Quantity::Indentation => "x̂ under body weight, Hertz (–)",
            Quantity::Restitution => "coefficient of restitution (–)",
            Quantity::PeakForce => "peak force / body weight (–)",
        }
    }

    fn limit(&self) -> Option<HeatLimit> {
        let limit = |label: &str, at| Some(HeatLimit { label: label.to_owned(), at });
        let speed = self.impact_speed_m_s;
        match self.quantity {
            Quantity::Indentation => {
                limit("x̂ = 0.16, limit of the Hertz law", limits::HERTZ_RELATIVE_INDENTATION)
            }
            Quantity::Restitution => {
                // The limit is one of (13), as `check` has it; the colours are the law's own.
                let dissipation = restitution::dissipation(limits::HUNT_CROSSLEY_RESTITUTION, speed).ok()?;
                limit(
                    "0.8 by (13), limit of the Hunt–Crossley law",
                    restitution::exact(dissipation, speed).ok()?,
                )
            }
            Quantity::PeakForce => None,
        }
    }
}
