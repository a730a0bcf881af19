//! A model's contacts as tables of at most 80 columns.

use osim_patch::Property;

use super::figures::SphereFigures;
use super::inspection::{ForceSeen, Inspection, SphereSeen};
use super::rows::{RESTITUTION, ROWS, Row, When};
use super::verdict::Figure;
use crate::report::paint::{OUTSIDE, painted};
use crate::report::{changes, clipped, four, number, right, table, wrapped};

/// Figures of more groups of spheres than this go into a further table.
const GROUPS_ABREAST: usize = 4;

/// Masses, limbs, spheres, forces, and what they do.
pub(crate) fn text(seen: &Inspection) -> String {
    let mut text = head(seen);
    if !seen.spheres.is_empty() {
        text.push('\n');
        text.push_str(&spheres(&seen.spheres));
    }
    if !seen.forces.is_empty() {
        text.push('\n');
        text.push_str(&forces(seen));
    }
    if !seen.forces.is_empty() {
        let figures = figures(seen);
        text.push_str(if figures.is_empty() { "" } else { "\n" });
        text.push_str(&painted(&figures));
    }
    if seen.body_factors.is_some() {
        text.push('\n');
        text.push_str(&body_factors(seen));
    }
    text.push_str(&changes::warnings(&seen.warnings));
    text
}

fn head(seen: &Inspection) -> String {
    let mut text = format!("{}: {} (document version {})\n", seen.model, seen.name, seen.document_version);
    let weighs = match seen.mass_kg {
        Some(mass) => format!("model weighs {} kg ({})", number(mass), seen.mass_told_by),
        None => "what the model weighs is not known".to_owned(),
    };
    let contacts = match &seen.contacts_mass_kg {
        Some(mass) => format!("contacts stand for {} kg ({})", number(mass.value), mass.told_by),
        None => "what its contacts stand for is not known".to_owned(),
    };
    text.push_str(&wrapped(&format!("{weighs}; {contacts}"), ""));
    match seen.gravity_m_s2 {
        Some(gravity) => text.push_str(&format!("gravity {} m/s2\n", number(gravity))),
        None => text.push_str("gravity cannot be read\n"),
    }
    match (&seen.limbs, &seen.limbs_unknown) {
        (Some(limbs), why) => {
            let each: Vec<_> = limbs
                .iter()
                .map(|limb| format!("{} ({}, n = {})", limb.name, limb.side, limb.spheres.len()))
                .collect();
            text.push_str(&wrapped(&format!("limbs: {}", each.join(", ")), "       "));
            text.push_str(&why.as_ref().map(|why| wrapped(why, "")).unwrap_or_default());
        }
        (None, why) => {
            let why = why.as_deref().unwrap_or_default();
            text.push_str(&wrapped(&format!("limbs are not known: {why}"), ""));
        }
    }
    text
}

/// One row per sphere; x, y, z are those of its lowest point.
fn spheres(spheres: &[SphereSeen]) -> String {
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
    right(&mut table, &[3, 4, 5, 6]);
    format!(
        "{}\n  (in m; the lowest point in the body's frame, with the body's axes upright)\n",
        table.trim_fmt()
    )
}

/// Decimals that show a hundredth of the smallest radius.
pub(crate) fn decimals(spheres: &[SphereSeen]) -> usize {
    let radii =
        spheres.iter().map(|sphere| sphere.radius_m).filter(|radius| *radius > 0.0 && radius.is_finite());
    let smallest = radii.fold(1.0, f64::min);
    let mut decimals = 2;
    let mut unit = smallest;
    while unit < 1.0 && decimals < 12 {
        unit *= 10.0;
        decimals += 1;
    }
    decimals
}

/// A length or coordinate, in m.
pub(crate) fn metres(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // Nobody's coordinate is -0.0000.
    if text.chars().all(|letter| matches!(letter, '-' | '0' | '.')) { "0".to_owned() } else { text }
}

