//! Plans new radii of moving spheres, and computes the ratio of new to old radii for each force.

use std::collections::{BTreeMap, BTreeSet};

use contact_scaling::{RatioValues, Ratios, modulus};
use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::compare::ScaleFile;
use osim_model::{
    Fault, Force, ForceId, LevelAxis, MissingFact, Model, Property, PropertySet, RadiusChangeReason,
    RadiusRule, Result, Sphere, SphereId, least_and_most, moving_spheres, root_mean_square,
};

use crate::builder::{NewNumber, PlanBuilder};
use crate::change::ChangedBy;

/// Old and new radius of each moving sphere of the chosen forces.
pub(crate) struct Radii(BTreeMap<SphereId, RadiusPair>);

impl Radii {
    /// Applies each sphere's rule to the moving spheres of `forces` and plans the changes.
    ///
    /// # Errors
    /// A radius that cannot be scaled, or a sphere that a force outside `forces` also uses.
    pub(crate) fn plan(
        plan: &mut PlanBuilder<'_>,
        forces: &[ForceId],
        rule_of: impl Fn(SphereId) -> SphereRadiusRule,
        isometric: f64,
        properties: &PropertySet,
    ) -> Result<Self> {
        let model = plan.model;
        let mut radii = BTreeMap::new();
        let users = ForcesOutsideChange::find(model, forces);
        for sphere in moving_spheres(model, forces) {
            let old = plan.model.radius_m(sphere)?;
            let stays = !properties.contains(Property::Radius);
            let rule = if stays { SphereRadiusRule::Rule(RadiusRule::Keep) } else { rule_of(sphere) };
            if matches!(rule, SphereRadiusRule::Rule(RadiusRule::Metres(_)) | SphereRadiusRule::Designed(_)) {
                model.round_radius_m(sphere)?;
            }
            let pair = rule.radius_pair(old, isometric);
            if pair.new != pair.old {
                users.refuse_change(model, forces, sphere, rule.change_reason())?;
            }
            let factor = rule.is_relative().then_some(pair.ratio);
            plan.change_radius(sphere, NewNumber { to: pair.new, factor, by: rule.changed_by() })?;
            radii.insert(sphere, pair);
        }
        Ok(Self(radii))
    }

    /// ρ, new radius over old, of one force: the common ratio of its spheres; if they differ, the ratio of the root mean
    /// squares of the radii. A force that presses spheres on each other has the radii R₁R₂/(R₁ + R₂).
    pub(crate) fn ratio(&self, model: &Model, force: &Force) -> f64 {
        let pairs = self.radius_pairs_of_contacts(model, force);
        match pairs.split_first() {
            None => 1.0,
            Some((first, rest)) if rest.iter().all(|pair| pair.ratio == first.ratio) => first.ratio,
            Some(_) => {
                self.rms_pressed_radius(model, force) / root_mean_square(pairs.iter().map(|pair| pair.old))
            }
        }
    }

    /// The scaling ratios of one force that follow from its new and old radii.
    pub(crate) fn own_ratios(&self, model: &Model, force: &Force) -> Result<Ratios> {
        let radius = self.ratio(model, force);
        Ratios::new(RatioValues { mass: 1.0, sphere_count: 1.0, radius, gravity: 1.0 }).map_err(Fault::new)
    }

    /// Root of the mean R² of the force's contacts after the change: R of each sphere, R₁R₂/(R₁ + R₂) of two spheres that press
    /// each other.
    pub(crate) fn rms_pressed_radius(&self, model: &Model, force: &Force) -> f64 {
        root_mean_square(self.radius_pairs_of_contacts(model, force).iter().map(|pair| pair.new))
    }

    /// Old and new radius of each contact of a force; of two spheres that press each other, their composite radius.
    fn radius_pairs_of_contacts(&self, model: &Model, force: &Force) -> Vec<RadiusPair> {
        let two = model.sphere_pairs(force);
        if two.is_empty() {
            return self.radius_pairs(force);
        }
        let change = |sphere: &Sphere| {
            let stays = RadiusPair { old: sphere.radius.number, new: sphere.radius.number, ratio: 1.0 };
            self.0.get(&sphere.id).copied().unwrap_or(stays)
        };
        two.into_iter().map(|pair| RadiusPair::of_two(pair.map(change))).collect()
    }

