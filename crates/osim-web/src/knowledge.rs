//! The calls that the web page can make, and answers that need no model: calculations, explanations, presets.

use osim_planning::{design_sheet, find_presets};
use osim_requests::Request;
use osim_requests::spell::{CommandLine, FrontEnd, Matlab, Page, Python};
use osim_view::report::explain::{Alphabet, answer};
use osim_view::report::layout::WIDTH;
use osim_view::report::results::{PresetRecord, design_sheet_text, preset_text};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use crate::given_files::GivenFiles;
use crate::problem::{Problem, Result};

/// What `design` computes without a model: its sheet, and the same as text.
pub(crate) fn calculate(request: &Request) -> Result<Value> {
    let Request::Design(request) = request else {
        return Err(Problem::wrong_call("only a request for design calculates without a model"));
    };
    let sheet = design_sheet(request)?;
    Ok(json!({ "sheet": sheet, "text": design_sheet_text(&sheet, None) }))
}

/// A preset as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct PresetShown {
    #[serde(flatten)]
    record: PresetRecord,
    text: String,
}

/// The presets of this program, or the presets in a file of the user.
pub(crate) fn presets(mut fields: Fields, files: &GivenFiles) -> Result<Vec<PresetShown>> {
    fields.insert("verb".to_owned(), "presets".into());
    let Request::Presets(request) = Request::from_map(fields)? else { return Ok(Vec::new()) };
    let presets = find_presets(&request, files)?;
    let shown = |preset| PresetShown { record: PresetRecord::from(preset), text: preset_text(preset, None) };
    Ok(presets.iter().map(shown).collect())
}

pub(crate) fn explain(topic: &str) -> Result<String> {
    let fields = [("verb", "explain"), ("topics", topic)];
    let fields: Fields = fields.map(|(name, value)| (name.to_owned(), value.into())).into_iter().collect();
    let Request::Explain(request) = Request::from_map(fields)? else { return Ok(String::new()) };
    answer(&request, Alphabet::Unicode, &Page, WIDTH)
        .map_err(|unknown| Problem::wrong_call(unknown.message(&Page)))
}

// A request as calls that people can copy: of the command, of Python, of MATLAB.

/// The three calls of one request: a line for a terminal, lines of Python, a line of MATLAB or GNU Octave. Each does what the request
/// asks for: it reads the same models and writes the same files.
pub(crate) fn spelled_calls(request: &Request) -> Value {
    json!({
        "command": CommandLine.script(request),
        "python": Python.script(request),
        "matlab": Matlab.script(request),
    })
}

// What the page may call.

/// The fields of a request, as `schemas/requests/` has them.
pub(crate) type Fields = Map<String, Value>;

/// A call of the page, in JSON: `{"do": "look", "model": "human.osim"}`.
#[derive(Debug, Deserialize)]
#[serde(tag = "do", rename_all = "lowercase", deny_unknown_fields)]
pub enum EngineCall {
    /// Asks for the contents of a model, and for what is wrong with it. `fields` are those of a request to inspect; with `from`, of one to
    /// check. `parts` are the sections to make; `None` for all.
    Look {
        model: String,
        #[serde(default)]
        fields: Fields,
        parts: Option<Vec<String>>,
    },
    /// The bones of a model, as surfaces. `fields` are those of a request to inspect.
    Bones {
        model: String,
        #[serde(default)]
        fields: Fields,
    },
    /// The model along a recording, frame by frame. The request has a motion and its plates.
    Play { request: Fields },
    /// The smallest correction of a recording that makes contacts give the forces of plates. The request has the name of the new file.
    Correct { request: Fields },
    /// What a change would do to one model. It is kept as the last change. The request has its verb and one model; `parts` are the
    /// sections to make, `None` for all.
    Change { request: Fields, parts: Option<Vec<String>> },
    /// The lines that the last change changes.
    Diff,
    /// Keep the files of the last change under their names.
    Keep,
    /// The report about a change, or about a model that is inspected.
    Report { request: Fields },
    /// What `design` computes without a model.
    Calculate { request: Fields },
    /// A request as calls that people can copy.
    Spell { request: Fields },
    /// Animals that fall on the contacts of a human, and on their own.
    Animals,
    /// An equation, a quantity or a code, by its number or name.
    Explain { topic: String },
    /// The presets there are, perhaps with a file of one's own.
    Presets {
        #[serde(default)]
        fields: Fields,
    },
}
