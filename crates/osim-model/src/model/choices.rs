//! Choices in a request: the forces, the properties to change, new values, and rules for radii and spheres.

use std::borrow::Cow;

use indexmap::IndexMap;

use crate::messages::{Input, listed, shortest};
use crate::model::components::{Carrier, ComponentId};
use crate::model::names_and_sides::{Pattern, any_pattern_matches};
use crate::model::{
    Fault, FaultKind, Force, ForceId, ForcesOfAnimal, MissingFact, Model, Property, Result, Sphere,
};

/// The user's choice of forces, by name.
///
/// Set the wanted fields and take the others from [`Selection::default`]: fields may be added.
///
/// ```
/// # let model = osim_model::Model::parse(include_bytes!("../../tests/data/one_foot.osim").as_slice())?;
/// use osim_model::Selection;
///
/// // All forces in which a moving sphere meets a half-space: contact_heel_r is the only one.
/// let selected = Selection::default().apply(&model)?;
/// assert!(selected.complete);
/// assert_eq!(model.short_force_names(&selected.forces), "contact_heel_r");
///
/// // Those of the left foot: there are none.
/// let left = "*_l".parse().map(|pattern| Selection { select: vec![pattern], ..Selection::default() });
/// assert_eq!(left.unwrap().apply(&model).unwrap_err().code(), "refused");
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Selection {
    /// Choose only forces whose name matches one of these patterns. Empty: the default choice.
    pub select: Vec<Pattern>,
    /// Leave out forces whose name matches one of these patterns.
    pub exclude: Vec<Pattern>,
    /// Leave out forces that are switched off.
    pub skip_disabled: bool,
}

/// The forces that [`Selection::apply`] chose; empty by default.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Selected {
    /// Handles of the chosen forces, in file order.
    pub forces: Vec<ForceId>,
    /// Whether the choice contains every force of the default choice.
    pub complete: bool,
}

impl Selected {
    pub fn matching(model: &Model, wanted: impl Fn(&Force) -> bool) -> Self {
        let forces = force_ids_where(model, wanted);
        Self { complete: is_complete(model, &forces), forces }
    }
}

impl Selection {
    /// Applies the choice to `model`: by default every force in which a moving sphere meets a half-space.
    ///
    /// # Errors
    /// The model has no force, no force matches, or the forces belong to several animals and the caller made no choice.
    pub fn apply(&self, model: &Model) -> Result<Selected> {
        let explicit = !self.select.is_empty();
        let moves = |id| model.sphere(id).is_some_and(|sphere| !sphere.fixed);
        let candidates = match explicit {
            true => force_ids_where(model, |force| force.spheres().iter().copied().any(moves)),
            false => force_ids_where(model, |force| model.meets_half_space(force)),
        };
        let selected = self.apply_among(model, &candidates)?;
        if !explicit {
            refuse_several_trees(model, &selected.forces)?;
        }
        Ok(selected)
    }

    /// Applies the choice to all contact forces of `model`, whatever they connect: for changes that are the same for every animal.
    pub fn apply_to_all(&self, model: &Model) -> Result<Selected> {
        self.apply_among(model, &force_ids_where(model, |_| true))
    }

    /// Patterns that match no contact force of `model`, probably by mistake, each with its input.
    pub fn unmatched_patterns(&self, model: &Model) -> Vec<(Input, &Pattern)> {
        let selected = self.select.iter().map(|pattern| (Input::Select, pattern));
        let patterns = selected.chain(self.exclude.iter().map(|pattern| (Input::Exclude, pattern)));
        let matches_nothing =
            |pattern: &Pattern| !model.forces().iter().any(|force| pattern.matches(&force.name));
        patterns.filter(|(_, pattern)| matches_nothing(pattern)).collect()
    }

    /// Whether the choice has forces of this name, if they are switched on.
    pub fn matches_name(&self, name: &str) -> bool {
        (self.select.is_empty() || any_pattern_matches(&self.select, name))
            && !any_pattern_matches(&self.exclude, name)
    }

    /// Applies the choice to the forces in `candidates`. No question about several animals is asked, because the candidates are known.
    pub fn apply_among(&self, model: &Model, candidates: &[ForceId]) -> Result<Selected> {
        if candidates.is_empty() {
            return Err(no_contacts(model));
        }
        let wanted =
            |force: &&Force| self.matches_name(&force.name) && (force.applies || !self.skip_disabled);
        let forces = candidates.iter().filter_map(|&id| model.force(id)).filter(wanted);
        let forces: Vec<ForceId> = forces.map(|force| force.id).collect();
        if forces.is_empty() {
            let forces = model.short_force_names(candidates);
            return Err(Fault::new(FaultKind::NothingSelected { forces }));
        }
        Ok(Selected { complete: is_complete(model, &forces), forces })
    }
}

