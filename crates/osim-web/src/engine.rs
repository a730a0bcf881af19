//! Answers calls of the web page about models in memory.

use std::collections::BTreeMap;
use std::path::Path;
use std::rc::Rc;

use osim_model::files::{Failure, Files};
use osim_planning::scene::{AnimalFall, BoneSurfaces};
use osim_planning::{Inspector, PreparedChange, prepare};
use osim_requests::Request;
use osim_requests::options::SetFiles;
use osim_requests::spell::{CommandLine, FrontEnd, Page};
use serde::Serialize;
use serde_json::{Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::change::{self, PlannedChange, report_name};
use crate::given_files::GivenFiles;
use crate::knowledge::{self, EngineCall, Fields};
use crate::opened_model::{self, OpenedModel};
use crate::problem::{Problem, Result};
use crate::recording::{CorrectedRecording, play_recording};

/// Most models that stay open, because the page looks at one model and compares it with others.
const MOST_OPEN_MODELS: usize = 4;

/// Keeps files in memory, and answers calls about the models in them.
///
/// ```
/// use osim_web::Engine;
///
/// let mut engine = Engine::new();
/// engine.put("one_foot.osim", include_bytes!("../../osim-model/tests/data/one_foot.osim").to_vec());
/// let request = r#"{"verb": "rescale", "models": "one_foot.osim", "target_mass": 80}"#;
/// let answer = engine.call(&format!(r#"{{"do": "change", "request": {request}}}"#));
/// assert!(answer.contains("one_foot.scaled.osim"));
/// let changed = engine.result(0).unwrap();
/// assert!(String::from_utf8_lossy(&changed).contains("<radius>0.06</radius>"));
/// ```
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    files: GivenFiles,
    /// Models that were opened, the latest first.
    opened: Vec<Rc<OpenedModel>>,
    last: Option<PlannedChange>,
}

#[wasm_bindgen]
impl Engine {
    /// An engine to which no file was given yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the date, such as `2026-11-25`, for the notes in models that are changed afterwards.
    pub fn set_today(&mut self, date: &str) {
        self.files.set_today(date);
    }

    /// Adds a file, or replaces the file of the same name.
    pub fn put(&mut self, name: &str, bytes: Vec<u8>) {
        self.files.put(name, bytes);
        self.opened.clear();
    }

    /// Removes a file that the page gave to the engine.
    pub fn remove(&mut self, name: &str) {
        self.files.remove(name);
        self.opened.clear();
    }

    /// The bytes of a file, if a file has this name.
    pub fn bytes(&self, name: &str) -> Option<Vec<u8>> {
        self.files.read(Path::new(name)).ok()
    }

    /// The bytes of a file that the last change makes. The model has the `index` 0.
    pub fn result(&self, index: usize) -> Option<Vec<u8>> {
        Some(self.last.as_ref()?.results.get(index)?.bytes.clone())
    }

    /// Answers an [`EngineCall`] in JSON. The answer is `{"ok": ...}`, or `{"error": ...}` with the fault and a way out.
    pub fn call(&mut self, call: &str) -> String {
        let answer = match serde_json::from_str(call) {
            Ok(call) => self.answer(call),
            Err(error) => Err(Problem::wrong_call(format!("this question cannot be understood: {error}"))),
        };
        answer.unwrap_or_else(|problem| {
            let error = json!({ "error": problem });
            error.to_string()
        })
    }
}

/// An answer without error, in JSON.
fn ok_answer(answer: impl Serialize) -> Result<String> {
    serde_json::to_string(&BTreeMap::from([("ok", answer)])).map_err(Problem::defect)
}

