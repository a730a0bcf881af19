//! The contacts of a model, and the figures of these under its weight, as text: tables of at most 80 columns, and sentences about how a
//! body stands on its feet.

mod models_table;
pub mod spheres;

use std::collections::HashMap;

use osim_inspect::{BodyAtRest, InspectedForce, InspectedSphere, Inspection, StandingBody, StandingSphere};
use osim_model::Property;
use osim_model::messages::{Dialect, Phrase, four_significant, one_line, readable, shown, three_significant};

use crate::report::check::beside_real_feet;
use crate::report::extent::{Extent, Layout};
use crate::report::layout::{colour_marks, table};
use crate::report::messages::finding_lines;
use crate::report::similarity;

pub use models_table::ModelsTable;
pub use spheres::csv_rows;

/// The inspection as text: masses, limbs, spheres, forces, and figures. The texts of the inspection are already in the words of the front
/// end.
pub fn text(inspected: &Inspection, dialect: &dyn Dialect, layout: Layout) -> String {
    let mut text = head_of_model(inspected, layout);
    if !inspected.spheres.is_empty() {
        text.push('\n');
        text.push_str(&table_of_spheres(&inspected.spheres, layout));
    }
    if !inspected.forces.is_empty() {
        text.push('\n');
        text.push_str(&table_of_forces(inspected, layout));
        let figures = spheres::sphere_sheet(inspected, dialect, layout);
        text.push_str(if figures.is_empty() { "" } else { "\n" });
        text.push_str(&colour_marks(&figures, layout.colour));
        text.push_str(&sentences_on_standing(inspected, layout));
        if layout.extent.is_full() {
            text.push_str(&beside_real_feet(&inspected.beside_real_feet(), layout));
        }
    }
    if inspected.body_factors.is_some() {
        text.push('\n');
        text.push_str(&body_factors(inspected, layout));
    }
    if let Some(list) = &inspected.similarity {
        text.push('\n');
        text.push_str(&similarity::text(list, layout));
    }
    text.push_str(&finding_lines(&inspected.findings));
    text
}

fn head_of_model(inspected: &Inspection, layout: Layout) -> String {
    let number = |value| layout.extent.number(value, four_significant);
    let title =
        format!("{}: {} (document version {})", inspected.model, inspected.name, inspected.document_version);
    let mut text = format!("{}\n", one_line(title));
    let weighs = match inspected.mass_kg {
        Some(mass) => format!("model weighs {} kg ({})", number(mass), inspected.mass_source),
        None => "the mass of the model is not known".to_owned(),
    };
    let contacts = match &inspected.contacts_mass_kg {
        Some(mass) => format!("contacts made for: {}", mass.in_words(&number(mass.value))),
        None => "which mass its contacts are made for is not known".to_owned(),
    };
    text.push_str(&layout.wrapped(&format!("{weighs}; {contacts}"), ""));
    for sentence in inspected.note.iter().flat_map(|note| &note.sentences) {
        text.push_str(&layout.wrapped(sentence, ""));
    }
    if let Some(known) = &inspected.known_contacts {
        let made_for = number(known.made_for_kg);
        text.push_str(&layout.wrapped(
            &format!("the contact parameters are those of {}, made for {made_for} kg", known.title),
            "",
        ));
    }
    match inspected.gravity_m_s2 {
        Some(gravity) => {
            text.push_str(&format!("gravity {} m/s2\n", layout.extent.number(gravity, few_digits)));
        }
        None => text.push_str("gravity cannot be read\n"),
    }
    let why = inspected.limbs_unknown.as_ref().map(Phrase::to_string);
    match &inspected.limbs {
        Some(limbs) => {
            let each: Vec<_> = limbs
                .iter()
                .map(|limb| format!("{} ({}, n = {})", limb.name, limb.side, limb.spheres.len()))
                .collect();
            text.push_str(&layout.wrapped(&format!("limbs: {}", each.join(", ")), "       "));
            text.push_str(&why.map(|why| layout.wrapped(&why, "")).unwrap_or_default());
        }
        None => {
            let why = why.unwrap_or_default();
            text.push_str(&layout.wrapped(&format!("limbs are not known: {why}"), ""));
        }
    }
    text
}

