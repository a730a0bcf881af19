//! `design`, `drop-test`, `fit`, `motion`, `reproduce`, `explain` and `presets`: verbs that print an answer and change no model.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use contact_plots::Paper;
use osim_library::{Disk, LibraryFault, MotionFiles, WriteMode, make_folder_of, write_files};
use osim_model::messages::{Input, Verb};
use osim_planning::{
    NextModels, design_sheet, find_presets, presets_of_unlike_spheres, run_drop_test, run_fit, run_motion,
};
use osim_requests::options::Format;
use osim_requests::{
    DesignRequest, DropTestRequest, ExplainRequest, FitRequest, MotionFormat, MotionRequest, PlotKind,
    PlotRequest, PresetsRequest, ReproduceRequest, SeriesFormat,
};
use osim_view::figures;
use osim_view::report::explain::{Alphabet, answer};
use osim_view::report::json::line;
use osim_view::report::layout::WIDTH;
use osim_view::report::messages::mass_mismatch;
use osim_view::report::reproduce::{ReproductionRecord, fig1_text, reproduction_csv, reproduction_text};
use osim_view::report::results::{
    DropRecord, FitRecord, MotionRecord, PresetRecord, design_sheet_text, drop_chart, drop_csv, drop_text,
    fit_text, motion_csv, motion_text, preset_text,
};

use crate::exit::Exit;
use crate::one_call::Session;

/// Calculates a design and prints its values.
///
/// # Errors
/// The request has too few values, or values that contradict each other.
pub(crate) fn design(request: &DesignRequest, session: &mut Session) -> Result<Exit> {
    let sheet = design_sheet(request).map_err(|fault| session.usage_error(&fault))?;
    let json = request.run.is_json();
    let text = if json { line(&sheet) } else { design_sheet_text(&sheet, session.terminal.columns()) };
    session.terminal.print_as(&text, json)?;
    Ok(Exit::Done)
}

// `drop-test`: what contacts do when their body falls on them.

/// Lets a body fall on its contacts and prints the movement.
///
/// # Errors
/// Wrong usage: numbers are missing or contradict a model.
pub(crate) fn drop_test(request: &DropTestRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.subject.iter().chain(&request.compare).find(|path| path.is_dir()) {
        bail!("{}", refusal_of_folder(&folder.display().to_string(), session));
    }
    let drop = run_drop_test(request, &Disk)
        .map_err(|error| session.refuse(error, request.format == SeriesFormat::Json))?;
    let columns = session.terminal.columns();
    let text = match request.format {
        SeriesFormat::Json => line(&DropRecord(&drop)),
        SeriesFormat::Csv => drop_csv(&drop)?,
        // A terminal can draw.
        _ if std::io::stdout().is_terminal() => {
            format!("{}{}", drop_text(&drop, columns), drop_chart(&drop, columns))
        }
        _ => drop_text(&drop, columns),
    };
    let is_for_programs = matches!(request.format, SeriesFormat::Json | SeriesFormat::Csv);
    session.terminal.print_as(&text, is_for_programs)?;
    for (name, mismatch) in &drop.mismatches {
        session.terminal.print_to_stderr(&mass_mismatch(name, mismatch, session.words))?;
    }
    Ok(Exit::Done)
}

/// The message that a folder cannot fall: each of its models needs a call of its own.
fn refusal_of_folder(folder: &str, session: &Session) -> String {
    format!(
        "'{folder}' is a folder, and one body falls at a time: name a model in it. `{} {}` has \
         indentation, stiffness and restitution of all its models",
        session.words.command(&Verb::Inspect.call()),
        session.words.word(folder)
    )
}

// `fit`: contact parameters from a measured indentation and force; a fit to recordings is a change of a model.

/// Fits parameters to measurements and prints them.
///
/// # Errors
/// Wrong usage.
pub(crate) fn fit(request: &FitRequest, session: &mut Session) -> Result<Exit> {
    let json = request.run.is_json();
    let fit = run_fit(request, &Disk).map_err(|error| session.refuse(error, json))?;
    let text = if json {
        line(&FitRecord::from(&fit))
    } else {
        fit_text(&fit, session.words, session.terminal.columns())
    };
    session.terminal.print_as(&text, json)?;
    Ok(Exit::Done)
}

// `reproduce`: what the paper prints and draws, computed again.

/// Compares the paper's numbers with the equations, and writes the table and figures if the request names a folder.
///
/// # Errors
/// A file exists already, or the folder cannot be written.
pub(crate) fn reproduce(request: &ReproduceRequest, session: &mut Session) -> Result<Exit> {
    let json = request.format == Format::Json;
    let record = ReproductionRecord::new(session.words).map_err(|failure| session.refuse(failure, json))?;
    let mut written = String::new();
    if let Some(folder) = &request.output_dir {
        let files = output_files(folder, &record, json, session)?;
        write_into_folder(&files, request.force, session)?;
        written.extend(files.iter().map(|(path, _)| format!("written to {}\n", path.display())));
    }
    if json {
        session.terminal.print_records(&line(&record))?;
        session.terminal.print_to_stderr(&written)?;
    } else {
        let gap = if written.is_empty() { "" } else { "\n" };
        let columns = session.terminal.columns();
        let texts = [reproduction_text(&record, columns), fig1_text(&record, columns)].join("\n");
        let text = format!("{texts}{gap}{written}");
        session.terminal.print(&text)?;
    }
    Ok(Exit::Done)
}

