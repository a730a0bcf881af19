//! Presets: the published ones, and those of a user's own TOML file.

use std::path::Path;

use contact_scaling::{Contact, ContactValues, DomainError, Preset, Scale, ScaleValues, SmoothingValues};
use osim_model::LineIndex;
use osim_model::files::Files;
use osim_model::messages::{Input, phrase};
use osim_requests::{PresetsRequest, RequestFault};
use serde::Deserialize;
use toml::Spanned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    preset: Vec<Entry>,
}

/// One `[[preset]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: Spanned<String>,
    source: String,
    mass_kg: f64,
    spheres: f64,
    radius_m: f64,
    gravity_m_s2: f64,
    stiffness: f64,
    dissipation: f64,
    constant_contact_force: Option<f64>,
    hertz_smoothing: Option<f64>,
    hunt_crossley_smoothing: Option<f64>,
}

/// All presets: the built-in ones, then those of `file`.
///
/// # Errors
/// A file that cannot be read, an unknown or missing key (with line and column), a value outside its domain, or a name
/// that is taken.
pub fn presets(file: Option<&Path>, files: &dyn Files) -> Result<Vec<Preset>, RequestFault> {
    let mut presets: Vec<Preset> =
        contact_scaling::preset_names().filter_map(contact_scaling::preset).collect();
    let Some(path) = file else { return Ok(presets) };
    let shown = path.display().to_string();
    let fault = |message: String| RequestFault::refused(Input::Presets, message);
    let bytes = files.read(path).map_err(|error| fault(format!("{shown}: {error}")))?;
    let text = std::str::from_utf8(&bytes)
        .map_err(|_| fault(format!("{shown}: not UTF-8 text, expected a TOML file")))?;
    let place = |offset: usize| {
        let at = LineIndex::new(&bytes).position(&bytes, offset);
        format!("{shown}:{}:{}", at.line, at.column)
    };
    let parsed: File = toml::from_str(text).map_err(|error| {
        let place = error.span().map_or_else(|| shown.clone(), |span| place(span.start));
        fault(format!("{place}: {}", error.message().replace("expected f64", "expected a number")))
    })?;
    for entry in parsed.preset {
        let (name, at) = (entry.name.get_ref().clone(), place(entry.name.span().start));
        if presets.iter().any(|preset| preset.name == name) {
            return Err(fault(format!("{at}: the name '{name}' is taken: choose another")));
        }
        presets.push(entry.preset().map_err(|why| fault(format!("{at}: preset '{name}': {why}")))?);
    }
    Ok(presets)
}

/// The preset called `name`, if there is one.
///
/// # Errors
/// As [`presets`].
pub(crate) fn find_preset(
    name: &Path,
    file: Option<&Path>,
    files: &dyn Files,
) -> Result<Option<Preset>, RequestFault> {
    let name = name.to_string_lossy();
    Ok(presets(file, files)?.into_iter().find(|preset| preset.name == name))
}

/// The names of all presets, for messages.
pub(crate) fn preset_names(file: Option<&Path>, files: &dyn Files) -> Vec<String> {
    let presets = presets(file, files).unwrap_or_default();
    presets.iter().map(|preset| preset.name.to_string()).collect()
}

/// Why the values of a preset make no contact.
#[derive(Debug, thiserror::Error)]
enum EntryError {
    #[error(transparent)]
    Domain(#[from] DomainError),
    #[error(
        "constant_contact_force, hertz_smoothing and hunt_crossley_smoothing come together or not at all"
    )]
    Smoothing,
}

impl Entry {
    fn preset(self) -> Result<Preset, EntryError> {
        let smoothing =
            match (self.constant_contact_force, self.hertz_smoothing, self.hunt_crossley_smoothing) {
                (None, None, None) => None,
                (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
                    Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
                }
                _ => return Err(EntryError::Smoothing),
            };
        let scale = Scale::new(ScaleValues {
            mass_kg: self.mass_kg,
            radius_m: self.radius_m,
            sphere_count: self.spheres,
            gravity_m_s2: self.gravity_m_s2,
        })?;
        let contact = Contact::new(ContactValues {
            plane_strain_modulus: self.stiffness,
            dissipation: self.dissipation,
            smoothing,
        })?;
        Ok(Preset { name: self.name.into_inner().into(), source: self.source.into(), scale, contact })
    }
}

/// The presets that are asked for.
///
/// # Errors
/// As [`presets`], or an unknown name.
pub fn find_presets(request: &PresetsRequest, files: &dyn Files) -> Result<Vec<Preset>, RequestFault> {
    let mut all = presets(request.presets.as_deref(), files)?;
    let Some(name) = &request.name else { return Ok(all) };
    all.retain(|preset| preset.name == name.as_str());
    if all.is_empty() {
        if osim_patch::preset_model(name).is_some() {
            return Err(RequestFault::general(phrase![format!(
                "the spheres of {name} have radii of their own, which this list cannot show: drop-test {name} says what they do; add and \
                 transfer take them"
            )]));
        }
        let names = preset_names(request.presets.as_deref(), files).join(", ");
        return Err(RequestFault::general(phrase![format!(
            "unknown preset '{name}', expected one of: {names}"
        )]));
    }
    Ok(all)
}
