//! Opens the files, models and presets that a request names. The trait [`Files`] gives the bytes.

use std::path::Path;

use contact_scaling::{Contact, ContactValues, DomainError, Preset, Scale, ScaleValues, SmoothingValues};
use osim_model::compare::{ScaleFile, refuse_without_moco_phase};
use osim_model::files::{CompanionPaths, Failure, Files, InMemory, ModelFiles, OpenModel};
use osim_model::messages::{Input, phrase};
use osim_model::{Document, FileId, LineIndex, nearest_names};
use osim_patch::{preset_model, presets_with_places};
use osim_requests::options::SetFiles;
use osim_requests::{PresetsRequest, RequestFault, Result};
use serde::Deserialize;
use toml::Spanned;

/// Opens the model at `path` alone, without files of separate sets.
pub(crate) fn open(path: &Path, files: &dyn Files) -> Result<OpenModel, Failure> {
    open_with(path, CompanionPaths::default(), files)
}

/// Opens a model together with the companion files `beside`.
pub fn open_with(path: &Path, beside: CompanionPaths<'_>, files: &dyn Files) -> Result<OpenModel, Failure> {
    let bytes = read(path, files)?;
    ModelFiles::read(path, bytes, beside, files)?.open()
}

/// Reads a file that the request names.
pub(crate) fn read(path: &Path, files: &dyn Files) -> Result<Vec<u8>, Failure> {
    files.read(path).map_err(|error| Failure::outside(path, "unreadable", error.to_string()))
}

/// Reads the Scale Tool's applied factors.
///
/// # Errors
/// The file cannot be read, or is not a ScaleSet.
pub(crate) fn read_scale_file(path: &Path, files: &dyn Files) -> Result<ScaleFile, Failure> {
    let bytes = read(path, files)?;
    let document = Document::parse(bytes).map_err(|fault| Failure::from_fault(path, fault))?;
    ScaleFile::read(&document)
        .map_err(|fault| Failure::from_fault(path, fault.in_file(FileId::MAIN).located(document.bytes())))
}

/// Reads a setup of Moco.
///
/// # Errors
/// The file cannot be read, or has no problem of Moco in it.
pub(crate) fn read_moco_setup(path: &Path, files: &dyn Files) -> Result<Document, Failure> {
    let bytes = read(path, files)?;
    let document = Document::parse(bytes).map_err(|fault| Failure::from_fault(path, fault))?;
    let problem = refuse_without_moco_phase(&document);
    problem.map_err(|fault| Failure::from_fault(path, fault.in_file(FileId::MAIN)))?;
    Ok(document)
}

/// The model or preset that a text in a request names. All verbs distinguish models and presets by this rule.
pub(crate) enum NamedSource {
    Preset(Preset),
    /// A preset with places of spheres. It is stored as a model.
    PlacedPreset(Box<OpenModel>),
    File,
}

impl NamedSource {
    /// Finds what the name means: a preset, even if a file has the same name; else a file. `input` is the field of the request, for
    /// messages.
    ///
    /// # Errors
    ///
    /// No preset and no file has this name, or the file of presets cannot be read.
    pub(crate) fn find(
        word: &Path,
        input: Option<Input>,
        presets: Option<&Path>,
        files: &dyn Files,
    ) -> Result<Self> {
        if let Some(preset) = find_preset(word, presets, files)? {
            return Ok(Self::Preset(preset));
        }
        if let Some(open) = placed_preset(word)? {
            return Ok(Self::PlacedPreset(Box::new(open)));
        }
        if may_be_file(word, files) {
            return Ok(Self::File);
        }
        let shown = word.display().to_string();
        let (names, model) = (all_preset_names(presets, files), word.with_extension("osim"));
        let hint = match files.exists(&model) {
            true => format!(": did you mean '{}'?", model.display()),
            false => similar_preset(&shown, &names),
        };
        let neither = format!(
            "'{shown}': there is no such file and no such preset, expected a model or one of: {}{hint}",
            names.join(", ")
        );
        let fault = match input {
            Some(input) => RequestFault::refused(input, phrase![input, " ", neither]),
            None => RequestFault::general(neither),
        };
        Err(fault.into())
    }
}

/// The preset with this name, as a model, if the preset has places of spheres.
pub(crate) fn placed_preset(name: &Path) -> Result<Option<OpenModel>, Failure> {
    let Some(text) = name.to_str().and_then(preset_model) else { return Ok(None) };
    ModelFiles::read(name, text.into(), CompanionPaths::default(), &InMemory::default())?.open().map(Some)
}

/// The names of all presets: without places of spheres, and with them.
pub fn all_preset_names(presets: Option<&Path>, files: &dyn Files) -> Vec<String> {
    let presets = self::presets(presets, files).unwrap_or_default();
    let names = presets.iter().map(|preset| preset.name.to_string());
    let others = presets_of_unlike_spheres(&presets).map(str::to_owned);
    names.chain(others).collect()
}

/// The hint `: did you mean ...?` with the preset whose name is nearly `name`, or begins so; an empty text if there is none.
fn similar_preset(name: &str, names: &[String]) -> String {
    let (known, begin) = (names.iter().map(String::as_str), name.to_lowercase());
    let near = nearest_names(name, known.clone(), 2).first().copied();
    let near = near.or_else(|| known.clone().find(|one| begin.len() > 2 && one.starts_with(&begin)));
    near.map(|near| format!(": did you mean '{near}'?")).unwrap_or_default()
}

