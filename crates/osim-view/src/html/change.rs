//! The entry and the sections on a page for a model that was changed.

use maud::{Markup, html};
use osim_inspect::{Figures, Inspection};
use osim_model::messages::{Dialect, readable};
use osim_patch::{NumberChange, PlaceChange, Plan};
use osim_planning::{BeforeAfter, ModelFeet};

use crate::html::explained::{Topics, as_sentence, first_names_and_count, severity_tag};
use crate::html::fragment::{DetailLevel, Fragment, Section, table_if_any};
use crate::html::inspected::{self, ListedFiles};
use crate::html::special_models::{DrawnStates, ModelFacts, largest_indentation};
use crate::html::sphere_figures::{self, ModelState};
use crate::html::{Entry, RunRow, findings, plots, reference};
use crate::report::plan::{
    centre, equal_changes, is_new, moves_of_others, name_or_count, names, object_groups,
    properties_in_several_groups,
};

/// A change of a model, and its effects. The texts of the plan, the inspections and the checks are already in the words of the front end.
pub struct ChangedModelOnPage<'c> {
    pub plan: &'c Plan,
    /// The model before and after the change.
    pub states: &'c BeforeAfter,
    /// The feet before and after the change, the last ones with bones; empty if feet are not drawn.
    pub feet: Vec<ModelFeet>,
    /// The section about the contacts along a recording, from [`recording`](crate::html::recording), if the change follows one.
    pub recording: Option<Section>,
    /// Whether the new model was written to a file.
    pub in_file: bool,
    /// Files that the change read and wrote.
    pub files: ListedFiles,
}

impl<'c> ChangedModelOnPage<'c> {
    /// A plan with the model before and after the change. The caller sets `in_file`.
    pub fn new(plan: &'c Plan, states: &'c BeforeAfter, files: ListedFiles) -> Self {
        Self { plan, states, feet: states.feet.clone(), recording: None, in_file: false, files }
    }
}

/// The entry of a changed model. `row` is its row in the table of models.
pub fn entry_of_changed_model(
    row: &RunRow,
    changed: ChangedModelOnPage<'_>,
    detail: DetailLevel,
    dialect: &dyn Dialect,
) -> Entry {
    let mut fragment = Fragment::new(detail);
    let (facts, plan) = (facts_of_change(changed.states), changed.plan);
    let drawn = add_change_sections(&mut fragment, changed, dialect);
    Entry::of_changed_model(row, plan, facts, drawn, fragment)
}

/// Adds the sections about a change. Returns the data for plots in other parts of the page.
pub(super) fn add_change_sections(
    fragment: &mut Fragment,
    changed: ChangedModelOnPage<'_>,
    dialect: &dyn Dialect,
) -> DrawnStates {
    add_changes_section(fragment, changed.plan);
    let states = changed.states;
    let (inspected, checked) = &states.before;
    if fragment.is_wanted(findings::SECTION_HEAD.0) {
        match &states.after {
            Some((_, found)) => {
                let (in_file, gravity_m_s2) = (changed.in_file, states.target_gravity_m_s2);
                findings::add_findings_of_change(fragment, checked, found, in_file, gravity_m_s2);
            }
            None => findings::add_verdicts_and_findings(fragment, checked),
        }
    }
    if let Some(recording) = &changed.recording {
        fragment.add_section(recording.id, recording.title, &maud::PreEscaped(recording.html.clone()));
    }
    if let Some(reference) = &states.reference
        && fragment.is_wanted(reference::SECTION_HEAD.0)
    {
        reference::section(fragment, reference, &states.bodies);
    }
    let files = inspected::list_of_files(&changed.files);
    let drawn = drawn_states(states, changed.feet);
    if fragment.detail.is_alone() {
        plots::add_sections(fragment, &drawn, dialect);
    }
    if fragment.is_wanted(sphere_figures::SECTION_HEAD.0) {
        let mut shown = states_of_change(inspected, states);
        let reference = states.reference.as_ref().and_then(|reference| reference.figures.as_ref());
        let state = |figures| ModelState { name: "reference".to_owned(), figures, is_reference: true };
        shown.extend(reference.map(state));
        sphere_figures::section(fragment, &shown);
    }
    fragment.add_section("files", "Files read and written", &files);
    drawn
}

/// The states of the model for plots, and the reference, if there is one.
fn drawn_states(states: &BeforeAfter, feet: Vec<ModelFeet>) -> DrawnStates {
    let reference = states.reference.as_ref().and_then(|reference| reference.body.clone());
    let has_reference = states.reference.is_some();
    let mut drawn = DrawnStates { bodies: states.bodies.clone(), has_reference, feet };
    if !drawn.bodies.is_empty() {
        drawn.bodies.extend(reference);
    }
    drawn
}

/// Numbers about the change for the summary of the page.
fn facts_of_change(states: &BeforeAfter) -> ModelFacts {
    let (inspected, checked) = states.after.as_ref().unwrap_or(&states.before);
    let mut facts = ModelFacts::new(&inspected.figures, checked, states.bodies.last());
    facts.reference = states.reference.as_ref().map(reference::in_words);
    facts.indentation.before = largest_indentation(&states.before.0.figures);
    facts.indentation.not_scaled = states.before_under_new_weight.as_ref().and_then(largest_indentation);
    facts
}

