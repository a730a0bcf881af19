//! Remarks beside a figure.

use osim_inspect::series::Body;
use osim_model::messages::{Dialect, counted, readable};

/// What each body is taken to weigh and to stand on, one line each; or why it is not known, if it is not needed.
#[must_use]
pub fn weights(bodies: &[Body], dialect: &dyn Dialect) -> String {
    let line = |body: &Body| match &body.weight {
        Ok(weight) => format!(
            "{}: {} kg on {}, {} m/s2\n",
            body.name,
            readable(weight.mass_kg),
            counted(readable(weight.sphere_count), "sphere"),
            readable(weight.gravity_m_s2)
        ),
        Err(failure) => {
            let why = failure.message.spelled(dialect);
            format!("{}: its share of the weight is not drawn: {why}\n", body.name)
        }
    };
    bodies.iter().map(line).collect()
}
