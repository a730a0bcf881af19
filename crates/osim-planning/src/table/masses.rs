//! Columns of masses: each row is judged by the others, because a slip is what is out of line.

use std::collections::BTreeMap;

use osim_model::MassesBeside;
use osim_model::messages::Input;
use serde_json::{Map, Value};

use super::cells::number;
use super::columns::{Columns, Kind};
use crate::sheet::Sheet;

/// Columns in which a mass may be a slip.
const MASSES: [Input; 3] = [Input::TargetMass, Input::ContactsMass, Input::Mass];

/// The masses of each such column, kg, from the lightest to the heaviest.
#[derive(Debug, Default)]
pub(super) struct Masses(BTreeMap<Input, Vec<f64>>);

impl Masses {
    /// Those of a table. A cell that is not a number is refused when its row is read.
    pub(super) fn of(sheet: &Sheet, columns: &Columns) -> Self {
        let read = |input: Input| {
            let is_of = |field: &str, kind| kind == Kind::Value && field == input.name();
            let at = columns.columns.iter().position(|column| is_of(&column.field, column.kind))?;
            let column = columns.columns.get(at)?;
            let cells = sheet.rows.iter().filter_map(|row| row.cells.get(at));
            let mut masses: Vec<f64> =
                cells.filter_map(|cell| number(cell, sheet, column).ok()?.parse().ok()).collect();
            masses.sort_by(f64::total_cmp);
            Some((input, masses))
        };
        Self(MASSES.into_iter().filter_map(read).collect())
    }

    /// What the other rows say of the masses of a row with these fields.
    pub(super) fn beside(&self, fields: &Map<String, Value>) -> BTreeMap<Input, MassesBeside> {
        let found = self.0.iter().filter_map(|(&input, sorted)| {
            let own_kg = fields.get(input.name())?.as_str()?.parse().ok()?;
            Some((input, MassesBeside::of(sorted, own_kg)?))
        });
        found.collect()
    }
}
