//! The figures of a model's contacts, as data.

#[cfg(feature = "schemas")]
use std::borrow::Cow;

use osim_model::messages::{Dialect, Phrase};
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::answer::Answer;
use super::register::Figure;
#[cfg(feature = "schemas")]
use crate::serialized::ObjectSchema;
use crate::serialized::optional_phrase;

/// Figures of one model.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
#[non_exhaustive]
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
#[non_exhaustive]
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
#[non_exhaustive]
pub struct SphereFigures {
    /// Name of the sphere.
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
#[non_exhaustive]
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
    /// No figures, and why.
    pub(crate) fn absent(why: Phrase) -> Self {
        Self {
            mass_kg: None,
            gravity_m_s2: None,
            impact_speed_m_s: None,
            why_no_body_weight: Some(why),
            limbs: Vec::new(),
        }
    }

    /// Every sphere.
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
    #[must_use]
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

    /// The figure, where it is known.
    #[must_use]
    pub fn value(&self, figure: Figure) -> Option<f64> {
        self.answer(figure).value()
    }

    /// Whether `figure` is within its limit; `None` where it is not known, or has no limit.
    #[must_use]
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
