//! What figures and failures are called.

use osim_inspect::series::Body;
use osim_model::files::Failure;
use osim_model::messages::Phrase;

/// The title wanted, else what the figure shows of whom.
pub(super) fn title(what: &str, bodies: &[Body], wanted: Option<&str>) -> String {
    match (wanted, bodies) {
        (Some(title), _) => title.to_owned(),
        (None, [one]) => format!("{what}: {}", one.name),
        (None, _) => what.to_owned(),
    }
}

/// A figure of these bodies that cannot be drawn.
pub(super) fn failure(bodies: &[Body], why: impl Into<Phrase>) -> Failure {
    let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    Failure::outside(names.join(", "), "plot", why)
}
