//! One run of a changing verb: for each model load, plan, show, write.

use std::fs::Metadata;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use osim_patch::{Fault, Model, Plan, Warning, WarningCode};

use crate::args::{Format, OutputArgs, PartArgs};
use crate::failure::Failure;
use crate::load::Loaded;
use crate::paths::resolved;
use crate::place::{Ledger, Place, beside, place};
use crate::report::{changes, diff, json};
use crate::sources::{Source, Sources};
use crate::terminal::{Exit, Terminal};
use crate::write::{Mode, Prepared, backup};

/// What a verb plans for a model.
pub(crate) trait Planner {
    fn plan(&self, model: &Model<'_, '_>) -> Result<Plan, Fault>;

    /// Files it reads beside the models.
    fn reads(&self) -> Vec<PathBuf> {
        Vec::new()
    }
}

/// Runs `planner` over all models.
///
/// # Errors
/// Wrong usage: found before any model is read.
pub(crate) fn run(
    named: &[PathBuf],
    parts: &PartArgs,
    output: &OutputArgs,
    planner: &impl Planner,
    terminal: &mut Terminal,
) -> Result<Exit> {
    let sources = Sources::find(named, output.output_dir.as_deref());
    check_usage(named, &sources, output)?;
    let places: Vec<Place> = sources.models.iter().map(|source| place(source, output)).collect();
    check_files(&sources.models, &places, parts, output, &planner.reads())?;
    let mut exit = Exit::Done;
    for failure in &sources.failures {
        exit = exit.and(report_failure(failure, output, terminal));
    }
    let say = |terminal: &mut Terminal, remark: &str| match output.quiet {
        true => Ok(()),
        false => terminal.note(&format!("note: {remark}\n")),
    };
    for remark in &sources.remarks {
        say(terminal, remark)?;
    }
    let mut without_contacts = 0;
    for (source, place) in sources.models.iter().zip(&places) {
        let job = Job { source, place, parts, output };
        match job.run(planner, terminal) {
            Ok(()) => {}
            // A folder may hold models without contacts; one that was named may not.
            Err(failure) if failure.code == "no-contacts" && source.folder.is_some() => without_contacts += 1,
            Err(failure) => exit = exit.and(report_failure(&failure, output, terminal)),
        }
    }
    if without_contacts > 0 {
        say(terminal, &format!("models without contacts passed over: {without_contacts}"))?;
    }
    Ok(exit)
}

fn check_usage(named: &[PathBuf], sources: &Sources, output: &OutputArgs) -> Result<()> {
    let from_stdin = named.iter().any(|path| path.as_os_str() == "-");
    let to_stdout = output.output.as_deref() == Some(Path::new("-"))
        || (from_stdin && output.output.is_none() && output.output_dir.is_none());
    let to_stdout = to_stdout && !output.dry_run;
    let several = named.len() > 1 || sources.models.len() > 1 || named.iter().any(|path| path.is_dir());
    if output.output.is_some() && several {
        bail!("-o is for one model: write several into a folder with -d DIR");
    }
    if to_stdout && several {
        bail!("one model goes to standard output: name it alone, or write several into a folder with -d DIR");
    }
    if to_stdout && (output.diff || output.format == Format::Json) {
        bail!(
            "the model goes to standard output: leave out --diff and --format json, or write it to a file with -o"
        );
    }
    if output.in_place && from_stdin {
        bail!("--in-place needs a file, standard input has none");
    }
    Ok(())
}

/// Nothing is written over what is read, and no file is written twice.
fn check_files(
    sources: &[Source],
    places: &[Place],
    parts: &PartArgs,
    output: &OutputArgs,
    reads: &[PathBuf],
) -> Result<()> {
    if parts.geometry.is_some() && sources.len() > 1 {
        bail!("--geometry belongs to one ForceSet: change several in runs of their own");
    }
    let mut ledger = Ledger::default();
    let beside_models = [&parts.geometry, &parts.model].into_iter().flatten().chain(reads);
    sources.iter().map(|source| &source.path).chain(beside_models).for_each(|path| ledger.read(path));
    for (source, place) in sources.iter().zip(places) {
        if let Place::File(path) = place {
            ledger.write(path, &source.shown())?;
        }
    }
    if let (Some(geometry), false) = (&parts.geometry, output.in_place) {
        ledger.write(&geometry_path(geometry, output), &geometry.display().to_string())?;
    }
    Ok(())
}

