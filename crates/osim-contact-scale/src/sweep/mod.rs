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

use anyhow::{Context, Result, anyhow, bail};
use serde::Serialize;

use crate::args::{Format, SweepArgs};
use crate::failure::Failure;
use crate::folders::{self, Folders};
use crate::load::Loaded;
use crate::paths::{Resolver, resolved};
use crate::report::json;
use crate::run::{Progress, interrupt};
use crate::sources::Source;
use crate::terminal::{Exit, Terminal};
use crate::workers::{in_order, threads};
use crate::write::{Mode, Prepared};

use grid::{Name, Point, count, ends, point};
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
    let Some(made) = made else { bail!("more models than can be counted: give fewer values") };
    if made > MANY && !args.yes && !args.dry_run {
        bail!("{made} models would be made, more than 10,000: say --yes, or give fewer values");
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
    let sweep = Sweep { args, loaded: &loaded, folder: folder(args), ladder, made };
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
    /// How many variants.
    made: usize,
}

/// One file to make.
struct Job {
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
        let manifest =
            self.folder.join(self.name(if self.ladder.is_some() { "ladder" } else { "sweep" }, "csv"));
        self.check_points()?;
        self.announce(terminal)?;
        if self.args.dry_run {
            return self.tell(None, self.made, 0, terminal);
        }
        self.check_new(&manifest)?;
        folders::make(&manifest)?;
        // Files left behind by a run that was killed go first.
        Folders::look(std::iter::once(manifest.as_path()), true);
        let mut table = Prepared::begin(&manifest, None, self.mode())?;
        table.add(&manifest::header(&self.asked())?)?;
        let (mut failed, mut not_begun) = (0, 0);
        interrupt::listen();
        interrupt::outlive_size_limit();
        let progress = Progress::begin(self.made, self.args.quiet);
        let work = |&index: &usize| {
            let made = self.make(index);
            progress.done(matches!(made, Made::Failed(_)));
            made
        };
        let each = |_: &usize, made: Made| match made {
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
        let indices: Vec<usize> = (0..self.made).collect();
        in_order(&indices, threads(self.args.jobs, self.made), work, each)?;
        progress.end();
        let done = self.made - failed - not_begun;
        if done > 0 {
            table.commit()?;
        }
        if not_begun > 0 {
            terminal.note(&format!("note: stopped: {done} of {} models are made\n", self.made))?;
        }
        let exit = self.tell((done > 0).then_some(manifest.as_path()), done, failed, terminal)?;
        Ok(if not_begun > 0 { Exit::Interrupted } else { exit })
    }

    /// Columns of what is asked.
    fn asked(&self) -> Vec<String> {
        match self.ladder {
            Some(_) => vec!["step".to_owned(), "wanted_dimensionless_stiffness".to_owned()],
            None => self.args.grid.iter().map(|axis| format!("grid_{}", axis.name.as_str())).collect(),
        }
    }

    /// What a variant asks for may make no sense: that shows before anything is written.
    ///
    /// # Errors
    /// Wrong usage, with the point.
    fn check_points(&self) -> Result<()> {
        let points =
            if self.ladder.is_some() { vec![0, self.made.saturating_sub(1)] } else { ends(&self.args.grid) };
        for index in points {
            let job = self.job(index)?;
            Variant::of(self.args, self.loaded, &job.stages, &job.operation, job.mass_kg)
                .map_err(|failure| anyhow!("{} ({})", failure.message, job.operation))?;
        }
        Ok(())
    }

    /// What makes variant `index`.
    fn job(&self, index: usize) -> Result<Job> {
        match &self.ladder {
            Some(ladder) => self.step(ladder, index),
            None => self.point(&point(&self.args.grid, index)),
        }
    }

    /// Name of the file of variant `index`.
    fn file(&self, index: usize) -> String {
        let part = match &self.ladder {
            Some(ladder) => ladder.file_part(index),
            None => point(&self.args.grid, index).file_part(),
        };
        self.name(&part, "osim")
    }

    fn point(&self, point: &Point<'_>) -> Result<Job> {
        let mass = point.values.iter().find(|(name, _)| *name == Name::TargetMass);
        Ok(Job {
            asked: point.values.iter().map(|(_, value)| value.exact()).collect(),
            operation: format!("sweep {point}"),
            mass_kg: mass.map(|(_, value)| value.number),
            stages: stages::of_point(self.args, point)?,
        })
    }

    fn step(&self, ladder: &Ladder, index: usize) -> Result<Job> {
        let (number, count) = (index + 1, ladder.len());
        let stiffness = ladder.dimensionless_stiffness(index).map(osim_patch::shortest).unwrap_or_default();
        Ok(Job {
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
    fn announce(&self, terminal: &mut Terminal) -> Result<()> {
        if self.args.quiet {
            return Ok(());
        }
        let (size, count) = (self.loaded.bytes.len(), self.made);
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
    fn check_new(&self, manifest: &Path) -> Result<()> {
        let names = (0..self.made).map(|index| self.folder.join(self.file(index)));
        let model = resolved(&self.args.model);
        let mut resolver = Resolver::default();
        let (mut first, mut there) = (None, 0);
        for path in names.chain(std::iter::once(manifest.to_owned())) {
            if resolver.resolved(&path) == model {
                bail!("a variant would replace the model itself: write into another folder with -d DIR");
            }
            if path.exists() {
                there += 1;
                first.get_or_insert(path);
            }
        }
        match first {
            Some(first) if !self.args.force => bail!(
                "{there} of these files exist already, such as {}: replace them with --force, or choose another folder \
                 with -d DIR",
                first.display()
            ),
            _ => Ok(()),
        }
    }

    fn mode(&self) -> Mode {
        if self.args.force { Mode::Replace } else { Mode::New }
    }

    fn make(&self, index: usize) -> Made {
        if interrupt::came() {
            return Made::NotBegun;
        }
        let file = self.file(index);
        let path = self.folder.join(&file);
        let outside = |error: anyhow::Error| Failure::outside(&path.display().to_string(), "output", &error);
        let job = match self.job(index) {
            Ok(job) => job,
            Err(error) => return Made::Failed(Failure::outside(&self.loaded.shown, "refused", &error)),
        };
        let variant = Variant::of(self.args, self.loaded, &job.stages, &job.operation, job.mass_kg);
        let row = variant.and_then(|variant| {
            let written = self.write(&path, &variant);
            written.and_then(|()| manifest::row(&file, &job.asked, &variant)).map_err(outside)
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
        self.loaded.find_included_from(path)?;
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
                Some(manifest) => {
                    let of = if made < self.made { format!(" of {}", self.made) } else { String::new() };
                    format!("{made}{of} models written; what is in which: {manifest}\n")
                }
                None if self.args.dry_run && self.made > MANY => {
                    "dry run: nothing written; more than 10,000 models need --yes\n".to_owned()
                }
                None if self.args.dry_run => "dry run: nothing written\n".to_owned(),
                None => "no model was made\n".to_owned(),
            };
            terminal.print(&text)?;
        }
        Ok(if failed > 0 { Exit::Failed } else { Exit::Done })
    }
}