fn force_ids_where(model: &Model, wanted: impl Fn(&Force) -> bool) -> Vec<ForceId> {
    model.forces().iter().filter(|force| wanted(force)).map(|force| force.id).collect()
}

/// Whether `forces` contains every force of the default choice.
fn is_complete(model: &Model, forces: &[ForceId]) -> bool {
    let mut default = model.forces().iter().filter(|force| model.meets_half_space(force));
    default.all(|force| forces.binary_search(&force.id).is_ok())
}

/// The largest number of names of forces or components in a message.
const MOST_NAMES_SHOWN: usize = 6;

impl Model {
    /// The first names of forces, at most six, so that a message stays readable.
    pub fn short_force_names(&self, forces: &[ForceId]) -> String {
        let named: Vec<&str> =
            forces.iter().filter_map(|&id| self.force(id)).map(|force| force.name.as_str()).collect();
        listed(&named, MOST_NAMES_SHOWN)
    }

    /// The names of components, as [`Model::short_force_names`] has them; without a name, OpenSim calls them after their class.
    pub fn short_component_names(&self, components: &[ComponentId]) -> String {
        let paths: Vec<String> = components.iter().map(|&id| self.components().tree.path(id)).collect();
        let names: Vec<&str> = paths.iter().filter_map(|path| path.rsplit('/').next()).collect();
        listed(&names, MOST_NAMES_SHOWN)
    }

    /// That contacts of another class carry the body, and of which; `None` if there are none.
    pub fn describe_other_carriers(&self) -> Option<String> {
        let carriers = self.carriers_of_other_classes();
        let class = self.components().tag(*carriers.first()?);
        let names = self.short_component_names(&carriers);
        Some(format!("the body stands on {class}, which this program does not scale: {names}"))
    }
}

fn no_contacts(model: &Model) -> Fault {
    if let Some(others) = model.describe_other_carriers() {
        let detail = format!("the model has no contacts to scale; {others}");
        return Fault::new(FaultKind::NoContacts { detail, replaces: true });
    }
    let detail = if model.forces().is_empty() {
        let tree = model.document().tree();
        let is_other = tree.elements().any(|id| tree.name(id) == "ElasticFoundationForce");
        let other = if is_other { "; an ElasticFoundationForce cannot be changed" } else { "" };
        format!("the model has no contacts (no HuntCrossleyForce, no SmoothSphereHalfSpaceForce{other})")
    } else {
        let count = match model.forces().len() {
            1 => "its contact force has no moving sphere".to_owned(),
            count => format!("none of its {count} contact forces has a moving sphere"),
        };
        format!("the model has no contacts ({count} that meets a half-space)")
    };
    Fault::new(FaultKind::NoContacts { detail, replaces: false })
}

/// Asks the caller to choose forces if their bodies are joined only through ground, such as a player and a ball.
fn refuse_several_trees(model: &Model, forces: &[ForceId]) -> Result<()> {
    let top = |sphere: &Sphere| match sphere.base {
        Carrier::Body(body) if !sphere.fixed => Some(model.skeleton().top(body)),
        _ => None,
    };
    let spheres = forces.iter().filter_map(|&id| model.force(id)).flat_map(Force::spheres);
    let mut tops = spheres.filter_map(|&sphere| top(model.sphere(sphere)?));
    let first = tops.next();
    if tops.all(|top| Some(top) == first) {
        return Ok(());
    }
    let mut trees: IndexMap<Cow<'_, str>, Vec<ForceId>> = IndexMap::new();
    for force in forces.iter().filter_map(|&id| model.force(id)) {
        for sphere in force.spheres().iter().filter_map(|&sphere| model.sphere(sphere)) {
            let Some(top) = top(sphere) else { continue };
            let forces = trees.entry(model.components().name(top)).or_default();
            if forces.last() != Some(&force.id) {
                forces.push(force.id);
            }
        }
    }
    if trees.len() < 2 {
        return Ok(());
    }
    let trees = trees.into_iter().map(|(top, forces)| ForcesOfAnimal {
        top: top.into_owned(),
        forces: model.short_force_names(&forces),
    });
    Err(Fault::new(MissingFact::Selection { trees: trees.collect(), input: Input::Select }))
}

/// The set of properties that a request may change.
///
/// ```
/// use osim_model::Property;
/// use osim_model::PropertySet;
///
/// // Everything the paper scales; friction is not among it.
/// let all = PropertySet::default();
/// assert!(all.contains(Property::Stiffness) && !all.contains(Property::TransitionVelocity));
/// assert!(all.clone().with_friction().contains(Property::TransitionVelocity));
///
/// // The stiffness alone: the contacts are not similar afterwards, because the others stay behind.
/// let stiffness = all.restricted(&[Property::Stiffness], &[]);
/// assert!(!stiffness.contains(Property::Dissipation) && !stiffness.is_complete());
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PropertySet(Vec<Property>);

