//! A model that was changed: from what, to what, by which equation, and what its contacts do before and after.

use maud::{Markup, html};
use osim_patch::{Change, Move, Plan};

use super::explained::Topics;
use super::figures::{self, State};
use super::fragment::{Fragment, Frame, table};
use super::values::{listed, sentence};
use super::{findings, plots};
use crate::check::Report;
use crate::look::Inspection;
use crate::look::figures::Figures;
use crate::plotting::body::Body;
use crate::report::changes::{groups, whose};
use crate::report::number;

/// A change and what it does.
pub(crate) struct Changed<'c> {
    pub plan: &'c Plan,
    /// The model as it was.
    pub now: (&'c Inspection, &'c Report),
    /// The figures of the model as it was, under the new weight, where that differs.
    pub now_heavier: Option<&'c Figures>,
    /// The model as it is written; none where nothing changes.
    pub new: Option<(&'c Inspection, &'c Report)>,
    /// States of the model to be drawn.
    pub bodies: Vec<Body>,
    /// The new model is in a file.
    pub in_file: bool,
    /// The contacts are scaled to a gravity of their own, m/s².
    pub target_gravity_m_s2: Option<f64>,
    pub files: Files,
}

/// The files of a change, for the record: names and, where there are bytes, their SHA-256.
pub(crate) struct Files {
    pub inputs: Vec<NamedDigest>,
    /// What became of it, in words.
    pub result: String,
    pub outputs: Vec<NamedDigest>,
}

/// A file by its name and the SHA-256 of its bytes.
pub(crate) type NamedDigest = (String, String);

/// Everything about one model.
pub(crate) fn of_change(changed: &Changed<'_>, frame: Frame) -> Fragment {
    let mut fragment = Fragment::new(frame);
    what_changed(&mut fragment, changed.plan);
    let (now, now_report) = changed.now;
    match changed.new {
        Some((_, new)) => {
            let new = findings::After {
                report: new,
                in_file: changed.in_file,
                gravity_m_s2: changed.target_gravity_m_s2,
            };
            findings::of_change(&mut fragment, now_report, &new);
        }
        None => findings::of_model(&mut fragment, now_report),
    }
    if frame.plots && !changed.bodies.is_empty() {
        plots::section(&mut fragment, &changed.bodies);
    }
    let states = states(now, changed.now_heavier, changed.new.map(|(new, _)| new));
    figures::section(&mut fragment, &states);
    fragment.section("files", "The files", &files(&changed.files));
    fragment
}

fn states<'s>(
    now: &'s Inspection,
    heavier: Option<&'s Figures>,
    new: Option<&'s Inspection>,
) -> Vec<State<'s>> {
    let after = new.map_or(heavier, |new| Some(&new.figures));
    let other_gravity = after.is_some_and(|after| after.gravity_m_s2 != now.figures.gravity_m_s2);
    let under = |word: &str, figures: &Figures| match (figures.mass_kg, figures.gravity_m_s2) {
        (Some(mass), Some(gravity)) if other_gravity => {
            format!("{word}, under {} kg at {} m/s²", number(mass), number(gravity))
        }
        (Some(mass), _) => format!("{word}, under {} kg", number(mass)),
        (None, _) => word.to_owned(),
    };
    let mut states = vec![State { name: under("before", &now.figures), figures: &now.figures }];
    states.extend(heavier.map(|figures| State { name: under("before", figures), figures }));
    states.extend(new.map(|new| State { name: under("after", &new.figures), figures: &new.figures }));
    states
}

fn what_changed(fragment: &mut Fragment, plan: &Plan) {
    let changes = changes(&mut fragment.topics, plan);
    let moves = moves(&mut fragment.topics, &plan.moves);
    let warnings = warnings(&mut fragment.topics, plan);
    let body = html! {
        p { (sentence(&plan.taken)) }
        @if plan.is_empty() { p.note { "Nothing had to change." } }
        (changes) (moves)
        @if !plan.remarks.is_empty() { ul { @for remark in &plan.remarks { li { (sentence(remark)) } } } }
        (warnings)
    };
    fragment.section("changes", "What changed", &body);
}

fn changes(topics: &mut Topics, plan: &Plan) -> Markup {
    if plan.changes.is_empty() {
        return html! {};
    }
    let groups = groups(&plan.changes);
    // Twelve spheres with the same numbers need no names; two groups of one property do.
    let alone = |group: &[&Change]| {
        let property = |group: &[&Change]| group.first().map(|change| change.property);
        groups.iter().filter(|other| property(other.as_slice()) == property(group)).count() == 1
    };
    let rows: Vec<Markup> = groups.iter().map(|group| change(topics, group, !alone(group))).collect();
    let mut caption =
        "Numbers that change, in OpenSim's units, and the equation each follows from.".to_owned();
    if plan.changes.iter().any(|change| change.inserted) {
        caption.push_str(" + was not in the file: OpenSim's default applied, and it is written out now.");
    }
    let headers = ["property", " of", "before", "after", "factor", "equation"];
    table("Numbers that change", &caption, &headers, &rows)
}

fn change(topics: &mut Topics, group: &[&Change], with_names: bool) -> Markup {
    let Some(first) = group.first() else { return html! {} };
    let unit = first.property.unit().replace("^2", "²");
    html! {
        tr {
            th scope="row" { code { (first.property.name()) } @if !unit.is_empty() && unit != "1" { " " span.quiet { (unit) } } }
            td.words { (whose(group)) @if with_names && group.len() > 1 { br; span.quiet { (names(group)) } } }
            td { (number(first.from)) }
            td { b { (number(first.to)) } @if first.inserted { " +" } }
            td { @if let Some(factor) = first.factor { "×" (number(factor)) } }
            td { (topics.equations(first.equation)) }
        }
    }
}

/// The first names of a group, and how many more there are.
fn names(group: &[&Change]) -> String {
    let names: Vec<&str> =
        group.iter().filter_map(|change| change.sphere.as_deref().or(change.force.as_deref())).collect();
    listed(&names)
}

fn moves(topics: &mut Topics, moves: &[Move]) -> Markup {
    if moves.is_empty() {
        return html! {};
    }
    let rows: Vec<Markup> = moves
        .iter()
        .map(|place| {
            html! {
                tr {
                    th scope="row" { (place.sphere) }
                    @for value in place.from.iter().chain(&place.to) { td { (format!("{value:.5}")) } }
                    td { (topics.equations(place.equation)) }
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
                    (super::values::severity(warning.code.severity())) " " (topics.code(warning.code)) " "
                    (warning.message) "."
                    @if let Some(line) = warning.line { " " span.quiet { "line " (line) } }
                } }
            }
        })
        .collect();
    html! { @if !items.is_empty() { ul.findings { @for item in items { (item) } } } }
}

fn files(files: &Files) -> Markup {
    html! {
        dl {
            (read(&files.inputs))
            dt { "Result" } dd { (files.result) }
            @for file in &files.outputs { dt { "Written" } dd { (digest(file)) } }
        }
    }
}

/// The files that a model was read from, the model first.
pub(super) fn read(files: &[NamedDigest]) -> Markup {
    html! {
        @for (index, file) in files.iter().enumerate() {
            dt { @if index == 0 { "Model" } @else { "With it" } } dd { (digest(file)) }
        }
    }
}

fn digest((name, sha256): &NamedDigest) -> Markup {
    html! { (name) @if !sha256.is_empty() { br; "SHA-256 " code.digest { (sha256) } } }
}
