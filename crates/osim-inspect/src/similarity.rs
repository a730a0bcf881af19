//! Lists the numbers besides contacts that follow the size of a body, for JSON, tables and reports.

use osim_model::compare::{LengthFrom, Similarity, SimilarityRow, SizeVerdict, Spread, similarity_formula};
use osim_model::{NotRead, SizedKind};
use serde::Serialize;

/// Other numbers of a model that follow the size of its body: by what factor geometric similarity would change each kind of number, and by
/// what factor it changed. The program never changes them.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct SizeList {
    /// The mass of the original, kg; without an original that of the model.
    pub original_mass_kg: Option<f64>,
    /// The mass of the model, kg; without an original the one that was asked for.
    pub mass_kg: Option<f64>,
    /// M, the second mass over the first.
    pub mass_ratio: Option<f64>,
    /// L, the ratio of lengths.
    pub length_ratio: Option<f64>,
    /// Source of L: `joints`, the summed distances between the joints of each body, or `mass`, the cube root of M.
    pub length_source: &'static str,
    /// The bodies whose joints were compared.
    pub compared_bodies: usize,
    /// The ratio of gravities, which is 1 in nearly all pairs: times are taken to go with √(L / gravity).
    pub gravity_ratio: Option<f64>,
    /// A row for each kind of number that the model has.
    pub kinds: Vec<SizeRow>,
    /// Objects of the model whose numbers have no counterpart of that name in the original.
    pub only_in_model: Vec<String>,
    /// Objects of the original whose numbers have no counterpart of that name in the model.
    pub only_in_original: Vec<String>,
    /// Objects that are not read.
    pub not_read: Vec<UnreadObjects>,
}

/// The numbers of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct SizeRow {
    /// A short name of the kind of number, for programs, such as `max_isometric_force`. It never changes.
    pub kind: &'static str,
    /// The kind in words for people.
    pub description: &'static str,
    /// The unit of the numbers.
    pub unit: &'static str,
    /// How many numbers of this kind the model has; each direction of a bushing is one.
    pub count: usize,
    /// The numbers of the model.
    pub value: SizeSpread,
    /// How many numbers have a counterpart in the original; null without an original.
    pub pairs: Option<usize>,
    /// How many numbers are the same in the model and the original.
    pub same: Option<usize>,
    /// New number over old one, where the old one is not 0.
    pub factor: Option<SizeSpread>,
    /// The factor that geometric similarity gives; null where a mass is not known.
    pub similarity_factor: Option<f64>,
    /// The expected factor at equal gravity, as a formula of the ratios of mass M and length L.
    pub similarity_formula: String,
    /// `follows` similarity, `left` at the old size, `partly-left`, `other`, `undecided` where it would change next to
    /// nothing, `not-compared`; null without an original.
    pub verdict: Option<&'static str>,
    /// The verdict in words for people.
    #[serde(skip)]
    #[cfg_attr(feature = "schemas", schemars(skip))]
    pub verdict_words: &'static str,
}

/// The spread of many numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct SizeSpread {
    /// Median of the factors.
    pub median: f64,
    /// Least of the factors.
    pub min: f64,
    /// Greatest of the factors.
    pub max: f64,
}

/// Objects with numbers that are not read.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct UnreadObjects {
    /// OpenSim's class, or the part of a file.
    pub class: String,
    /// The number of objects.
    pub count: usize,
    /// Description of the objects' numbers that are not read.
    pub why: &'static str,
}

impl SizeList {
    /// Whether the list has anything besides bodies. It has not if a model has contacts, but no muscle, spring or actuator.
    pub fn is_worth_showing(&self) -> bool {
        let more_than_bodies = self.kinds.iter().any(|row| row.kind != SizedKind::Inertia.as_str());
        more_than_bodies || !self.not_read.is_empty()
    }

    /// Whether the list compares two models. If not, it lists the numbers that would follow a new mass.
    pub fn is_of_two_models(&self) -> bool {
        self.kinds.iter().any(|row| row.verdict.is_some())
    }
}

impl From<Similarity> for SizeList {
    fn from(found: Similarity) -> Self {
        let [original_mass_kg, mass_kg] = found.masses_kg;
        let (length_source, compared_bodies) = match found.length_from {
            LengthFrom::Joints(bodies) => ("joints", bodies),
            _ => ("mass", 0),
        };
        let unread = |NotRead { class, count, why, .. }| UnreadObjects { class, count, why };
        Self {
            original_mass_kg,
            mass_kg,
            mass_ratio: found.ratios.map(|ratios| ratios.mass),
            length_ratio: found.ratios.map(|ratios| ratios.length),
            length_source,
            compared_bodies,
            gravity_ratio: found.ratios.map(|ratios| ratios.gravity),
            kinds: found.rows.into_iter().map(SizeRow::from).collect(),
            only_in_model: found.only_in_model,
            only_in_original: found.only_in_original,
            not_read: found.not_read.into_iter().map(unread).collect(),
        }
    }
}

impl From<SimilarityRow> for SizeRow {
    fn from(row: SimilarityRow) -> Self {
        Self {
            kind: row.kind.as_str(),
            description: row.kind.words(),
            unit: row.kind.unit(),
            count: row.count,
            value: row.values.into(),
            pairs: row.compared.as_ref().map(|compared| compared.pairs),
            same: row.compared.as_ref().map(|compared| compared.same),
            factor: row.compared.and_then(|compared| compared.factors).map(SizeSpread::from),
            similarity_factor: row.similar,
            similarity_formula: similarity_formula(row.kind.dimension()),
            verdict: row.verdict.map(SizeVerdict::as_str),
            verdict_words: row.verdict.map(SizeVerdict::words).unwrap_or_default(),
        }
    }
}

impl From<Spread> for SizeSpread {
    fn from(Spread { median, min, max }: Spread) -> Self {
        Self { median, min, max }
    }
}
