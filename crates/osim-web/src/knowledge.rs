//! What is known apart from models: calculations, explanations, presets.

use osim_planning::{DesignSheet, design_sheet, find_presets};
use osim_requests::Request;
use osim_requests::spell::{CommandLine, Matlab, Page, Python, Speller};
use osim_view::report::explain::{Letters, answer};
use osim_view::report::results::{PresetRecord, design_sheet_text, preset_text};
use serde::Serialize;

use crate::problem::Problem;
use crate::question::Fields;
use crate::shelf::Shelf;

/// What `design` computes without a model.
#[derive(Debug, Serialize)]
pub(crate) struct Calculated {
    sheet: DesignSheet,
    text: String,
}

/// Calculates.
pub(crate) fn calculate(request: &Request) -> Result<Calculated, Problem> {
    let Request::Design(request) = request else {
        return Err(Problem::question("only a request for design calculates without a model"));
    };
    let sheet = design_sheet(request)?;
    let text = design_sheet_text(&sheet);
    Ok(Calculated { sheet, text })
}

/// A preset.
#[derive(Debug, Serialize)]
pub(crate) struct PresetShown {
    #[serde(flatten)]
    record: PresetRecord,
    text: String,
}

/// The presets that there are, or those of a file.
pub(crate) fn presets(mut fields: Fields, shelf: &Shelf) -> Result<Vec<PresetShown>, Problem> {
    fields.insert("verb".to_owned(), "presets".into());
    let Request::Presets(request) = Request::from_map(fields)? else { return Ok(Vec::new()) };
    let presets = find_presets(&request, shelf)?;
    let shown = |preset| PresetShown { record: PresetRecord::from(preset), text: preset_text(preset) };
    Ok(presets.iter().map(shown).collect())
}

/// Explains a topic in words.
pub(crate) fn explain(topic: &str) -> Result<String, Problem> {
    let fields = [("verb", "explain"), ("topics", topic)];
    let fields: Fields = fields.map(|(name, value)| (name.to_owned(), value.into())).into_iter().collect();
    let Request::Explain(request) = Request::from_map(fields)? else { return Ok(String::new()) };
    answer(&request, Letters::Unicode, &Page).map_err(|unknown| Problem::question(unknown.message(&Page)))
}

// A request as calls that people can copy: of the command, of Python, of MATLAB.

/// The three calls of one request. Each does what the request asks for: it reads the same models and writes the same files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Calls {
    /// A line for a terminal.
    command: String,
    /// Lines of Python, from the import on.
    python: String,
    /// A line of MATLAB or GNU Octave.
    matlab: String,
}

impl Calls {
    pub(crate) fn of(request: &Request) -> Self {
        Self {
            command: CommandLine.script(request),
            python: Python.script(request),
            matlab: Matlab.script(request),
        }
    }
}
