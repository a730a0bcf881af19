//! What else follows the size of a body.

use crate::report::similarity::{about, cells, gaps, headings};
use maud::{Markup, html};
use osim_inspect::SizeList;

use super::fragment::{Fragment, table};

/// Adds the list, a row a kind.
pub(super) fn section(fragment: &mut Fragment, list: &SizeList) {
    let rows: Vec<Markup> = list
        .kinds
        .iter()
        .map(|row| {
            let [name, count, numbers, similar, last] = cells(list, row);
            html! {
                tr {
                    th scope="row" { (name) }
                    td { (count) } td { (numbers) } td { (similar) } td.words { (last) }
                }
            }
        })
        .collect();
    let [name, count, numbers, similar, last] = headings(list);
    let last = format!(" {last}");
    let body = html! {
        @for sentence in about(list) { p { (sentence) "." } }
        (table("What else follows size", "Factors, new over old.", &[name, count, numbers, similar, &last], &rows))
        @for sentence in gaps(list) { p.note { (sentence) "." } }
    };
    fragment.section("similarity", "What else follows size", &body);
}
