//! The one register of figures, and the figures of a model. A new figure is a new entry here, and a test.

#[cfg(feature = "schemas")]
use std::borrow::Cow;

use contact_scaling::{Hertz, limits, patch, restitution, smoothing, stiffness};
use osim_model::messages::{Dialect, Phrase};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use self::FigureVisibility::{Always, IfMixed, IfMixedAndSmooth, IfSmooth, Never};
use crate::figures::sphere_on_floor::{ComputedFigure, SphereOnFloor};
use crate::quantity::Quantity;
#[cfg(feature = "schemas")]
use crate::serialized::ObjectSchema;
use crate::serialized::optional_phrase;

/// An entry of the register of figures: the condition on which tables show the figure, and the function that computes its value.
struct Entry {
    visibility: FigureVisibility,
    compute: fn(&SphereOnFloor<'_>) -> ComputedFigure,
}

/// An entry of the register of figures.
const fn entry(visibility: FigureVisibility, compute: fn(&SphereOnFloor<'_>) -> ComputedFigure) -> Entry {
    Entry { visibility, compute }
}

/// A quantity x̂ that is compared with the limit of the Hertz law.
const fn indentation(name: &'static str, label: &'static str) -> Quantity {
    Quantity::new(name, label, "").with_limit(&limits::INDENTATION)
}

crate::quantities! {
    /// A number of a contact sphere that carries its share of the body weight; [`Quantity`] says which.
    Figure: Entry {
        Radius = "Radius R of the sphere.", Quantity::RADIUS => entry(Always, |s| ComputedFigure::Known(s.contacts.radius_m));
        CompositeModulus = "Composite modulus E*; the sum where several forces press the sphere.",
            Quantity::COMPOSITE_MODULUS => entry(Never, |s| ComputedFigure::Known(s.composite_modulus()));
        Dissipation = "Dissipation α; absent where forces of different α press the sphere.",
            Quantity::new("dissipation_s_m", "dissipation", "s/m")
            .with_column("dissipation_of_sphere")
            => entry(Never, |s| s.dissipation().into());
        Load = "The sphere's share of one body weight, W/n.", Quantity::new("load_n", "load at 1 BW", "N")
            .with_column("load_at_1_body_weight")
            => entry(Always, |s| s.at_one_body_weight(|rest| Some(rest.load_n)));
        Indentation = "x̂ under its share of one body weight, by the Hertz law.", Quantity::INDENTATION_HERTZ.labelled("x/R at 1 BW, Hertz")
            .with_column("indentation_at_rest_over_radius_hertz_law")
            => entry(Always, |s| s.at_one_body_weight(|rest| rest.hertz));
        IndentationModelLaw = "x̂ under its share of one body weight, by the model's law; below 0 if the smoothing alone carries the load.",
            Quantity::INDENTATION_MODEL_LAW.labelled("  by the model's law")
            .with_column("indentation_at_rest_over_radius_model_law")
            => entry(IfSmooth, |s| s.at_one_body_weight(|rest| rest.model_law));
        LevelIndentation = "x̂ with the bottoms of all spheres of the limb level, under one body weight, by the Hertz law.",
            indentation("relative_indentation_hertz_level", "  level, Hertz")
            .with_column("indentation_at_rest_over_radius_level_hertz_law")
            => entry(IfMixed, |s| s.at_one_body_weight(|rest| rest.level_hertz));
        LevelIndentationModelLaw = "x̂ with the bottoms of all spheres of the limb level, under one body weight, by the model's law.",
            indentation("relative_indentation_model_law_level", "  level, the model's law")
            .with_column("indentation_at_rest_over_radius_level_model_law")
            => entry(IfMixedAndSmooth, |s| s.at_one_body_weight(|rest| rest.level_model_law));
        StandingIndentation = "x̂ with each sphere of the limb at its own height at the default pose, under one body weight, by the Hertz law. \
             Below 0 if the sphere does not touch; absent if the pose or the spheres are not known.",
            Quantity::new("relative_indentation_hertz_standing", "x/R at its own height, Hertz", "")
            .with_column("indentation_at_rest_over_radius_default_pose_hertz_law")
            => entry(Never, |s| s.at_one_body_weight(|rest| rest.standing_hertz));
        StandingIndentationModelLaw = "x̂ with each sphere of the limb at its own height at the default pose, under one body weight, by the model's law.",
            Quantity::new("relative_indentation_model_law_standing", "x/R at its own height, the model's law", "")
            .with_column("indentation_at_rest_over_radius_default_pose_model_law")
            => entry(Never, |s| s.at_one_body_weight(|rest| rest.standing_model_law));
        IndentationAtTwo = "x̂ under its share of two body weights, by the Hertz law.",
            indentation("relative_indentation_hertz_at_two", "x/R at 2 BW, Hertz")
            .with_column("indentation_at_2_body_weights_over_radius_hertz_law")
            => entry(Always, |s| s.at_two_body_weights(|rest| rest.hertz));
        IndentationModelLawAtTwo = "x̂ under its share of two body weights, by the model's law.",
            indentation("relative_indentation_model_law_at_two", "  by the model's law")
            .with_column("indentation_at_2_body_weights_over_radius_model_law")
            => entry(IfSmooth, |s| s.at_two_body_weights(|rest| rest.model_law));
        LevelIndentationAtTwo = "x̂ with the bottoms of all spheres of the limb level, under two body weights, by the Hertz law.",
            indentation("relative_indentation_hertz_level_at_two", "  level, Hertz")
            .with_column("indentation_at_2_body_weights_over_radius_level_hertz_law")
            => entry(IfMixed, |s| s.at_two_body_weights(|rest| rest.level_hertz));
        LevelIndentationModelLawAtTwo = "x̂ with the bottoms of all spheres of the limb level, under two body weights, by the model's law.",
            indentation("relative_indentation_model_law_level_at_two", "  level, the model's law")
            .with_column("indentation_at_2_body_weights_over_radius_level_model_law")
            => entry(IfMixedAndSmooth, |s| s.at_two_body_weights(|rest| rest.level_model_law));
        ContactStiffness = "Stiffness k of the Hertz law under one body weight.", Quantity::CONTACT_STIFFNESS.labelled("stiffness k")
            => entry(Always, |s| contact_stiffness(s).into());
        DimensionlessStiffness = "k̂ = k R n / F under one body weight.",
            Quantity::DIMENSIONLESS_STIFFNESS.labelled("k R n/F") => entry(Always, |s| {
            let k = contact_stiffness(s).zip(s.one_body_weight);
            k.and_then(|(k, load)| stiffness::dimensionless(k, s.contacts.radius_m, &load).ok()).into()
        });
        NaturalFrequency = "Natural frequency f_n about the rest under one body weight, from k and the mass on the sphere, M/n.",
            Quantity::NATURAL_FREQUENCY.labelled("frequency f_n") => entry(Always, |s| {
            let k = contact_stiffness(s).zip(s.mass_on_sphere());
            k.and_then(|(k, mass)| stiffness::natural_frequency(k, mass).ok()).into()
        });
        MeanContactStress = "Mean contact stress σ under one body weight.",
            Quantity::MEAN_CONTACT_STRESS.labelled("mean stress") => entry(Always, |s| {
            let rest = s.rest_at(1.0).and_then(|rest| Some((rest.load_n, rest.hertz?)));
            rest.and_then(|(load_n, x_hat)| patch::mean_stress(load_n, s.contacts.radius_m, x_hat).ok()).into()
        });
        RestitutionExact = "Restitution c_r of the law at the impact speed.",
            Quantity::RESTITUTION_EXACT.with_column("coefficient_of_restitution_exact")
            => entry(Always, |s| s.dissipation_and_speed().and_then(|(alpha, speed)| restitution::exact(alpha, speed).ok()).into());
        RestitutionApproximate = "Restitution by (13); absent if it is below 0.", Quantity::RESTITUTION_APPROXIMATE.labelled("  by (13)")
            .with_column("coefficient_of_restitution_equation_13")
            => entry(Always, |s| match s.dissipation_and_speed() {
                Some((alpha, speed)) => restitution::approximate(alpha, speed).map_or(ComputedFigure::Beyond, ComputedFigure::Known),
                None => ComputedFigure::Unknown,
            });
        ConstantIndentation = "Constant indentation √cf / R; absent for a `HuntCrossleyForce`. Of several forces the largest.",
            Quantity::new("constant_indentation", "sqrt(cf)/R", "").by_equation("C.2").with_limit(&limits::CONSTANT_INDENTATION)
            .with_column("constant_indentation_over_radius")
            => entry(Always, |s| {
                s.largest_of_smoothing(|values, radius| smoothing::constant_indentation(values.constant_contact_force, radius)).into()
            });
        TransitionWidth = "Width Δx̂ over which the contact state goes from 5 % to 95 %, in radii. Of several forces the largest.",
            Quantity::new("transition_width", "transition, in R", "").by_equation("C.7").with_limit(&limits::TRANSITION_WIDTH)
            .with_column("transition_width_over_radius")
            => entry(Always, |s| {
                let threshold = limits::TRANSITION_SHARE;
                s.largest_of_smoothing(|values, radius| smoothing::transition_width(threshold, values.hertz_smoothing, radius)).into()
            });
        ForceJustTouching = "Force at rest while the sphere just touches, x = 0.", Quantity::FORCE_JUST_TOUCHING.labelled("force at touch")
            => entry(Always, |s| s.force_just_touching().into());
        TouchingShare = "Force at rest while the sphere just touches, over its share of one body weight.",
            Quantity::new("touching_share", "  over the load at 1 BW", "").with_limit(&limits::TOUCHING_SHARE)
            .with_column("force_just_touching_over_load_at_1_body_weight")
            => entry(Always, |s| {
                let share = s.force_just_touching().zip(s.one_body_weight);
                share.map(|(force, load)| force / load.per_sphere_n()).into()
            });
    }
}

impl Figure {
    pub const fn visibility(self) -> FigureVisibility {
        self.entry().visibility
    }

    /// The value of this figure for one sphere.
    pub(super) fn compute(self, sphere: &SphereOnFloor<'_>) -> ComputedFigure {
        (self.entry().compute)(sphere)
    }
}

/// Stiffness of a sphere under its share of the body weight, N/m.
fn contact_stiffness(sphere: &SphereOnFloor<'_>) -> Option<f64> {
    let x_hat = sphere.rest_at(1.0)?.hertz?;
    let hertz = Hertz::sphere(sphere.composite_modulus(), sphere.contacts.radius_m).ok()?;
    Some(hertz.stiffness_at_relative_indentation(x_hat))
}

/// The condition on which a table or page shows a number of a sphere. JSON and CSV always have all numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureVisibility {
    Always,
    /// Never in this table, because another line or column has the number.
    Never,
    /// Only if the law of the model is smoothed, and so differs from the Hertz law.
    IfSmooth,
    /// Only if the spheres of a limb differ in radius or parameters.
    IfMixed,
    /// Only if the law of the model is smoothed and the spheres of a limb differ.
    IfMixedAndSmooth,
}

/// Figures of one model.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct Figures {
    /// Mass whose weight the spheres carry: what the model weighs, else the mass that its contacts are made for, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that the loads are computed with, m/s²: the model's, unless the caller gave another; `None` without gravity. On a slope
    /// its part along the floor's normal counts.
    pub gravity_m_s2: Option<f64>,
    /// Speed before an impact, m/s: given, or √(gR/2) with R = √(Σ R_i²/n) of all spheres, as in a drop test.
    pub impact_speed_m_s: Option<f64>,
    /// Why figures under body weight are absent, in words.
    #[serde(serialize_with = "optional_phrase")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>"))]
    pub why_no_body_weight: Option<Phrase>,
    /// Each limb with chosen spheres; one entry without a name if limbs are not known.
    pub limbs: Vec<LimbFigures>,
}

