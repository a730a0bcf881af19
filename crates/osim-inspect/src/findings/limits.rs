//! Findings from figures: what the contacts do, against the limits of the paper.

use contact_scaling::limits;
use osim_messages::{four_significant, readable};
use osim_model::{Finding, FindingCode, same_mass};

use super::found::Found;
use super::remedy::Remedies;
use crate::figures::{Figure, SphereFigures};
use crate::inspection::{InspectedForce, Inspection};

/// x̂ at which a sphere is in the floor up to its centre.
const CENTRE: f64 = 1.0;

/// Known contacts under a body of another mass, where no note says that this is known. They can be scaled where the places of
/// the spheres are right.
pub(super) fn another_mass(
    inspected: &Inspection,
    remedies: &Remedies<'_>,
    places_are_right: bool,
) -> Option<Found> {
    Limits::new(inspected, remedies).another_mass(places_are_right)
}

/// Everything else that the figures show.
pub(super) fn findings(inspected: &Inspection, remedies: &Remedies<'_>) -> Vec<Found> {
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

/// The spheres that a finding is about, and the one of which its figure is the largest.
struct Concerned<'l> {
    most: f64,
    worst: &'l SphereFigures,
    all: Vec<&'l SphereFigures>,
}

/// The figure of a sphere that is beyond its limit.
fn beyond(sphere: &SphereFigures, figure: Figure) -> Option<f64> {
    sphere.value(figure).filter(|_| sphere.is_within(figure) == Some(false))
}

impl<'l> Limits<'l> {
    fn new(inspected: &'l Inspection, remedies: &'l Remedies<'l>) -> Self {
        Self { inspected, remedies, spheres: inspected.figures.spheres().collect() }
    }

