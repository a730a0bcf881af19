//! `sweep`: variants of one model, and a manifest of what is in which file.
//!
//! All variants come from one reading of the model. Count and size are told first; then each variant is planned, written
//! as any other output, and read again from its own bytes for the manifest.

mod grid;
mod ladder;
mod manifest;
mod stages;
mod variant;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use serde::Serialize;

use crate::args::{Format, SweepArgs};
use crate::failure::Failure;
use crate::folders::{self, Folders};
use crate::load::Loaded;
use crate::report::json;
use crate::run::{Progress, interrupt};
use crate::sources::Source;
use crate::terminal::{Exit, Terminal};
use crate::workers::{in_order, threads};
use crate::write::{Mode, Prepared};

use grid::{Name, Point, count, points};
use ladder::Ladder;
use stages::Stages;
use variant::Variant;

pub(crate) use grid::Axis;

/// More models than this are made only with `--yes`.
const MANY: usize = 10_000;
/// End of the name of the folder that variants are written into by default. Walks over folders pass it over.
pub(crate) const FOLDER_MARK: &str = ".sweep";

/// Makes all variants.
///
/// # Errors
/// Wrong usage, found before anything is written.
pub(crate) fn sweep(args: &SweepArgs, terminal: &mut Terminal) -> Result<Exit> {
    stages::check(args)?;
    if args.model.as_os_str() == "-" || args.model.is_dir() {
        bail!("a sweep makes variants of one model: name its file");
    }
    let made = args.ladder.map_or_else(|| count(&args.grid), |steps| usize::try_from(steps).ok());
    let made = made.filter(|&made| made <= MANY || args.yes);
    if made.is_none() && !args.dry_run {
        bail!("more than 10,000 models would be made: say --yes, or give fewer values");
    }
    let loaded = match Loaded::read(&Source::file(&args.model), &crate::args::PartArgs::default()) {
        Ok(loaded) => loaded,
        Err(failure) => return fail(&failure, args, terminal),
    };
    // What is wrong with the model itself is told once, not for every variant.
    if let Err(failure) = Variant::unchanged(args, &loaded) {
        return fail(&failure, args, terminal);
    }
    let ladder = args.ladder.map(|steps| Ladder::of(args, &loaded, steps)).transpose()?;
    let sweep = Sweep { args, loaded: &loaded, folder: folder(args), ladder };
    sweep.run(terminal)
}

fn fail(failure: &Failure, args: &SweepArgs, terminal: &mut Terminal) -> Result<Exit> {
    if args.format == Format::Json {
        terminal.print(&failure.json())?;
    }
    terminal.error(&failure.text());
    Ok(Exit::Failed)
}

fn folder(args: &SweepArgs) -> PathBuf {
    let beside = || {
        let mut name = stem(&args.model);
        name.push(FOLDER_MARK);
        args.model.with_file_name(name)
    };
    args.output_dir.clone().unwrap_or_else(beside)
}

fn stem(model: &Path) -> OsString {
    model.file_stem().unwrap_or_default().to_owned()
}

struct Sweep<'s> {
    args: &'s SweepArgs,
    loaded: &'s Loaded,
    folder: PathBuf,
    ladder: Option<Ladder>,
}

/// One file to make.
struct Job {
    file: String,
    /// What was asked, in the columns of the manifest.
    asked: Vec<String>,
    /// As the note has it.
    operation: String,
    /// What the contacts stand for then, where that changes.
    mass_kg: Option<f64>,
    stages: Stages,
}

/// What became of a job.
enum Made {
    Row(Vec<u8>),
    Failed(Failure),
    NotBegun,
}

/// The end of a sweep, for scripts.
#[derive(Serialize)]
struct JsonSweep<'j> {
    schema_version: u32,
    model: &'j str,
    manifest: Option<String>,
    folder: String,
    models: usize,
    failed: usize,
}