/// Where the changed geometry set of a standalone force set goes, unless it is changed in place.
fn geometry_path(geometry: &Path, output: &OutputArgs) -> PathBuf {
    match (&output.geometry_output, &output.output_dir) {
        (Some(path), _) => path.clone(),
        (None, Some(folder)) => folder.join(geometry.file_name().unwrap_or_default()),
        (None, None) => beside(geometry),
    }
}

fn report_failure(failure: &Failure, output: &OutputArgs, terminal: &mut Terminal) -> Exit {
    if output.format == Format::Json {
        // Scripts read one object per model, also of those that failed.
        if terminal.print(&failure.json()).is_err() {
            return Exit::Failed;
        }
    }
    terminal.error(&failure.text());
    Exit::Failed
}

/// One model.
struct Job<'j> {
    source: &'j Source,
    place: &'j Place,
    parts: &'j PartArgs,
    output: &'j OutputArgs,
}

impl Job<'_> {
    fn run(&self, planner: &impl Planner, terminal: &mut Terminal) -> Result<(), Failure> {
        let loaded = Loaded::read(self.source, self.parts)?;
        loaded.with_model(|model| {
            let mut plan = planner.plan(model).map_err(|fault| loaded.failure(fault))?;
            if self.output.no_note {
                plan.without_note();
                if model.note.is_some() && !plan.is_empty() {
                    let text = "the note is removed: the next run cannot know what the contacts stand for";
                    plan.remarks.push(text.to_owned());
                }
            }
            plan.warnings.splice(0..0, model.warnings.iter().cloned());
            plan.warnings.extend(self.compiled_beside());
            let outside = |error: anyhow::Error| Failure::outside(&loaded.shown, "output", &error);
            let patched = plan.patched(model, 0).map_err(|fault| loaded.failure(fault))?;
            let geometry = match self.geometry_file(&plan, model, &loaded) {
                Some(file) => {
                    let bytes = plan.patched(model, file).map_err(|fault| loaded.failure(fault))?;
                    let path = loaded.parts.get(file - 1).map(|part| part.path.clone()).unwrap_or_default();
                    Some(Geometry { file, path, bytes })
                }
                None => None,
            };
            let written = self.write(&loaded, &plan, &patched, geometry.as_ref()).map_err(outside)?;
            self.show(&loaded, &plan, &patched, geometry.as_ref(), &written, terminal).map_err(outside)
        })
    }

    /// The standalone geometry set that changes with the force set.
    fn geometry_file(&self, plan: &Plan, model: &Model<'_, '_>, loaded: &Loaded) -> Option<usize> {
        self.parts.geometry.as_ref()?;
        (1..=loaded.parts.len()).find(|&file| !plan.edits(model, file).is_empty())
    }

    fn compiled_beside(&self) -> Option<Warning> {
        let path = self.place.path()?;
        let prefix = format!("F_{}.", path.file_stem()?.to_string_lossy());
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut entries = std::fs::read_dir(folder).ok()?.flatten();
        let found = entries.find(|entry| entry.file_name().to_string_lossy().starts_with(&prefix))?;
        let text = format!(
            "{} lies beside the output: PredSim and OpenCap would go on using it",
            found.path().display()
        );
        Some(Warning::new(WarningCode::CompiledModelBeside, text))
    }

    /// Writes what is to be written; where it went.
    fn write(
        &self,
        loaded: &Loaded,
        plan: &Plan,
        patched: &[u8],
        geometry: Option<&Geometry>,
    ) -> Result<Written> {
        if self.output.dry_run {
            return Ok(Written::Nothing("dry run: nothing written"));
        }
        let asked = self.output.output.is_some() || self.output.output_dir.is_some();
        let to_stdout = *self.place == Place::Stdout;
        if plan.is_empty() && !asked && !to_stdout {
            return Ok(Written::Nothing("nothing written"));
        }
        let like = std::fs::metadata(&self.source.path).ok();
        let mode = if self.output.force || self.output.in_place { Mode::Replace } else { Mode::New };
        let mut successors = Vec::new();
        let mut backups = Vec::new();
        let mut paths = Vec::new();
        let mut prepare = |path: &Path, new: &[u8], old: &[u8], like: Option<&Metadata>| -> Result<()> {
            if self.output.in_place {
                self.refuse_protected(path)?;
                if !self.output.no_backup {
                    backups.push(
                        backup(path, old).context("the backup could not be kept, so nothing was changed")?,
                    );
                }
            }
            make_folder(path)?;
            successors.push(Prepared::new(path, new, like, mode)?);
            paths.push(path.to_owned());
            Ok(())
        };
        if let Some(path) = self.place.path() {
            prepare(path, patched, &loaded.bytes, like.as_ref())?;
        }
        if let Some(geometry) = geometry {
            let in_place = self.output.in_place;
            let path =
                if in_place { geometry.path.clone() } else { geometry_path(&geometry.path, self.output) };
            let like = std::fs::metadata(&geometry.path).ok();
            prepare(&path, &geometry.bytes, loaded.file(geometry.file).1, like.as_ref())?;
        }
        // Two files that belong together, and a file whose old contents are about to go: all on the disk first.
        let together = successors.len() > 1 || successors.iter().any(Prepared::replaces);
        let kept: Vec<PathBuf> = backups.iter().map(|(_, path)| path.clone()).collect();
        let all = backups.into_iter().map(|(prepared, _)| prepared).chain(successors).collect::<Vec<_>>();
        if together {
            all.iter().try_for_each(Prepared::sync)?;
        }
        for prepared in all {
            prepared.commit()?;
        }
        Ok(if to_stdout { Written::Stdout } else { Written::Files { paths, kept } })
    }

    /// A model that somebody protected is not changed in passing.
    fn refuse_protected(&self, path: &Path) -> Result<()> {
        let protected = std::fs::metadata(path).is_ok_and(|metadata| metadata.permissions().readonly());
        if protected && !self.output.force {
            bail!("{} is write-protected: change it all the same with --force", path.display());
        }
        Ok(())
    }

    fn show(
        &self,
        loaded: &Loaded,
        plan: &Plan,
        patched: &[u8],
        geometry: Option<&Geometry>,
        written: &Written,
        terminal: &mut Terminal,
    ) -> Result<()> {
        let paths: Vec<String> = written.paths().iter().map(|path| path.display().to_string()).collect();
        if self.output.format == Format::Json {
            let output = paths.first().map(String::as_str);
            terminal.print(&json::plan(plan, &loaded.shown, output, paths.get(1).map(String::as_str)))?;
        } else if !self.output.quiet {
            let result = match written {
                Written::Nothing(why) => (*why).to_owned(),
                Written::Stdout => "model written to standard output".to_owned(),
                Written::Files { kept, .. } => {
                    let kept: Vec<_> = kept.iter().map(|path| path.display().to_string()).collect();
                    let kept =
                        if kept.is_empty() { String::new() } else { format!(" (old: {})", kept.join(", ")) };
                    format!("written: {}{kept}", paths.join(", "))
                }
            };
            let text = changes::text(plan, &loaded.shown, &result);
            if *self.place == Place::Stdout && !self.output.dry_run {
                terminal.note(&text)?;
            } else {
                terminal.print(&text)?;
            }
        }
        if self.output.diff {
            let target =
                self.place.path().map_or_else(|| loaded.shown.clone(), |path| path.display().to_string());
            let mut text = diff::unified(&loaded.bytes, patched, &loaded.shown, &target);
            if let Some(geometry) = geometry {
                let (name, bytes) = loaded.file(geometry.file);
                text.push_str(&diff::unified(bytes, &geometry.bytes, name, name));
            }
            // With JSON on standard output, the diff would not be JSON.
            if self.output.format == Format::Json { terminal.note(&text)? } else { terminal.print(&text)? }
        }
        if matches!(written, Written::Stdout) {
            terminal.write_bytes(patched)?;
        }
        Ok(())
    }
}

/// The changed bytes of a standalone geometry set.
struct Geometry {
    file: usize,
    path: PathBuf,
    bytes: Vec<u8>,
}

/// What was written.
enum Written {
    /// Nothing, and why.
    Nothing(&'static str),
    /// The model goes to standard output.
    Stdout,
    /// The model, then its geometry set; and the backups of both.
    Files { paths: Vec<PathBuf>, kept: Vec<PathBuf> },
}

impl Written {
    fn paths(&self) -> &[PathBuf] {
        match self {
            Self::Files { paths, .. } => paths,
            Self::Nothing(_) | Self::Stdout => &[],
        }
    }
}

fn make_folder(path: &Path) -> Result<()> {
    match resolved(path).parent() {
        Some(folder) => {
            let shown = path.parent().unwrap_or(Path::new(".")).display();
            std::fs::create_dir_all(folder).with_context(|| format!("cannot make the folder {shown}"))
        }
        None => Ok(()),
    }
}
