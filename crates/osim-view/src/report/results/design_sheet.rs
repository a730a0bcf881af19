//! A design without a model, as text.

use osim_model::messages::readable;
use osim_planning::{DesignQuantity, DesignSheet};

use crate::report::layout::table;

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
        let equation = if figure.equation == DesignQuantity::EXACT {
            "exact law".to_owned()
        } else {
            format!("({})", figure.equation)
        };
        table.add_row(vec![
            figure.quantity.info().label.to_owned(),
            readable(figure.value),
            figure.unit.to_owned(),
            equation,
            mark,
        ]);
    }
    table.right_aligned(&[1]);
    let mut text = format!("{}\n", table.trim_fmt());
    for note in &sheet.notes {
        text.push_str(&format!("note: {note}\n"));
    }
    if sheet.figures.iter().any(|figure| figure.quantity == DesignQuantity::Stiffness) {
        text.push_str(
            "note: 'stiffness' (E1*) is what to type into OpenSim, 2^(3/2) times the composite modulus E*\n",
        );
    }
    text
}
