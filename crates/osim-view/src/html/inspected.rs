//! The entry and the sections on a page for a model that was inspected and checked.

use maud::{Markup, html};
use osim_inspect::series::ContactBody;
use osim_inspect::{CheckResult, InspectOptions, Inspection};
use osim_model::files::OpenModel;
use osim_model::messages::{Dialect, four_significant};
use osim_planning::ModelFeet;

use crate::html::explained::file_name;
use crate::html::fragment::{DetailLevel, Fragment, Section, table, table_if_any};
use crate::html::special_models::{DrawnStates, ModelFacts};
use crate::html::sphere_figures::{self, ModelState};
use crate::html::{Entry, findings, plots, reference};
use crate::report::extent::Extent;
use crate::report::inspection::{
    alike_forces, counted_and_named_forces, decimals, metres, radius_text, sentences_on_body,
    sources_in_words,
};

/// A model that was inspected, and the data about it for a page.
pub struct InspectedModelOnPage<'m> {
    pub options: &'m InspectOptions,
    pub model: &'m OpenModel,
    /// Inspection and check of the model.
    pub examined: (&'m Inspection, &'m CheckResult),
    /// The files from which the model was read, the model first.
    pub files: &'m [NamedDigest],
    /// Feet of the model, if the page draws them.
    pub feet: Option<ModelFeet>,
    /// The section about the contacts along a recording, from [`recording`](crate::html::recording), if the request names a recording.
    pub recording: Option<Section>,
}

pub fn entry_of_inspected_model(
    inspected: InspectedModelOnPage<'_>,
    detail: DetailLevel,
    dialect: &dyn Dialect,
) -> Entry {
    let mut fragment = Fragment::new(detail);
    let (inspection, check) = inspected.examined;
    let drawn = add_inspection_sections(&mut fragment, inspected, dialect);
    let facts = ModelFacts::new(&inspection.figures, check, drawn.bodies.first());
    Entry::of_inspected_model(inspection, facts, drawn, fragment)
}

/// Adds the sections about an inspected model. Returns the data for plots in other parts of the page.
pub(super) fn add_inspection_sections(
    fragment: &mut Fragment,
    inspected: InspectedModelOnPage<'_>,
    dialect: &dyn Dialect,
) -> DrawnStates {
    let InspectedModelOnPage { options, model, examined, files, feet, recording } = inspected;
    let (inspected, checked) = examined;
    findings::add_verdicts_and_findings(fragment, checked);
    if let Some(recording) = recording {
        fragment.add_section(recording.id, recording.title, &maud::PreEscaped(recording.html));
    }
    let failed = |fault| model.failure(fault);
    let name = file_name(model.name()).to_owned();
    let body = ContactBody::from_inspected_model(name, &model.model, options, &failed).ok();
    let (bodies, feet) = (body.into_iter().collect(), feet.into_iter().collect());
    let drawn = DrawnStates { bodies, has_reference: false, feet };
    if fragment.detail.is_alone() {
        plots::add_sections(fragment, &drawn, dialect);
    }
    let state = ModelState { name: String::new(), figures: &inspected.figures, is_reference: false };
    sphere_figures::section(fragment, &[state]);
    let asked = inspected.similarity.as_ref();
    let compared = checked.similarity.as_ref().filter(|list| list.is_worth_showing());
    if let Some(list) = compared.or(asked) {
        reference::size_section(fragment, list);
    }
    let body = html! { (table_of_forces(inspected)) (table_of_spheres(inspected)) (sentences_on_standing(inspected)) (beside_real_feet(inspected)) (table_of_factors(inspected)) };
    fragment.add_section("contacts", "Forces and spheres of the model", &body);
    fragment.add_section("model", "The model and its files", &facts_of_model(inspected, files));
    drawn
}

fn table_of_forces(inspected: &Inspection) -> Markup {
    let groups = alike_forces(inspected, Extent::Brief);
    if groups.is_empty() {
        return html! { p { "No contact force." } };
    }
    let rows = html! {
        @for group in &groups {
            tr { th scope="row" { (counted_and_named_forces(&group.forces, Extent::Brief)) } @for cell in &group.cells { td { (cell) } } }
        }
    };
    let mut caption =
        "Forces with the same parameters share a row. E₁*, E* in N/m², α and bv in s/m, slip in m/s, cf \
                       in m², bd in 1/m; friction static/dynamic/viscous."
            .to_owned();
    if groups.iter().any(|group| group.cells.iter().any(|cell| cell.contains('*'))) {
        caption.push_str(" * not in the file: from <defaults> or OpenSim's class default.");
    }
    table("Forces", &caption, &["forces", "E₁*", "E*", "α", "friction", "slip", "cf", "bd", "bv"], &rows)
}

