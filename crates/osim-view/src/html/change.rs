//! A model that was changed: from what, to what, by which equation, and what its contacts do before and after.

use maud::{Markup, html};
use osim_inspect::series::Body;
use osim_inspect::{Figures, Inspection, ReferenceState};
use osim_model::messages::{Dialect, readable};
use osim_patch::{NumberChange, PlaceChange, Plan};
use osim_planning::{BeforeAfter, ModelFeet};

use crate::html::entry::{Entry, RunRow};
use crate::html::explained::{Topics, listed, sentence, severity};
use crate::html::fragment::{DetailLevel, Fragment, Section, table};
use crate::html::inspected::{self, Examined, Files};
use crate::html::special::{Drawn, Facts, deepest};
use crate::html::sphere_figures::{self, State};
use crate::html::{findings, plots, reference};
use crate::report::plan::{
    centre, groups, is_new, moves_of_others, names, object_groups, several_groups, whose,
};

/// A change and what it does. What the plan, the inspections and the checks say is taken as it is spelled.
#[derive(Debug)]
pub struct Changed<'c> {
    /// What changes.
    pub plan: &'c Plan,
    /// The model as it was.
    pub before: Examined<'c>,
    /// The figures of the model as it was, under the new weight, where that differs.
    pub before_under_new_weight: Option<&'c Figures>,
    /// The model as it is written; `None` where nothing changes.
    pub after: Option<Examined<'c>>,
    /// States of the model to be drawn.
    pub bodies: Vec<Body>,
    /// The feet of these states, the last with its bones; empty if they are not drawn.
    pub feet: Vec<ModelFeet>,
    /// What the contacts are taken from, where they are another body's.
    pub reference: Option<&'c ReferenceState>,
    /// What the new contacts do along a recording, where the change follows one: from [`recording`](crate::html::recording).
    pub recording: Option<Section>,
    /// Whether the new model is in a file.
    pub in_file: bool,
    /// The gravity the contacts are scaled to, where the model's is another, m/s².
    pub target_gravity_m_s2: Option<f64>,
    /// What was read and written.
    pub files: Files,
}

impl<'c> Changed<'c> {
    /// A plan for a model as it was, not written yet.
    pub fn new(plan: &'c Plan, before: Examined<'c>, files: Files) -> Self {
        Self {
            plan,
            before,
            before_under_new_weight: None,
            after: None,
            bodies: Vec::new(),
            feet: Vec::new(),
            reference: None,
            recording: None,
            in_file: false,
            target_gravity_m_s2: None,
            files,
        }
    }

    /// A plan with all that is known of both states of its model; its caller says whether that is in a file.
    pub fn of_states(plan: &'c Plan, states: &'c BeforeAfter, files: Files) -> Self {
        Self {
            before_under_new_weight: states.before_under_new_weight.as_ref(),
            after: states.after.as_ref().map(Examined::from),
            bodies: states.bodies.clone(),
            feet: states.feet.clone(),
            reference: states.reference.as_ref(),
            target_gravity_m_s2: states.target_gravity_m_s2,
            ..Self::new(plan, Examined::from(&states.before), files)
        }
    }
}

/// Everything about one model that was changed; `row` is in the table of models.
pub fn changed(row: &RunRow, changed: Changed<'_>, detail: DetailLevel, dialect: &dyn Dialect) -> Entry {
    let mut fragment = Fragment::new(detail);
    let (facts, plan) = (facts(&changed), changed.plan);
    let drawn = fill(&mut fragment, changed, dialect);
    Entry::of_change(row, plan, facts, drawn, fragment)
}

