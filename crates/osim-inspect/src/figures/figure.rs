//! What is known of a figure, apart from its value.

use contact_scaling::limits::Limit;
use osim_model::wording::Phrase;

use super::answer::Answer;
use super::on_floor::OnFloor;

/// A figure of a sphere: its name, unit, equation and limit, and how to get it.
///
/// Everything that shows a figure takes this from here: the table, the page, CSV, JSON and the documents.
#[derive(Debug)]
#[non_exhaustive]
pub struct FigureInfo {
    /// Name in JSON and CSV; it ends in the unit, where there is one.
    pub name: &'static str,
    /// In tables, without unit and equation.
    pub label: &'static str,
    /// Its unit, for people; empty for a pure number.
    pub unit: &'static str,
    /// Number of the equation in the paper; empty where there is none.
    pub equation: &'static str,
    /// What it is, in a sentence.
    pub(super) meaning: &'static str,
    /// Its limit, where it has one.
    pub limit: Option<&'static Limit>,
    /// Where a table shows it.
    pub shown: Shown,
    /// How to get it.
    pub(super) answer: fn(&OnFloor<'_>) -> Answer,
}

/// Where a table or page shows a figure; JSON and CSV have all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// Always.
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

impl FigureInfo {
    /// The label with unit and equation, as the first column of a table has it.
    #[must_use]
    pub fn heading(&self) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(", {}", self.unit) };
        let equation = if self.equation.is_empty() { String::new() } else { format!(" ({})", self.equation) };
        format!("{}{unit}{equation}", self.label)
    }

    /// What it is, with unit and equation, for schemas.
    pub(super) fn described(&self) -> String {
        let meaning = self.meaning.trim_ascii();
        let meaning = meaning.strip_suffix('.').unwrap_or(meaning);
        let unit = if self.unit.is_empty() { String::new() } else { format!(", {}", self.unit) };
        let equation = if self.equation.is_empty() { String::new() } else { format!(" ({})", self.equation) };
        format!("{meaning}{equation}{unit}.")
    }

    /// What it is, in a sentence.
    #[must_use]
    pub fn meaning(&self) -> Phrase {
        Phrase::template(self.meaning.trim_ascii())
    }
}
