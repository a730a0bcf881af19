//! `plot`: what contacts do, as SVG or PNG.

use std::path::Path;

use anyhow::{Result, bail};
use osim_library::run::PathConflicts;
use osim_library::{Disk, Mode, Prepared};
use osim_model::wording::Input;
use osim_report::figures;
use osim_report::messages::mass_mismatch;
use osim_requests::PlotRequest;

use crate::session::Session;
use crate::terminal::Exit;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Picture {
    Svg,
    Png,
}

/// Draws and writes one figure.
///
/// # Errors
/// Wrong usage: an ending that is not a picture's, a body too many or too few, a file that is there already.
pub(super) fn run(request: &PlotRequest, session: &mut Session) -> Result<Exit> {
    if let Some(folder) = request.models.iter().find(|path| path.is_dir()) {
        bail!(
            "'{}' is a folder, and a figure shows one model, or a few: name models in it",
            folder.display()
        );
    }
    let output = Output::of(request, session)?;
    request.check_models().map_err(|fault| session.usage(&fault))?;
    if request.is_of_feet() {
        return feet(request, &output, session);
    }
    let bodies = match request.bodies(&Disk) {
        Ok(bodies) => bodies,
        Err(error) => return session.refuse(error, false),
    };
    let svg = match figures::draw(request, &bodies) {
        Ok(svg) => svg,
        Err(failure) => return session.fail(&failure, false),
    };
    for body in &bodies {
        if let Some(mismatch) = &body.mismatch {
            session.terminal.note(&mass_mismatch(&body.name, mismatch, session.words))?;
        }
    }
    output.write(&svg, &figures::weights(&bodies, session.words), request, session)
}

/// Draws and writes a figure of feet.
///
/// # Errors
/// As [`run`].
fn feet(request: &PlotRequest, output: &Output<'_>, session: &mut Session) -> Result<Exit> {
    let states = match request.feet(&Disk) {
        Ok(states) => states,
        Err(error) => return session.refuse(error, false),
    };
    let name = states.first().map(|state| state.name.as_str()).unwrap_or_default();
    match figures::feet_svg(&states, name, request.title.as_deref()) {
        Ok(svg) => output.write(&svg, &figures::feet_notes(&states, session.words), request, session),
        Err(failure) => session.fail(&failure, false),
    }
}

/// A file of a format, or standard output.
struct Output<'o> {
    /// `None` is standard output.
    path: Option<&'o Path>,
    picture: Picture,
}

impl<'o> Output<'o> {
    /// What the request says, checked before anything is computed.
    ///
    /// # Errors
    /// An ending that is neither `.svg` nor `.png`, or a file that is read.
    fn of(request: &'o PlotRequest, session: &Session) -> Result<Self> {
        let Some(path) = request.output.as_deref() else { bail!("no output given") };
        if path.as_os_str() == "-" {
            return Ok(Self { path: None, picture: Picture::Svg });
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let picture = match ending.as_deref() {
            Some("svg") => Picture::Svg,
            Some("png") if cfg!(feature = "png") => Picture::Png,
            Some("png") => bail!("this program was built without PNG: write to a name that ends in .svg"),
            _ => bail!(
                "{} '{}': expected a name that ends in .svg or .png",
                session.words.input(Input::Output, None),
                path.display()
            ),
        };
        let mut conflicts = PathConflicts::default();
        for read in request.models.iter().chain(&request.presets) {
            conflicts.read(read.as_path());
        }
        conflicts.write(path, "the figure").map_err(|fault| session.refused(&fault))?;
        Ok(Self { path: Some(path), picture })
    }

    /// Writes the figure and says what is on it.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    fn write(&self, svg: &str, notes: &str, request: &PlotRequest, session: &mut Session) -> Result<Exit> {
        let Some(path) = self.path else {
            session.terminal.print(svg)?;
            session.terminal.note(notes)?;
            return Ok(Exit::Done);
        };
        let refused = |fault| session.refused(&fault);
        let bytes = match self.picture {
            Picture::Svg => svg.as_bytes().to_vec(),
            Picture::Png => pixels(svg, request)?,
        };
        let mode = if request.force { Mode::Replace } else { Mode::New };
        Prepared::new(path, &bytes, None, mode).and_then(Prepared::commit).map_err(refused)?;
        session.terminal.print(&format!("{notes}written to {}\n", path.display()))?;
        Ok(Exit::Done)
    }
}

#[cfg(feature = "png")]
fn pixels(svg: &str, request: &PlotRequest) -> Result<Vec<u8>> {
    Ok(contact_plots::png(svg, f32::from(request.dpi.get()))?)
}

#[cfg(not(feature = "png"))]
fn pixels(_svg: &str, request: &PlotRequest) -> Result<Vec<u8>> {
    bail!("this program was built without PNG, at {} dpi or any other", request.dpi)
}
