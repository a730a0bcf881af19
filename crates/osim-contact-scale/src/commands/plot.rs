//! `plot`: draws figures of contacts as SVG, PDF or PNG, and writes their numbers as a table.

use std::path::Path;

use anyhow::{Result, bail};
use contact_plots::Drawing;
use osim_inspect::series::ContactBody;
use osim_library::run::PathConflicts;
use osim_library::{Disk, WriteMode, require_folder_of, write_files};
use osim_model::messages::Input;
use osim_requests::PlotRequest;
use osim_view::figures;
use osim_view::report::messages::mass_mismatch;

use crate::exit::Exit;
use crate::one_call::Session;

/// The format of the picture that `plot` writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Picture {
    Svg,
    #[cfg(feature = "pdf")]
    Pdf,
    #[cfg(feature = "png")]
    Png,
}

/// Draws and writes one figure.
///
/// # Errors
/// Wrong usage: the file name has no ending of a picture, a body is missing or superfluous, or a file exists already.
pub(crate) fn run(request: &PlotRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.models.iter().find(|path| path.is_dir()) {
        bail!(
            "'{}' is a folder, and a figure shows one model, or a few: name models in it",
            folder.display()
        );
    }
    let output = PlotOutput::of(request, session)?;
    let (drawing, bodies, remarks) =
        figures::draw_request(request, &Disk, session.words).map_err(|error| session.refuse(error, false))?;
    for body in &bodies {
        if let Some(mismatch) = &body.mismatch {
            session.terminal.print_to_stderr(&mass_mismatch(&body.name, mismatch, session.words))?;
        }
    }
    output.write(&drawing, &bodies, &remarks, request, session)
}

/// The outputs of a plot: a picture in a file or on standard output, and perhaps a table of the numbers.
struct PlotOutput<'o> {
    /// The file for the picture; `None` is standard output.
    path: Option<&'o Path>,
    picture: Picture,
    data: Option<&'o Path>,
}

impl<'o> PlotOutput<'o> {
    /// The outputs that the request names, checked before anything is computed.
    ///
    /// # Errors
    /// A name does not have the ending of a picture or table, is that of a file that is read, or its folder is not there.
    fn of(request: &'o PlotRequest, session: &Session) -> Result<Self> {
        let Some(path) = request.output.as_deref() else { bail!("no output given") };
        let data = request.data.as_deref();
        let mut conflicts = PathConflicts::default();
        let recording = [&request.motion, &request.plates, &request.loads].into_iter().flatten();
        let read = request.models.iter().chain(&request.presets).chain(&request.heat.table).chain(recording);
        for read in read {
            conflicts.add_input(read.as_path());
        }
        let failed = |fault| session.file_error(&fault);
        if let Some(data) = data {
            if !data.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv")) {
                return Err(session.wrong_ending(Input::Data, data, ".csv"));
            }
            require_folder_of(data, None).map_err(failed)?;
            conflicts.add_output(data, "the table of the figure").map_err(failed)?;
        }
        if path.as_os_str() == "-" {
            return Ok(Self { path: None, picture: Picture::Svg, data });
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let picture = match ending.as_deref() {
            Some("svg") => Picture::Svg,
            #[cfg(feature = "pdf")]
            Some("pdf") => Picture::Pdf,
            #[cfg(feature = "png")]
            Some("png") => Picture::Png,
            Some(ending) if ["pdf", "png"].contains(&ending) => {
                bail!("this program was built without {ending}: write to a name that ends in .svg")
            }
            _ => return Err(session.wrong_ending(Input::Output, path, ".svg, .pdf or .png")),
        };
        require_folder_of(path, None).map_err(failed)?;
        conflicts.add_output(path, "the figure").map_err(failed)?;
        Ok(Self { path: Some(path), picture, data })
    }

    /// Writes the figure and its numbers, and prints a description of the figure.
    ///
    /// # Errors
    /// As [`PendingFile::new`].
    fn write(
        &self,
        drawing: &Drawing,
        bodies: &[ContactBody],
        remarks: &str,
        request: &PlotRequest,
        session: &mut Session,
    ) -> Result<Exit> {
        let svg = figures::svg(drawing, figures::paper_of(&request.looks), bodies)
            .map_err(|failure| session.refuse(failure, false))?;
        let mode = if request.force { WriteMode::Replace } else { WriteMode::New };
        let mut files: Vec<(&Path, Vec<u8>)> = Vec::new();
        if let Some(path) = self.path {
            let bytes = match self.picture {
                Picture::Svg => svg.as_bytes().to_vec(),
                #[cfg(feature = "pdf")]
                Picture::Pdf => contact_plots::pdf(&svg, drawing.title())?,
                #[cfg(feature = "png")]
                Picture::Png => contact_plots::png(&svg, f32::from(request.looks.dpi.get()))?,
            };
            files.push((path, bytes));
        }
        if let Some(path) = self.data {
            files.push((path, figures::data_csv(drawing)?));
        }
        // All are complete before the first gets its name.
        write_files(files.iter().map(|(path, bytes)| (*path, bytes.as_slice())), mode)
            .map_err(|fault| session.file_error(&fault))?;
        let written: String =
            files.iter().map(|(path, _)| format!("written to {}\n", path.display())).collect();
        if self.path.is_some() {
            session.terminal.print(&format!("{remarks}{written}"))?;
        } else {
            session.terminal.print_records(&svg)?;
            session.terminal.print_to_stderr(&format!("{remarks}{written}"))?;
        }
        Ok(Exit::Done)
    }
}
