//! A folder in memory. Commands run in it as `check` prints them.

use std::collections::BTreeSet;
use std::path::Path;

use osim_inspect::CheckResult;
use osim_model::files::{Files, InMemory};
use osim_model::messages::Verb;
use osim_model::{FindingCode, Severity};
use osim_planning::{Inspector, open_with, prepare};
use osim_requests::options::OutputOptions;
use osim_requests::{CheckRequest, Request};
use serde_json::{Value, json};

use super::cases::NAME;

/// A finding as its code, its severity and its place.
pub type FindingAndPlace = (FindingCode, Severity, Option<String>);

/// The outcome of a command on a model of the folder in memory.
pub struct CommandResult {
    /// The name of the file that the command wrote.
    pub output: String,
    /// The codes of the warnings and errors.
    pub warned: BTreeSet<&'static str>,
    /// All findings; `None` if no note is written, so that only the run knows what the contacts are made for.
    pub said: Option<BTreeSet<FindingAndPlace>>,
    /// The mass for which the contacts were scaled.
    pub target_kg: Option<f64>,
}

/// Files in memory, and the options with which they are checked.
#[derive(Clone)]
pub struct FolderInMemory {
    pub files: InMemory,
    options: Value,
}

impl FolderInMemory {
    pub fn of(text: &str, options: &Value) -> Self {
        Self { files: InMemory::from_iter([(NAME, text)]), options: options.clone() }
    }

    /// Whether models are checked with any options.
    pub fn has_options(&self) -> bool {
        self.options != json!({})
    }

    fn request(&self, model: &Path, kg: Option<f64>) -> CheckRequest {
        let mut request = json!({"verb": "check", "models": [model]});
        request.as_object_mut().unwrap().extend(self.options.as_object().unwrap().clone());
        if let Some(kg) = kg {
            request["mass"] = kg.into();
        }
        match Request::from_json(request.to_string().as_bytes()) {
            Ok(Request::Check(check)) => *check,
            other => panic!("{}: {other:?}", self.options),
        }
    }

    /// The result of `check` for a file; `None` if the file cannot be read, or there is nothing to check.
    pub fn check(&self, model: &Path) -> Option<CheckResult> {
        self.check_at_mass(model, None)
    }

    /// The result of `check` for a file, with `--mass` if a mass is given.
    pub fn check_at_mass(&self, model: &Path, kg: Option<f64>) -> Option<CheckResult> {
        let inspector = Inspector::for_check(&self.request(model, kg), &self.files);
        let opened = open_with(model, inspector.set_files.companion_paths(), &self.files).ok()?;
        let inspected = inspector.inspect(&opened).ok()?;
        inspector.refuse_without_contacts(&opened, &inspected).ok()?;
        Some(inspector.check(&opened.model, &inspected, None, &self.files))
    }

    /// Runs a command as it is printed. No file is overwritten.
    pub fn run(&mut self, request: &Request) -> Result<CommandResult, String> {
        // As somebody who copies the text.
        let request =
            Request::from_json(request.to_json().as_bytes()).map_err(|fault| format!("{fault:?}"))?;
        let change = prepare(request, &self.files).map_err(|error| format!("{error:?}"))?;
        let [model] = change.models.as_slice() else { return Err("not one model".to_owned()) };
        let opened = change.open(model, &self.files).map_err(|failure| failure.message.to_string())?;
        let plan = change.plan(&opened, &self.files).map_err(|failure| failure.message.to_string())?;
        let warned: BTreeSet<_> = plan
            .findings
            .iter()
            .filter(|finding| finding.severity >= Severity::Warning)
            // What a verb's own numbers make worse is not what the remedy did.
            .filter(|finding| !finding.message.to_string().starts_with("in the new model"))
            .map(|finding| finding.code().as_str())
            .collect();
        if plan.is_empty() {
            return Err("nothing to change".to_owned());
        }
        let output = change.output.output.clone().unwrap_or_else(|| OutputOptions::result_beside(model));
        let bytes =
            plan.patched(&opened.model, osim_model::FileId::MAIN).map_err(|fault| fault.to_string())?;
        if self.files.exists(&output) {
            return Err(format!("{} exists already", output.display()));
        }
        let name = output.to_string_lossy().into_owned();
        self.files.add(output, bytes);
        let said = plan.findings.iter().map(|one| (one.code(), one.severity, one.place.clone()));
        let said = plan.note().map(|_| said.collect());
        let masses = plan.masses.as_ref().filter(|_| change.verb == Verb::Rescale);
        Ok(CommandResult {
            output: name,
            warned,
            said,
            target_kg: masses.map(|masses| masses.target_mass_kg),
        })
    }

    /// The result of each verb for a file: the codes of its warnings, or the reason why it is refused.
    pub fn run_each_verb(
        &self,
        model: &str,
        kg: f64,
    ) -> Vec<(Value, Result<BTreeSet<&'static str>, String>)> {
        let calls = [
            json!({"verb": "rescale", "target_mass": kg * 1.3}),
            json!({"verb": "transfer", "from": "falisse2022"}),
            json!({"verb": "set", "set": {"viscous_friction": "x1.1"}}),
            json!({"verb": "set", "set": {"stiffness": "x1.01"}}),
            json!({"verb": "design", "restitution": 0.85, "impact_speed": 0.3}),
            json!({"verb": "design", "constant_indentation": 0.021}),
            json!({"verb": "convert", "to": "hunt-crossley"}),
            // It asks where the smoothing that it takes would hold stiff contacts in the air.
            json!({"verb": "convert", "to": "smooth", "yes": ["wrong-afterwards"]}),
            json!({"verb": "note", "contacts_mass": kg}),
            json!({"verb": "remove"}),
        ];
        let run = |call: Value| {
            let mut fields = call.clone();
            // What was said of the masses is said again.
            let masses =
                ["mass", "exclude_body"].into_iter().filter_map(|name| Some((name, self.options.get(name)?)));
            if ["rescale", "transfer", "set", "design"].iter().any(|verb| call["verb"] == *verb) {
                masses.for_each(|(name, value)| fields[name] = value.clone());
            }
            fields.as_object_mut().unwrap().insert("models".to_owned(), json!([model]));
            fields.as_object_mut().unwrap().insert("output".to_owned(), "result.osim".into());
            let request = Request::from_json(fields.to_string().as_bytes()).unwrap();
            let ran = self.clone().run(&request).map(|ran| ran.warned);
            (call, ran)
        };
        calls.into_iter().map(run).collect()
    }
}

/// The findings that are at least warnings, as code and place. Findings about spheres have no place, because they are about all spheres.
pub fn warnings_and_errors(found: &CheckResult) -> BTreeSet<(FindingCode, Option<String>)> {
    let bad = found.findings.iter().filter(|one| one.severity >= Severity::Warning);
    bad.map(|one| (one.code(), one.place.clone().filter(|_| one.spheres.is_empty()))).collect()
}