/// One row for each sphere; x, y, z are the place of its lowest point.
fn table_of_spheres(spheres: &[InspectedSphere], layout: Layout) -> String {
    let extent = layout.extent;
    let mut table = table(&["sphere", "body", "limb", "radius", "lowest x", "y", "z"]);
    let decimals = decimals(spheres);
    let length = |value| extent.number(value, |value| metres(value, decimals));
    for sphere in spheres {
        let body = sphere.body.as_deref().unwrap_or(&sphere.frame);
        let mut cells = vec![
            extent.name(&sphere.name, 17),
            extent.name(body, 12),
            extent.name(sphere.limb.as_deref().unwrap_or("-"), 10),
            radius_text(sphere, length),
        ];
        let lowest = sphere.lowest_point_m.map(|point| point.map(length));
        cells.extend(lowest.unwrap_or_else(|| ["?"; 3].map(str::to_owned)));
        table.add_row(cells);
    }
    table.right_aligned(&[3, 4, 5, 6]);
    format!(
        "{}\n  (in m; the lowest point in the body's frame, with the body's axes upright)\n",
        table.into_lines(layout.columns)
    )
}

/// A row for each group of forces with the same parameters, and a legend with the names of these forces.
fn table_of_forces(inspected: &Inspection, layout: Layout) -> String {
    let extent = layout.extent;
    let groups = alike_forces(inspected, extent);
    let mut table = table(&["", "E1*", "E*", "alpha", "friction", "slip", "cf", "bd", "bv"]);
    let mut legend = String::new();
    for (index, group) in groups.into_iter().enumerate() {
        let label = format!("F{}", index + 1);
        legend.push_str(
            &layout.wrapped(&format!("{label}  {}", counted_and_named_forces(&group.forces, extent)), "    "),
        );
        table.add_row([vec![label], group.cells].concat());
    }
    table.right_aligned(&[1, 2, 3, 4, 5, 6, 7, 8]);
    let mut text = format!("{legend}\n{}\n", table.into_lines(layout.columns));
    text.push_str("  (E1*, E* in N/m2, alpha and bv in s/m, slip in m/s, cf in m2, bd in 1/m;\n");
    text.push_str("   friction static/dynamic/viscous)\n");
    let has_default =
        |force: &InspectedForce| Property::changeable().any(|property| force.is_default(property));
    if inspected.forces.iter().any(has_default) {
        text.push_str("  (* not in the file: from <defaults> or OpenSim's class default)\n");
    }
    text
}

/// Sentences about the heights of bodies over their floors, and about the coordinate that puts each body on its feet.
fn sentences_on_standing(inspected: &Inspection, layout: Layout) -> String {
    let several = inspected.standing.len() > 1;
    let mut text = String::new();
    for body in &inspected.standing {
        let which = if several { format!(" of {}", shown(&body.body)) } else { String::new() };
        text.push_str(&format!("\nStanding{which}:\n"));
        for sentence in sentences_on_body(body, layout.extent) {
            text.push_str(&layout.wrapped(&format!("  {sentence}"), "    "));
        }
    }
    if let Some(why) = &inspected.why_no_standing {
        text.push_str(&layout.wrapped(&format!("its height over the floor is not known: {why}"), ""));
    }
    text
}

/// The scale factors of each body, compared with the generic model; `?` for a factor that no source has.
fn body_factors(inspected: &Inspection, layout: Layout) -> String {
    let number = |factor| layout.extent.number(factor, |factor| format!("{factor:.4}"));
    let mut table = table(&["scaled body", "x", "y", "z", "from"]);
    for body in inspected.body_factors.iter().flatten() {
        let mut cells = vec![body.body.clone()];
        cells.extend(body.factors.map(|factor| factor.map_or_else(|| "?".to_owned(), number)));
        cells.push(sources_in_words(&body.sources));
        table.add_row(cells);
    }
    table.right_aligned(&[1, 2, 3]);
    format!("{}\n", table.into_lines(layout.columns))
}

