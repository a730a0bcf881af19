//! Whether the floor is one.

use osim_model::feet::{ContactPlane, DefaultPose};
use osim_model::messages::{Phrase, readable, shown};

use super::known::Known;

/// The plane that most spheres press on: how it lies, and what carries it.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let model = known.model;
    let planes = ContactPlane::all(model, &model.force_ids(), &DefaultPose::of(model));
    // The first of those that equally many press on.
    let most = planes.iter().reduce(|a, b| if b.spheres.len() > a.spheres.len() { b } else { a });
    let plane = most.ok_or_else(|| Phrase::from("no moving sphere meets a half-space"))?;
    let name = shown(&plane.plane.name).to_string();
    let Some(surface) = plane.surface else {
        return Err(format!("how {name} lies is not known").into());
    };
    let carrier =
        plane.plane.body.as_deref().map_or_else(|| "ground".to_owned(), |body| shown(body).to_string());
    let others = match planes.len() {
        1 => String::new(),
        2 => "; one more plane".to_owned(),
        count => format!("; {} more planes", count - 1),
    };
    let degrees = readable((surface.tilt_rad.to_degrees() * 100.0).round() / 100.0);
    Ok(format!("{name} leans by {degrees} degrees, on {carrier}{others}").into())
}
