//! `inspect`: what contacts a model has, and what they do under its weight.
//!
//! [`Look`] makes an [`Inspection`] of each model, on any thread; the renderers only read it.

mod csv;
pub(crate) mod figures;
mod inspection;
pub(crate) mod rows;
mod standing;
pub(crate) mod table;
mod verdict;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::Result;
use contact_scaling::{DimensionlessContact, Scale, ScaleValues};
use osim_patch::{
    Anatomy, Factors, Fault, Limbs, Mass, MassRequest, Model, Selected, Selection, Warning, WarningCode,
    loaded_spheres,
};

use crate::args::{CheckArgs, InspectArgs, PartArgs, ReportArgs, SheetFormat, ViewArgs};
use crate::check::judged;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::page::{self, Entry, Page, entry_of_look};
use crate::report::json;
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::verbs::scale_file;
use crate::workers::{in_order, threads};

use figures::Figures;
pub(crate) use figures::{SphereFigures, Stance};
pub(crate) use inspection::Inspection;
use inspection::{Found, SetContact};
pub(crate) use verdict::Figure;

/// What to look at and how to print it.
pub(crate) struct Look<'l> {
    pub verb: &'static str,
    pub models: &'l [PathBuf],
    pub args: ViewArgs,
    pub view: View,
    pub format: SheetFormat,
    pub report: ReportArgs,
    /// Say what to do next, once, behind all models.
    pub hint: bool,
    /// The generic model the models were scaled from, and the Scale Tool's factors.
    pub from: Option<&'l Path>,
    pub body_scale_file: Option<&'l Path>,
}

/// Whose weight, by which forces, on how many spheres.
#[derive(Debug, Clone)]
pub(crate) struct View {
    pub masses: MassRequest,
    pub selection: Selection,
    pub stance: Stance,
}

impl View {
    /// # Errors
    /// Patterns that are none.
    pub(crate) fn new(args: &ViewArgs) -> Result<Self> {
        Ok(Self {
            masses: args.masses.request()?,
            selection: args.choice.selection()?,
            stance: args.stance.stance(),
        })
    }
}

impl<'l> Look<'l> {
    pub(crate) fn new(args: &'l InspectArgs) -> Result<Self> {
        Ok(Self {
            verb: "inspect",
            models: &args.models,
            args: args.view.clone(),
            view: View::new(&args.view)?,
            format: args.format,
            report: args.report.clone(),
            hint: false,
            from: args.from.as_deref(),
            body_scale_file: args.body_scale_file.as_deref(),
        })
    }

    /// As `check` looks.
    pub(crate) fn of_check(args: &'l CheckArgs) -> Result<Self> {
        Ok(Self {
            verb: "check",
            models: &args.models,
            args: args.view.clone(),
            view: View::new(&args.view)?,
            format: args.format,
            report: args.report.clone(),
            hint: false,
            from: None,
            body_scale_file: None,
        })
    }

    /// Files it reads beside the models.
    pub(crate) fn reads(&self) -> impl Iterator<Item = &'_ Path> {
        let parts = [&self.args.parts.geometry, &self.args.parts.model]
            .into_iter()
            .filter_map(|path| path.as_deref());
        parts.chain(self.from).chain(self.body_scale_file)
    }

    pub(crate) fn run(&self, terminal: &mut Terminal) -> Result<Exit> {
        let sources = Sources::find(self.models, None);
        let mut page = Page::of_looks(self, &sources)?;
        let mut exit = Exit::Done;
        for failure in &sources.failures {
            exit = exit.and(self.fail(failure, terminal)?);
        }
        for remark in &sources.remarks {
            terminal.note(&format!("note: {remark}\n"))?;
        }
        let (mut first, mut untold) = (true, None);
        in_order(
            &sources.models,
            threads(None, sources.models.len()),
            |source| self.one(source, &sources),
            |_, seen| {
                match seen {
                    Ok((seen, entry)) => {
                        // What cannot be printed is no reason to leave a page without its models.
                        let told = self.tell(&seen, first, terminal);
                        match (told, &page) {
                            (Err(error), Some(_)) => untold = untold.take().or(Some(error)),
                            (told, _) => told?,
                        }
                        first = false;
                        if let Some((page, entry)) = page.as_mut().zip(entry) {
                            page.tell(*entry);
                        }
                    }
                    Err(failure) => {
                        exit = exit.and(self.fail(&failure, terminal)?);
                        if let Some(page) = &mut page {
                            page.tell(Entry::lost(&failure));
                        }
                    }
                }
                Ok(())
            },
        )?;
        exit = exit.and(Page::end(page, terminal));
        untold.map_or(Ok(()), Err)?;
        if self.hint && !first && self.format == SheetFormat::Table {
            terminal.print(HINT)?;
        }
        Ok(exit)
    }

    /// A model, and the page's entry of it where a page is asked for.
    fn one(&self, source: &Source, sources: &Sources) -> Result<(Inspection, Option<Box<Entry>>), Failure> {
        self.with(source, |loaded, model, seen| {
            let entry = page::frame_of_look(self, source, sources).map(|frame| {
                let report = judged(&self.view, &self.args, model, &seen, None);
                Box::new(entry_of_look(&self.view, loaded, model, (&seen, &report), frame))
            });
            Ok((seen, entry))
        })
    }

    fn tell(&self, seen: &Inspection, first: bool, terminal: &mut Terminal) -> Result<()> {
        match self.format {
            SheetFormat::Json => terminal.print(&json::line(seen))?,
            SheetFormat::Csv => terminal.print(&csv::rows(seen, first)?)?,
            SheetFormat::Table => {
                let gap = if first { "" } else { "\n" };
                terminal.print_painted(&format!("{gap}{}", table::text(seen)))?;
            }
        }
        Ok(())
    }

    fn fail(&self, failure: &Failure, terminal: &mut Terminal) -> Result<Exit> {
        if self.format == SheetFormat::Json {
            terminal.print(&failure.json())?;
        }
        terminal.error(&failure.text());
        Ok(Exit::Failed)
    }

    /// Hands everything about one model to `then`, with the model.
    ///
    /// # Errors
    /// A model that cannot be read, or an error of `then`.
    pub(crate) fn with<T>(
        &self,
        source: &Source,
        then: impl FnOnce(&Loaded, &Model, Inspection) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let loaded = Loaded::read(source, &self.args.parts)?;
        loaded.with_model(|model| {
            let factors = self.factors(&loaded, model)?;
            then(&loaded, model, self.view.inspection(&loaded.shown, model, factors.as_ref()))
        })
    }

    /// Each body's factors against the generic model, where one was named.
    fn factors(&self, loaded: &Loaded, model: &Model) -> Result<Option<Factors>, Failure> {
        let Some(from) = self.from else { return Ok(None) };
        let generic = Loaded::read(&Source { path: from.to_owned(), folder: None }, &PartArgs::default())?;
        let generic =
            generic.with_model(|model| Anatomy::of(model).map_err(|fault| generic.failure(fault)))?;
        let file = self.body_scale_file.map(scale_file).transpose()?;
        let scaled = Anatomy::of(model).map_err(|fault| loaded.failure(fault))?;
        let found = Factors::find(&scaled, &generic, file.as_ref(), &BTreeMap::new());
        found.map(Some).map_err(|fault| loaded.failure(fault))
    }
}

