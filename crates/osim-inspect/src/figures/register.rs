//! The one register of figures, and the figures of a model. A new figure is a new entry here, and a test.

#[cfg(feature = "schemas")]
use std::borrow::Cow;

use contact_scaling::{Hertz, limits, patch, restitution, smoothing, stiffness};
use osim_model::messages::{Dialect, Phrase};
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use self::Shown::{Always, Mixed, MixedSmooth, Nowhere, Smooth};
use crate::figures::on_floor::{Answer, OnFloor};
use crate::quantity::Quantity;
#[cfg(feature = "schemas")]
use crate::serialized::ObjectSchema;
use crate::serialized::optional_phrase;

/// What an entry has beside its quantity.
struct Entry {
    shown: Shown,
    answer: fn(&OnFloor<'_>) -> Answer,
}

/// Where a figure is shown, and how to get it.
const fn entry(shown: Shown, answer: fn(&OnFloor<'_>) -> Answer) -> Entry {
    Entry { shown, answer }
}

const fn indentation(name: &'static str, label: &'static str) -> Quantity {
    Quantity::new(name, label, "").within(&limits::INDENTATION)
}

/// A relative indentation that follows from the pose, not from the contact alone: no limit is set on it.
const fn indentation_alone(name: &'static str, label: &'static str) -> Quantity {
    Quantity::new(name, label, "")
}

crate::quantities! {
    /// A figure of a sphere that stands, see [`Quantity`].
    Figure: Entry {
        /// Radius R.
        Radius = Quantity::RADIUS => entry(Always, |s| Answer::Known(s.sphere.radius_m));
        /// Composite modulus E*; the sum where several forces press the sphere.
        CompositeModulus = Quantity::COMPOSITE_MODULUS => entry(Nowhere, |s| Answer::Known(s.composite_modulus()));
        /// Dissipation α; absent where forces of different α press the sphere.
        Dissipation = Quantity::new("dissipation_s_m", "dissipation", "s/m")
            .in_column("dissipation_of_sphere")
            => entry(Nowhere, |s| s.dissipation().into());
        /// The sphere's share of one body weight, W/n.
        Load = Quantity::new("load_n", "load at 1 BW", "N")
            .in_column("load_at_1_body_weight")
            => entry(Always, |s| s.one(|rest| Some(rest.load_n)));
        /// x̂ under its share of one body weight, by the Hertz law.
        Indentation = Quantity::INDENTATION_HERTZ.labelled("x/R at 1 BW, Hertz")
            .in_column("indentation_at_rest_over_radius_hertz_law")
            => entry(Always, |s| s.one(|rest| rest.hertz));
        /// The same by the model's law; below 0 where the smoothing alone carries the load.
        IndentationModelLaw = Quantity::INDENTATION_MODEL_LAW.labelled("  by the model's law")
            .in_column("indentation_at_rest_over_radius_model_law")
            => entry(Smooth, |s| s.one(|rest| rest.model_law));
        /// x̂ with the bottoms of all spheres of the limb level, under one body weight, by the Hertz law.
        LevelIndentation = indentation("relative_indentation_hertz_level", "  level, Hertz")
            .in_column("indentation_at_rest_over_radius_level_hertz_law")
            => entry(Mixed, |s| s.one(|rest| rest.level_hertz));
        /// The same by the model's law.
        LevelIndentationModelLaw = indentation("relative_indentation_model_law_level", "  level, the model's law")
            .in_column("indentation_at_rest_over_radius_level_model_law")
            => entry(MixedSmooth, |s| s.one(|rest| rest.level_model_law));
        /// x̂ of the sphere where the limb, its bodies as they are at the default pose, carries one body weight: each sphere at its
        /// own height, by the Hertz law. Below 0 where it does not touch; absent where the pose or the spheres are not known.
        StandingIndentation = indentation_alone("relative_indentation_hertz_standing", "x/R at its own height, Hertz")
            .in_column("indentation_at_rest_over_radius_default_pose_hertz_law")
            => entry(Nowhere, |s| s.one(|rest| rest.standing_hertz));
        /// The same by the model's law.
        StandingIndentationModelLaw
            = indentation_alone("relative_indentation_model_law_standing", "x/R at its own height, the model's law")
            .in_column("indentation_at_rest_over_radius_default_pose_model_law")
            => entry(Nowhere, |s| s.one(|rest| rest.standing_model_law));
        /// x̂ under its share of two body weights, by the Hertz law.
        IndentationAtTwo = indentation("relative_indentation_hertz_at_two", "x/R at 2 BW, Hertz")
            .in_column("indentation_at_2_body_weights_over_radius_hertz_law")
            => entry(Always, |s| s.two(|rest| rest.hertz));
        /// The same by the model's law.
        IndentationModelLawAtTwo = indentation("relative_indentation_model_law_at_two", "  by the model's law")
            .in_column("indentation_at_2_body_weights_over_radius_model_law")
            => entry(Smooth, |s| s.two(|rest| rest.model_law));
        /// x̂ with the bottoms of all spheres of the limb level, under two body weights, by the Hertz law.
        LevelIndentationAtTwo = indentation("relative_indentation_hertz_level_at_two", "  level, Hertz")
            .in_column("indentation_at_2_body_weights_over_radius_level_hertz_law")
            => entry(Mixed, |s| s.two(|rest| rest.level_hertz));
        /// The same by the model's law.
        LevelIndentationModelLawAtTwo
            = indentation("relative_indentation_model_law_level_at_two", "  level, the model's law")
            .in_column("indentation_at_2_body_weights_over_radius_level_model_law")
            => entry(MixedSmooth, |s| s.two(|rest| rest.level_model_law));
        /// Stiffness k of the Hertz law under one body weight.
        ContactStiffness = Quantity::CONTACT_STIFFNESS.labelled("stiffness k")
            => entry(Always, |s| contact_stiffness(s).into());
        /// k̂ = k R n / F under one body weight.
        DimensionlessStiffness = Quantity::DIMENSIONLESS_STIFFNESS.labelled("k R n/F") => entry(Always, |s| {
            let k = contact_stiffness(s).zip(s.load());
            k.and_then(|(k, load)| stiffness::dimensionless(k, s.sphere.radius_m, &load).ok()).into()
        });
        /// Natural frequency f_n about the rest under one body weight, from k and the mass on the sphere, M/n.
        NaturalFrequency = Quantity::NATURAL_FREQUENCY.labelled("frequency f_n") => entry(Always, |s| {
            let k = contact_stiffness(s).zip(s.mass_on_sphere());
            k.and_then(|(k, mass)| stiffness::natural_frequency(k, mass).ok()).into()
        });
        /// Mean contact stress σ under one body weight.
        MeanContactStress = Quantity::MEAN_CONTACT_STRESS.labelled("mean stress") => entry(Always, |s| {
            let rest = s.at_one().and_then(|rest| Some((rest.load_n, rest.hertz?)));
            rest.and_then(|(load_n, x_hat)| patch::mean_stress(load_n, s.sphere.radius_m, x_hat).ok()).into()
        });
        /// Restitution c_r of the law at the impact speed.
        RestitutionExact = Quantity::RESTITUTION_EXACT.in_column("coefficient_of_restitution_exact")
            => entry(Always, |s| s.impact().and_then(|(alpha, speed)| restitution::exact(alpha, speed).ok()).into());
        /// Restitution by (13); absent if it is below 0.
        RestitutionApproximate = Quantity::RESTITUTION_APPROXIMATE.labelled("  by (13)")
            .in_column("coefficient_of_restitution_equation_13")
            => entry(Always, |s| match s.impact() {
                Some((alpha, speed)) => restitution::approximate(alpha, speed).map_or(Answer::Beyond, Answer::Known),
                None => Answer::Unknown,
            });
        /// Constant indentation √cf / R; absent for a `HuntCrossleyForce`. Of several forces the largest.
        ConstantIndentation
            = Quantity::new("constant_indentation", "sqrt(cf)/R", "").by("C.2").within(&limits::CONSTANT_INDENTATION)
            .in_column("constant_indentation_over_radius")
            => entry(Always, |s| {
                s.most(|values, radius| smoothing::constant_indentation(values.constant_contact_force, radius)).into()
            });
        /// Width Δx̂ over which the contact state goes from 5 % to 95 %, in radii. Of several forces the largest.
        TransitionWidth
            = Quantity::new("transition_width", "transition, in R", "").by("C.7").within(&limits::TRANSITION_WIDTH)
            .in_column("transition_width_over_radius")
            => entry(Always, |s| {
                let threshold = limits::TRANSITION_THRESHOLD;
                s.most(|values, radius| smoothing::transition_width(threshold, values.hertz_smoothing, radius)).into()
            });
        /// Force at rest while the sphere just touches, x = 0.
        ForceJustTouching = Quantity::FORCE_JUST_TOUCHING.labelled("force at touch")
            => entry(Always, |s| s.force_just_touching().into());
        /// The same over the sphere's share of one body weight.
        TouchingShare = Quantity::new("touching_share", "  over the load at 1 BW", "").within(&limits::TOUCHING_SHARE)
            .in_column("force_just_touching_over_load_at_1_body_weight")
            => entry(Always, |s| {
                let share = s.force_just_touching().zip(s.load());
                share.map(|(force, load)| force / load.per_sphere_n()).into()
            });
    }
}

impl Figure {
    pub const fn shown(self) -> Shown {
        self.entry().shown
    }

    /// Its value for one sphere.
    pub(super) fn answer(self, on_floor: &OnFloor<'_>) -> Answer {
        (self.entry().answer)(on_floor)
    }
}

fn contact_stiffness(on_floor: &OnFloor<'_>) -> Option<f64> {
    let x_hat = on_floor.at_one()?.hertz?;
    let hertz = Hertz::sphere(on_floor.composite_modulus(), on_floor.sphere.radius_m).ok()?;
    Some(hertz.stiffness_at_relative_indentation(x_hat))
}

/// Where a table or page shows a figure; JSON and CSV have all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    Always,
    /// Nowhere: the tables have it in another place.
    Nowhere,
    /// Where the model's law is not Hertz's.
    Smooth,
    /// Where spheres of a limb differ.
    Mixed,
    /// Where both are so.
    MixedSmooth,
}

// The figures of a model's contacts, as data.

/// Figures of one model.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Figures {
    /// Mass whose weight the spheres carry: what the model weighs, else the mass that its contacts are made for, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that was taken, m/s²: the model's own as a rule; `None` without gravity. On a slope, loads are made of its part along the
    /// normal of the floor.
    pub gravity_m_s2: Option<f64>,
    /// Speed before an impact, m/s: given, or √(gR/2) with R = √(Σ R_i²/n) of all spheres, as in a drop test.
    pub impact_speed_m_s: Option<f64>,
    /// Why figures under body weight are absent, in words.
    #[serde(serialize_with = "optional_phrase")]
    #[cfg_attr(feature = "schemas", schemars(with = "Option<String>"))]
    pub why_no_body_weight: Option<Phrase>,
    /// Each limb with chosen spheres; one entry without a name where limbs are not known.
    pub limbs: Vec<LimbFigures>,
}