impl Sweep<'_> {
    fn run(&self, terminal: &mut Terminal) -> Result<Exit> {
        let (asked, jobs) = self.jobs()?;
        let manifest =
            self.folder.join(self.name(if self.ladder.is_some() { "ladder" } else { "sweep" }, "csv"));
        self.announce(jobs.len(), terminal)?;
        if self.args.dry_run {
            return self.tell(None, jobs.len(), 0, terminal);
        }
        self.check_new(&jobs, &manifest)?;
        folders::make(&manifest)?;
        // Files left behind by a run that was killed go first.
        Folders::look(std::iter::once(manifest.as_path()), true);
        let mut table = Prepared::begin(&manifest, None, self.mode())?;
        table.add(&manifest::header(&asked)?)?;
        let (mut failed, mut not_begun) = (0, 0);
        interrupt::listen();
        let progress = Progress::begin(jobs.len(), self.args.quiet);
        let work = |job: &Job| {
            let made = self.make(job);
            progress.done(matches!(made, Made::Failed(_)));
            made
        };
        let each = |_: &Job, made: Made| match made {
            Made::Row(row) => table.add(&row),
            Made::Failed(failure) => {
                failed += 1;
                progress.suspended(|| fail(&failure, self.args, terminal)).map(|_| ())
            }
            Made::NotBegun => {
                not_begun += 1;
                Ok(())
            }
        };
        in_order(&jobs, threads(self.args.jobs, jobs.len()), work, each)?;
        progress.end();
        table.commit()?;
        let done = jobs.len() - failed - not_begun;
        if not_begun > 0 {
            terminal.note(&format!("note: stopped: {done} of {} models are made\n", jobs.len()))?;
            return Ok(Exit::Interrupted);
        }
        self.tell(Some(&manifest), done, failed, terminal)
    }

    /// Columns of what is asked, and everything to make.
    fn jobs(&self) -> Result<(Vec<String>, Vec<Job>)> {
        let Some(ladder) = &self.ladder else {
            let asked = self.args.grid.iter().map(|axis| format!("grid_{}", axis.name.as_str())).collect();
            let jobs =
                points(&self.args.grid).iter().map(|point| self.point(point)).collect::<Result<_>>()?;
            return Ok((asked, jobs));
        };
        let asked = vec!["step".to_owned(), "wanted_dimensionless_stiffness".to_owned()];
        let jobs = (0..ladder.len()).map(|index| self.step(ladder, index)).collect::<Result<_>>()?;
        Ok((asked, jobs))
    }

    fn point(&self, point: &Point<'_>) -> Result<Job> {
        let mass = point.values.iter().find(|(name, _)| *name == Name::TargetMass);
        Ok(Job {
            file: self.name(&point.file_part(), "osim"),
            asked: point.values.iter().map(|(_, value)| value.exact()).collect(),
            operation: format!("sweep {point}"),
            mass_kg: mass.map(|(_, value)| value.number),
            stages: stages::of_point(self.args, point)?,
        })
    }

    fn step(&self, ladder: &Ladder, index: usize) -> Result<Job> {
        let (number, count) = (index + 1, ladder.len());
        let width = count.to_string().len();
        let stiffness = ladder.dimensionless_stiffness(index).map(osim_patch::shortest).unwrap_or_default();
        Ok(Job {
            file: self.name(&format!("ladder-{number:0width$}-of-{count}"), "osim"),
            asked: vec![number.to_string(), stiffness],
            operation: format!("ladder step {number} of {count}"),
            mass_kg: None,
            stages: ladder.stages(self.args, index)?,
        })
    }

    /// `NAME_part.extension`
    fn name(&self, part: &str, extension: &str) -> String {
        format!("{}_{part}.{extension}", stem(&self.args.model).to_string_lossy())
    }

    /// Count and size, before anything is made.
    fn announce(&self, count: usize, terminal: &mut Terminal) -> Result<()> {
        if self.args.quiet {
            return Ok(());
        }
        let size = self.loaded.bytes.len();
        #[expect(clippy::cast_precision_loss, reason = "shown in MB")]
        let megabytes = |bytes: usize| bytes as f64 / 1e6;
        let text = format!(
            "note: {count} models of {:.2} MB each, {:.1} MB together, into {}\n",
            megabytes(size),
            megabytes(size.saturating_mul(count)),
            self.folder.display()
        );
        Ok(terminal.note(&text)?)
    }

    /// Nothing is replaced without `--force`, and that is known before the first file is written.
    fn check_new(&self, jobs: &[Job], manifest: &Path) -> Result<()> {
        let names = jobs.iter().map(|job| self.folder.join(&job.file));
        let all: Vec<PathBuf> = names.chain(std::iter::once(manifest.to_owned())).collect();
        let model = crate::paths::resolved(&self.args.model);
        if all.iter().any(|path| crate::paths::resolved(path) == model) {
            bail!("a variant would replace the model itself: write into another folder with -d DIR");
        }
        let there: Vec<&PathBuf> = all.iter().filter(|path| path.exists()).collect();
        match there.first() {
            Some(first) if !self.args.force => bail!(
                "{} of these files exist already, such as {}: replace them with --force, or choose another folder \
                 with -d DIR",
                there.len(),
                first.display()
            ),
            _ => Ok(()),
        }
    }

    fn mode(&self) -> Mode {
        if self.args.force { Mode::Replace } else { Mode::New }
    }

    fn make(&self, job: &Job) -> Made {
        if interrupt::came() {
            return Made::NotBegun;
        }
        let path = self.folder.join(&job.file);
        let variant = Variant::of(self.args, self.loaded, &job.stages, &job.operation, job.mass_kg);
        let row = variant.and_then(|variant| {
            self.write(&path, &variant)
                .and_then(|()| manifest::row(&job.file, &job.asked, &variant))
                .map_err(|error| Failure::outside(&path.display().to_string(), "output", &error))
        });
        match row {
            Ok(row) => Made::Row(row),
            Err(failure) => {
                let message = format!("{} ({})", failure.message, job.operation);
                Made::Failed(Failure { message, ..failure })
            }
        }
    }

    fn write(&self, path: &Path, variant: &Variant) -> Result<()> {
        let like = self.loaded.stamp.as_ref().map(|stamp| &stamp.metadata);
        let prepared = Prepared::new(path, &variant.bytes, like, self.mode())?;
        if prepared.replaces() {
            prepared.sync()?;
        }
        prepared.commit().context("not written")
    }

    fn tell(
        &self,
        manifest: Option<&Path>,
        made: usize,
        failed: usize,
        terminal: &mut Terminal,
    ) -> Result<Exit> {
        let manifest = manifest.map(|path| path.display().to_string());
        if self.args.format == Format::Json {
            terminal.print(&json::line(&JsonSweep {
                schema_version: 1,
                model: &self.loaded.shown,
                manifest,
                folder: self.folder.display().to_string(),
                models: made,
                failed,
            }))?;
        } else if !self.args.quiet {
            let text = match &manifest {
                Some(manifest) => format!("{made} models written; what is in which: {manifest}\n"),
                None => "dry run: nothing written\n".to_owned(),
            };
            terminal.print(&text)?;
        }
        Ok(if failed > 0 { Exit::Failed } else { Exit::Done })
    }
}