/// Figures of one limb.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct LimbFigures {
    /// First body below the place where left and right split; `None` if limbs are not known.
    pub limb: Option<String>,
    /// Side of the limb, `right` or `left`.
    pub side: Option<&'static str>,
    /// Spheres n that share the body weight, chosen or not; `None` if it is not known.
    pub sphere_count: Option<f64>,
    /// Each chosen sphere, in file order.
    pub spheres: Vec<SphereFigures>,
}

/// The figures of one sphere. A figure may have no value.
#[derive(Debug, Clone, PartialEq)]
pub struct SphereFigures {
    pub sphere: String,
    /// Component path of the sphere.
    pub path: String,
    /// Names of the forces that press this sphere on the floor.
    pub forces: Vec<String>,
    /// The value of each figure, or the reason why it has none, in the order of [`Figure::ALL`].
    pub(super) computed: Vec<ComputedFigure>,
}

/// A figure of a sphere and its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct LimitCheck {
    /// Name of the figure.
    pub figure: &'static str,
    /// Value of the figure; `None` if it is beyond what its equation gives.
    pub value: Option<f64>,
    /// The limit, in the figure's own unit.
    pub limit: f64,
    /// Whether the figure is within the limit.
    pub within_limit: bool,
}

impl Figures {
    /// No figures, for the reason `why`.
    pub(crate) fn absent(why: Phrase) -> Self {
        Self { why_no_body_weight: Some(why), ..Self::default() }
    }

