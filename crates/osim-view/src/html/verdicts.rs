//! The six verdicts on a model, a row each; after a change, on both states.

use maud::{Markup, html};
use osim_inspect::{Sign, Verdict};

use super::fragment::table;

const NAME: &str = "Verdicts";

/// Verdicts on a model that was inspected.
pub(super) fn of_model(verdicts: &[Verdict]) -> Markup {
    let rows: Vec<Markup> = verdicts
        .iter()
        .map(|verdict| html! { tr { (question(verdict)) td.words { (sign(verdict.sign)) } (answer(verdict)) } })
        .collect();
    table(
        NAME,
        &format!("{} questions about the model.", number(rows.len())),
        &["question", " verdict", " why"],
        &rows,
    )
}

/// Verdicts on the model before and after a change.
pub(super) fn of_change(before: &[Verdict], after: &[Verdict]) -> Markup {
    let rows: Vec<Markup> = before
        .iter()
        .zip(after)
        .map(|(before, after)| {
            html! { tr {
                (question(after)) td.words { (sign(before.sign)) } td.words { (sign(after.sign)) } (answer(after))
            } }
        })
        .collect();
    let headers = ["question", " before", " after", " why, after the change"];
    table(NAME, "Six questions about the model, before and after the change.", &headers, &rows)
}

fn question(verdict: &Verdict) -> Markup {
    html! { th scope="row" { (verdict.on.question()) } }
}

fn sign(sign: Sign) -> Markup {
    html! { span class={ "tag " (sign.as_str()) } { (sign.as_str()) } }
}

fn answer(verdict: &Verdict) -> Markup {
    let text = verdict.text.to_string();
    let place = verdict.place.as_deref().filter(|place| !text.contains(*place));
    html! { td.words { (text) @if let Some(place) = place { " " span.quiet { (place) } } } }
}

/// Six questions, and one more where a recording is named.
fn number(questions: usize) -> String {
    match questions {
        6 => "Six".to_owned(),
        7 => "Seven".to_owned(),
        other => other.to_string(),
    }
}