impl Engine {
    fn answer(&mut self, call: EngineCall) -> Result<String> {
        match call {
            EngineCall::Look { model, fields, parts } => {
                let inspector = opened_model::inspector(&model, fields, &self.files)?;
                let opened = self.open(Path::new(&model), &inspector.set_files)?;
                ok_answer(opened_model::inspect_for_page(&inspector, &opened, parts.as_deref(), &self.files)?)
            }
            EngineCall::Bones { model, fields } => {
                let inspector = opened_model::inspector(&model, fields, &self.files)?;
                let opened = self.open(Path::new(&model), &inspector.set_files)?;
                ok_answer(BoneSurfaces::of(&opened.model.model, Path::new(&model), &self.files))
            }
            EngineCall::Play { request } => {
                ok_answer(play_recording(Request::from_map(request)?, &self.files)?)
            }
            EngineCall::Correct { request } => {
                ok_answer(CorrectedRecording::correct(Request::from_map(request)?, &mut self.files)?)
            }
            EngineCall::Change { request, parts } => {
                self.last = None;
                let planned = self.plan(Request::from_map(request)?, &Page)?;
                let answer = ok_answer(planned.shown(parts.as_deref(), &self.files)?);
                self.last = Some(planned);
                answer
            }
            EngineCall::Diff => ok_answer(json!({ "text": self.last_change()?.diff() })),
            EngineCall::Keep => self.keep_last_change(),
            EngineCall::Report { request } => ok_answer(self.report(request)?),
            EngineCall::Calculate { request } => {
                ok_answer(knowledge::calculate(&Request::from_map(request)?)?)
            }
            EngineCall::Spell { request } => {
                ok_answer(knowledge::spelled_calls(&Request::from_map(request)?))
            }
            EngineCall::Animals => ok_answer(AnimalFall::all().map_err(Problem::defect)?),
            EngineCall::Explain { topic } => ok_answer(json!({ "text": knowledge::explain(&topic)? })),
            EngineCall::Presets { fields } => ok_answer(knowledge::presets(fields, &self.files)?),
        }
    }

    /// The model at `path`. It is read again only after a file changed.
    fn open(&mut self, path: &Path, set_files: &SetFiles) -> Result<Rc<OpenedModel>, Failure> {
        let is_it = |opened: &Rc<OpenedModel>| opened.path == path && opened.set_files == *set_files;
        let opened = match self.opened.iter().position(is_it) {
            Some(at) => self.opened.remove(at),
            None => Rc::new(OpenedModel::read(path, set_files, &self.files)?),
        };
        self.opened.insert(0, Rc::clone(&opened));
        self.opened.truncate(MOST_OPEN_MODELS);
        Ok(opened)
    }

    fn plan(&mut self, request: Request, words: &'static dyn FrontEnd) -> Result<PlannedChange> {
        let change: PreparedChange = prepare(request, &self.files)?;
        let [path] = change.models.as_slice() else {
            return Err(Problem::wrong_call("a change is of one model"));
        };
        let opened = self.open(&path.clone(), &change.set_files)?;
        PlannedChange::new(change, opened, &self.files, words)
    }

    fn last_change(&self) -> Result<&PlannedChange> {
        self.last.as_ref().ok_or_else(|| Problem::wrong_call("there is no change yet"))
    }

    /// Adds the results of the last change to the files in memory.
    fn keep_last_change(&mut self) -> Result<String> {
        let planned = self.last.take().ok_or_else(|| Problem::wrong_call("there is no change yet"))?;
        let mut names = Vec::new();
        if planned.is_unchanged() {
            return ok_answer(json!({ "model": planned.path(), "names": names }));
        }
        for file in planned.results {
            let name = file.name.display().to_string();
            self.put(&name, file.bytes);
            names.push(name);
        }
        ok_answer(json!({ "model": names.first(), "names": names }))
    }

    /// The same report that the command writes for these `fields` of a request.
    fn report(&mut self, mut fields: Fields) -> Result<Value> {
        let request = Request::from_map(fields.clone())?;
        let verb = request.verb();
        let (path, entry) = if let Request::Inspect(request) = &request {
            let [path] = request.models.as_slice() else {
                return Err(Problem::wrong_call("this report is about one model"));
            };
            let inspector = Inspector::for_inspect(request, &self.files);
            let opened = self.open(path, &inspector.set_files)?;
            (path.clone(), opened_model::entry(&inspector, &opened, &self.files, &CommandLine)?)
        } else {
            let planned = self.plan(request, &CommandLine)?;
            (planned.path().to_owned(), planned.entry(&self.files)?)
        };
        fields.insert("report".to_owned(), report_name(&path).into());
        let command = CommandLine.request(&Request::from_map(fields)?);
        change::report(verb, &path, command, entry)
    }
}
