//! `set`: plain changes.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use osim_patch::{
    Assignment, Fault, Mass, MassRequest, MassSource, Model, Plan, Property, Selection, Set, set,
};

use crate::args::{SetArgs, ViewArgs, assignment};
use crate::run::{Planner, Verb};

type Assignments = Vec<(Property, Assignment)>;

/// `set`.
struct Setting {
    assignments: Assignments,
    selection: Selection,
    masses: MassRequest,
    again: bool,
    view: ViewArgs,
    options: String,
}

/// # Errors
/// No model, nothing to set, an unknown property or a value that is no number.
pub(crate) fn verb(args: SetArgs) -> Result<Verb> {
    let SetArgs { items, masses, choice, output, run: _, parts } = args;
    let (models, assignments) = parted(&items)?;
    let planner = Setting {
        options: format!("set {assignments:?} {masses:?} {choice:?}"),
        assignments,
        selection: choice.selection()?,
        masses: masses.request()?,
        again: output.force || !output.in_place,
        view: ViewArgs { masses, choice, ..ViewArgs::default() },
    };
    Ok(Verb { models, output, parts, planner: Box::new(planner) })
}

/// Parts the words of the command line into models and assignments.
fn parted(items: &[OsString]) -> Result<(Vec<PathBuf>, Assignments)> {
    let mut models = Vec::new();
    let mut assignments: Assignments = Vec::new();
    for item in items {
        // A name that is not UTF-8 is no assignment.
        match item.to_str().and_then(|item| item.split_once('=')) {
            Some((name, value)) if !Path::new(item).exists() => {
                let new = assignment(name, value).map_err(|why| anyhow!(why))?;
                if assignments.iter().any(|(property, _)| *property == new.0) {
                    bail!("{} is set twice", new.0);
                }
                assignments.push(new);
            }
            _ => models.push(PathBuf::from(item)),
        }
    }
    if models.is_empty() {
        bail!("no model given, expected one or more .osim files or folders (see set --help)");
    }
    if assignments.is_empty() {
        bail!("nothing to set, expected PROPERTY=VALUE or PROPERTY=xFACTOR, for example stiffness=x2");
    }
    Ok((models, assignments))
}

impl Planner for Setting {
    fn name(&self) -> &'static str {
        "set"
    }

    fn view(&self) -> ViewArgs {
        self.view.clone()
    }

    fn options(&self) -> String {
        self.options.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let mut warnings = Vec::new();
        // A plain change needs no mass; where one is known, the note goes on saying it.
        let of_note = || {
            let kg = model.note.as_ref()?.mass_kg?;
            Some(Mass { kg, source: MassSource::Note, told_by: "note in the file".to_owned() })
        };
        let contacts_mass = self.masses.of_contacts(model, &mut warnings).ok().or_else(of_note);
        let assignments = self.assignments.clone();
        let mut plan = set(model, &selected, &Set { assignments, contacts_mass, again: self.again })?;
        plan.warnings.append(&mut warnings);
        Ok(plan)
    }
}
