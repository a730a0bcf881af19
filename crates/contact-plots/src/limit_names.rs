//! The names of vertical limits, above a panel, in as many rows as keep them apart.

use crate::figure::{Limit, Panel};
use crate::frame::Frame;
use crate::letters::roomy_pt;
use crate::style::TEXT_PT;

pub(crate) const LIMIT_ROW_PT: f64 = 8.5;
const GAP_PT: f64 = 4.0;

/// A name and how far along the axis its middle is, in points.
pub(crate) type Placed<'p> = (&'p Limit, f64);

/// Named vertical limits within the panel, split into rows in which no two names touch.
pub(crate) fn limit_rows<'p>(panel: &'p Panel, frame: &Frame<'_>, plot_pt: f64) -> Vec<Vec<Placed<'p>>> {
    let mut rows: Vec<Vec<Placed<'p>>> = Vec::new();
    let named = panel.limits.iter().filter(|limit| !limit.label.is_empty());
    for (limit, share) in named.filter_map(|limit| Some((limit, frame.share(limit)?))) {
        let placed = (limit, plot_pt * share);
        match rows.iter_mut().find(|row| row.iter().all(|other| are_apart(*other, placed))) {
            Some(row) => row.push(placed),
            None => rows.push(vec![placed]),
        }
    }
    rows
}

fn are_apart((a, at_a): Placed<'_>, (b, at_b): Placed<'_>) -> bool {
    let wide = |limit: &Limit| roomy_pt(&limit.label, TEXT_PT);
    (at_a - at_b).abs() > 0.5 * (wide(a) + wide(b)) + GAP_PT
}
