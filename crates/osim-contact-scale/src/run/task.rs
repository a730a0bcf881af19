//! One model and what is to be done with it.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use anyhow::{Result, bail};
use osim_patch::{Fault, Model, Plan};

use super::Work;
use crate::args::{OutputArgs, PartArgs, RunArgs, RunFormat, ViewArgs};
use crate::digest::sha256;
use crate::load::read;
use crate::place::{Place, Who, geometry_place, place};
use crate::sources::{Source, Sources};

/// What a verb plans for a model.
pub(crate) trait Planner: Send + Sync {
    fn plan(&self, model: &Model) -> Result<Plan, Fault>;

    /// Files it reads beside the models.
    fn reads(&self) -> Vec<PathBuf> {
        Vec::new()
    }

    /// The verb.
    fn name(&self) -> &'static str;

    /// How `inspect` and `check` would look at the model with the same options.
    fn view(&self) -> ViewArgs;

    /// Gravity that the contacts are scaled to, m/s², where that is asked for.
    fn target_gravity_m_s2(&self) -> Option<f64> {
        None
    }

    /// Everything its plans follow from but for the files: equal texts, equal plans.
    fn options(&self) -> String;
}

/// A verb with its options: where its models are, what it plans, and where results go.
pub(crate) struct Verb {
    pub models: Vec<PathBuf>,
    pub output: OutputArgs,
    pub parts: PartArgs,
    pub planner: Box<dyn Planner>,
}

/// What is done with a model: shared by all models of a call, or by like rows of a manifest.
pub(crate) struct Order {
    planner: Box<dyn Planner>,
    pub parts: PartArgs,
    pub in_place: bool,
    pub no_backup: bool,
    pub force: bool,
    pub no_note: bool,
    recipe: OnceLock<String>,
}

impl Order {
    pub(crate) fn new(planner: Box<dyn Planner>, parts: PartArgs, output: &OutputArgs) -> Self {
        Self {
            planner,
            parts,
            in_place: output.in_place,
            no_backup: output.no_backup,
            force: output.force,
            no_note: output.no_note,
            recipe: OnceLock::new(),
        }
    }

    pub(super) fn planner(&self) -> &dyn Planner {
        self.planner.as_ref()
    }

    /// The verb.
    pub(super) fn name(&self) -> &'static str {
        self.planner.name()
    }

    /// How `inspect` and `check` would look at the model with the same options.
    pub(super) fn view(&self) -> ViewArgs {
        ViewArgs { parts: self.parts.clone(), ..self.planner.view() }
    }

    /// Files it reads beside the models.
    pub(super) fn reads(&self) -> Vec<PathBuf> {
        let parts = [&self.parts.geometry, &self.parts.model].into_iter().flatten().cloned();
        parts.chain(self.planner.reads()).collect()
    }

    /// Digest of everything an output follows from but for the model itself.
    pub(super) fn recipe(&self) -> &str {
        self.recipe.get_or_init(|| {
            let mut text = format!("{}\nno note: {}\n", self.planner.options(), self.no_note);
            for path in self.reads() {
                // What cannot be read fails later, with its name.
                let digest = read(&path).map(|bytes| sha256(&bytes)).unwrap_or_default();
                text.push_str(&format!("{digest}\n"));
            }
            sha256(text.as_bytes())
        })
    }
}

/// One model with its order.
pub(crate) struct Task {
    pub source: Source,
    pub place: Place,
    /// Where the changed geometry set of a standalone force set goes.
    pub geometry_output: Option<PathBuf>,
    /// The output was asked for by name: it is written even where nothing changes.
    pub asked: bool,
    pub order: Arc<Order>,
    /// Row of the manifest, from 1.
    pub row: Option<usize>,
}

impl Task {
    pub(crate) fn new(source: Source, output: &OutputArgs, order: Arc<Order>) -> Self {
        let geometry = order.parts.geometry.as_deref();
        Self {
            place: place(&source, output),
            geometry_output: geometry.map(|geometry| geometry_place(geometry, output)),
            asked: output.output.is_some() || output.output_dir.is_some(),
            source,
            order,
            row: None,
        }
    }

    /// The file that is written.
    pub(crate) fn output(&self) -> Option<&Path> {
        self.place.path(&self.source)
    }

    /// As named in messages about several models.
    pub(super) fn who(&self) -> Who<'_> {
        Who::Model(&self.source.path, self.row)
    }
}

/// The tasks of one verb: its files, and the models in its folders.
///
/// # Errors
/// Wrong usage.
pub(crate) fn tasks_of(verb: Verb, run: &RunArgs) -> Result<Work> {
    let Verb { models, output, parts, planner } = verb;
    let sources = Sources::find(&models, output.output_dir.as_deref());
    check_usage(&models, &sources, &output, run)?;
    if parts.geometry.is_some() && sources.models.len() > 1 {
        bail!("--geometry belongs to one ForceSet: change several in runs of their own");
    }
    let verb = planner.name();
    let order = Arc::new(Order::new(planner, parts, &output));
    let task = |source: Source| Task::new(source, &output, Arc::clone(&order));
    Ok(Work {
        verb,
        tasks: sources.models.into_iter().map(task).collect(),
        failures: sources.failures,
        remarks: sources.remarks,
        force: output.force,
        ..Work::default()
    })
}

fn check_usage(named: &[PathBuf], sources: &Sources, output: &OutputArgs, run: &RunArgs) -> Result<()> {
    let from_stdin = named.iter().any(|path| path.as_os_str() == "-");
    let to_stdout = output.output.as_deref() == Some(Path::new("-"))
        || (from_stdin && output.output.is_none() && output.output_dir.is_none());
    let to_stdout = to_stdout && !run.dry_run;
    let several = named.len() > 1 || sources.models.len() > 1 || named.iter().any(|path| path.is_dir());
    if output.output.is_some() && several {
        bail!("-o is for one model: write several into a folder with -d DIR");
    }
    if to_stdout && several {
        bail!("one model goes to standard output: name it alone, or write several into a folder with -d DIR");
    }
    if to_stdout && (run.diff || run.format == Some(RunFormat::Json)) {
        bail!(
            "the model goes to standard output: leave out --diff and --format json, or write it to a file with -o"
        );
    }
    if output.in_place && from_stdin {
        bail!("--in-place needs a file, standard input has none");
    }
    Ok(())
}