/// Figures of one limb.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct LimbFigures {
    /// First body below the place where left and right split; `None` where limbs are not known.
    pub limb: Option<String>,
    /// `right` or `left`.
    pub side: Option<&'static str>,
    /// Spheres n that share the body weight, chosen or not; `None` where it is not known.
    pub sphere_count: Option<f64>,
    /// Each chosen sphere, in file order.
    pub spheres: Vec<SphereFigures>,
}

/// Figures of one sphere: a value, or none, for each [`Figure`].
#[derive(Debug, Clone, PartialEq)]
pub struct SphereFigures {
    pub sphere: String,
    /// Its component path.
    pub path: String,
    /// Names of the forces that press it on the floor.
    pub forces: Vec<String>,
    /// In the order of [`Figure::ALL`].
    pub(super) answers: Vec<Answer>,
}

/// One figure and its limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct LimitCheck {
    /// Name of the figure.
    pub figure: &'static str,
    /// Its value; `None` where it is beyond what its equation gives.
    pub value: Option<f64>,
    /// The limit, in the figure's own unit.
    pub limit: f64,
    /// Whether the figure is within it.
    pub within_limit: bool,
}

impl Figures {
    pub(crate) fn absent(why: Phrase) -> Self {
        Self {
            mass_kg: None,
            gravity_m_s2: None,
            impact_speed_m_s: None,
            why_no_body_weight: Some(why),
            limbs: Vec::new(),
        }
    }

