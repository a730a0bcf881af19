//! What contacts do along a recording: words, one row for each foot, and the figure.

use crate::figures::draw_motion;
use crate::report::results::motion_feet;
use maud::{Markup, PreEscaped, html};
use osim_model::messages::Dialect;
use osim_planning::{MotionRemark, MotionResult};
use osim_requests::PlotRequest;

use super::fragment::table;
use super::section::Section;
use super::values::sentence;

/// The section, made where a recording is compared: a page that never compares one does without all that it needs.
#[must_use]
pub fn recording(result: &MotionResult, remarks: &[MotionRemark], dialect: &dyn Dialect) -> Section {
    let body = html! {
        p.note {
            (result.motion.to_string()) ": " (result.states.frames()) " frames."
        }
        ul { @for remark in remarks { li { (sentence(&remark.message.spelled(dialect))) } } }
        (feet(result))
        (figure(result, dialect))
    };
    Section { id: "recording", title: "Contacts along the recording", html: body.0 }
}

fn feet(result: &MotionResult) -> Markup {
    let (columns, rows) = motion_feet(result);
    let rows: Vec<Markup> = rows
        .iter()
        .map(|row| {
            let mut cells = row.iter();
            html! { tr { @if let Some(name) = cells.next() { th scope="row" { (name) } } @for cell in cells { td { (cell) } } } }
        })
        .collect();
    let caption = "Forces along the normal of the floor, in body weights (BW): the largest of the model and of the plates, and the root mean \
                   square of the difference; of the distance between the centres of pressure (COP).";
    table("Feet along the recording", caption, &columns, &rows)
}

fn figure(result: &MotionResult, dialect: &dyn Dialect) -> Markup {
    let drawn = draw_motion(&PlotRequest::default(), result)
        .and_then(|drawing| crate::figures::svg(&drawing, contact_plots::Paper::default(), &[]));
    match drawn {
        Ok(svg) => html! {
            div.plots { figure {
                div.plot { (PreEscaped(svg)) }
                figcaption { "For each foot: its force beside the plates'; how deep each sphere is, over time and over strides; where the force acts on the sole; forces of one stance along the foot." }
            } }
        },
        Err(failure) => html! { p.note { "Not drawn: " (failure.message.spelled(dialect)) "." } },
    }
}
