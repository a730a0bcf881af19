//! The dimensionless contact beside that of its reference, and other numbers that follow the size of a body.

use contact_scaling::DimensionlessContact;
use maud::{Markup, html};
use osim_inspect::series::{ContactBody, SphereKind};
use osim_inspect::{ReferenceState, SizeList};
use osim_model::messages::{four_significant, readable};

use crate::html::fragment::{Fragment, table};
use crate::report::extent::Extent;
use crate::report::similarity::{about, cells, gaps, headings};

/// Id and title of the section that compares the contact with that of the reference.
pub(super) const SECTION_HEAD: (&str, &str) = ("reference", "The contact beside that of the reference");
/// Numbers are equal if they differ by less than this, relative to the larger number.
const RELATIVE_ROUNDING: f64 = 1e-9;

type Contacts<'b> = Vec<(&'b SphereKind, DimensionlessContact)>;

/// Adds the section about the reference. `bodies` are the model before and after the change.
pub(super) fn section(fragment: &mut Fragment, reference: &ReferenceState, bodies: &[ContactBody]) {
    let Some(body) = &reference.body else { return };
    let states: Vec<(&str, Contacts<'_>)> =
        bodies.iter().filter_map(|body| Some((body.name.as_str(), body.dimensionless().ok()?))).collect();
    // A transfer that scales no gravity takes the contacts as they are under the gravity of the model.
    let gravity = bodies.last().and_then(|body| body.weight().ok()).map(|weight| weight.gravity_m_s2);
    let moved_body = gravity.map(|gravity| with_gravity(body, gravity));
    let (Ok(in_own_gravity), Some(Ok(in_model_gravity))) =
        (body.dimensionless(), moved_body.as_ref().map(ContactBody::dimensionless))
    else {
        return;
    };
    let last = states.last().map(|(_, last)| last);
    let equal = |reference: &Contacts<'_>| last.is_some_and(|last| all_agree(last, reference));
    let has_own_gravity = equal(&in_own_gravity) || !equal(&in_model_gravity);
    let shown = if has_own_gravity { &in_own_gravity } else { &in_model_gravity };
    let rows = html! {
        @for contact in shown { (table_row("reference", contact)) }
        @for (state, contacts) in &states { @for contact in contacts { (table_row(state, contact)) } }
    };
    let name = match gravity.filter(|_| !has_own_gravity) {
        Some(gravity) => format!("{} under {} m/s²", reference.name, readable(gravity)),
        None => reference.name.clone(),
    };
    let caption = "Dimensionless numbers of the contacts, each under its own weight: x/R by (11), damping, constant indentation, and \
                   smoothing.";
    let headers = ["contact", " spheres", "R in m", "x/R", "α √(gR)", "√cf/R", "bd R", "bv √(gR)"];
    let body = html! {
        p { (verdict_on_contact(&name, equal(shown), states.len() > 1)) }
        (table("Contacts beside the reference's", caption, &headers, &rows))
        (table_of_parameters(body, bodies))
    };
    fragment.add_section(SECTION_HEAD.0, SECTION_HEAD.1, &body);
}

/// The reference in one clause, for a page about many models.
pub(super) fn in_words(reference: &ReferenceState) -> String {
    let Some(body) = &reference.body else { return reference.name.clone() };
    let weight = body
        .weight()
        .ok()
        .map(|weight| format!(" ({} kg, n = {})", readable(weight.mass_kg), readable(weight.sphere_count)));
    let contacts = body.dimensionless().unwrap_or_default();
    let kinds = contacts.iter().map(|(kind, contact)| {
        let (modulus, damping) = (kind.contact.plane_strain_modulus(), kind.contact.dissipation());
        format!(
            "R = {} m, E₁* = {} N/m², α = {} s/m, x/R = {}",
            readable(kind.radius_m),
            readable(modulus),
            readable(damping),
            four_significant(contact.relative_indentation())
        )
    });
    let kinds: Vec<String> = kinds.collect();
    format!("{}{}: {}", reference.name, weight.unwrap_or_default(), kinds.join("; "))
}

/// A table of the contact parameters in the files of both models.
fn table_of_parameters(reference: &ContactBody, bodies: &[ContactBody]) -> Markup {
    let named =
        std::iter::once(("reference", reference)).chain(bodies.iter().map(|body| (body.name.as_str(), body)));
    let rows = html! {
        @for (state, body) in named { @for kind in &body.kinds { (parameter_row(state, body, kind)) } }
    };
    let caption = "The same contacts with dimensions: body mass, n (spheres that share the weight), R, and the properties of the \
                   force. They differ from the reference's as the bodies do.";
    let properties = ["E₁*, N/m²", "α, s/m", "cf, m²", "bd, 1/m", "bv, s/m"];
    let headers = [&["contact", " spheres", "mass, kg", "n", "R, m"][..], &properties].concat();
    table("Parameters beside the reference's", caption, &headers, &rows)
}

fn parameter_row(state: &str, body: &ContactBody, kind: &SphereKind) -> Markup {
    let weight = body.weight().ok();
    let (contact, smoothing) = (kind.contact.values(), kind.contact.smoothing());
    let numbers = [
        weight.map(|weight| weight.mass_kg),
        weight.map(|weight| weight.sphere_count),
        Some(kind.radius_m),
        Some(contact.plane_strain_modulus),
        Some(contact.dissipation),
        smoothing.map(|smoothing| smoothing.constant_contact_force),
        smoothing.map(|smoothing| smoothing.hertz_smoothing),
        smoothing.map(|smoothing| smoothing.hunt_crossley_smoothing),
    ];
    html! {
        tr {
            th scope="row" { (state) }
            td.words { (sphere_names(kind)) }
            @for number in numbers { td { (number.map_or_else(|| "–".to_owned(), readable)) } }
        }
    }
}

fn sphere_names(kind: &SphereKind) -> &str {
    if kind.spheres.is_empty() { "all" } else { &kind.spheres }
}

fn with_gravity(body: &ContactBody, gravity_m_s2: f64) -> ContactBody {
    let mut body = body.clone();
    if let Ok(weight) = &mut body.weight {
        weight.gravity_m_s2 = gravity_m_s2;
    }
    body
}

fn all_agree(contacts: &Contacts<'_>, reference: &Contacts<'_>) -> bool {
    contacts.iter().all(|(_, contact)| reference.iter().any(|(_, other)| contacts_agree(contact, other)))
}

/// A sentence that says whether the contact is the same as in the reference.
fn verdict_on_contact(name: &str, equal: bool, changed: bool) -> String {
    let is = if changed { "The contact is now" } else { "The contact is" };
    if equal {
        return format!(
            "{is} as that of {name}: all dimensionless numbers are equal. What is outside a limit here is outside it in \
             the reference, too."
        );
    }
    format!("{is} not that of {name} in all numbers: the rows of this table show which differ.")
}

/// Whether all numbers that both contacts have are the same. A `HuntCrossleyForce` has no smoothing.
fn contacts_agree(one: &DimensionlessContact, other: &DimensionlessContact) -> bool {
    let numbers = |contact: &DimensionlessContact| {
        [
            Some(contact.modulus()),
            Some(contact.dissipation()),
            contact.constant_indentation(),
            contact.hertz_smoothing(),
            contact.hunt_crossley_smoothing(),
        ]
    };
    numbers(one).into_iter().zip(numbers(other)).all(|pair| match pair {
        (Some(a), Some(b)) => (a - b).abs() <= RELATIVE_ROUNDING * f64::max(a.abs(), b.abs()),
        _ => true,
    })
}

fn table_row(state: &str, (kind, contact): &(&SphereKind, DimensionlessContact)) -> Markup {
    let four = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), four_significant);
    html! {
        tr {
            th scope="row" { (state) }
            td.words { (sphere_names(kind)) }
            td { (readable(kind.radius_m)) }
            td { (four(Some(contact.relative_indentation()))) }
            td { (four(Some(contact.dissipation()))) }
            td { (four(contact.constant_indentation())) }
            td { (four(contact.hertz_smoothing())) }
            td { (four(contact.hunt_crossley_smoothing())) }
        }
    }
}

// What else follows the size of a body.

/// Adds the section with the numbers that follow the size of a body, with a row for each kind of number.
pub(super) fn size_section(fragment: &mut Fragment, list: &SizeList) {
    let rows = html! {
        @for [name, count, numbers, similar, last] in list.kinds.iter().map(|row| cells(list, row, Extent::Brief)) {
            tr { th scope="row" { (name) } td { (count) } td { (numbers) } td { (similar) } td.words { (last) } }
        }
    };
    let [name, count, numbers, similar, last] = headings(list);
    let last = format!(" {last}");
    let body = html! {
        @for sentence in about(list, Extent::Brief) { p { (sentence) "." } }
        (table("What else follows size", "Factors, new over old.", &[name, count, numbers, similar, &last], &rows))
        @for sentence in gaps(list, Extent::Brief) { p.aside { (sentence) "." } }
    };
    fragment.add_section("similarity", "What else follows size", &body);
}
