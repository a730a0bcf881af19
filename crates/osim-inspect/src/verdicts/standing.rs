//! Whether the model stands at its default pose.

use osim_model::messages::Phrase;

use super::known::Known;
use crate::inspection::StandingBody;

/// Where the lowest sphere starts, and what puts the body on its feet.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let of_body = |body: &StandingBody| Some(format!("it starts {}; {}", body.place()?, body.way_to_stand()));
    let first = known.inspected.standing.iter().find_map(of_body);
    first.map(Phrase::from).ok_or_else(|| "where its spheres are over a floor is not known".into())
}
