//! The figures of a model against the limits of the paper: what the rules about them share.

use osim_model::{Finding, Rule};

use crate::figures::{Figure, SphereFigures};
use crate::findings::Remedies;
use crate::inspection::{InspectedForce, Inspection};

/// x̂ at which a sphere is in the floor up to its centre.
pub(super) const CENTRE: f64 = 1.0;

/// A model that was inspected, and what can be proposed for it.
pub(crate) struct Limits<'l> {
    pub(super) inspected: &'l Inspection,
    pub(super) remedies: &'l Remedies<'l>,
    pub(super) spheres: Vec<&'l SphereFigures>,
}

/// The spheres that a finding is about, and the one that has the largest figure.
pub(super) struct Concerned<'l> {
    pub(super) most: f64,
    pub(super) worst: &'l SphereFigures,
    all: Vec<&'l SphereFigures>,
}

/// The figure of a sphere that is beyond its limit.
pub(super) fn beyond(sphere: &SphereFigures, figure: Figure) -> Option<f64> {
    sphere.value(figure).filter(|_| sphere.is_within(figure) == Some(false))
}

impl<'l> Limits<'l> {
    pub(crate) fn new(inspected: &'l Inspection, remedies: &'l Remedies<'l>) -> Self {
        Self { inspected, remedies, spheres: inspected.figures.spheres().collect() }
    }

    pub(super) fn concerned(&self, figure: impl Fn(&SphereFigures) -> Option<f64>) -> Option<Concerned<'l>> {
        let known: Vec<(f64, &SphereFigures)> =
            self.spheres.iter().filter_map(|sphere| Some((figure(sphere)?, *sphere))).collect();
        // The first of equally bad ones.
        let (most, worst) = known.iter().copied().reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        Some(Concerned { most, worst, all: known.into_iter().map(|(_, sphere)| sphere).collect() })
    }

    /// A finding about spheres, at the worst of them.
    pub(super) fn about(&self, rule: &'static Rule, text: &str, found: &Concerned<'_>) -> Finding {
        let Concerned { worst, all, .. } = found;
        let which = match (all.len(), self.spheres.len()) {
            (1, _) => worst.sphere.clone(),
            (some, of) if some == of => format!("all {of} spheres"),
            (some, of) => format!("{some} of {of} spheres, most in {}", worst.sphere),
        };
        let line =
            self.inspected.spheres.iter().find(|sphere| sphere.path == worst.path).map(|sphere| sphere.line);
        let finding = Finding::new(rule, format!("{text} ({which})")).with_place(&worst.path);
        finding.with_line(line).with_spheres(all.iter().map(|sphere| sphere.sphere.clone()).collect())
    }

    /// A finding at the force that presses the worst sphere: its parameters are what can be changed.
    pub(super) fn about_force(&self, rule: &'static Rule, text: &str, found: &Concerned<'_>) -> Finding {
        let (finding, sphere) = (self.about(rule, text, found), found.worst);
        let presses = |force: &&InspectedForce| {
            sphere.forces.contains(&force.name) && force.spheres.contains(&sphere.sphere)
        };
        match self.inspected.forces.iter().find(presses) {
            Some(force) => finding.with_place(&force.path).with_line(Some(force.line)),
            None => finding,
        }
    }
}
