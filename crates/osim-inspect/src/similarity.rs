//! Lists the numbers besides contacts that follow the size of a body, for JSON, tables and reports.

use osim_model::compare::{LengthFrom, Similarity, SimilarityRow, SizeVerdict, Spread, similarity_formula};
use osim_model::{NotRead, SizedKind};

use crate::serialized::json_records;

json_records! {
    /// Other numbers of a model that follow the size of its body: by what factor geometric similarity would change each kind of number, and by
    /// what factor it changed. The program never changes them.
    SizeList from found: Similarity {
        /// The mass of the original, kg; without an original that of the model.
        original_mass_kg: Option<f64> = found.masses_kg[0],
        /// The mass of the model, kg; without an original the one that was asked for.
        mass_kg: Option<f64> = found.masses_kg[1],
        /// M, the second mass over the first.
        mass_ratio: Option<f64> = found.ratios.map(|ratios| ratios.mass),
        /// L, the ratio of lengths.
        length_ratio: Option<f64> = found.ratios.map(|ratios| ratios.length),
        /// Source of L: `joints`, the summed distances between the joints of each body, or `mass`, the cube root of M.
        length_source: &'static str =
            if let LengthFrom::Joints(_) = found.length_from { "joints" } else { "mass" },
        /// The bodies whose joints were compared.
        compared_bodies: usize =
            if let LengthFrom::Joints(bodies) = found.length_from { bodies } else { 0 },
        /// The ratio of gravities, which is 1 in nearly all pairs: times are taken to go with √(L / gravity).
        gravity_ratio: Option<f64> = found.ratios.map(|ratios| ratios.gravity),
        /// A row for each kind of number that the model has.
        kinds: Vec<SizeRow> = found.rows.into_iter().map(SizeRow::from).collect(),
        /// Objects of the model whose numbers have no counterpart of that name in the original.
        only_in_model: Vec<String> = found.only_in_model,
        /// Objects of the original whose numbers have no counterpart of that name in the model.
        only_in_original: Vec<String> = found.only_in_original,
        /// Objects that are not read.
        not_read: Vec<UnreadObjects> = found.not_read.into_iter().map(UnreadObjects::from).collect(),
    }

    /// The numbers of one kind.
    SizeRow from row: SimilarityRow {
        /// A short name of the kind of number, for programs, such as `max_isometric_force`. It never changes.
        kind: &'static str = row.kind.as_str(),
        /// The kind in words for people.
        description: &'static str = row.kind.words(),
        /// The unit of the numbers.
        unit: &'static str = row.kind.unit(),
        /// How many numbers of this kind the model has; each direction of a bushing is one.
        count: usize = row.count,
        /// The numbers of the model.
        value: SizeSpread = row.values.into(),
        /// How many numbers have a counterpart in the original; null without an original.
        pairs: Option<usize> = row.compared.as_ref().map(|compared| compared.pairs),
        /// How many numbers are the same in the model and the original.
        same: Option<usize> = row.compared.as_ref().map(|compared| compared.same),
        /// New number over old one, where the old one is not 0.
        factor: Option<SizeSpread> =
            row.compared.and_then(|compared| compared.factors).map(SizeSpread::from),
        /// The factor that geometric similarity gives; null where a mass is not known.
        similarity_factor: Option<f64> = row.similar,
        /// The expected factor at equal gravity, as a formula of the ratios of mass M and length L.
        similarity_formula: String = similarity_formula(row.kind.dimension()),
        /// `follows` similarity, `left` at the old size, `partly-left`, `other`, `undecided` where it would change next to
        /// nothing, `not-compared`; null without an original.
        verdict: Option<&'static str> = row.verdict.map(SizeVerdict::as_str),
        /// The verdict in words for people.
        #[serde(skip)]
        #[cfg_attr(feature = "schemas", schemars(skip))]
        verdict_words: &'static str = row.verdict.map(SizeVerdict::words).unwrap_or_default(),
    }

    /// The spread of many numbers.
    #[derive(Copy)]
    SizeSpread from spread: Spread {
        /// Median of the factors.
        median: f64 = spread.median,
        /// Least of the factors.
        min: f64 = spread.min,
        /// Greatest of the factors.
        max: f64 = spread.max,
    }

    /// Objects with numbers that are not read.
    UnreadObjects from objects: NotRead {
        /// OpenSim's class, or the part of a file.
        class: String = objects.class,
        /// The number of objects.
        count: usize = objects.count,
        /// Description of the objects' numbers that are not read.
        why: &'static str = objects.why,
    }
}

impl SizeList {
    /// The ratio of lengths, if it comes from the distances between joints.
    pub fn length_ratio_of_joints(&self) -> Option<f64> {
        self.length_ratio.filter(|_| self.compared_bodies > 0)
    }

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
