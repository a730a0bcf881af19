//! New radii, and the one radius ratio by which a force's parameters follow.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::draft::{Draft, New, PropertySet};
use crate::error::{Fault, FaultKind};
use crate::follow::{LevelAxis, rotation_of};
use crate::model::{Force, Model};
use crate::property::Property;
use crate::warning::{Warning, WarningCode};

/// What becomes of the radii of the moving spheres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RadiusRule {
    /// R ∝ M^{1/3}: with the linear dimensions of the body.
    Isometric,
    /// They stay.
    Keep,
    /// All become this, m.
    Metres(f64),
    /// All are multiplied by this.
    Factor(f64),
    /// As large against the body as the reference's: this, m (transfers only).
    #[doc(hidden)]
    Like(f64),
    /// As the wanted stiffness and indentation need: this, m (designs only).
    #[doc(hidden)]
    Designed(f64),
    /// As its body grew: this, m (spheres that follow their bodies only).
    #[doc(hidden)]
    Followed(f64),
}

/// Old and new radius of each moving sphere of the chosen forces.
pub(super) struct Radii(BTreeMap<usize, Pair>);

#[derive(Clone, Copy)]
struct Pair {
    old: f64,
    new: f64,
    ratio: f64,
}

impl RadiusRule {
    fn equation(self) -> &'static str {
        match self {
            Self::Isometric | Self::Like(_) => "8",
            Self::Followed(_) => "follow",
            Self::Designed(_) => "11, B.2",
            _ => "given",
        }
    }

    /// Whether the new radius is a multiple of the old one.
    fn is_relative(self) -> bool {
        matches!(self, Self::Isometric | Self::Keep | Self::Factor(_))
    }

    fn pair(self, old: f64, isometric: f64) -> Pair {
        let times = |ratio: f64| Pair { old, new: if ratio == 1.0 { old } else { old * ratio }, ratio };
        match self {
            Self::Isometric => times(isometric),
            Self::Keep => times(1.0),
            Self::Factor(factor) => times(factor),
            Self::Metres(new) | Self::Like(new) | Self::Followed(new) | Self::Designed(new) => {
                Pair { old, new, ratio: new / old }
            }
        }
    }
}

impl Radii {
    /// Applies each sphere's rule to the moving spheres of `forces` and plans the changes.
    ///
    /// # Errors
    /// A radius that cannot be scaled, or a sphere that another applied force needs as it is.
    pub(super) fn plan(
        draft: &mut Draft<'_, '_, '_>,
        forces: &[usize],
        rule_of: impl Fn(usize) -> RadiusRule,
        isometric: f64,
        properties: &PropertySet,
    ) -> Result<Self, Fault> {
        let model = draft.model;
        let mut radii = BTreeMap::new();
        let users = Users::outside(model, forces);
        for sphere in moving_spheres(model, forces) {
            let old = draft.current_radius(sphere)?;
            let rule = if properties.contains(Property::Radius) { rule_of(sphere) } else { RadiusRule::Keep };
            let pair = rule.pair(old, isometric);
            if pair.new != pair.old {
                users.refuse(model, forces, sphere)?;
            }
            let factor = rule.is_relative().then_some(pair.ratio);
            draft.radius(sphere, New { to: pair.new, factor, equation: rule.equation() })?;
            radii.insert(sphere, pair);
        }
        warn_terrain(draft, forces);
        Ok(Self(radii))
    }

    /// ρ of one force: the common ratio of its spheres, or by the mean of R² before and after where they differ.
    pub(super) fn ratio(&self, force: &Force) -> f64 {
        let pairs = self.of(force);
        match pairs.split_first() {
            None => 1.0,
            Some((first, rest)) if rest.iter().all(|pair| pair.ratio == first.ratio) => first.ratio,
            Some(_) => self.mean_new(force) / self.mean_old(force),
        }
    }

    /// Root of the mean R² before.
    pub(super) fn mean_old(&self, force: &Force) -> f64 {
        root_mean_square(self.of(force).iter().map(|pair| pair.old))
    }

    /// Root of the mean R² afterwards.
    pub(super) fn mean_new(&self, force: &Force) -> f64 {
        root_mean_square(self.of(force).iter().map(|pair| pair.new))
    }

    fn of(&self, force: &Force) -> Vec<Pair> {
        force.spheres().iter().filter_map(|sphere| self.0.get(sphere)).copied().collect()
    }

    /// How far sphere bottoms move down, least and most, m.
    pub(super) fn bottoms(&self) -> Option<(f64, f64)> {
        let moves = self.0.values().map(|pair| pair.new - pair.old);
        let least = moves.clone().fold(f64::INFINITY, f64::min);
        let most = moves.fold(f64::NEG_INFINITY, f64::max);
        (least.is_finite() && (least != 0.0 || most != 0.0)).then_some((least, most))
    }

