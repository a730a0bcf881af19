//! Where a figure goes, and in which format.

use std::path::Path;

use anyhow::{Result, bail};

use super::body::Body;
use crate::args::PlotArgs;
use crate::place::Ledger;
use crate::report::number;
use crate::terminal::{Exit, Terminal};
use crate::write::{Mode, Prepared};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
}

/// A file of a format, or standard output.
pub(super) struct Output<'o> {
    /// `None` is standard output.
    path: Option<&'o Path>,
    format: Format,
}

impl<'o> Output<'o> {
    /// What `--output` says, checked before anything is computed.
    ///
    /// # Errors
    /// An ending that is neither `.svg` nor `.png`, or a file that is read.
    pub(super) fn of(args: &'o PlotArgs) -> Result<Self> {
        let path = args.output.as_path();
        if path.as_os_str() == "-" {
            return Ok(Self { path: None, format: Format::Svg });
        }
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let format = match ending.as_deref() {
            Some("svg") => Format::Svg,
            Some("png") if cfg!(feature = "png") => Format::Png,
            Some("png") => bail!("this program was built without PNG: write to a name that ends in .svg"),
            _ => bail!("--output '{}': expected a name that ends in .svg or .png", path.display()),
        };
        let mut ledger = Ledger::default();
        for read in args.models.iter().chain(&args.presets) {
            ledger.read(read);
        }
        ledger.write(path, "the figure")?;
        Ok(Self { path: Some(path), format })
    }

    /// Writes the figure and says what is on it.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    pub(super) fn write(
        &self,
        svg: &str,
        bodies: &[Body],
        args: &PlotArgs,
        terminal: &mut Terminal,
    ) -> Result<Exit> {
        let Some(path) = self.path else {
            terminal.print(svg)?;
            terminal.note(&said(bodies))?;
            return Ok(Exit::Done);
        };
        let bytes = match self.format {
            Format::Svg => svg.as_bytes().to_vec(),
            Format::Png => pixels(svg, args)?,
        };
        let mode = if args.force { Mode::Replace } else { Mode::New };
        Prepared::new(path, &bytes, None, mode)?.commit()?;
        terminal.print(&format!("{}written to {}\n", said(bodies), path.display()))?;
        Ok(Exit::Done)
    }
}

#[cfg(feature = "png")]
fn pixels(svg: &str, args: &PlotArgs) -> Result<Vec<u8>> {
    Ok(contact_plots::png(svg, f32::from(args.dpi))?)
}

#[cfg(not(feature = "png"))]
fn pixels(_svg: &str, args: &PlotArgs) -> Result<Vec<u8>> {
    bail!("this program was built without PNG, at {} dpi or any other", args.dpi)
}

/// What each body is taken to weigh and to stand on; nothing where that is not known and not needed.
fn said(bodies: &[Body]) -> String {
    let line = |body: &Body| match &body.weight {
        Ok(weight) => format!(
            "{}: {} kg on {} spheres, {} m/s2\n",
            body.name,
            number(weight.mass_kg),
            number(weight.sphere_count),
            number(weight.gravity_m_s2)
        ),
        Err(failure) => format!("{}: its share of the weight is not drawn: {}\n", body.name, failure.message),
    };
    bodies.iter().map(line).collect()
}
