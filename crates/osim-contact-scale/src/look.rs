//! `inspect`: what contacts a model has.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::Result;
use contact_scaling::{DimensionlessContact, Scale, ScaleValues};
use osim_patch::{
    Anatomy, Factors, Fault, Limbs, Mass, MassRequest, Model, Selected, Selection, Warning, WarningCode,
    loaded_spheres,
};

use crate::args::{Format, InspectArgs, PartArgs};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::report::json::Inspected;
use crate::report::{inspect, json};
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::verbs::scale_file;

/// What to look at and how to print it.
pub(crate) struct Look<'l> {
    pub models: &'l [PathBuf],
    pub parts: &'l PartArgs,
    pub format: Format,
    pub masses: MassRequest,
    pub selection: Selection,
    /// Say what to do next, once, behind all models.
    pub hint: bool,
    /// The generic model the models were scaled from, and the Scale Tool's factors.
    pub from: Option<&'l Path>,
    pub body_scale_file: Option<&'l Path>,
}

impl<'l> Look<'l> {
    pub(crate) fn new(args: &'l InspectArgs) -> Result<Self> {
        Ok(Self {
            models: &args.models,
            parts: &args.parts,
            format: args.format,
            masses: args.masses.request()?,
            selection: args.choice.selection()?,
            hint: false,
            from: args.from.as_deref(),
            body_scale_file: args.body_scale_file.as_deref(),
        })
    }

    pub(crate) fn run(&self, terminal: &mut Terminal) -> Result<Exit> {
        let sources = Sources::find(self.models, None);
        let mut exit = Exit::Done;
        for failure in &sources.failures {
            exit = exit.and(self.fail(failure, terminal)?);
        }
        for remark in &sources.remarks {
            terminal.note(&format!("note: {remark}\n"))?;
        }
        let mut first = true;
        for source in &sources.models {
            match self.one(source) {
                Ok(text) => {
                    if !first && self.format == Format::Table {
                        terminal.print("\n")?;
                    }
                    first = false;
                    terminal.print(&text)?;
                }
                Err(failure) => exit = exit.and(self.fail(&failure, terminal)?),
            }
        }
        if self.hint && !first && self.format == Format::Table {
            terminal.print(HINT)?;
        }
        Ok(exit)
    }

    fn fail(&self, failure: &Failure, terminal: &mut Terminal) -> Result<Exit> {
        if self.format == Format::Json {
            terminal.print(&failure.json())?;
        }
        terminal.error(&failure.text());
        Ok(Exit::Failed)
    }

    fn one(&self, source: &Source) -> Result<String, Failure> {
        let loaded = Loaded::read(source, self.parts)?;
        loaded.with_model(|model| {
            let factors = self.factors(&loaded, model)?;
            Ok(self.show(&loaded, model, factors.as_ref()))
        })
    }

    /// Each body's factors against the generic model, where one was named.
    fn factors(&self, loaded: &Loaded, model: &Model<'_, '_>) -> Result<Option<Factors>, Failure> {
        let Some(from) = self.from else { return Ok(None) };
        let generic = Loaded::read(&Source { path: from.to_owned(), folder: None }, &PartArgs::default())?;
        let generic =
            generic.with_model(|model| Anatomy::of(model).map_err(|fault| generic.failure(fault)))?;
        let file = self.body_scale_file.map(scale_file).transpose()?;
        let scaled = Anatomy::of(model).map_err(|fault| loaded.failure(fault))?;
        let found = Factors::find(&scaled, &generic, file.as_ref(), &BTreeMap::new());
        found.map(Some).map_err(|fault| loaded.failure(fault))
    }

    /// Looking never refuses: what is not known is left open.
    fn show(&self, loaded: &Loaded, model: &Model<'_, '_>, factors: Option<&Factors>) -> String {
        let mut warnings = model.warnings.clone();
        let mass = self.masses.of_model(model);
        let contacts_mass = self.masses.of_contacts(model, &mut warnings);
        let selection = self.selection.apply(model);
        let (selected, unknown) = match selection {
            Ok(selected) => (selected, None),
            Err(fault) => (Selected { forces: vec![], complete: false }, Some(fault.to_string())),
        };
        let limbs = match &unknown {
            Some(why) => Limbs::Unknown(why.clone()),
            None => model.limbs(&selected.forces),
        };
        warnings.extend(factors.iter().flat_map(|factors| factors.warnings.iter().cloned()));
        for fault in [mass.as_ref().err(), contacts_mass.as_ref().err()].into_iter().flatten() {
            let code =
                if fault.code() == "stale-note" { WarningCode::StaleNote } else { WarningCode::MassUnknown };
            let warning = Warning { code, message: fault.to_string(), line: line_of(model, fault) };
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        let dimensionless = dimensionless(model, &selected, contacts_mass.as_ref().ok(), &limbs);
        let seen = Inspected {
            path: &loaded.shown,
            model,
            mass: mass.as_ref().ok(),
            contacts_mass: contacts_mass.as_ref().ok(),
            selected: &selected,
            limbs: &limbs,
            warnings: &warnings,
            dimensionless: &dimensionless,
            factors,
        };
        if self.format == Format::Json {
            return json::inspect(&seen);
        }
        inspect::text(&seen)
    }
}

/// Each selected force's contact without dimensions, at the mass its contacts stand for on one limb.
fn dimensionless(
    model: &Model<'_, '_>,
    selected: &Selected,
    mass: Option<&Mass>,
    limbs: &Limbs,
) -> Vec<(usize, usize, DimensionlessContact)> {
    let (Some(mass), Ok(count), Some(gravity)) = (mass, limbs.spheres_per_limb(), model.contacts_gravity())
    else {
        return Vec::new();
    };
    let Ok(loaded) = loaded_spheres(model, &selected.forces) else { return Vec::new() };
    let mut found: Vec<(usize, usize, DimensionlessContact)> = Vec::new();
    for sphere in loaded {
        #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
        let scale = Scale::new(ScaleValues {
            mass_kg: mass.kg,
            radius_m: sphere.radius_m,
            sphere_count: count as f64,
            gravity_m_s2: gravity,
        });
        let known = found.iter().any(|(force, set, _)| (*force, *set) == (sphere.force, sphere.set));
        if let (Ok(scale), false) = (scale, known) {
            found.push((sphere.force, sphere.set, DimensionlessContact::of(&sphere.contact, &scale)));
        }
    }
    found
}

fn line_of(model: &Model<'_, '_>, fault: &Fault) -> Option<usize> {
    fault.offset.map(|offset| model.file(fault.source_file).line(offset))
}

const HINT: &str = "
Nothing was changed. Next (MODEL is the name of the file, in quotes where it has blanks):
  osim-contact-scale MODEL --target-mass KG         scale its contacts to another mass
  osim-contact-scale transfer MODEL --from OTHER    take the contacts of a known model
  osim-contact-scale --help                         everything else
";