    pub fn spheres(&self) -> impl Iterator<Item = &SphereFigures> {
        self.limbs.iter().flat_map(|limb| &limb.spheres)
    }

    /// Spells what they say in the words of a front end.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        self.why_no_body_weight.iter_mut().for_each(|why| why.spell(dialect));
    }
}

impl LimbFigures {
    /// `true` where the spheres differ, so that level figures say something of their own.
    pub fn is_mixed(&self) -> bool {
        let pairs = [
            (Figure::Indentation, Figure::LevelIndentation),
            (Figure::IndentationAtTwo, Figure::LevelIndentationAtTwo),
        ];
        let differs = |sphere: &SphereFigures, (equal, level): (Figure, Figure)| match (
            sphere.value(equal),
            sphere.value(level),
        ) {
            (Some(equal), Some(level)) => (equal - level).abs() > 1e-9 * equal.abs(),
            _ => false,
        };
        self.spheres.iter().any(|sphere| pairs.iter().any(|&pair| differs(sphere, pair)))
    }
}

impl SphereFigures {
    fn answer(&self, figure: Figure) -> Answer {
        // The discriminant is the place in `Figure::ALL`: both come from one list.
        self.answers.get(figure as usize).copied().unwrap_or(Answer::Unknown)
    }

    pub fn value(&self, figure: Figure) -> Option<f64> {
        self.answer(figure).value()
    }

    /// Whether `figure` is within its limit; `None` where it is not known, or has no limit.
    pub fn is_within(&self, figure: Figure) -> Option<bool> {
        let limit = figure.info().limit?;
        match self.answer(figure) {
            Answer::Known(value) => Some(limit.admits(value)),
            Answer::Beyond => Some(false),
            Answer::Unknown => None,
        }
    }

    /// Each figure that has a limit, compared with it, where it is known.
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

/// Each figure has its name, in their order.
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
impl JsonSchema for SphereFigures {
    fn schema_name() -> Cow<'static, str> {
        "SphereFigures".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut object = ObjectSchema::new(generator);
        object.field::<String>("sphere", "Name of the sphere.");
        object.field::<String>("path", "Its component path.");
        object.field::<Vec<String>>("forces", "Names of the forces that press it on the floor.");
        for info in Figure::ALL.iter().map(|figure| figure.info()) {
            object.field::<Option<f64>>(info.name, &info.described());
        }
        let limits = "Each figure that has a limit, compared with it, where it is known.";
        object.field::<Vec<LimitCheck>>("limits", limits);
        object.finish("Figures of one sphere; null where one is not known.")
    }
}