/// Where factors of a body come from.
pub(crate) fn sources_in_words(sources: &[Option<&'static str>]) -> String {
    let mut named: Vec<&str> = sources.iter().flatten().copied().collect();
    named.dedup();
    named.join(", ")
}

// A body over its floor and on its feet, in sentences: the text and the page share them.

/// The largest number of spheres that are named.
const MOST_SPHERES_NAMED: usize = 6;

/// Sentences about a body: its height at the default pose, and the equilibria on all its feet and on one limb.
pub(crate) fn sentences_on_body(body: &StandingBody, extent: Extent) -> Vec<String> {
    let Some((lowest, place)) = body.lowest().zip(body.pose_in_words()) else {
        return vec!["the height of its spheres over a floor is not known".to_owned()];
    };
    let mut sentence =
        format!("at the default pose {}, the lowest sphere, is {place}", shown(&lowest.sphere));
    if let Some(why) = &body.why_no_coordinate {
        sentence.push_str(&format!("; no coordinate brings the body to the floor: {why}"));
    }
    let mut sentences = vec![sentence];
    let (one, all) = (body.on_one_limb.as_ref(), body.as_posed.as_ref());
    let differs = |one: &&BodyAtRest| all.is_some_and(|all| one.spheres != all.spheres);
    let rests = [("on all feet", all), ("on one limb", one.filter(differs))];
    let known = rests.into_iter().filter_map(|(how, rest)| Some((how, rest?)));
    sentences.extend(known.map(|(how, rest)| sentence_on_rest(body, how, rest, extent)));
    if body.as_posed.is_none() {
        let why = match body.weight_n {
            None => "a mass or gravity is missing",
            Some(_) => "a contact cannot be read, or no depth carries the weight",
        };
        sentences.push(format!("which coordinate brings the body to the floor is not known: {why}"));
    }
    sentences
}

fn sentence_on_rest(body: &StandingBody, how: &str, rest: &BodyAtRest, extent: Extent) -> String {
    let limb = rest.limb.as_deref().map(|limb| format!(", {}", shown(limb))).unwrap_or_default();
    let load = extent.number(rest.load_n, four_significant);
    let carries = if rest.carried {
        let place = body.coordinate_at_rest(rest).map(|set| format!(" with {set}")).unwrap_or_default();
        format!("carries {load} N{place}")
    } else {
        format!("its spheres cannot carry the {load} N")
    };
    format!("{how}{limb}: {carries}; {}", depths_in_words(rest, extent))
}

/// The spheres that touch the floor, and how deep each is.
fn depths_in_words(rest: &BodyAtRest, extent: Extent) -> String {
    let touching: Vec<&StandingSphere> = rest.touching().collect();
    let deep = |one: &StandingSphere| extent.number(one.relative_indentation, three_significant);
    let least = touching
        .iter()
        .copied()
        .reduce(|a, b| if b.relative_indentation < a.relative_indentation { b } else { a });
    let Some((most, least)) = rest.deepest().zip(least) else {
        return "no sphere touches: the smoothing carries it".to_owned();
    };
    let x = match deep(most) == deep(least) {
        true => format!("x is {} R", deep(most)),
        false => {
            let (most_of, least_of) = (shown(&most.sphere), shown(&least.sphere));
            format!("x is {} R ({least_of}) to {} R ({most_of})", deep(least), deep(most))
        }
    };
    match (touching.len(), rest.spheres.len()) {
        (1, 1) => format!("its only sphere touches, {x}"),
        (some, of) if some == of => format!("all {of} spheres touch, {x}"),
        (some, of) => {
            let names: Vec<String> = touching.iter().map(|one| shown(&one.sphere).to_string()).collect();
            let names = extent.names(&names, MOST_SPHERES_NAMED);
            format!("{some} of {of} spheres touch ({names}), {x}")
        }
    }
}

// Forces with the same parameters together.

/// A group of forces with the same parameters.
pub struct ForceGroup<'m> {
    /// The parameters, in the order of the table.
    pub cells: Vec<String>,
    /// The forces, in the order of the file.
    pub forces: Vec<&'m InspectedForce>,
}