impl View {
    /// Looking never refuses: what is not known is left open. `shown` is the model's name.
    pub(crate) fn inspection(
        &self,
        shown: &str,
        model: &Model,
        factors: Option<&Factors>,
    ) -> Inspection {
        let mut warnings = model.warnings.clone();
        let mass = self.masses.of_model(model);
        let contacts_mass = self.masses.of_contacts(model, &mut warnings);
        let (selected, unknown) = match self.selection.apply(model) {
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
            let line = line_of(model, fault);
            let warning = Warning { code, message: fault.to_string(), line, subject: None };
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        let (mass, contacts_mass) = (mass.ok(), contacts_mass.ok());
        let weight = mass.as_ref().or(contacts_mass.as_ref());
        let figures = Figures::of(model, &selected, &limbs, weight, &self.stance);
        let contacts = contacts(model, &selected, contacts_mass.as_ref(), &limbs);
        let found = Found {
            path: shown,
            mass: mass.as_ref(),
            contacts_mass: contacts_mass.as_ref(),
            selected: &selected,
            limbs: &limbs,
            warnings: &warnings,
            contacts: &contacts,
            factors,
            figures: figures.unwrap_or_else(|fault| Figures::absent(fault.to_string())),
        };
        Inspection::new(model, found)
    }
}

/// Each selected force's contact, without dimensions at the mass its contacts stand for on one limb.
fn contacts(
    model: &Model,
    selected: &Selected,
    mass: Option<&Mass>,
    limbs: &Limbs,
) -> Vec<SetContact> {
    let Ok(loaded) = loaded_spheres(model, &selected.forces) else { return Vec::new() };
    let mut found: Vec<SetContact> = Vec::new();
    for sphere in loaded {
        if found.iter().any(|known| (known.force, known.set) == (sphere.force, sphere.set)) {
            continue;
        }
        let scale = || {
            #[expect(clippy::cast_precision_loss, reason = "sphere counts are small")]
            let sphere_count = limbs.spheres_per_limb().ok()? as f64;
            let gravity_m_s2 = model.contacts_gravity()?;
            let (mass_kg, radius_m) = (mass?.kg, sphere.radius_m);
            Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2 }).ok()
        };
        found.push(SetContact {
            force: sphere.force,
            set: sphere.set,
            composite_modulus_n_m2: sphere.contact.composite_modulus(),
            dimensionless: scale().map(|scale| DimensionlessContact::of(&sphere.contact, &scale)),
        });
    }
    found
}

fn line_of(model: &Model, fault: &Fault) -> Option<usize> {
    fault.offset.map(|offset| model.file(fault.source_file).line(offset))
}

const HINT: &str = "
Nothing was changed. Next (MODEL is the name of the file, in quotes where it has blanks):
  osim-contact-scale check MODEL                    what to mend, and how
  osim-contact-scale MODEL --target-mass KG         scale its contacts to another mass
  osim-contact-scale transfer MODEL --from OTHER    take the contacts of a known model
  osim-contact-scale --help                         everything else
";
