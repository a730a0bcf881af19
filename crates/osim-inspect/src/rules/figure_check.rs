//! Parts that the rules about figures of spheres have in common: the spheres beyond a limit, and findings about them.

use osim_model::{Finding, Rule};

use crate::findings::Remedies;
use crate::{Figure, InspectedForce, Inspection, SphereFigures};

/// The numbers of a model's spheres, which rules compare with limits, and the maker of remedies for the model.
pub(crate) struct FigureCheck<'l> {
    pub(super) inspected: &'l Inspection,
    pub(super) remedies: &'l Remedies<'l>,
    pub(super) spheres: Vec<&'l SphereFigures>,
}

/// The spheres that a finding is about, and the sphere with the largest figure among them.
pub(super) struct AffectedSpheres<'l> {
    pub(super) largest: f64,
    pub(super) worst: &'l SphereFigures,
    all: Vec<&'l SphereFigures>,
}

/// The value of a figure, if it is beyond its limit.
pub(super) fn value_beyond_limit(sphere: &SphereFigures, figure: Figure) -> Option<f64> {
    sphere.value(figure).filter(|_| sphere.is_within(figure) == Some(false))
}

impl<'l> FigureCheck<'l> {
    /// The figures of all spheres of an inspected model, ready for the rules.
    pub(crate) fn new(inspected: &'l Inspection, remedies: &'l Remedies<'l>) -> Self {
        Self { inspected, remedies, spheres: inspected.figures.spheres().collect() }
    }

    /// The spheres for which the function `figure` gives a value.
    pub(super) fn spheres_with(
        &self,
        figure: impl Fn(&SphereFigures) -> Option<f64>,
    ) -> Option<AffectedSpheres<'l>> {
        let affected: Vec<(f64, &SphereFigures)> =
            self.spheres.iter().filter_map(|sphere| Some((figure(sphere)?, *sphere))).collect();
        // The first of equally bad ones.
        let (largest, worst) = affected.iter().copied().reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        let all = affected.into_iter().map(|(_, sphere)| sphere).collect();
        Some(AffectedSpheres { largest, worst, all })
    }

    /// A finding about spheres. Its place is the worst sphere.
    pub(super) fn finding_at_sphere(
        &self,
        rule: &'static Rule,
        text: &str,
        affected: &AffectedSpheres<'_>,
    ) -> Finding {
        let AffectedSpheres { worst, all, .. } = affected;
        let which = match (all.len(), self.spheres.len()) {
            (1, _) => worst.sphere.clone(),
            (some, total) if some == total => format!("all {total} spheres"),
            (some, total) => format!("{some} of {total} spheres, most in {}", worst.sphere),
        };
        let position = self
            .inspected
            .spheres
            .iter()
            .find(|sphere| sphere.path == worst.path)
            .map(|sphere| sphere.position);
        let finding = Finding::new(rule, format!("{text} ({which})")).with_place(&worst.path);
        let finding = finding.with_measure(affected.largest, "");
        finding.with_position(position).with_spheres(all.iter().map(|sphere| sphere.sphere.clone()).collect())
    }

    /// A finding about spheres. Its place is the force that presses the worst sphere, because the parameters of this force can be changed.
    pub(super) fn finding_at_force(
        &self,
        rule: &'static Rule,
        text: &str,
        affected: &AffectedSpheres<'_>,
    ) -> Finding {
        let finding = self.finding_at_sphere(rule, text, affected);
        match self.force_of(affected.worst) {
            Some(force) => finding.with_place(&force.path).with_position(Some(force.position)),
            None => finding,
        }
    }

    /// The first force that presses the sphere.
    pub(super) fn force_of(&self, sphere: &SphereFigures) -> Option<&'l InspectedForce> {
        let mut forces = self.inspected.forces.iter();
        forces.find(|force| sphere.forces.contains(&force.name) && force.spheres.contains(&sphere.sphere))
    }
}
