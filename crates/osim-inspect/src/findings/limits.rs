//! Findings from figures: what the contacts do, against the limits of the paper.

use contact_scaling::limits;
use osim_model::{WarningCode, four_significant, same_mass};

use super::finding::Finding;
use super::remedy::Remedies;
use crate::figures::{Figure, SphereFigures};
use crate::inspection::Inspection;

/// x̂ at which a sphere is in the floor up to its centre.
const CENTRE: f64 = 1.0;

/// A preset's contacts under a body of another mass, where no note says that this is known.
pub(super) fn another_mass(inspected: &Inspection, remedies: &Remedies<'_>) -> Option<Finding> {
    Limits::new(inspected, remedies).another_mass()
}

/// Everything else that the figures show.
pub(super) fn findings(inspected: &Inspection, remedies: &Remedies<'_>) -> Vec<Finding> {
    let limits = Limits::new(inspected, remedies);
    let found = [
        limits.sunk_in(),
        limits.beyond_hertz(),
        limits.beyond_hertz_at_two(),
        limits.beyond_hunt_crossley(),
        limits.constant_indentation(),
        limits.transition(),
        limits.before_contact(),
        limits.floats(),
    ];
    found.into_iter().flatten().collect()
}

struct Limits<'l> {
    inspected: &'l Inspection,
    remedies: &'l Remedies<'l>,
    spheres: Vec<&'l SphereFigures>,
}

fn hertz(sphere: &SphereFigures, body_weights: f64) -> Option<f64> {
    sphere.load(body_weights).and_then(|load| load.hertz)
}

fn own(sphere: &SphereFigures) -> Option<f64> {
    sphere.load(1.0).and_then(|load| load.own)
}

impl<'l> Limits<'l> {
    fn new(inspected: &'l Inspection, remedies: &'l Remedies<'l>) -> Self {
        Self { inspected, remedies, spheres: inspected.figures.spheres().collect() }
    }

    /// The spheres of which `concerned` tells a figure, and the one with the largest.
    fn worst(
        &self,
        concerned: impl Fn(&SphereFigures) -> Option<f64>,
    ) -> Option<(f64, &SphereFigures, Vec<&SphereFigures>)> {
        let told: Vec<(f64, &SphereFigures)> =
            self.spheres.iter().filter_map(|sphere| Some((concerned(sphere)?, *sphere))).collect();
        // The first of equally bad ones.
        let worst = told.iter().fold(None, |worst: Option<&(f64, &SphereFigures)>, one| match worst {
            Some(known) if known.0 >= one.0 => Some(known),
            _ => Some(one),
        })?;
        Some((worst.0, worst.1, told.iter().map(|(_, sphere)| *sphere).collect()))
    }

    /// A finding about spheres, at the worst of them.
    fn about(&self, code: WarningCode, text: &str, worst: &SphereFigures, all: &[&SphereFigures]) -> Finding {
        let which = match (all.len(), self.spheres.len()) {
            (1, _) => worst.sphere.clone(),
            (some, of) if some == of => format!("all {of} spheres"),
            (some, of) => format!("{some} of {of} spheres, most in {}", worst.sphere),
        };
        let line =
            self.inspected.spheres.iter().find(|sphere| sphere.path == worst.path).map(|sphere| sphere.line);
        let mut finding = Finding::new(code, format!("{text} ({which})")).at(Some(&worst.path), line);
        finding.spheres = all.iter().map(|sphere| sphere.sphere.clone()).collect();
        finding
    }

    fn sunk_in(&self) -> Option<Finding> {
        let (x, worst, all) = self.worst(|sphere| hertz(sphere, 1.0).filter(|&x| x >= CENTRE))?;
        let text = format!(
            "at body weight on one limb x/R is {} by Hertz: in up to the centre",
            four_significant(x)
        );
        Some(
            self.about(WarningCode::SunkIn, &text, worst, &all)
                .put_right_by(self.remedies.indentation(&self.spheres, 1.0)),
        )
    }

    fn beyond_hertz(&self) -> Option<Finding> {
        let beyond = |sphere: &SphereFigures| {
            hertz(sphere, 1.0).filter(|&x| x < CENTRE && sphere.is_within(Figure::Hertz) == Some(false))
        };
        let (x, worst, all) = self.worst(beyond)?;
        let limit = limits::HERTZ_RELATIVE_INDENTATION;
        let text =
            format!("at body weight on one limb x/R is {} by Hertz, at most {limit}", four_significant(x));
        let remedy = self.remedies.indentation(&self.spheres, 1.0);
        Some(self.about(WarningCode::BeyondHertz, &text, worst, &all).put_right_by(remedy))
    }

    fn beyond_hertz_at_two(&self) -> Option<Finding> {
        let beyond = |sphere: &SphereFigures| {
            let only_at_two = sphere.is_within(Figure::Hertz)? && !sphere.is_within(Figure::HertzAtTwo)?;
            hertz(sphere, 2.0).filter(|_| only_at_two)
        };
        let (x, worst, all) = self.worst(beyond)?;
        let limit = limits::HERTZ_RELATIVE_INDENTATION;
        let text = format!(
            "at two body weights on one limb x/R is {} by Hertz, at most {limit}",
            four_significant(x)
        );
        let remedy = self.remedies.indentation(&self.spheres, 2.0);
        Some(self.about(WarningCode::BeyondHertzAtTwo, &text, worst, &all).put_right_by(remedy))
    }