    /// The figures of all spheres, limb by limb.
    pub fn spheres(&self) -> impl Iterator<Item = &SphereFigures> {
        self.limbs.iter().flat_map(|limb| &limb.spheres)
    }

    /// Writes the texts of the figures in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.why_no_body_weight.iter_mut().for_each(|why| why.spell(dialect));
    }
}

impl LimbFigures {
    /// Whether the spheres of the limb differ. Then the figures with level bottoms differ from the figures with equal loads.
    pub fn is_mixed(&self) -> bool {
        let pairs = [
            (Figure::Indentation, Figure::LevelIndentation),
            (Figure::IndentationAtTwo, Figure::LevelIndentationAtTwo),
        ];
        let differs = |sphere: &SphereFigures, (equal, level): (Figure, Figure)| {
            let values = sphere.value(equal).zip(sphere.value(level));
            values.is_some_and(|(equal, level)| (equal - level).abs() > 1e-9 * equal.abs())
        };
        self.spheres.iter().any(|sphere| pairs.iter().any(|&pair| differs(sphere, pair)))
    }
}

/// x̂ at which a sphere is in the floor up to its centre.
pub(crate) const UP_TO_CENTRE_RADII: f64 = 1.0;
/// A sphere whose x̂ with an equal share of the load is above this carries hardly anything: its stiffness lost digits. A published one has
/// 1.59.
const CARRIES_NOTHING_RADII: f64 = 3.0;
/// Tolerance for rounding errors of x̂.
pub(crate) const ROUNDING_RADII: f64 = 1e-9;