    /// The spheres that have the figure.
    fn concerned(&self, figure: impl Fn(&SphereFigures) -> Option<f64>) -> Option<Concerned<'l>> {
        let known: Vec<(f64, &SphereFigures)> =
            self.spheres.iter().filter_map(|sphere| Some((figure(sphere)?, *sphere))).collect();
        // The first of equally bad ones.
        let (most, worst) = known.iter().copied().reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        Some(Concerned { most, worst, all: known.into_iter().map(|(_, sphere)| sphere).collect() })
    }

    /// A finding about spheres, at the worst of them.
    fn about(&self, code: FindingCode, text: &str, found: &Concerned<'_>) -> Finding {
        let Concerned { worst, all, .. } = found;
        let which = match (all.len(), self.spheres.len()) {
            (1, _) => worst.sphere.clone(),
            (some, of) if some == of => format!("all {of} spheres"),
            (some, of) => format!("{some} of {of} spheres, most in {}", worst.sphere),
        };
        let line =
            self.inspected.spheres.iter().find(|sphere| sphere.path == worst.path).map(|sphere| sphere.line);
        let finding = Finding::new(code, format!("{text} ({which})")).about(&worst.path);
        finding.on_line(line).of_spheres(all.iter().map(|sphere| sphere.sphere.clone()).collect())
    }

    /// The same at the force that presses the worst sphere: its parameters are what can be changed.
    fn about_force(&self, code: FindingCode, text: &str, found: &Concerned<'_>) -> Finding {
        let (finding, sphere) = (self.about(code, text, found), found.worst);
        let presses = |force: &&InspectedForce| {
            sphere.forces.contains(&force.name) && force.spheres.contains(&sphere.sphere)
        };
        match self.inspected.forces.iter().find(presses) {
            Some(force) => finding.about(&force.path).on_line(Some(force.line)),
            None => finding,
        }
    }

    fn sunk_in(&self) -> Option<Found> {
        let found = self.concerned(|sphere| sphere.value(Figure::Indentation).filter(|&x| x >= CENTRE))?;
        let x = four_significant(found.most);
        let text = format!("at body weight on one limb x/R is {x} by Hertz: in up to the centre");
        let remedy = self.remedies.indentation(&self.spheres, 1.0);
        Some(Found::new(self.about(FindingCode::SunkIn, &text, &found), remedy))
    }

    fn beyond_hertz(&self) -> Option<Found> {
        let found = self.concerned(|sphere| beyond(sphere, Figure::Indentation).filter(|&x| x < CENTRE))?;
        let (x, limit) = (four_significant(found.most), limits::INDENTATION.in_words());
        let text = format!("at body weight on one limb x/R is {x} by Hertz, {limit}");
        let remedy = self.remedies.indentation(&self.spheres, 1.0);
        Some(Found::new(self.about(FindingCode::BeyondHertz, &text, &found), remedy))
    }

    fn beyond_hertz_at_two(&self) -> Option<Found> {
        let only_at_two = |sphere: &SphereFigures| {
            beyond(sphere, Figure::IndentationAtTwo)
                .filter(|_| sphere.is_within(Figure::Indentation) == Some(true))
        };
        let found = self.concerned(only_at_two)?;
        let (x, limit) = (four_significant(found.most), limits::INDENTATION.in_words());
        let text = format!("at two body weights on one limb x/R is {x} by Hertz, {limit}");
        let remedy = self.remedies.indentation(&self.spheres, 2.0);
        Some(Found::new(self.about(FindingCode::BeyondHertzAtTwo, &text, &found), remedy))
    }

    fn beyond_hunt_crossley(&self) -> Option<Found> {
        let speed = self.inspected.figures.impact_speed_m_s?;
        // The largest dissipation has the least restitution.
        let found = self.concerned(|sphere| {
            let outside = sphere.is_within(Figure::RestitutionApproximate) == Some(false);
            sphere.value(Figure::Dissipation).filter(|_| outside)
        })?;
        let restitution = found.worst.value(Figure::RestitutionApproximate);
        let restitution = restitution.map_or_else(|| "below 0".to_owned(), four_significant);
        let text = format!(
            "at an impact speed of {} m/s the restitution is {restitution} by (13), {}",
            four_significant(speed),
            limits::RESTITUTION.in_words()
        );
        let remedy = self.remedies.restitution(speed, found.most);
        Some(Found::new(self.about_force(FindingCode::BeyondHuntCrossley, &text, &found), remedy))
    }

    fn constant_indentation(&self) -> Option<Found> {
        let found = self.concerned(|sphere| beyond(sphere, Figure::ConstantIndentation))?;
        let limit = limits::CONSTANT_INDENTATION;
        let x = four_significant(found.most);
        let text = format!("sqrt(constant_contact_force)/R is {x}, {}", limit.in_words());
        let remedy = self.remedies.constant_indentation(limit.value);
        Some(Found::new(self.about_force(FindingCode::LargeConstantIndentation, &text, &found), remedy))
    }

    fn transition(&self) -> Option<Found> {
        let found = self.concerned(|sphere| beyond(sphere, Figure::TransitionWidth))?;
        let (width, limit) = (four_significant(found.most), limits::TRANSITION_WIDTH.in_words());
        let text = format!("contact sets in over {width} R, {limit}");
        let finding = self.about_force(FindingCode::WideTransition, &text, &found);
        Some(Found::new(finding, self.remedies.transition()))
    }

    fn before_contact(&self) -> Option<Found> {
        let found = self.concerned(|sphere| beyond(sphere, Figure::TouchingShare))?;
        let force = found.worst.value(Figure::ForceJustTouching).map(four_significant).unwrap_or_default();
        let share = four_significant(found.most);
        let text = format!("just touching, a sphere carries {force} N, {share} of its share of body weight");
        let finding = self.about_force(FindingCode::ForceBeforeContact, &text, &found);
        Some(Found::new(finding, self.remedies.touching(&self.spheres)))
    }

    fn floats(&self) -> Option<Found> {
        let above = |sphere: &SphereFigures| {
            sphere.value(Figure::IndentationModelLaw).filter(|&x| x <= 0.0).map(|x| -x)
        };
        let found = self.concerned(above)?;
        let text = format!("body weight is carried {} R above the floor", four_significant(found.most));
        let finding = self.about_force(FindingCode::Floats, &text, &found);
        Some(Found::new(finding, self.remedies.floating(&self.spheres)))
    }

    fn another_mass(&self, places_are_right: bool) -> Option<Found> {
        let mass = self.inspected.mass_kg?;
        let known = self.inspected.known_contacts?;
        let unsaid =
            self.inspected.contacts_mass_kg.as_ref().is_some_and(|made_for| made_for.source == "bodies");
        if !unsaid || same_mass(mass, known.made_for_kg) {
            return None;
        }
        let made_for = known.made_for_kg;
        let text = format!(
            "the contacts are those of {}, made for {} kg, and the body weighs {} kg",
            known.title,
            readable(made_for),
            four_significant(mass)
        );
        let remedy = places_are_right.then(|| self.remedies.rescale(made_for, mass)).flatten();
        Some(Found::new(Finding::new(FindingCode::ContactsOfAnotherMass, text), remedy))
    }
}
