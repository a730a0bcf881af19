//! A model's contacts as tables of at most 80 columns.

use osim_inspect::{InspectedSphere, Inspection};
use osim_model::messages::{Dialect, Phrase, one_line, readable, shown};

use super::force_groups::{described, groups, has_default};
use super::lengths::{decimals, metres};
use super::on_feet::sentences;
use super::sphere_sheet;
use crate::report::layout::{Colour, clipped, painted, table, wrapped};
use crate::report::messages::warnings;
use crate::report::similarity;

/// Masses, limbs, spheres, forces, and what they do. What the inspection says is taken as it is spelled.
#[must_use]
pub fn text(inspected: &Inspection, dialect: &dyn Dialect, colour: Colour) -> String {
    let mut text = head(inspected);
    if !inspected.spheres.is_empty() {
        text.push('\n');
        text.push_str(&spheres(&inspected.spheres));
    }
    if !inspected.forces.is_empty() {
        text.push('\n');
        text.push_str(&forces(inspected));
    }
    if !inspected.forces.is_empty() {
        let figures = sphere_sheet::text(inspected, dialect);
        text.push_str(if figures.is_empty() { "" } else { "\n" });
        text.push_str(&painted(&figures, colour));
        text.push_str(&standing(inspected));
    }
    if inspected.body_factors.is_some() {
        text.push('\n');
        text.push_str(&body_factors(inspected));
    }
    if let Some(list) = &inspected.similarity {
        text.push('\n');
        text.push_str(&similarity::text(list));
    }
    text.push_str(&warnings(&inspected.warnings));
    text
}

fn head(inspected: &Inspection) -> String {
    let title =
        format!("{}: {} (document version {})", inspected.model, inspected.name, inspected.document_version);
    let mut text = format!("{}\n", one_line(title));
    let weighs = match inspected.mass_kg {
        Some(mass) => format!("model weighs {} kg ({})", readable(mass), inspected.mass_source),
        None => "what the model weighs is not known".to_owned(),
    };
    let contacts = match &inspected.contacts_mass_kg {
        Some(mass) => format!("contacts made for: {}", mass.in_words()),
        None => "which mass its contacts are made for is not known".to_owned(),
    };
    text.push_str(&wrapped(&format!("{weighs}; {contacts}"), ""));
    for sentence in inspected.note.iter().flat_map(|note| &note.sentences) {
        text.push_str(&wrapped(sentence, ""));
    }
    if let Some(known) = &inspected.known_contacts {
        let made_for = readable(known.made_for_kg);
        text.push_str(&wrapped(
            &format!("the contact parameters are those of {}, made for {made_for} kg", known.title),
            "",
        ));
    }
    match inspected.gravity_m_s2 {
        Some(gravity) => text.push_str(&format!("gravity {} m/s2\n", readable(gravity))),
        None => text.push_str("gravity cannot be read\n"),
    }
    let why = inspected.limbs_unknown.as_ref().map(Phrase::to_string);
    match &inspected.limbs {
        Some(limbs) => {
            let each: Vec<_> = limbs
                .iter()
                .map(|limb| format!("{} ({}, n = {})", limb.name, limb.side, limb.spheres.len()))
                .collect();
            text.push_str(&wrapped(&format!("limbs: {}", each.join(", ")), "       "));
            text.push_str(&why.map(|why| wrapped(&why, "")).unwrap_or_default());
        }
        None => {
            let why = why.unwrap_or_default();
            text.push_str(&wrapped(&format!("limbs are not known: {why}"), ""));
        }
    }
    text
}

/// One row per sphere; x, y, z are those of its lowest point.
fn spheres(spheres: &[InspectedSphere]) -> String {
    let mut table = table(&["sphere", "body", "limb", "radius", "lowest x", "y", "z"]);
    let decimals = decimals(spheres);
    for sphere in spheres {
        let body = sphere.body.as_deref().unwrap_or(&sphere.frame);
        let mut cells = vec![
            clipped(&sphere.name, 17),
            clipped(body, 12),
            clipped(sphere.limb.as_deref().unwrap_or("-"), 10),
            metres(sphere.radius_m, decimals),
        ];
        match sphere.lowest_point_m {
            Some(point) => cells.extend(point.map(|value| metres(value, decimals))),
            None => cells.extend(["?", "?", "?"].map(str::to_owned)),
        }
        table.add_row(cells);
    }
    table.right_aligned(&[3, 4, 5, 6]);
    format!(
        "{}\n  (in m; the lowest point in the body's frame, with the body's axes upright)\n",
        table.trim_fmt()
    )
}

/// Forces with the same parameters share a row; a legend says which they are.
fn forces(inspected: &Inspection) -> String {
    let groups = groups(inspected);
    let mut table = table(&["", "E1*", "E*", "alpha", "friction", "slip", "cf", "bd", "bv"]);
    let mut legend = String::new();
    for (index, group) in groups.into_iter().enumerate() {
        let label = format!("F{}", index + 1);
        legend.push_str(&wrapped(&format!("{label}  {}", described(&group.forces)), "    "));
        table.add_row([vec![label], group.cells].concat());
    }
    table.right_aligned(&[1, 2, 3, 4, 5, 6, 7, 8]);
    let mut text = format!("{legend}\n{}\n", table.trim_fmt());
    text.push_str("  (E1*, E* in N/m2, alpha and bv in s/m, slip in m/s, cf in m2, bd in 1/m;\n");
    text.push_str("   friction static/dynamic/viscous)\n");
    if inspected.forces.iter().any(has_default) {
        text.push_str("  (* not in the file: from <defaults> or OpenSim's class default)\n");
    }
    text
}

/// Where bodies are over their floors, and what puts them on their feet.
fn standing(inspected: &Inspection) -> String {
    let several = inspected.standing.len() > 1;
    let mut text = String::new();
    for body in &inspected.standing {
        let which = if several { format!(" of {}", shown(&body.body)) } else { String::new() };
        text.push_str(&format!("\nStanding{which}:\n"));
        for sentence in sentences(body) {
            text.push_str(&wrapped(&format!("  {sentence}"), "    "));
        }
    }
    if let Some(why) = &inspected.why_no_standing {
        text.push_str(&wrapped(&format!("where it stands is not known: {why}"), ""));
    }
    text
}

/// Each body's factors, compared with the generic model; `?` if no source has them.
fn body_factors(inspected: &Inspection) -> String {
    let mut table = table(&["scaled body", "x", "y", "z", "from"]);
    for body in inspected.body_factors.iter().flatten() {
        let mut cells = vec![body.body.clone()];
        cells.extend(body.factors.map(|factor| factor.map_or_else(|| "?".to_owned(), |f| format!("{f:.6}"))));
        let mut sources: Vec<&str> = body.sources.iter().flatten().copied().collect();
        sources.dedup();
        cells.push(sources.join(", "));
        table.add_row(cells);
    }
    table.right_aligned(&[1, 2, 3]);
    format!("{}\n", table.trim_fmt())
}