/// The forces of a model in groups; the forces of a group have the same parameters.
pub(crate) fn alike_forces(inspected: &Inspection, extent: Extent) -> Vec<ForceGroup<'_>> {
    let mut groups: Vec<ForceGroup<'_>> = Vec::new();
    let (mut places, mut exact) = (HashMap::new(), HashMap::new());
    for force in &inspected.forces {
        let how = (force.kind, force.applies, force.selected);
        let found = || *places.entry((parameter_cells(force, extent), how)).or_insert(groups.len());
        let place = *exact.entry((exact_parameters(force), how)).or_insert_with(found);
        match groups.get_mut(place) {
            Some(group) => group.forces.push(force),
            None => groups.push(ForceGroup { cells: parameter_cells(force, extent), forces: vec![force] }),
        }
    }
    groups
}

/// The number of forces of each class, and the names of the forces.
pub(crate) fn counted_and_named_forces(members: &[&InspectedForce], extent: Extent) -> String {
    const MOST_NOTE_STEPS: usize = 6;
    let Some(first) = members.first() else { return String::new() };
    let name = |force: &&InspectedForce| match force.set {
        Some(set) if set > 0 => format!("{} (set {set})", force.name),
        _ => force.name.clone(),
    };
    let most = if extent.is_full() { members.len() } else { MOST_NOTE_STEPS };
    let mut names: Vec<String> = members.iter().take(most).map(name).collect();
    if members.len() > most {
        names.push(format!("{} more", members.len() - most));
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

fn parameter_cells(force: &InspectedForce, extent: Extent) -> Vec<String> {
    let one = |property: Property| match force.parameter(property) {
        Some(value) => {
            format!(
                "{}{}",
                extent.number(value, few_digits),
                if force.is_default(property) { "*" } else { "" }
            )
        }
        None => "-".to_owned(),
    };
    let friction = [Property::StaticFriction, Property::DynamicFriction, Property::ViscousFriction].map(one);
    vec![
        one(Property::Stiffness),
        force
            .composite_modulus_n_m2
            .map_or_else(|| "-".to_owned(), |modulus| extent.number(modulus, four_significant)),
        one(Property::Dissipation),
        friction.join("/"),
        one(Property::TransitionVelocity),
        one(Property::ConstantContactForce),
        one(Property::HertzSmoothing),
        one(Property::HuntCrossleySmoothing),
    ]
}

/// The numbers from which the cells of a force are made. Forces with equal numbers have equal cells.
fn exact_parameters(force: &InspectedForce) -> (Vec<(Option<u64>, bool)>, Option<u64>) {
    let one = |property| (force.parameter(property).map(f64::to_bits), force.is_default(property));
    (Property::changeable().map(one).collect(), force.composite_modulus_n_m2.map(f64::to_bits))
}

/// A number of the file: all its digits if these are at most eight letters, else four significant digits.
fn few_digits(value: f64) -> String {
    let exact = readable(value);
    if exact.len() <= 8 { exact } else { four_significant(value) }
}

/// The radius of a sphere, or the three radii of an ellipsoid, each number written by `length`.
pub(crate) fn radius_text(sphere: &InspectedSphere, length: impl Fn(f64) -> String) -> String {
    match sphere.radii_m {
        Some(radii) => radii.map(length).join(" "),
        None => length(sphere.radius_m),
    }
}

/// The number of decimals with which a hundredth of the smallest radius can be seen.
pub fn decimals(spheres: &[InspectedSphere]) -> usize {
    let own = |sphere: &InspectedSphere| sphere.radii_m.unwrap_or([sphere.radius_m; 3]);
    let radii = spheres.iter().flat_map(own).filter(|radius| *radius > 0.0 && radius.is_finite());
    let smallest = radii.fold(1.0, f64::min);
    let mut decimals = 2;
    let mut unit = smallest;
    while unit < 1.0 && decimals < 12 {
        unit *= 10.0;
        decimals += 1;
    }
    decimals
}

/// A length or coordinate in m, with this number of decimals.
pub fn metres(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // Nobody's coordinate is -0.0000.
    if text.chars().all(|letter| matches!(letter, '-' | '0' | '.')) { "0".to_owned() } else { text }
}
