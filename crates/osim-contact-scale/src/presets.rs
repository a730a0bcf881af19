//! Presets: the published ones, and those of a user's own TOML file.

use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};
use contact_scaling::{
    Contact, ContactValues, DimensionlessContact, Preset, Scale, ScaleValues, SmoothingValues,
};
use osim_patch::LineIndex;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use crate::args::{Format, PresetsArgs};
use crate::load::read;
use crate::report::{json, number, table};
use crate::terminal::Terminal;

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
pub(crate) fn all(file: Option<&Path>) -> Result<Vec<Preset>> {
    let mut presets: Vec<Preset> =
        contact_scaling::preset_names().filter_map(contact_scaling::preset).collect();
    let Some(path) = file else { return Ok(presets) };
    let shown = path.display().to_string();
    let bytes = read(path).with_context(|| shown.clone())?;
    let text =
        std::str::from_utf8(&bytes).map_err(|_| anyhow!("{shown}: not UTF-8 text, expected a TOML file"))?;
    let place = |offset: usize| {
        let at = LineIndex::new(&bytes).position(&bytes, offset);
        format!("{shown}:{}:{}", at.line, at.column)
    };
    let parsed: File = toml::from_str(text).map_err(|error| {
        let place = error.span().map_or_else(|| shown.clone(), |span| place(span.start));
        anyhow!("{place}: {}", error.message().replace("expected f64", "expected a number"))
    })?;
    for entry in parsed.preset {
        let (name, at) = (entry.name.get_ref().clone(), place(entry.name.span().start));
        if presets.iter().any(|preset| preset.name == name) {
            bail!("{at}: the name '{name}' is taken: choose another");
        }
        presets.push(entry.preset().with_context(|| format!("{at}: preset '{name}'"))?);
    }
    Ok(presets)
}

/// The preset called `name`, if there is one.
///
/// # Errors
/// As [`all`].
pub(crate) fn find(name: &Path, file: Option<&Path>) -> Result<Option<Preset>> {
    let name = name.to_string_lossy();
    Ok(all(file)?.into_iter().find(|preset| preset.name == name))
}

/// The names of all presets, for messages.
pub(crate) fn names(file: Option<&Path>) -> String {
    let presets = all(file).unwrap_or_default();
    presets.iter().map(|preset| preset.name.to_string()).collect::<Vec<_>>().join(", ")
}

impl Entry {
    fn preset(self) -> Result<Preset> {
        let smoothing = match (
            self.constant_contact_force,
            self.hertz_smoothing,
            self.hunt_crossley_smoothing,
        ) {
            (None, None, None) => None,
            (Some(constant_contact_force), Some(hertz_smoothing), Some(hunt_crossley_smoothing)) => {
                Some(SmoothingValues { constant_contact_force, hertz_smoothing, hunt_crossley_smoothing })
            }
            _ => bail!(
                "constant_contact_force, hertz_smoothing and hunt_crossley_smoothing come together or not at all"
            ),
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

#[derive(Serialize)]
struct JsonPreset<'p> {
    schema_version: u32,
    name: &'p str,
    source: &'p str,
    mass_kg: f64,
    spheres: f64,
    radius_m: f64,
    gravity_m_s2: f64,
    stiffness: f64,
    dissipation: f64,
    constant_contact_force: Option<f64>,
    hertz_smoothing: Option<f64>,
    hunt_crossley_smoothing: Option<f64>,
    dimensionless: JsonDimensionless,
}

#[derive(Serialize)]
struct JsonDimensionless {
    modulus: f64,
    relative_indentation: f64,
    dissipation: f64,
    constant_indentation: Option<f64>,
    hertz_smoothing: Option<f64>,
    hunt_crossley_smoothing: Option<f64>,
}

/// Lists presets, or shows one.
///
/// # Errors
/// As [`all`], or an unknown name.
pub(crate) fn run(args: &PresetsArgs, terminal: &mut Terminal) -> Result<()> {
    let presets = all(args.presets.as_deref())?;
    let chosen: Vec<&Preset> = match &args.name {
        None => presets.iter().collect(),
        Some(name) => match presets.iter().find(|preset| preset.name == name.as_str()) {
            Some(preset) => vec![preset],
            None => bail!("unknown preset '{name}', expected one of: {}", names(args.presets.as_deref())),
        },
    };
    for (index, preset) in chosen.into_iter().enumerate() {
        let text = match args.format {
            Format::Json => json_of(preset),
            Format::Table if index == 0 => table_of(preset),
            Format::Table => format!("\n{}", table_of(preset)),
        };
        terminal.print(&text)?;
    }
    Ok(())
}

fn json_of(preset: &Preset) -> String {
    let (scale, contact) = (&preset.scale, &preset.contact);
    let smoothing = contact.smoothing();
    let dimensionless = DimensionlessContact::of(contact, scale);
    json::line(&JsonPreset {
        schema_version: 1,
        name: &preset.name,
        source: &preset.source,
        mass_kg: scale.mass_kg(),
        spheres: scale.sphere_count(),
        radius_m: scale.radius_m(),
        gravity_m_s2: scale.gravity_m_s2(),
        stiffness: contact.plane_strain_modulus(),
        dissipation: contact.dissipation(),
        constant_contact_force: smoothing.map(|s| s.constant_contact_force),
        hertz_smoothing: smoothing.map(|s| s.hertz_smoothing),
        hunt_crossley_smoothing: smoothing.map(|s| s.hunt_crossley_smoothing),
        dimensionless: JsonDimensionless {
            modulus: dimensionless.modulus(),
            relative_indentation: dimensionless.relative_indentation(),
            dissipation: dimensionless.dissipation(),
            constant_indentation: dimensionless.constant_indentation(),
            hertz_smoothing: dimensionless.hertz_smoothing(),
            hunt_crossley_smoothing: dimensionless.hunt_crossley_smoothing(),
        },
    })
}

fn table_of(preset: &Preset) -> String {
    let (scale, contact) = (&preset.scale, &preset.contact);
    let dimensionless = DimensionlessContact::of(contact, scale);
    let mut table = table(&["quantity", "value", "unit", "dimensionless"]);
    let mut row = |name: &str, value: f64, unit: &str, pure: Option<f64>| {
        let pure = pure.map(number).unwrap_or_default();
        table.add_row(vec![name.to_owned(), number(value), unit.to_owned(), pure]);
    };
    row("mass", scale.mass_kg(), "kg", None);
    row("spheres", scale.sphere_count(), "", None);
    row("radius", scale.radius_m(), "m", None);
    row("gravity", scale.gravity_m_s2(), "m/s^2", None);
    row("stiffness", contact.plane_strain_modulus(), "N/m^2", Some(dimensionless.modulus()));
    row("dissipation", contact.dissipation(), "s/m", Some(dimensionless.dissipation()));
    if let Some(smoothing) = contact.smoothing() {
        let cf = smoothing.constant_contact_force;
        row("constant_contact_force", cf, "m^2", dimensionless.constant_indentation());
        row("hertz_smoothing", smoothing.hertz_smoothing, "1/m", dimensionless.hertz_smoothing());
        let bv = smoothing.hunt_crossley_smoothing;
        row("hunt_crossley_smoothing", bv, "s/m", dimensionless.hunt_crossley_smoothing());
    }
    let source = textwrap::fill(&format!("source: {}", preset.source), 80);
    format!(
        "{}\n{source}\n\n{}\n\nrelative indentation at body weight: {}\n",
        preset.name,
        table.trim_fmt(),
        number(dimensionless.relative_indentation())
    )
}
