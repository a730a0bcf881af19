//! A model that was looked at: `inspect` and `check`.

use maud::{Markup, html};
use osim_patch::Model;

use super::figures::{self, State};
use super::fragment::{Fragment, Frame, table};
use super::{Entry, change, file_name, findings, plots};
use crate::check::Report;
use crate::load::Loaded;
use crate::look::{self, Inspection, View};
use crate::plotting::body::Body;
use crate::report::{four, number};

/// Everything about one model.
pub(crate) fn entry_of_look(
    view: &View,
    loaded: &Loaded,
    model: &Model,
    (seen, report): (&Inspection, &Report),
    frame: Frame,
) -> Entry {
    let mut fragment = Fragment::new(frame);
    findings::of_model(&mut fragment, report);
    let failed = |fault| loaded.failure(fault);
    let body = || Body::seen(file_name(&loaded.shown).to_owned(), model, view, &failed).ok();
    if let Some(body) = frame.plots.then(body).flatten() {
        plots::section(&mut fragment, &[body]);
    }
    figures::section(&mut fragment, &[State { name: String::new(), figures: &seen.figures }]);
    let body = html! { (forces(seen)) (spheres(seen)) (factors(seen)) };
    fragment.section("contacts", "The contacts", &body);
    fragment.section("model", "The model", &the_model(seen, loaded));
    Entry::of_inspection(seen, report.counts, fragment)
}

fn forces(seen: &Inspection) -> Markup {
    let groups = look::table::groups(seen);
    let rows: Vec<Markup> = groups
        .iter()
        .map(|(row, members)| {
            html! { tr { th scope="row" { (look::table::described(members)) } @for cell in row { td { (cell) } } } }
        })
        .collect();
    if rows.is_empty() {
        return html! { p { "No contact force." } };
    }
    let mut caption =
        "Forces with the same parameters share a row. E₁*, E* in N/m², α and bv in s/m, slip in m/s, cf \
                       in m², bd in 1/m; friction static/dynamic/viscous."
            .to_owned();
    if groups.iter().any(|(row, _)| row.iter().any(|cell| cell.contains('*'))) {
        caption.push_str(" * not in the file: from <defaults> or OpenSim's class default.");
    }
    table("Forces", &caption, &["forces", "E₁*", "E*", "α", "friction", "slip", "cf", "bd", "bv"], &rows)
}

fn spheres(seen: &Inspection) -> Markup {
    if seen.spheres.is_empty() {
        return html! {};
    }
    let decimals = look::table::decimals(&seen.spheres);
    let metres = |value: f64| look::table::metres(value, decimals);
    let rows: Vec<Markup> = seen
        .spheres
        .iter()
        .map(|sphere| {
            let lowest = sphere.lowest_point_m.map(|point| point.map(metres));
            html! {
                tr {
                    th scope="row" { (sphere.name) }
                    td.words { (sphere.body.as_deref().unwrap_or(&sphere.frame)) }
                    td.words { (sphere.limb.as_deref().unwrap_or("–")) }
                    td { (metres(sphere.radius_m)) }
                    @for value in lowest.unwrap_or_else(|| ["?", "?", "?"].map(str::to_owned)) { td { (value) } }
                }
            }
        })
        .collect();
    let caption = "Spheres, in m. The lowest point is in the body's frame, with the body's axes upright.";
    table("Spheres", caption, &["sphere", " body", " limb", "radius", "lowest x", "y", "z"], &rows)
}

/// Each body's factors against the generic model, where one was named.
fn factors(seen: &Inspection) -> Markup {
    let Some(factors) = &seen.body_factors else { return html! {} };
    let shown = |factor: Option<f64>| factor.map_or_else(|| "?".to_owned(), |factor| format!("{factor:.6}"));
    let rows: Vec<Markup> = factors
        .iter()
        .map(|body| {
            html! {
                tr {
                    th scope="row" { (body.body) }
                    @for factor in body.factors { td { (shown(factor)) } }
                    td.words { (sources(&body.sources)) }
                }
            }
        })
        .collect();
    let caption = "How bodies were scaled against the generic model; ? where nothing says.";
    table("Factors of bodies", caption, &["body", "x", "y", "z", " from"], &rows)
}

fn sources(sources: &[Option<&'static str>]) -> String {
    let mut named: Vec<&str> = sources.iter().flatten().copied().collect();
    named.dedup();
    named.join(", ")
}

fn the_model(seen: &Inspection, loaded: &Loaded) -> Markup {
    let limbs = seen.limbs.iter().flatten();
    let limbs: Vec<String> =
        limbs.map(|limb| format!("{} ({}, n = {})", limb.name, limb.side, limb.spheres.len())).collect();
    html! {
        dl {
            (change::read(&loaded.digests()))
            dt { "Name" } dd { (seen.name) ", document version " (seen.document_version) }
            dt { "Weighs" } dd { @match seen.mass_kg {
                Some(mass) => { (number(mass)) " kg (" (seen.mass_told_by) ")" }
                None => { "not known" }
            } }
            dt { "Contacts stand for" } dd { @match &seen.contacts_mass_kg {
                Some(mass) => { (number(mass.value)) " kg (" (mass.told_by) ")" }
                None => { "not known" }
            } }
            dt { "Gravity" } dd { @match seen.gravity_m_s2 {
                Some(gravity) => { (four(gravity)) " m/s²" }
                None => { "cannot be read" }
            } }
            dt { "Limbs" } dd {
                @if limbs.is_empty() { "not known" } @else { (limbs.join(", ")) }
                @if let Some(why) = &seen.limbs_unknown { ": " (why) }
            }
        }
    }
}