/// Sentences about the heights of bodies over their floors.
fn sentences_on_standing(inspected: &Inspection) -> Markup {
    let several = inspected.standing.len() > 1;
    html! {
        @for body in &inspected.standing {
            p {
                "Standing" @if several { " of " (body.body) } ": "
                @for (number, sentence) in sentences_on_body(body, Extent::Brief).iter().enumerate() { @if number > 0 { "; " } (sentence) } "."
            }
        }
        @if let Some(why) = &inspected.why_no_standing { p.aside { "Its height over the floor is not known: " (why) "." } }
    }
}

fn beside_real_feet(inspected: &Inspection) -> Markup {
    let sentences = inspected.beside_real_feet();
    html! { @if !sentences.is_empty() { p { "Beside measured feet: " (sentences.join("; ")) "." } } }
}

fn table_of_spheres(inspected: &Inspection) -> Markup {
    let places = decimals(&inspected.spheres);
    let metres = |value: f64| metres(value, places);
    let unknown = || ["?", "?", "?"].map(str::to_owned);
    let rows = html! {
        @for sphere in &inspected.spheres {
            tr {
                th scope="row" { (sphere.name) }
                td.words { (sphere.body.as_deref().unwrap_or(&sphere.frame)) }
                td.words { (sphere.limb.as_deref().unwrap_or("–")) }
                td { (radius_text(sphere, metres)) }
                @for value in sphere.lowest_point_m.map_or_else(unknown, |point| point.map(metres)) { td { (value) } }
            }
        }
    };
    let caption = "Spheres, in m. The lowest point is in the body's frame, with the body's axes upright.";
    table_if_any("Spheres", caption, &["sphere", " body", " limb", "radius", "lowest x", "y", "z"], &rows)
}

/// The scale factors of each body, compared with the generic model, if there is one.
fn table_of_factors(inspected: &Inspection) -> Markup {
    let Some(factors) = &inspected.body_factors else { return html! {} };
    let shown = |factor: Option<f64>| factor.map_or_else(|| "?".to_owned(), |factor| format!("{factor:.4}"));
    let rows = html! {
        @for body in factors {
            tr {
                th scope="row" { (body.body) }
                @for factor in body.factors { td { (shown(factor)) } }
                td.words { (sources_in_words(&body.sources)) }
            }
        }
    };
    let caption = "Scale factors of bodies, compared with the generic model; ? if not known.";
    table("Factors of bodies", caption, &["body", "x", "y", "z", " from"], &rows)
}

fn facts_of_model(inspected: &Inspection, files: &[NamedDigest]) -> Markup {
    let limbs = inspected.limbs.iter().flatten();
    let limbs: Vec<String> =
        limbs.map(|limb| format!("{} ({}, n = {})", limb.name, limb.side, limb.spheres.len())).collect();
    html! {
        dl {
            (list_of_read_files(files))
            dt { "Name" } dd { (inspected.name) ", document version " (inspected.document_version) }
            dt { "Weighs" } dd { @match inspected.mass_kg {
                Some(mass) => { (four_significant(mass)) " kg (" (inspected.mass_source) ")" }
                None => { "not known" }
            } }
            dt { "Contacts made for" } dd { @match &inspected.contacts_mass_kg {
                Some(mass) => { (mass.in_words(&four_significant(mass.value))) }
                None => { "not known" }
            } }
            @if let Some(note) = &inspected.note { dt { "Note" } dd { (note.sentences.join(" ")) } }
            dt { "Gravity" } dd { @match inspected.gravity_m_s2 {
                Some(gravity) => { (four_significant(gravity)) " m/s²" }
                None => { "cannot be read" }
            } }
            dt { "Limbs" } dd {
                @if limbs.is_empty() { "not known" } @else { (limbs.join(", ")) }
                @if let Some(why) = &inspected.limbs_unknown { ": " (why) }
            }
        }
    }
}

/// The name and the digest of a file.
#[derive(Debug, Clone)]
pub struct NamedDigest {
    pub name: String,
    /// The SHA-256 of the bytes of the file; empty if there are no bytes.
    pub sha256: String,
}

/// The files that a page lists: those that were read, and those that were written.
#[derive(Debug, Clone, Default)]
pub struct ListedFiles {
    /// Files that were read, the model first.
    pub inputs: Vec<NamedDigest>,
    pub result: String,
    pub outputs: Vec<NamedDigest>,
}

/// The files of a change, as a list.
pub(super) fn list_of_files(files: &ListedFiles) -> Markup {
    html! {
        dl {
            (list_of_read_files(&files.inputs))
            dt { "Result" } dd { (files.result) }
            @for file in &files.outputs { dt { "Written" } dd { (name_and_digest(file)) } }
        }
    }
}

/// The files that a model was read from, the model first.
pub(super) fn list_of_read_files(files: &[NamedDigest]) -> Markup {
    html! {
        @for (index, file) in files.iter().enumerate() {
            dt { @if index == 0 { "Model" } @else { "With it" } } dd { (name_and_digest(file)) }
        }
    }
}

fn name_and_digest(NamedDigest { name, sha256 }: &NamedDigest) -> Markup {
    html! { (name) @if !sha256.is_empty() { br; "SHA-256 " code.digest { (sha256) } } }
}
