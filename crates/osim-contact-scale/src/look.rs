//! `inspect`: what contacts a model has.

use std::path::PathBuf;

use anyhow::Result;
use osim_patch::{Limbs, MassRequest, Model, Selected, Selection};

use crate::args::{Format, InspectArgs, PartArgs};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::report::json::Inspected;
use crate::report::{inspect, json};
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};

/// What to look at and how to print it.
pub(crate) struct Look<'l> {
    pub models: &'l [PathBuf],
    pub parts: &'l PartArgs,
    pub format: Format,
    pub masses: MassRequest,
    pub selection: Selection,
    /// Say what to do next.
    pub hint: bool,
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
        loaded.with_model(|model| Ok(self.show(&loaded, model)))
    }

    /// Looking never refuses: what is not known is left open.
    fn show(&self, loaded: &Loaded, model: &Model<'_, '_>) -> String {
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
        let seen = Inspected {
            path: &loaded.shown,
            model,
            mass: mass.as_ref().ok(),
            contacts_mass: contacts_mass.as_ref().ok(),
            selected: &selected,
            limbs: &limbs,
            warnings: &warnings,
        };
        if self.format == Format::Json {
            return json::inspect(&seen);
        }
        let mut text = inspect::text(&seen);
        for fault in [mass.as_ref().err(), contacts_mass.as_ref().err()].into_iter().flatten() {
            let line = format!("warning: {fault}\n");
            if !text.contains(&line) {
                text.push_str(&line);
            }
        }
        if self.hint {
            text.push_str(&hint(&loaded.shown));
        }
        text
    }
}

fn hint(model: &str) -> String {
    format!(
        "\nNothing was changed. Next:\n  \
         osim-contact-scale {model} --target-mass KG        scale its contacts to another mass\n  \
         osim-contact-scale transfer {model} --from MODEL   take the contacts of a known model\n  \
         osim-contact-scale --help                          everything else\n"
    )
}