/// Writes files into a folder, which is made where it is not there.
///
/// # Errors
/// A file exists already, or the folder cannot be written.
pub(crate) fn write_into_folder<B: AsRef<[u8]>>(
    files: &[(PathBuf, B)],
    force: bool,
    session: &Session,
) -> Result<()> {
    if let Some((there, _)) = files.iter().find(|(path, _)| !force && path.exists()) {
        return Err(session.file_error(&LibraryFault::file_exists(there, Input::OutputDir)));
    }
    let mode = if force { WriteMode::Replace } else { WriteMode::New };
    let made = files.iter().try_for_each(|(path, _)| make_folder_of(path));
    made.and_then(|()| write_files(files.iter().map(|(path, bytes)| (path.as_path(), bytes.as_ref())), mode))
        .map_err(|fault| session.file_error(&fault))
}

/// Paths and texts of the files that a reproduction writes into `folder`: the table and both figures.
fn output_files(
    folder: &Path,
    record: &ReproductionRecord,
    json: bool,
    session: &mut Session,
) -> Result<Vec<(PathBuf, String)>> {
    let mut files = vec![(folder.join("table1.csv"), reproduction_csv(record)?)];
    for (name, kind) in [("fig4.svg", PlotKind::Fig4), ("fig-c5.svg", PlotKind::FigC5)] {
        let request = PlotRequest { kind: Some(kind), ..PlotRequest::default() };
        let drawing = figures::draw(&request, &[], None);
        let svg = drawing.and_then(|drawing| figures::svg(&drawing, Paper::default(), &[]));
        files.push((folder.join(name), svg.map_err(|failure| session.refuse(failure, json))?));
    }
    Ok(files)
}

// `explain`: equations, quantities, and the codes of findings and errors.

/// Explains an equation, a quantity or a code; without a topic, lists all topics.
///
/// # Errors
/// The topic is neither an equation nor a code.
pub(crate) fn explain(request: &ExplainRequest, session: &mut Session) -> Result<Exit> {
    let words = session.words;
    // Files and pipes always show letters beyond ASCII.
    let is_unicode = supports_unicode::on(supports_unicode::Stream::Stdout);
    let letters = if is_unicode { Alphabet::Unicode } else { Alphabet::Ascii };
    let width = session.terminal.columns().unwrap_or(WIDTH);
    let shown = answer(request, letters, words, width).map_err(|unknown| anyhow!(unknown.message(words)))?;
    session.terminal.print_as(&shown, request.format == Format::Json)?;
    Ok(Exit::Done)
}

// `presets`: published contacts, and the user's own.

/// Lists all presets, or shows one preset.
///
/// # Errors
/// The file of presets cannot be read, or the name is unknown.
pub(crate) fn presets(request: &PresetsRequest, session: &mut Session) -> Result<Exit> {
    // A record has one radius for all spheres.
    let (is_text, named) = (request.format != Format::Json, request.name.as_deref());
    let presets = match find_presets(request, &Disk) {
        Err(_) if is_text && presets_of_unlike_spheres(&[]).any(|name| named == Some(name)) => Vec::new(),
        found => found.map_err(|fault| session.usage_error(&fault))?,
    };
    let columns = session.terminal.columns();
    for (index, preset) in presets.iter().enumerate() {
        let text = match request.format {
            Format::Json => line(&PresetRecord::from(preset)),
            _ if index == 0 => preset_text(preset, columns),
            _ => format!("\n{}", preset_text(preset, columns)),
        };
        session.terminal.print_as(&text, request.format == Format::Json)?;
    }
    let is_shown = |name: &&str| is_text && named.is_none_or(|one| one == *name);
    for name in presets_of_unlike_spheres(&presets).filter(is_shown) {
        let gap = if presets.is_empty() { "" } else { "\n" };
        let text = "spheres with radii and places of their own; add, transfer and drop-test take it";
        session.terminal.print(&format!("{gap}{name}\n{text}\n"))?;
    }
    Ok(Exit::Done)
}

/// Computes the contact forces along a recorded motion, prints them and writes the files that the request names.
///
/// # Errors
/// Wrong usage, or a file that exists already.
pub(crate) fn motion(request: &MotionRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.subject.iter().find(|path| path.is_dir()) {
        bail!("'{}' is a folder, and a motion is that of one model: name a model in it", folder.display());
    }
    let files = MotionFiles::of(request).map_err(|fault| session.file_error(&fault))?;
    let json = request.format == MotionFormat::Json;
    let result = run_motion(request, &Disk).map_err(|error| session.refuse(error, json))?;
    let next = NextModels::new(request, &result, &Disk).map_err(|error| session.refuse(error, json))?;
    let remarks = result.remarks(request);
    let text = match request.format {
        MotionFormat::Json => line(&MotionRecord::new(&result, &remarks, session.words)),
        MotionFormat::Csv => motion_csv(&result)?,
        _ => motion_text(&result, &remarks, session.words, session.terminal.columns()),
    };
    let written = files.write(&result, &next).map_err(|fault| session.file_error(&fault))?;
    let written: String = written.iter().map(|path| format!("written to {}\n", path.display())).collect();
    let is_for_programs = matches!(request.format, MotionFormat::Json | MotionFormat::Csv);
    session.terminal.print_as(&text, is_for_programs)?;
    session.terminal.print_to_stderr(&written)?;
    let is_uncorrected = result.consistency.is_some_and(|one| one.correction.is_none());
    Ok(if is_uncorrected { Exit::Failed } else { Exit::Done })
}