fn states_of_change<'s>(before: &'s Inspection, changed: &'s BeforeAfter) -> Vec<ModelState<'s>> {
    let under_new_weight = changed.before_under_new_weight.as_ref();
    let after = changed.after.as_ref().map(|(after, _)| &after.figures);
    let last = after.or(under_new_weight);
    let other_gravity = last.is_some_and(|last| last.gravity_m_s2 != before.figures.gravity_m_s2);
    let under = |word: &str, figures: &Figures| match (figures.mass_kg, figures.gravity_m_s2) {
        (Some(mass), Some(gravity)) if other_gravity => {
            format!("{word}, under {} kg at {} m/s²", readable(mass), readable(gravity))
        }
        (Some(mass), _) => format!("{word}, under {} kg", readable(mass)),
        (None, _) => word.to_owned(),
    };
    let state = |word, figures| ModelState { name: under(word, figures), figures, is_reference: false };
    let mut states = vec![state("before", &before.figures)];
    states.extend(under_new_weight.map(|figures| state("before", figures)));
    states.extend(after.map(|figures| state("after", figures)));
    // If all contacts were added or removed, one state has no spheres and is left out.
    if states.iter().any(|state| state.figures.spheres().next().is_some()) {
        states.retain(|state| state.figures.spheres().next().is_some());
    }
    states
}

/// Adds the section about all changes of a plan.
pub(super) fn add_changes_section(fragment: &mut Fragment, plan: &Plan) {
    let objects = table_of_objects(plan);
    let changes = table_of_numbers(&mut fragment.topics, plan);
    let spheres = table_of_new_spheres(plan);
    let moves = table_of_moves(&mut fragment.topics, &moves_of_others(plan));
    let findings = list_of_findings(&mut fragment.topics, plan);
    let body = html! {
        p { (as_sentence(&plan.taken.to_string())) }
        @if plan.is_empty() { p.aside { "Nothing had to change." } }
        (objects) (changes) (spheres) (moves)
        @if !plan.remarks.is_empty() { ul { @for remark in &plan.remarks { li { (as_sentence(&remark.to_string())) } } } }
        (findings)
    };
    fragment.add_section("changes", "What changed", &body);
}

fn table_of_objects(plan: &Plan) -> Markup {
    let rows = html! {
        @for ((action, class), names) in object_groups(plan.objects()) {
            tr {
                th scope="row" { code { (class) } }
                td.words { (action.as_str()) }
                td { (names.len()) }
                td.words { (first_names_and_count(&names)) }
            }
        }
    };
    let caption = "Whole objects that are added or removed.";
    table_if_any("Objects", caption, &["class", " change", "number", " names"], &rows)
}

fn table_of_numbers(topics: &mut Topics, plan: &Plan) -> Markup {
    let groups = equal_changes(&plan.changes);
    // Names are shown only if a property has several groups of objects with different numbers.
    let several = properties_in_several_groups(&groups);
    let is_named =
        |group: &[&NumberChange]| group.first().is_some_and(|change| several.contains(&change.property));
    let rows = html! { @for group in &groups { (row_of_numbers(topics, group, is_named(group))) } };
    let mut caption =
        "Numbers that change, in OpenSim's units, and the equation each follows from.".to_owned();
    if plan.changes.iter().any(|change| change.inserted) {
        caption.push_str(" + was not in the file: OpenSim's default applied, and it is written out now.");
    }
    let before = if is_new(plan) { "from" } else { "before" };
    let headers = ["property", " of", before, "after", "factor", "equation"];
    table_if_any("Numbers that change", &caption, &headers, &rows)
}

/// One row for all spheres or forces of a group of equal changes: their number, and if `with_names`, the names of the first ones.
fn row_of_numbers(topics: &mut Topics, group: &[&NumberChange], with_names: bool) -> Markup {
    let Some(first) = group.first() else { return html! {} };
    let [from, to] = first.values(readable);
    let unit = first.property.unit().replace("m2", "m²");
    html! {
        tr {
            th scope="row" { code { (first.name()) } @if !unit.is_empty() && unit != "1" { " " span.quiet { (unit) } } }
            td.words { (name_or_count(group)) @if with_names && group.len() > 1 { br; span.quiet { (first_names_and_count(&names(group))) } } }
            td { (from) }
            td { b { (to) } @if first.inserted { " +" } }
            td { @if let Some(factor) = first.factor { "×" (readable(factor)) } }
            td { (topics.links_to_equations(first.by.as_str())) }
        }
    }
}

fn table_of_new_spheres(plan: &Plan) -> Markup {
    let spheres = plan.new_spheres();
    let rows = html! {
        @for sphere in spheres {
            tr {
                th scope="row" { (sphere.name) }
                td.words { (sphere.body) }
                td { (readable(sphere.radius_m)) }
                @for value in sphere.centre_m { td { (centre(value)) } }
            }
        }
    };
    let caption = "New spheres, in m, in the frames of their bodies.";
    table_if_any("New spheres", caption, &["sphere", " on", "radius", "x", "y", "z"], &rows)
}

fn table_of_moves(topics: &mut Topics, moves: &[&PlaceChange]) -> Markup {
    let rows = html! {
        @for moved in moves {
            tr {
                th scope="row" { (moved.geometry) }
                @for value in moved.from.iter().chain(&moved.to) { td { (centre(*value)) } }
                td { (topics.links_to_equations(moved.by.as_str())) }
            }
        }
    };
    let caption = "Sphere centres that move, in m, in their own frames.";
    let headers = ["centre of", "x before", "y before", "z before", "x after", "y after", "z after", "by"];
    table_if_any("Centres that move", caption, &headers, &rows)
}

fn list_of_findings(topics: &mut Topics, plan: &Plan) -> Markup {
    let new: Vec<_> = plan.findings.iter().filter(|finding| !finding.had_before).collect();
    html! {
        @if !new.is_empty() {
            ul.findings { @for finding in new { li { p {
                (severity_tag(finding.severity)) " " (topics.link_to_finding(finding.code())) " "
                (finding.message.to_string()) "."
                @if let Some(position) = finding.position { " " span.quiet { (position) } }
            } } } }
        }
    }
}