    /// All moving spheres of the chosen forces.
    pub(crate) fn spheres(&self) -> BTreeSet<SphereId> {
        self.0.keys().copied().collect()
    }

    /// Root of the mean R² of the force's spheres after the change.
    pub(crate) fn rms_new_radius(&self, force: &Force) -> f64 {
        root_mean_square(self.radius_pairs(force).iter().map(|pair| pair.new))
    }

    /// Old and new radius of each sphere of a force that is changed.
    fn radius_pairs(&self, force: &Force) -> Vec<RadiusPair> {
        force.spheres().iter().filter_map(|sphere| self.0.get(sphere)).copied().collect()
    }

    /// The smallest and the largest distance by which the lowest points of spheres move down, m.
    pub(crate) fn bottom_shifts(&self) -> Option<(f64, f64)> {
        let (least, most) = least_and_most(self.0.values().map(|pair| pair.new - pair.old));
        (least.is_finite() && (least != 0.0 || most != 0.0)).then_some((least, most))
    }

    /// Moves sphere centres so that the lowest points of the spheres stay where they are.
    pub(crate) fn keep_bottoms(&self, plan: &mut PlanBuilder<'_>, axis: LevelAxis) -> Result<()> {
        for (&sphere, pair) in &self.0 {
            let Some(found) = plan.model.sphere(sphere) else { continue };
            found.round_radius_m()?;
            let axis = axis.in_frame(&plan.model.rotation_of(found)?);
            let place = axis.levelled_centre(found.location_m, pair.old, pair.new, |vector| vector);
            plan.move_sphere(sphere, place, ChangedBy::Level)?;
        }
        Ok(())
    }

    /// Moves sphere centres with their scaled bodies; with `level`, the lowest points of the spheres stay on the scaled
    /// soles.
    pub(crate) fn follow_bodies(
        &self,
        plan: &mut PlanBuilder<'_>,
        forces: &[ForceId],
        bodies: &ScaleFile,
        level: Option<LevelAxis>,
    ) -> Result<()> {
        let users = ForcesOutsideChange::find(plan.model, forces);
        for (&sphere, pair) in &self.0 {
            let Some(found) = plan.model.sphere(sphere) else { continue };
            let Some(body) = found.body.as_deref() else { continue };
            let factors =
                bodies.required_factors(body).map_err(|fault| fault.at_element(found.path.clone()))?;
            if level.is_some() {
                found.round_radius_m()?;
            }
            let (location, rotation) = (found.location_m, plan.model.rotation_of(found)?);
            let scaled = |vector| rotation.scaled_in_frame(factors, vector);
            let place = match level {
                Some(axis) => axis.in_frame(&rotation).levelled_centre(location, pair.old, pair.new, scaled),
                None => scaled(location),
            };
            if place != location {
                users.refuse_change(plan.model, forces, sphere, RadiusChangeReason::Bodies)?;
            }
            plan.move_sphere(sphere, place, ChangedBy::Follow)?;
        }
        Ok(())
    }

    /// The largest ratio of new to old radius among the spheres of a force, divided by the smallest.
    pub(crate) fn ratio_spread(&self, force: &Force, old_radius: impl Fn(SphereId) -> f64) -> f64 {
        let ratio = |sphere: &SphereId| Some(self.0.get(sphere)?.new / old_radius(*sphere));
        let ratios: Vec<f64> = force.spheres().iter().filter_map(ratio).collect();
        let (least, most) = least_and_most(ratios.iter().copied());
        if ratios.is_empty() { 1.0 } else { most / least }
    }
}

/// The rule that gives one sphere its new radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SphereRadiusRule {
    /// One rule gives the radii of all spheres.
    Rule(RadiusRule),
    /// A radius, m, with the same ratio to the size of the body as in the reference.
    Like(f64),
    /// A radius, m, computed from the wanted stiffness and indentation.
    Designed(f64),
    /// A radius, m, scaled with the body of the sphere.
    Followed(f64),
}

/// Old and new radius of a sphere, m.
#[derive(Clone, Copy)]
struct RadiusPair {
    old: f64,
    new: f64,
    ratio: f64,
}