impl SphereFigures {
    /// The value of `figure`, or why it has none.
    fn compute(&self, figure: Figure) -> ComputedFigure {
        // The discriminant is the place in `Figure::ALL`: both come from one list.
        self.computed.get(figure as usize).copied().unwrap_or(ComputedFigure::Unknown)
    }

    /// The value of `figure`; `None` if it is not known.
    pub fn value(&self, figure: Figure) -> Option<f64> {
        self.compute(figure).value()
    }

    /// Whether the sphere is in the floor up to its centre under one body weight, by the Hertz law. A soft sphere beside stiffer ones, as
    /// of small toes, is less deep with level bottoms than with an equal share of the load.
    pub fn is_in_to_centre(&self) -> bool {
        let Some(x) = self.value(Figure::Indentation) else { return false };
        let level = self.value(Figure::LevelIndentation).unwrap_or(x);
        let is_held_by_others = level < UP_TO_CENTRE_RADII - ROUNDING_RADII && x < CARRIES_NOTHING_RADII;
        x >= UP_TO_CENTRE_RADII && !is_held_by_others
    }

    /// Whether `figure` is within its limit; `None` if the value of the figure is not known, or the figure has no limit.
    pub fn is_within(&self, figure: Figure) -> Option<bool> {
        let limit = figure.info().limit?;
        match self.compute(figure) {
            ComputedFigure::Known(value) => Some(limit.admits(value)),
            ComputedFigure::Beyond => Some(false),
            ComputedFigure::Unknown => None,
        }
    }

    /// Compares each figure that has a limit and a known value with its limit.
    pub fn limits(&self) -> impl Iterator<Item = LimitCheck> {
        Figure::ALL.iter().filter_map(|&figure| {
            let info = figure.info();
            Some(LimitCheck {
                figure: info.name,
                value: self.value(figure),
                limit: info.limit?.value,
                within_limit: self.is_within(figure)?,
            })
        })
    }
}

/// Serialises the figures as one object, each figure under its name, in the order of the register.
impl Serialize for SphereFigures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("sphere", &self.sphere)?;
        map.serialize_entry("path", &self.path)?;
        map.serialize_entry("forces", &self.forces)?;
        for &figure in Figure::ALL {
            map.serialize_entry(figure.info().name, &self.value(figure))?;
        }
        map.serialize_entry("limits", &self.limits().collect::<Vec<_>>())?;
        map.end()
    }
}

#[cfg(feature = "schemas")]
impl schemars::JsonSchema for SphereFigures {
    fn schema_name() -> Cow<'static, str> {
        "SphereFigures".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let mut object = ObjectSchema::new(generator);
        object.field::<String>("sphere", "Name of the sphere.");
        object.field::<String>("path", "Its component path.");
        object.field::<Vec<String>>("forces", "Names of the forces that press it on the floor.");
        for info in Figure::ALL.iter().map(|figure| figure.info()) {
            object.field::<Option<f64>>(info.name, &info.schema_description());
        }
        let limits = "Each figure that has a limit, compared with it, where it is known.";
        object.field::<Vec<LimitCheck>>("limits", limits);
        object.finish("Figures of one sphere; null where one is not known.")
    }
}
