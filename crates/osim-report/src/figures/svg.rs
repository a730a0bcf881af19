//! A figure that was drawn, or why it was not.

use contact_plots::PlotError;
use osim_inspect::series::Body;
use osim_model::files::Failure;
use osim_model::wording::{Input, Phrase, harmless, phrase};

use super::names::failure;

/// What `contact_plots` made of a figure of `bodies`.
///
/// # Errors
/// It was not drawn: the failure says why, and a way out where there is one.
pub fn svg(drawn: Result<String, PlotError>, bodies: &[Body]) -> Result<String, Failure> {
    // Names of spheres are labels: what a picture cannot show would make it unreadable.
    drawn.map(|svg| harmless(&svg).into_owned()).map_err(|error| {
        let why: Phrase = match error {
            PlotError::TooMany { .. } => {
                phrase![error.to_string(), ": choose with ", Input::Select.like("GLOB")]
            }
            error => error.to_string().into(),
        };
        failure(bodies, why)
    })
}