/// Adds the sections; what may be drawn of the model elsewhere.
pub(super) fn fill(fragment: &mut Fragment, changed: Changed<'_>, dialect: &dyn Dialect) -> Drawn {
    what_changed(fragment, changed.plan);
    let before = changed.before;
    if fragment.wants(findings::SECTION.0) {
        match changed.after {
            Some(after) => {
                let found = after.check;
                let (in_file, gravity_m_s2) = (changed.in_file, changed.target_gravity_m_s2);
                let after = findings::After { found, in_file, gravity_m_s2 };
                findings::of_change(fragment, before.check, &after);
            }
            None => findings::of_model(fragment, before.check),
        }
    }
    if let Some(recording) = &changed.recording {
        fragment.section(recording.id, recording.title, &maud::PreEscaped(recording.html.clone()));
    }
    if let Some(reference) = changed.reference.filter(|_| fragment.wants(reference::SECTION.0)) {
        reference::section(fragment, reference, &changed.bodies);
    }
    let Changed { before_under_new_weight, after, reference, .. } = changed;
    let files = inspected::of_change(&changed.files);
    let drawn = drawn(changed);
    if fragment.detail.is_alone() {
        plots::feet_section(fragment, &drawn.feet);
        if !drawn.bodies.is_empty() {
            plots::contact_section(fragment, &drawn.bodies, drawn.has_reference, dialect);
            plots::state_section(fragment, &drawn.bodies);
        }
    }
    if fragment.wants(sphere_figures::SECTION.0) {
        let after = after.map(|after| after.inspection);
        let mut states = states(before.inspection, before_under_new_weight, after);
        let there = reference.and_then(|reference| reference.figures.as_ref());
        states.extend(there.map(|figures| State {
            name: "reference".to_owned(),
            figures,
            is_reference: true,
        }));
        sphere_figures::section(fragment, &states);
    }
    fragment.section("files", "Files read and written", &files);
    drawn
}

/// What is drawn: the states of the model, and the reference where there are any.
fn drawn(changed: Changed<'_>) -> Drawn {
    let reference = changed.reference.and_then(|reference| reference.body.clone());
    let mut drawn =
        Drawn { bodies: changed.bodies, has_reference: changed.reference.is_some(), feet: changed.feet };
    if !drawn.bodies.is_empty() {
        drawn.bodies.extend(reference);
    }
    drawn
}

/// What the page counts.
fn facts(changed: &Changed<'_>) -> Facts {
    let last = changed.after.unwrap_or(changed.before);
    let mut facts = Facts::new(&last.inspection.figures, last.check, changed.bodies.last());
    facts.reference = changed.reference.map(reference::in_words);
    facts.indentation.before = deepest(&changed.before.inspection.figures);
    facts.indentation.not_scaled = changed.before_under_new_weight.and_then(deepest);
    facts
}

fn states<'s>(
    before: &'s Inspection,
    under_new_weight: Option<&'s Figures>,
    after: Option<&'s Inspection>,
) -> Vec<State<'s>> {
    let last = after.map_or(under_new_weight, |after| Some(&after.figures));
    let other_gravity = last.is_some_and(|last| last.gravity_m_s2 != before.figures.gravity_m_s2);
    let under = |word: &str, figures: &Figures| match (figures.mass_kg, figures.gravity_m_s2) {
        (Some(mass), Some(gravity)) if other_gravity => {
            format!("{word}, under {} kg at {} m/s²", readable(mass), readable(gravity))
        }
        (Some(mass), _) => format!("{word}, under {} kg", readable(mass)),
        (None, _) => word.to_owned(),
    };
    let mut states =
        vec![State { name: under("before", &before.figures), figures: &before.figures, is_reference: false }];
    states.extend(under_new_weight.map(|figures| State {
        name: under("before", figures),
        figures,
        is_reference: false,
    }));
    states.extend(after.map(|after| State {
        name: under("after", &after.figures),
        figures: &after.figures,
        is_reference: false,
    }));
    // Contacts that are new, or that are gone, have one state.
    if states.iter().any(|state| state.figures.spheres().next().is_some()) {
        states.retain(|state| state.figures.spheres().next().is_some());
    }
    states
}

/// Adds what changes.
pub(super) fn what_changed(fragment: &mut Fragment, plan: &Plan) {
    let objects = objects(plan);
    let changes = changes(&mut fragment.topics, plan);
    let spheres = new_spheres(plan);
    let moves = moves(&mut fragment.topics, &moves_of_others(plan));
    let warnings = warnings(&mut fragment.topics, plan);
    let body = html! {
        p { (sentence(&plan.taken.to_string())) }
        @if plan.is_empty() { p.aside { "Nothing had to change." } }
        (objects) (changes) (spheres) (moves)
        @if !plan.remarks.is_empty() { ul { @for remark in &plan.remarks { li { (sentence(&remark.to_string())) } } } }
        (warnings)
    };
    fragment.section("changes", "What changed", &body);
}

