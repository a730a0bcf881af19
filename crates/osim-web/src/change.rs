//! A change of one model: its plan, its content on the web page, and its report.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use osim_model::files::{Failure, ModelFiles};
use osim_model::messages::Verb;
use osim_model::{FileId, Model};
use osim_patch::Plan;
use osim_planning::scene::{BodyFall, Scene};
use osim_planning::{BeforeAfter, BeforeAndAfterPlan, PreparedChange};
use osim_requests::options::OutputOptions;
use osim_requests::spell::{CommandLine, FrontEnd};
use osim_view::html::{
    Columns, DeferredParts, DetailLevel, Entry, Explained, ListedFiles, NamedDigest, Page, PageHead, RunRow,
    Section, Sections,
};
use osim_view::report::json::PlanRecord;
use osim_view::report::plan::unified_diff;
use serde::Serialize;
use serde_json::{Value, json};

use crate::given_files::GivenFiles;
use crate::opened_model::{FindingShown, OpenedModel, VerdictWithQuestion, sha256};
use crate::problem::{Problem, Result};

/// Sections of the page that are made again while the user moves a slider: they need only the plan and the drawings of the model.
const QUICK_SECTIONS: [&str; 5] = ["changes", "plots", "state", SCENE_SECTION, FALLS_SECTION];
/// Name of the section that shows the new model in space.
const SCENE_SECTION: &str = "scene";
/// Name of the section that shows falls on the contacts before and after the change.
const FALLS_SECTION: &str = "falls";

/// A change that is planned for an opened model, as the page shows it.
pub(crate) struct PlannedChange {
    change: PreparedChange,
    opened: Rc<OpenedModel>,
    plan: Plan,
    /// The changed model, for inspection only; `None` if nothing changes.
    changed: Option<Model>,
    words: &'static dyn FrontEnd,
    /// The changed files, the model first.
    pub(crate) results: Vec<NewFile>,
}

/// A new file that a change makes.
pub(crate) struct NewFile {
    from: FileId,
    /// Name of the file as the command would choose it.
    pub(crate) name: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

/// A change as the page shows it.
#[derive(Debug, Serialize)]
pub(crate) struct ChangeShown {
    record: PlanRecord,
    /// Whether the plan changes nothing in the model.
    unchanged: bool,
    /// The name and the size of each file that the change makes.
    results: Vec<Value>,
    sections: Vec<Section>,
    explained: Vec<Explained>,
    /// Findings of the model after the change, where they were asked for.
    findings: Option<Vec<FindingShown>>,
    /// Verdicts on the model after the change, where they were asked for.
    verdicts: Option<Vec<VerdictWithQuestion>>,
    /// The new model in space, where it was asked for.
    scene: Option<Scene>,
    /// Falls on the contacts before and after the change, where they were asked for.
    falls: Vec<BodyFall>,
}

impl PlannedChange {
    /// Plans `change` for the `opened` model. The front end `words` spells messages.
    ///
    /// # Errors
    /// The change is impossible for this model, or needs an answer that only the user can give.
    pub(crate) fn new(
        change: PreparedChange,
        opened: Rc<OpenedModel>,
        given_files: &GivenFiles,
        words: &'static dyn FrontEnd,
    ) -> Result<Self> {
        let (mut plan, changed) =
            change.plan_with_result(&opened.model, given_files, Plan::model_to_inspect)?;
        plan.spell(words);
        let output =
            change.output.output.clone().unwrap_or_else(|| OutputOptions::result_beside(&opened.path));
        let geometry = change.set_files.geometry.as_deref().map(|path| change.output.of_geometry(path));
        let model = &opened.model.model;
        let named = plan.files(model).zip(std::iter::once(output).chain(geometry));
        let made = |(from, name)| {
            let bytes = plan.patched(model, from).map_err(|fault| opened.model.failure(fault))?;
            Ok(NewFile { from, name, bytes })
        };
        let results = named.map(made).collect::<Result<_, Failure>>()?;
        Ok(Self { change, opened, plan, changed, words, results })
    }

    /// Path of the model that the change is for.
    pub(crate) fn path(&self) -> &Path {
        &self.opened.path
    }

    /// Whether the change leaves all files of the model as they are.
    pub(crate) fn is_unchanged(&self) -> bool {
        self.plan.is_empty()
    }

    /// The files of the model after the change.
    fn files_after(&self) -> ModelFiles {
        let mut after = self.opened.files.clone();
        for made in &self.results {
            match made.from {
                FileId::MAIN => {
                    after = after.with_bytes(made.bytes.clone()).with_name(made.name.display().to_string());
                }
                other => after.replace_companion(other, made.bytes.clone()),
            }
        }
        after
    }

    /// The model before and after the change.
    fn before_after(&self, with_feet: bool, given_files: &GivenFiles) -> Result<BeforeAfter> {
        let opened = &self.opened.model;
        let mut before_after = BeforeAfter::of_plan(
            &self.change,
            opened,
            &self.plan,
            || self.files_after(),
            self.words,
            with_feet,
        )?;
        if let Some(feet) = before_after.feet.last_mut() {
            feet.add_bones(&opened.model, &self.opened.path, None, given_files);
        }
        Ok(before_after)
    }

    fn before_after_plan(&self) -> BeforeAndAfterPlan<'_> {
        BeforeAndAfterPlan {
            change: &self.change,
            opened: &self.opened.model,
            plan: &self.plan,
            changed: self.changed.as_ref(),
        }
    }