    /// Moves centres so that bottoms stay where they are.
    pub(super) fn level(&self, draft: &mut Draft<'_, '_, '_>, axis: LevelAxis) -> Result<(), Fault> {
        for (&sphere, pair) in &self.0 {
            let Some(found) = draft.model.spheres.get(sphere) else { continue };
            let location = found.location_m;
            let axis = axis.in_frame(&rotation_of(draft.model.files(), found.frame_object)?);
            draft.location(sphere, axis.centre(location, pair.old, pair.new, |vector| vector), "level")?;
        }
        Ok(())
    }

    /// Largest over smallest ratio among the spheres of a force.
    pub(super) fn spread(&self, force: &Force, old_radius: impl Fn(usize) -> f64) -> f64 {
        let ratios: Vec<f64> = force
            .spheres()
            .into_iter()
            .filter_map(|sphere| Some(self.0.get(&sphere)?.new / old_radius(sphere)))
            .collect();
        let most = ratios.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
        if ratios.is_empty() { 1.0 } else { most / least }
    }

    /// Says where one modulus serves several radii.
    pub(super) fn warn_mixed(&self, draft: &mut Draft<'_, '_, '_>, forces: &[usize]) {
        for force in forces.iter().filter_map(|&index| draft.model.forces.get(index)) {
            let pairs = self.of(force);
            if pairs.windows(2).any(|two| matches!(two, [a, b] if a.old != b.old)) {
                let text =
                    format!("{} has spheres of different radii: the mean of R squared is used", force.path);
                draft.warnings.push(Warning::at(WarningCode::MixedRadii, force.line, text));
            }
        }
    }
}

/// Exactly the common value where all are equal.
pub(super) fn root_mean_square(radii: impl Iterator<Item = f64> + Clone) -> f64 {
    let mut others = radii.clone();
    match others.next() {
        None => f64::NAN,
        Some(first) if others.all(|other| other == first) => first,
        Some(_) => {
            let (sum, count) =
                radii.fold((0.0, 0.0), |(sum, count), radius| (sum + radius * radius, count + 1.0));
            (sum / count).sqrt()
        }
    }
}

/// Moving spheres of `forces`, each once, in file order.
#[must_use]
pub fn moving_spheres(model: &Model<'_, '_>, forces: &[usize]) -> Vec<usize> {
    let mut spheres: Vec<usize> =
        forces.iter().filter_map(|&index| model.forces.get(index)).flat_map(Force::spheres).collect();
    spheres.sort_unstable();
    spheres.dedup();
    spheres.retain(|&index| model.spheres.get(index).is_some_and(|sphere| !sphere.fixed));
    spheres
}

/// Forces that use a sphere and are not changed with it.
pub(super) struct Users<'m> {
    forces: HashMap<usize, Vec<&'m str>>,
    /// By sphere name: contact classes that are not Hertz's.
    others: HashMap<String, Vec<String>>,
}

impl<'m> Users<'m> {
    pub(super) fn outside(model: &'m Model<'_, '_>, chosen: &[usize]) -> Self {
        let chosen: HashSet<usize> = chosen.iter().copied().collect();
        let mut forces: HashMap<usize, Vec<&str>> = HashMap::new();
        for (index, force) in model.forces.iter().enumerate() {
            if force.applies && !chosen.contains(&index) {
                for sphere in force.spheres() {
                    forces.entry(sphere).or_default().push(&force.name);
                }
            }
        }
        Self { forces, others: model.users_of_other_classes() }
    }

    /// A radius may change only if every applied force that uses the sphere changes with it.
    pub(super) fn refuse(&self, model: &Model<'_, '_>, chosen: &[usize], sphere: usize) -> Result<(), Fault> {
        let Some(shared) = model.spheres.get(sphere) else { return Ok(()) };
        let mut left: Vec<&str> = self.forces.get(&sphere).cloned().unwrap_or_default();
        left.extend(self.others.get(&shared.name).into_iter().flatten().map(String::as_str));
        if left.is_empty() {
            return Ok(());
        }
        let changed: Vec<usize> = chosen
            .iter()
            .copied()
            .filter(|&index| model.forces.get(index).is_some_and(|force| force.spheres().contains(&sphere)))
            .collect();
        let fault = Fault::new(FaultKind::NeedsAnswer {
            code: "shared-sphere",
            question: format!(
                "sphere {} is used by {} and by {}, which is not rescaled",
                shared.path,
                crate::select::names(model, &changed),
                left.join(", ")
            ),
            way_out: "choose all of them with --select GLOB, or leave radii as they are with --radius keep"
                .to_owned(),
        });
        let offset = shared.radius.offset;
        Err(Fault { offset: Some(offset), ..fault }.of(shared.path.clone()).in_file(shared.file))
    }
}

fn warn_terrain(draft: &mut Draft<'_, '_, '_>, forces: &[usize]) {
    for force in forces.iter().filter_map(|&index| draft.model.forces.get(index)) {
        let fixed =
            force.spheres().iter().filter_map(|&s| draft.model.spheres.get(s)).filter(|s| s.fixed).count();
        if fixed > 0 {
            let text = format!("{} meets terrain ({fixed} fixed spheres): their radii stay", force.path);
            draft.warnings.push(Warning::at(WarningCode::Terrain, force.line, text));
        }
    }
}