impl RadiusPair {
    /// Old and new R₁R₂/(R₁ + R₂) of two spheres.
    fn of_two([one, other]: [Self; 2]) -> Self {
        let composite = |one, other| modulus::composite_radius(one, other).unwrap_or(f64::NAN);
        let (old, new) = (composite(one.old, other.old), composite(one.new, other.new));
        Self { old, new, ratio: if one.ratio == other.ratio { one.ratio } else { new / old } }
    }
}

impl SphereRadiusRule {
    /// The rule as reports name it.
    fn changed_by(self) -> ChangedBy {
        match self {
            Self::Rule(RadiusRule::Isometric) | Self::Like(_) => ChangedBy::Equation("8"),
            Self::Followed(_) => ChangedBy::Follow,
            Self::Designed(_) => ChangedBy::Equation("11, B.2"),
            Self::Rule(_) => ChangedBy::Given,
        }
    }

    /// Why the radius would change, for the advice how it can stay.
    fn change_reason(self) -> RadiusChangeReason {
        match self {
            Self::Rule(_) | Self::Like(_) => RadiusChangeReason::Rule,
            Self::Designed(_) => RadiusChangeReason::ContactStiffness,
            Self::Followed(_) => RadiusChangeReason::Bodies,
        }
    }

    /// Whether the new radius is a multiple of the old one.
    fn is_relative(self) -> bool {
        matches!(self, Self::Rule(RadiusRule::Isometric | RadiusRule::Keep | RadiusRule::Factor(_)))
    }

    /// Old and new radius of a sphere by this rule; `isometric` is the factor of isometric radii.
    fn radius_pair(self, old: f64, isometric: f64) -> RadiusPair {
        let times = |ratio: f64| RadiusPair { old, new: if ratio == 1.0 { old } else { old * ratio }, ratio };
        match self {
            Self::Rule(RadiusRule::Isometric) => times(isometric),
            Self::Rule(RadiusRule::Keep) => times(1.0),
            Self::Rule(RadiusRule::Factor(factor)) => times(factor),
            Self::Rule(RadiusRule::Metres(new))
            | Self::Like(new)
            | Self::Followed(new)
            | Self::Designed(new) => RadiusPair { old, new, ratio: new / old },
        }
    }
}

/// For each sphere, the forces that use the sphere but are not changed together with it.
pub(crate) struct ForcesOutsideChange<'m> {
    forces: HashMap<SphereId, Vec<&'m str>>,
    /// Names of forces of classes without a Hertz law, by the name of the sphere that they use.
    others: HashMap<String, Vec<String>>,
}

impl<'m> ForcesOutsideChange<'m> {
    /// Finds, for each sphere, the switched-on forces that are not `chosen`.
    pub(crate) fn find(model: &'m Model, chosen: &[ForceId]) -> Self {
        let chosen: HashSet<ForceId> = chosen.iter().copied().collect();
        let mut forces: HashMap<SphereId, Vec<&str>> = HashMap::new();
        for force in model.forces() {
            if force.applies && !chosen.contains(&force.id) {
                for &sphere in force.spheres() {
                    forces.entry(sphere).or_default().push(&force.name);
                }
            }
        }
        Self { forces, others: model.forces_of_other_classes() }
    }

    /// Refuses to change a sphere if a force outside the change uses it, too.
    pub(crate) fn refuse_change(
        &self,
        model: &Model,
        chosen: &[ForceId],
        sphere: SphereId,
        radius: RadiusChangeReason,
    ) -> Result<()> {
        let Some(shared) = model.sphere(sphere) else { return Ok(()) };
        let mut left: Vec<&str> = self.forces.get(&sphere).cloned().unwrap_or_default();
        let forces = left.len();
        left.extend(self.others.get(&shared.name).into_iter().flatten().map(String::as_str));
        if left.is_empty() {
            return Ok(());
        }
        let uses = |&id: &ForceId| model.force(id).is_some_and(|force| force.spheres().contains(&sphere));
        let changed: Vec<ForceId> = chosen.iter().copied().filter(uses).collect();
        let fact = MissingFact::SharedSphere {
            sphere: shared.path.clone(),
            changed: model.short_force_names(&changed),
            can_choose: left.len() == forces,
            radius,
            left: left.into_iter().map(str::to_owned).collect(),
        };
        Err(Fault::at(fact, shared.radius.offset).at_element(shared.path.clone()).in_file(shared.file))
    }
}