fn objects(plan: &Plan) -> Markup {
    let rows: Vec<Markup> = object_groups(plan.objects())
        .iter()
        .map(|group| {
            html! {
                tr {
                    th scope="row" { code { (group.class) } }
                    td.words { (group.action.as_str()) }
                    td { (group.names.len()) }
                    td.words { (listed(&group.names)) }
                }
            }
        })
        .collect();
    if rows.is_empty() {
        return html! {};
    }
    table(
        "Objects",
        "Whole objects that are added or removed.",
        &["class", " change", "number", " names"],
        &rows,
    )
}

fn changes(topics: &mut Topics, plan: &Plan) -> Markup {
    if plan.changes.is_empty() {
        return html! {};
    }
    let groups = groups(&plan.changes);
    // Twelve spheres with the same numbers need no names; two groups of one property do.
    let several = several_groups(&groups);
    let is_named =
        |group: &[&NumberChange]| group.first().is_some_and(|change| several.contains(&change.property));
    let rows: Vec<Markup> = groups.iter().map(|group| change(topics, group, is_named(group))).collect();
    let mut caption =
        "Numbers that change, in OpenSim's units, and the equation each follows from.".to_owned();
    if plan.changes.iter().any(|change| change.inserted) {
        caption.push_str(" + was not in the file: OpenSim's default applied, and it is written out now.");
    }
    let before = if is_new(plan) { "from" } else { "before" };
    let headers = ["property", " of", before, "after", "factor", "equation"];
    table("Numbers that change", &caption, &headers, &rows)
}

fn change(topics: &mut Topics, group: &[&NumberChange], with_names: bool) -> Markup {
    let Some(first) = group.first() else { return html! {} };
    let unit = first.property.unit().replace("m2", "m²");
    html! {
        tr {
            th scope="row" { code { (first.property.name()) } @if !unit.is_empty() && unit != "1" { " " span.quiet { (unit) } } }
            td.words { (whose(group)) @if with_names && group.len() > 1 { br; span.quiet { (listed(&names(group))) } } }
            td { (readable(first.from)) }
            td { b { (readable(first.to)) } @if first.inserted { " +" } }
            td { @if let Some(factor) = first.factor { "×" (readable(factor)) } }
            td { (topics.equations(first.by.as_str())) }
        }
    }
}

/// Spheres that are added, as they are written.
fn new_spheres(plan: &Plan) -> Markup {
    let rows: Vec<Markup> = plan
        .new_spheres()
        .iter()
        .map(|sphere| {
            html! {
                tr {
                    th scope="row" { (sphere.name) }
                    td.words { (sphere.body) }
                    td { (readable(sphere.radius_m)) }
                    @for value in sphere.centre_m { td { (centre(value)) } }
                }
            }
        })
        .collect();
    if rows.is_empty() {
        return html! {};
    }
    let caption = "New spheres, in m, in the frames of their bodies.";
    table("New spheres", caption, &["sphere", " on", "radius", "x", "y", "z"], &rows)
}

fn moves(topics: &mut Topics, moves: &[&PlaceChange]) -> Markup {
    if moves.is_empty() {
        return html! {};
    }
    let rows: Vec<Markup> = moves
        .iter()
        .map(|moved| {
            html! {
                tr {
                    th scope="row" { (moved.sphere) }
                    @for value in moved.from.iter().chain(&moved.to) { td { (centre(*value)) } }
                    td { (topics.equations(moved.by.as_str())) }
                }
            }
        })
        .collect();
    let caption = "Sphere centres that move, in m, in their own frames.";
    let headers = ["centre of", "x before", "y before", "z before", "x after", "y after", "z after", "by"];
    table("Centres that move", caption, &headers, &rows)
}

fn warnings(topics: &mut Topics, plan: &Plan) -> Markup {
    let items: Vec<Markup> = plan
        .warnings
        .iter()
        .map(|warning| {
            html! {
                li { p {
                    (severity(warning.severity)) " " (topics.code(warning.code())) " "
                    (warning.message.to_string()) "."
                    @if let Some(line) = warning.line { " " span.quiet { "line " (line) } }
                } }
            }
        })
        .collect();
    html! { @if !items.is_empty() { ul.findings { @for item in items { (item) } } } }
}
