//! A design without a model, as text.

use osim_model::{Property, readable};
use osim_requests::DesignSheet;

use crate::layout::{right_aligned, table};

/// `contact_patch_diameter_m` is contact patch diameter; OpenSim's own names stay as OpenSim spells them.
fn name_for_people(name: &str) -> String {
    if Property::ALL.iter().any(|property| property.name() == name) {
        return name.to_owned();
    }
    let unit = ["_n_m2", "_n_m", "_m_s", "_hz", "_n", "_m"].iter().find_map(|unit| name.strip_suffix(unit));
    unit.unwrap_or(name).replace('_', " ")
}

/// Every figure with its equation and its limit.
#[must_use]
pub fn design_sheet_text(sheet: &DesignSheet) -> String {
    let mut table = table(&["quantity", "value", "unit", "equation", ""]);
    for figure in &sheet.figures {
        let limit = figure
            .limit
            .as_ref()
            .map(|limit| format!("{} {}", if limit.within_limit { "ok:" } else { "outside:" }, limit.text));
        let given = figure.given.then(|| "given".to_owned());
        let mark = given.into_iter().chain(limit).collect::<Vec<_>>().join("; ");
        let equation = if figure.equation == "exact" {
            "exact law".to_owned()
        } else {
            format!("({})", figure.equation)
        };
        table.add_row(vec![
            name_for_people(figure.name),
            readable(figure.value),
            figure.unit.to_owned(),
            equation,
            mark,
        ]);
    }
    right_aligned(&mut table, &[1]);
    let mut text = format!("{}\n", table.trim_fmt());
    for note in &sheet.notes {
        text.push_str(&format!("note: {note}\n"));
    }
    if sheet.figures.iter().any(|figure| figure.name == "stiffness") {
        text.push_str(
            "note: 'stiffness' (E1*) is what to type into OpenSim, 2^(3/2) times the composite modulus E*\n",
        );
    }
    text
}