    fn beyond_hunt_crossley(&self) -> Option<Finding> {
        let speed = self.inspected.figures.impact_speed_m_s?;
        // The largest dissipation has the least restitution.
        let beyond = |sphere: &SphereFigures| {
            sphere.dissipation_s_m.filter(|_| sphere.is_within(Figure::Restitution) == Some(false))
        };
        let (dissipation, worst, all) = self.worst(beyond)?;
        let restitution =
            worst.restitution_approximate.map_or_else(|| "below 0".to_owned(), four_significant);
        let text = format!(
            "at an impact speed of {} m/s the restitution is {restitution} by (13), at least {}",
            four_significant(speed),
            limits::HUNT_CROSSLEY_RESTITUTION
        );
        let remedy = self.remedies.restitution(speed, dissipation);
        Some(
            self.at_force(self.about(WarningCode::BeyondHuntCrossley, &text, worst, &all), worst)
                .put_right_by(remedy),
        )
    }

    fn constant_indentation(&self) -> Option<Finding> {
        let large = |sphere: &SphereFigures| {
            sphere
                .constant_indentation
                .filter(|_| sphere.is_within(Figure::ConstantIndentation) == Some(false))
        };
        let (x, worst, all) = self.worst(large)?;
        let text = format!(
            "sqrt(constant_contact_force)/R is {}, at most {}",
            four_significant(x),
            limits::CONSTANT_INDENTATION
        );
        let remedy = self.remedies.constant_indentation(limits::CONSTANT_INDENTATION);
        let finding = self.about(WarningCode::LargeConstantIndentation, &text, worst, &all);
        Some(self.at_force(finding, worst).put_right_by(remedy))
    }

    fn transition(&self) -> Option<Finding> {
        let wide = |sphere: &SphereFigures| {
            sphere.transition_width.filter(|_| sphere.is_within(Figure::TransitionWidth) == Some(false))
        };
        let (width, worst, all) = self.worst(wide)?;
        let text = format!(
            "contact sets in over {} R, at most {}",
            four_significant(width),
            limits::TRANSITION_WIDTH
        );
        let finding = self.about(WarningCode::WideTransition, &text, worst, &all);
        Some(self.at_force(finding, worst).put_right_by(self.remedies.transition()))
    }

    fn before_contact(&self) -> Option<Finding> {
        let early = |sphere: &SphereFigures| {
            sphere.touching_share.filter(|_| sphere.is_within(Figure::TouchingShare) == Some(false))
        };
        let (share, worst, all) = self.worst(early)?;
        let force = worst.force_just_touching_n.map(four_significant).unwrap_or_default();
        let text = format!(
            "just touching, a sphere carries {force} N, {} of its share of body weight",
            four_significant(share)
        );
        let finding = self.about(WarningCode::ForceBeforeContact, &text, worst, &all);
        Some(self.at_force(finding, worst).put_right_by(self.remedies.touching(&self.spheres)))
    }

    fn floats(&self) -> Option<Finding> {
        let above = |sphere: &SphereFigures| own(sphere).filter(|&x| x <= 0.0).map(|x| -x);
        let (height, worst, all) = self.worst(above)?;
        let text = format!("body weight is carried {} R above the floor", four_significant(height));
        let finding = self.about(WarningCode::Floats, &text, worst, &all);
        Some(self.at_force(finding, worst).put_right_by(self.remedies.touching(&self.spheres)))
    }

    /// Moves a finding to the force that presses the sphere: its parameters are what can be changed.
    fn at_force(&self, finding: Finding, sphere: &SphereFigures) -> Finding {
        let force = self
            .inspected
            .forces
            .iter()
            .find(|force| sphere.forces.contains(&force.name) && force.spheres.contains(&sphere.sphere));
        match force {
            Some(force) => finding.at(Some(&force.path), Some(force.line)),
            None => finding,
        }
    }

    fn another_mass(&self) -> Option<Finding> {
        let mass = self.inspected.mass_kg?;
        let stands_for = self.inspected.contacts_mass_kg.as_ref().filter(|told| told.source == "bodies")?;
        let presets = contact_scaling::preset_names().filter_map(contact_scaling::preset);
        for preset in presets {
            let scale = preset.scale;
            let alike = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b;
            let same = |sphere: &SphereFigures| {
                alike(sphere.radius_m, scale.radius_m())
                    && alike(sphere.composite_modulus_n_m2, preset.contact.composite_modulus())
                    && sphere.dissipation_s_m.is_some_and(|alpha| alike(alpha, preset.contact.dissipation()))
            };
            #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
            let count =
                self.inspected.spheres_per_limb.is_some_and(|count| count as f64 == scale.sphere_count());
            if count
                && !self.spheres.is_empty()
                && self.spheres.iter().all(|sphere| same(sphere))
                && !same_mass(stands_for.value, scale.mass_kg())
            {
                let text = format!(
                    "the contacts are those of the preset {}, made for {} kg, and the body weighs {} kg",
                    preset.name,
                    scale.mass_kg(),
                    four_significant(mass)
                );
                let remedy = self.remedies.rescale(scale.mass_kg(), mass);
                return Some(Finding::new(WarningCode::ContactsOfAnotherMass, text).put_right_by(remedy));
            }
        }
        None
    }
}