impl Default for PropertySet {
    fn default() -> Self {
        Self(Self::SCALED.to_vec())
    }
}

impl PropertySet {
    /// All properties that the paper scales: radius, E₁*, α and the three smoothing parameters.
    pub const SCALED: [Property; 6] = [
        Property::Radius,
        Property::Stiffness,
        Property::Dissipation,
        Property::ConstantContactForce,
        Property::HertzSmoothing,
        Property::HuntCrossleySmoothing,
    ];

    /// Adds the friction speeds, which the paper does not scale: `transition_velocity` ∝ √(g R) and `viscous_friction` ∝ 1/√(g R).
    pub fn with_friction(mut self) -> Self {
        self.0.extend([Property::TransitionVelocity, Property::ViscousFriction]);
        self
    }

    /// Keeps the properties in `only` (all properties if `only` is empty), without those in `keep`.
    pub fn restricted(mut self, only: &[Property], keep: &[Property]) -> Self {
        self.0.retain(|property| (only.is_empty() || only.contains(property)) && !keep.contains(property));
        self
    }

    pub fn contains(&self, property: Property) -> bool {
        self.0.contains(&property)
    }

    /// Whether the set has all properties that the paper scales. The radius may be missing: the other properties then follow from the
    /// unchanged radius.
    pub fn is_complete(&self) -> bool {
        Self::SCALED.into_iter().all(|property| property == Property::Radius || self.contains(property))
    }
}

/// A new value of a property, or a factor for its present value.
///
/// Exhaustive: a number is set or multiplied, and nothing else.
///
/// ```
/// use osim_model::Assignment;
/// assert_eq!(Assignment::Value(1e6).to_string(), "1000000");
/// assert_eq!(Assignment::Factor(0.5).to_string(), "x0.5");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Assignment {
    /// The new value in the unit of the property.
    Value(f64),
    /// The factor that multiplies the present value.
    Factor(f64),
}

impl std::fmt::Display for Assignment {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Value(value) => f.write_str(&shortest(*value)),
            Self::Factor(factor) => write!(f, "x{}", shortest(*factor)),
        }
    }
}

/// The rule that gives moving spheres their new radii.
///
/// Exhaustive: plans of changes have a formula for each rule.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum RadiusRule {
    /// R ∝ M^{1/3}, like the linear dimensions of the body (8). In a transfer: as large relative to the body as in the reference.
    Isometric,
    #[default]
    Keep,
    /// All radii get this value, m.
    Metres(f64),
    /// All radii are multiplied by this factor.
    Factor(f64),
}

/// Whether the dissipation α changes with the radius or with the mass, (14).
///
/// Exhaustive: plans of changes have a factor for each choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DissipationBy {
    /// α ∝ R^{−1/2}: dissipation changes with the radius, as in the paper's Table 1.
    #[default]
    Radius,
    /// α ∝ M^{−1/6}: dissipation changes with the mass.
    Mass,
}

/// How the ratio of radii follows from a body's factors along x, y and z.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RadiusAxis {
    X,
    Y,
    Z,
    /// The cube root of the product of the three factors.
    #[default]
    GeometricMean,
    Min,
    Max,
}

impl RadiusAxis {
    /// The ratio of radii for a body's factors along x, y and z.
    pub fn radius_ratio(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::X => x,
            Self::Y => y,
            Self::Z => z,
            // Three equal factors are their own mean, to the last bit.
            Self::GeometricMean if x == y && y == z => x,
            Self::GeometricMean => libm::cbrt(x * y * z),
            Self::Min => x.min(y).min(z),
            Self::Max => x.max(y).max(z),
        }
    }
}

/// What to do with spheres of the scaled model that somebody has already moved or resized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MovedSpheres {
    /// Refuse the request, so that the caller decides ([`MissingFact::MovedSpheres`](crate::model::MissingFact::MovedSpheres)).
    #[default]
    Refuse,
    /// The spheres are right: keep their location and radius.
    Keep,
    /// The spheres are wrong: place them again from the reference.
    Replace,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_ratios_follow_the_requested_axis() {
        let factors = [1.0, 2.0, 4.0];
        let ratio = |axis: RadiusAxis| axis.radius_ratio(factors);
        assert_eq!((ratio(RadiusAxis::X), ratio(RadiusAxis::Y), ratio(RadiusAxis::Z)), (1.0, 2.0, 4.0));
        assert_eq!((ratio(RadiusAxis::Min), ratio(RadiusAxis::Max)), (1.0, 4.0));
        assert!((ratio(RadiusAxis::GeometricMean) - 2.0).abs() < 1e-15);
        assert_eq!(RadiusAxis::GeometricMean.radius_ratio([1.3, 1.3, 1.3]), 1.3);
    }
}