/// Forces with the same parameters share a row; a legend says which they are.
fn forces(seen: &Inspection) -> String {
    let groups = groups(seen);
    let mut table = table(&["", "E1*", "E*", "alpha", "friction", "slip", "cf", "bd", "bv"]);
    let mut legend = String::new();
    for (index, (row, members)) in groups.iter().enumerate() {
        let label = format!("F{}", index + 1);
        legend.push_str(&wrapped(&format!("{label}  {}", described(members)), "    "));
        table.add_row([vec![label], row.clone()].concat());
    }
    right(&mut table, &[1, 2, 3, 4, 5, 6, 7, 8]);
    let mut text = format!("{legend}\n{}\n", table.trim_fmt());
    text.push_str("  (E1*, E* in N/m2, alpha and bv in s/m, slip in m/s, cf in m2, bd in 1/m;\n");
    text.push_str("   friction static/dynamic/viscous)\n");
    if seen.forces.iter().any(row_has_default) {
        text.push_str("  (* not in the file: from <defaults> or OpenSim's class default)\n");
    }
    text
}

/// Forces with the same parameters, and these as cells.
pub(crate) fn groups(seen: &Inspection) -> Vec<(Vec<String>, Vec<&ForceSeen>)> {
    let mut groups: Vec<(Vec<String>, Vec<&ForceSeen>)> = Vec::new();
    for force in &seen.forces {
        let row = parameters(force);
        match groups.iter_mut().find(|(known, members)| {
            *known == row
                && members.first().is_some_and(|first| {
                    (first.kind, first.applies, first.selected) == (force.kind, force.applies, force.selected)
                })
        }) {
            Some((_, members)) => members.push(force),
            None => groups.push((row, vec![force])),
        }
    }
    groups
}

fn row_has_default(force: &ForceSeen) -> bool {
    Property::ALL.iter().any(|&property| force.origin.is_default(property))
}

/// How many forces of which class, and their names.
pub(crate) fn described(members: &[&ForceSeen]) -> String {
    const SHOWN: usize = 6;
    let Some(first) = members.first() else { return String::new() };
    let name = |force: &&ForceSeen| match force.set {
        Some(set) if set > 0 => format!("{} (set {set})", force.name),
        _ => force.name.clone(),
    };
    let mut names: Vec<String> = members.iter().take(SHOWN).map(name).collect();
    if members.len() > SHOWN {
        names.push(format!("{} more", members.len() - SHOWN));
    }
    let mut text = format!("{} x {}: {}", members.len(), first.kind, names.join(", "));
    if !first.applies {
        text.push_str(" (disabled)");
    }
    if !first.selected {
        text.push_str(" (not ground contact)");
    }
    text
}

fn parameters(force: &ForceSeen) -> Vec<String> {
    let one = |property: Property| match force.parameters.get(property) {
        Some(value) => {
            format!("{}{}", short(value), if force.origin.is_default(property) { "*" } else { "" })
        }
        None => "-".to_owned(),
    };
    let friction = [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction].map(one);
    vec![
        one(Property::Stiffness),
        force.composite_modulus_n_m2.map_or_else(|| "-".to_owned(), four),
        one(Property::Dissipation),
        friction.join("/"),
        one(Property::TransitionVelocity),
        one(Property::ConstantContactForce),
        one(Property::HertzSmoothing),
        one(Property::HuntCrossleySmoothing),
    ]
}

/// A number of the file: exact where that is short.
fn short(value: f64) -> String {
    let exact = number(value);
    if exact.len() <= 8 { exact } else { four(value) }
}

/// Spheres that do the same, wherever they are.
struct Alike<'a> {
    names: Vec<&'a str>,
    first: &'a SphereFigures,
    mixed: bool,
    key: Vec<String>,
}