/// The names of presets whose spheres have radii of their own, so that no [`Preset`] describes them.
pub fn presets_of_unlike_spheres(others: &[Preset]) -> impl Iterator<Item = &'static str> {
    presets_with_places().filter(|name| others.iter().all(|other| other.name != *name))
}

/// Whether the text `word` names a file: the file exists, or the text is `-` or looks like the name of a file.
pub fn may_be_file(word: &Path, files: &dyn Files) -> bool {
    files.exists(word) || looks_like_file(word)
}

/// Whether the text `word` is `-`, or has a folder or a file extension.
pub(crate) fn looks_like_file(word: &Path) -> bool {
    word.as_os_str() == "-" || word.components().count() > 1 || word.extension().is_some()
}

/// What a name in a request means: a model that was opened, or a preset.
pub(crate) enum ModelOrPreset {
    Model(Box<OpenModel>),
    Preset(Preset),
}

impl ModelOrPreset {
    /// The preset of this name; if there is none, the model of this path.
    ///
    /// # Errors
    /// There is neither, or the model cannot be read.
    pub(crate) fn find(
        path: &Path,
        presets: Option<&Path>,
        set_files: &SetFiles,
        files: &dyn Files,
    ) -> Result<Self> {
        Ok(match NamedSource::find(path, None, presets, files)? {
            NamedSource::Preset(preset) => Self::Preset(preset),
            NamedSource::PlacedPreset(open) => Self::Model(open),
            NamedSource::File => Self::Model(Box::new(open_with(path, set_files.companion_paths(), files)?)),
        })
    }
}

/// The content of a TOML file in which a user keeps presets.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PresetFile {
    #[serde(default)]
    preset: Vec<PresetEntry>,
}

/// One `[[preset]]` of a TOML file in which a user keeps presets.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PresetEntry {
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

/// All presets: the built-in presets, then the presets in `file`.
///
/// # Errors
/// A file that cannot be read, an unknown or missing key (with line and column), a value outside its domain, or a name
/// that is taken.
pub(crate) fn presets(file: Option<&Path>, files: &dyn Files) -> Result<Vec<Preset>, RequestFault> {
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
    let parsed: PresetFile = toml::from_str(text).map_err(|error| {
        let place = error.span().map_or_else(|| shown.clone(), |span| place(span.start));
        fault(format!("{place}: {}", error.message().replace("expected f64", "expected a number")))
    })?;
    for entry in parsed.preset {
        let (name, at) = (entry.name.get_ref().clone(), place(entry.name.span().start));
        if presets.iter().any(|preset| preset.name == name) {
            return Err(fault(format!("{at}: the name '{name}' is taken: choose another")));
        }
        presets.push(entry.into_preset().map_err(|why| fault(format!("{at}: preset '{name}': {why}")))?);
    }
    Ok(presets)
}

/// The preset called `name`, if there is one.
pub(crate) fn find_preset(
    name: &Path,
    file: Option<&Path>,
    files: &dyn Files,
) -> Result<Option<Preset>, RequestFault> {
    let name = name.to_string_lossy();
    Ok(presets(file, files)?.into_iter().find(|preset| preset.name == name))
}

impl PresetEntry {
    /// The preset that a user's entry describes.
    fn into_preset(self) -> Result<Preset, String> {
        let smoothing =
            match (self.constant_contact_force, self.hertz_smoothing, self.hunt_crossley_smoothing) {
                (None, None, None) => None,
                (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
                    Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
                }
                _ => {
                    let names = "constant_contact_force, hertz_smoothing and hunt_crossley_smoothing";
                    return Err(format!("{names} come together or not at all"));
                }
            };
        let failed = |error: DomainError| error.to_string();
        let scale = Scale::new(ScaleValues {
            mass_kg: self.mass_kg,
            radius_m: self.radius_m,
            sphere_count: self.spheres,
            gravity_m_s2: self.gravity_m_s2,
        });
        let scale = scale.map_err(failed)?;
        let (plane_strain_modulus, dissipation) = (self.stiffness, self.dissipation);
        let contact = Contact::new(ContactValues { plane_strain_modulus, dissipation, smoothing });
        let contact = contact.map_err(failed)?;
        Ok(Preset { name: self.name.into_inner().into(), source: self.source.into(), scale, contact })
    }
}

/// The presets that the request names; all presets if it names none.
///
/// # Errors
/// A file of presets that cannot be read, or an unknown name.
pub fn find_presets(request: &PresetsRequest, files: &dyn Files) -> Result<Vec<Preset>, RequestFault> {
    let mut all = presets(request.presets.as_deref(), files)?;
    let Some(name) = &request.name else { return Ok(all) };
    if let Some(at) = all.iter().position(|preset| preset.name == name.as_str()) {
        return Ok(vec![all.swap_remove(at)]);
    }
    if preset_model(name).is_some() {
        return Err(RequestFault::general(phrase![format!(
            "the spheres of {name} have radii of their own, which this list cannot show: drop-test {name} says what they do; add and \
             transfer take them"
        )]));
    }
    let names = all_preset_names(request.presets.as_deref(), files);
    let (listed, hint) = (names.join(", "), similar_preset(name, &names));
    Err(RequestFault::general(phrase![format!("unknown preset '{name}', expected one of: {listed}{hint}")]))
}
