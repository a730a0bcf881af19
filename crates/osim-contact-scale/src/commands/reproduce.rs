//! `reproduce`: what the paper prints and draws, computed again.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use contact_plots::Paper;
use osim_library::{Mode, Prepared, make_folder_of};
use osim_model::files::Failure;
use osim_model::messages::Input;
use osim_requests::options::Format;
use osim_requests::{PlotKind, PlotRequest, ReproduceRequest};
use osim_view::figures;
use osim_view::report::json::line;
use osim_view::report::reproduce::{ReproductionRecord, fig1_text, reproduction_csv, reproduction_text};

use crate::exit::Exit;
use crate::session::Session;

/// Compares, draws and writes.
///
/// # Errors
/// A file that is there already, or a folder that cannot be written.
pub(super) fn run(request: &ReproduceRequest, session: &mut Session) -> Result<Exit> {
    let json = request.format == Format::Json;
    let record = match ReproductionRecord::new(session.words) {
        Ok(record) => record,
        Err(failure) => return session.fail(&failure, json),
    };
    let mut written = String::new();
    if let Some(folder) = &request.output_dir {
        let files = match files(folder, &record)? {
            Ok(files) => files,
            Err(failure) => return session.fail(&failure, json),
        };
        write(&files, request.force, session)?;
        for (path, _) in &files {
            written.push_str(&format!("written to {}\n", path.display()));
        }
    }
    if json {
        session.terminal.print_records(&line(&record))?;
        session.terminal.note(&written)?;
    } else {
        let gap = if written.is_empty() { "" } else { "\n" };
        let text = format!("{}\n{}{gap}{written}", reproduction_text(&record), fig1_text(&record));
        session.terminal.print(&text)?;
    }
    Ok(Exit::Done)
}

/// What goes into the folder: the table and both figures.
fn files(folder: &Path, record: &ReproductionRecord) -> Result<Result<Vec<(PathBuf, String)>, Failure>> {
    let mut files = vec![(folder.join("table1.csv"), reproduction_csv(record)?)];
    for (name, kind) in [("fig4.svg", PlotKind::Fig4), ("fig-c5.svg", PlotKind::FigC5)] {
        let request = PlotRequest { kind: Some(kind), ..PlotRequest::default() };
        let drawing = figures::draw(&request, &[], None);
        match drawing.and_then(|drawing| figures::svg(&drawing, Paper::default(), &[])) {
            Ok(svg) => files.push((folder.join(name), svg)),
            Err(failure) => return Ok(Err(failure)),
        }
    }
    Ok(Ok(files))
}

/// Writes all of them. If one of them exists and may not be replaced, writes none.
fn write(files: &[(PathBuf, String)], force: bool, session: &Session) -> Result<()> {
    if let Some((there, _)) = files.iter().find(|(path, _)| !force && path.exists()) {
        let [folder, force] = [Input::OutputDir, Input::Force].map(|input| session.words.input(input, None));
        bail!(
            "{} exists already: choose another folder with {folder}, or replace it with {force}",
            there.display()
        );
    }
    let refused = |fault| session.refused(&fault);
    let mode = if force { Mode::Replace } else { Mode::New };
    let mut prepared = Vec::new();
    for (path, text) in files {
        make_folder_of(path).map_err(refused)?;
        prepared.push(Prepared::new(path, text.as_bytes(), None, mode).map_err(refused)?);
    }
    prepared.into_iter().try_for_each(Prepared::commit).map_err(refused)
}