fn figures(seen: &Inspection) -> String {
    let mut groups: Vec<Alike<'_>> = Vec::new();
    for limb in &seen.figures.limbs {
        let mixed = limb.is_mixed();
        for sphere in &limb.spheres {
            let key = key(sphere);
            match groups.iter_mut().find(|group| group.key == key) {
                Some(group) => group.names.push(&sphere.sphere),
                None => groups.push(Alike { names: vec![&sphere.sphere], first: sphere, mixed, key }),
            }
        }
    }
    let mut text = String::new();
    if let Some(why) = &seen.figures.without_weight {
        text.push_str(&wrapped(&format!("no figures under body weight: {why}"), ""));
    }
    if !groups.is_empty() {
        text.push_str("What the spheres do (BW: body weight, on one limb unless you say otherwise):\n");
    }
    for (number, chunk) in groups.chunks(GROUPS_ABREAST).enumerate() {
        for (index, group) in chunk.iter().enumerate() {
            let label = format!("S{}", number * GROUPS_ABREAST + index + 1);
            text.push_str(&wrapped(&format!("{label}  {}", listed(&group.names)), "    "));
        }
        text.push('\n');
        text.push_str(&sheet(seen, chunk, number * GROUPS_ABREAST));
    }
    if text.contains(OUTSIDE) {
        text.push_str(&format!("  ({OUTSIDE} outside the limit: check MODEL says more)\n"));
    }
    text
}

/// What is shown of a sphere: spheres with the same figures share a column.
fn key(sphere: &SphereFigures) -> Vec<String> {
    ROWS.iter().map(|row| (row.value)(sphere).map(four).unwrap_or_default()).collect()
}

fn listed(names: &[&str]) -> String {
    const SHOWN: usize = 6;
    let shown = names.iter().take(SHOWN).copied().collect::<Vec<_>>().join(", ");
    match names.len() {
        0..=SHOWN => shown,
        more => format!("{shown} and {} more", more - SHOWN),
    }
}

fn sheet(seen: &Inspection, groups: &[Alike<'_>], before: usize) -> String {
    let labels = (1..=groups.len()).map(|index| format!("S{}", before + index));
    let header: Vec<String> = ["figure".to_owned(), "limit".to_owned()].into_iter().chain(labels).collect();
    let mut table = table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    let mixed = groups.iter().any(|group| group.mixed);
    let smooth = groups.iter().any(|group| group.first.constant_indentation.is_some());
    let shown = |row: &&Row| match row.when {
        When::Always => true,
        When::Smooth => smooth,
        When::Mixed => mixed,
        When::MixedSmooth => mixed && smooth,
    };
    for row in ROWS.iter().filter(shown) {
        let values: Vec<String> = groups.iter().map(|group| cell(row, group.first)).collect();
        if values.iter().all(|value| value == NOTHING) {
            continue;
        }
        let name = match (row.name, seen.figures.impact_speed_m_s) {
            (RESTITUTION, Some(speed)) => format!("restitution at {} m/s", four(speed)),
            (name, _) => name.to_owned(),
        };
        let limit = row.figure.map(Figure::limit_text).unwrap_or_default();
        table.add_row([vec![name, limit], values].concat());
    }
    right(&mut table, &(2..2 + groups.len()).collect::<Vec<_>>());
    format!("{}\n", table.trim_fmt())
}

/// In place of a figure that is not known; its two blanks keep digits below digits.
const NOTHING: &str = "-  ";

fn cell(row: &Row, sphere: &SphereFigures) -> String {
    let holds = row.figure.and_then(|figure| sphere.holds(figure));
    let value = match ((row.value)(sphere), holds) {
        (Some(value), _) => four(value),
        // (13) has no answer below 0, and that is outside.
        (None, Some(false)) => "below 0".to_owned(),
        (None, _) => return NOTHING.to_owned(),
    };
    match holds {
        Some(false) => format!("{value} {OUTSIDE}"),
        _ => format!("{value}  "),
    }
}

/// Each body's factors against the generic model; `?` where no source says.
fn body_factors(seen: &Inspection) -> String {
    let mut table = table(&["scaled body", "x", "y", "z", "from"]);
    for body in seen.body_factors.iter().flatten() {
        let mut cells = vec![body.body.clone()];
        cells.extend(body.factors.map(|factor| factor.map_or_else(|| "?".to_owned(), |f| format!("{f:.6}"))));
        let mut sources: Vec<&str> = body.sources.iter().flatten().copied().collect();
        sources.dedup();
        cells.push(sources.join(", "));
        table.add_row(cells);
    }
    right(&mut table, &[1, 2, 3]);
    format!("{}\n", table.trim_fmt())
}