    /// The section about the changes, and those plots of the model before and after that are in `wanted`.
    fn quick_sections(&self, wanted: Option<&[String]>) -> Sections {
        let drawn =
            wanted.is_some_and(|wanted| wanted.iter().any(|one| ["plots", "state"].contains(&one.as_str())));
        let bodies = if drawn { self.before_after_plan().bodies() } else { Vec::new() };
        Sections::of_plan(&self.plan, &bodies, self.change.reference.as_ref(), wanted, self.words)
    }

    /// The content of the page about the change; `wanted` are the sections to make, `None` for all.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect.
    pub(crate) fn shown(&self, wanted: Option<&[String]>, given_files: &GivenFiles) -> Result<ChangeShown> {
        let wants = |id: &str| wanted.is_none_or(|wanted| wanted.iter().any(|one| one == id));
        let quick =
            wanted.is_some_and(|wanted| wanted.iter().all(|one| QUICK_SECTIONS.contains(&one.as_str())));
        let asks_for = |id: &str| wanted.is_some_and(|wanted| wanted.iter().any(|one| one == id));
        let (shown, findings, verdicts) = match quick {
            true => (self.quick_sections(wanted), None, None),
            false => {
                let before_after = self.before_after(wants("feet"), given_files)?;
                let last = before_after.after.as_ref().unwrap_or(&before_after.before);
                let findings = wants("findings").then(|| FindingShown::all(&last.1));
                // Digests are only for the record.
                let files = if wants("files") { self.files() } else { ListedFiles::default() };
                let changed = osim_view::html::ChangedModelOnPage::new(&self.plan, &before_after, files);
                let verdicts = wants("findings").then(|| VerdictWithQuestion::all(&last.1.verdicts));
                (Sections::of_change(changed, wanted, self.words), findings, verdicts)
            }
        };
        let results = self
            .results
            .iter()
            .map(|made| json!({ "name": made.name.to_str().unwrap_or_default(), "bytes": made.bytes.len() }));
        Ok(ChangeShown {
            record: PlanRecord::new(&self.plan, &self.opened.model.model, &self.opened.path, None, None),
            unchanged: self.is_unchanged(),
            results: results.collect(),
            sections: shown.sections,
            explained: shown.explained,
            findings,
            verdicts,
            scene: if asks_for(SCENE_SECTION) { self.before_after_plan().scene() } else { None },
            falls: if asks_for(FALLS_SECTION) { self.before_after_plan().falls() } else { Vec::new() },
        })
    }

    /// The changed lines of the model's files, as a diff.
    pub(crate) fn diff(&self) -> String {
        let opened = &self.opened.model;
        let each = self.results.iter().map(|made| {
            let (old_name, new_name) = (opened.name_of(made.from), made.name.display().to_string());
            let new_name = if made.from == FileId::MAIN { &new_name } else { old_name };
            unified_diff(opened.model.file(made.from).bytes(), &made.bytes, old_name, new_name)
        });
        each.collect()
    }

    /// The files that were read, and the files that the change makes.
    fn files(&self) -> ListedFiles {
        let names: Vec<String> = self.results.iter().map(|made| made.name.display().to_string()).collect();
        let outputs = names
            .iter()
            .zip(&self.results)
            .map(|(name, made)| NamedDigest { name: name.clone(), sha256: sha256(&made.bytes) });
        let result = match self.plan.is_empty() {
            true => "nothing written".to_owned(),
            false => format!("written: {}", names.join(", ")),
        };
        let outputs = if self.plan.is_empty() { Vec::new() } else { outputs.collect() };
        ListedFiles { inputs: self.opened.digests(), result, outputs }
    }

    /// The change as an entry of a report, with the same content as in the report of the command that writes the files.
    ///
    /// # Errors
    /// The new model cannot be read, which would be a defect.
    pub(crate) fn entry(&self, given_files: &GivenFiles) -> Result<Entry> {
        let before_after = self.before_after(true, given_files)?;
        let plan = &self.plan;
        let status = if plan.is_empty() { "unchanged" } else { "written" };
        let mut row = RunRow::new(self.opened.model.name().to_string(), status);
        row.output = (!plan.is_empty())
            .then(|| self.results.first().map(|made| made.name.display().to_string()))
            .flatten();
        row.contacts_mass_kg = plan.masses.as_ref().map(|masses| masses.contacts_mass.kg);
        row.target_mass_kg = plan.masses.as_ref().map(|masses| masses.target_mass_kg);
        row.changes = plan.changes.len() + plan.moves.len();
        let mut shown = osim_view::html::ChangedModelOnPage::new(plan, &before_after, self.files());
        shown.in_file = !plan.is_empty();
        Ok(osim_view::html::entry_of_changed_model(&row, shown, DetailLevel::Alone, self.words))
    }
}

// Reports, as the command writes them: in its words, because a report says by which command it is made again.

/// The name of a report about the model `path`.
pub(crate) fn report_name(path: &Path) -> String {
    path.with_extension("report.html").display().to_string()
}

/// The report about one model for the page to download, its name and its text; `command` is the call of the command that writes the same
/// report.
pub(crate) fn report(verb: Verb, model: &Path, command: String, entry: Entry) -> Result<Value> {
    let columns = if verb == Verb::Inspect { Columns::Inspections } else { Columns::Changes };
    let head = PageHead { verb, model: Some(model.display().to_string()), columns, call: command };
    let mut page = Page::new(head, DeferredParts::<String>::default(), &CommandLine);
    page.add(entry);
    let mut bytes = Vec::new();
    page.finish(&mut bytes).map_err(Problem::defect)?;
    let html = String::from_utf8(bytes).map_err(Problem::defect)?;
    Ok(json!({ "name": report_name(model), "html": html }))
}
