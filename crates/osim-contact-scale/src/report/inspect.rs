//! A model's contacts as tables.

use osim_patch::{Factors, Limbs, Origin, Property};

use super::json::Inspected;
use super::{changes, number, right, table};

/// Masses, limbs, spheres and forces.
pub(crate) fn text(seen: &Inspected<'_>) -> String {
    let model = seen.model;
    let mut text =
        format!("{}: {} (document version {})\n", seen.path, model.name, model.document().version());
    match seen.mass {
        Some(mass) => text.push_str(&format!("model weighs {} kg ({})", number(mass.kg), mass.told_by)),
        None => text.push_str("what the model weighs is not known"),
    }
    match seen.contacts_mass {
        Some(mass) => {
            text.push_str(&format!("; contacts stand for {} kg ({})\n", number(mass.kg), mass.told_by));
        }
        None => text.push_str("; what its contacts stand for is not known\n"),
    }
    match model.gravity() {
        Some(gravity) => text.push_str(&format!("gravity {} m/s2\n", number(gravity))),
        None => text.push_str("gravity cannot be read\n"),
    }
    text.push_str(&limbs(seen));
    if !model.spheres.is_empty() {
        text.push('\n');
        text.push_str(&spheres(seen));
    }
    if !model.forces.is_empty() {
        text.push('\n');
        text.push_str(&forces(seen));
    }
    if let Some(factors) = seen.factors {
        text.push('\n');
        text.push_str(&body_factors(factors));
    }
    text.push_str(&changes::warnings(seen.warnings));
    text
}

/// Each body's factors against the generic model; `?` where no source says.
fn body_factors(factors: &Factors) -> String {
    let mut table = table(&["scaled body", "x", "y", "z", "from"]);
    for body in &factors.bodies {
        let mut cells = vec![body.body.clone()];
        cells.extend(
            body.axes.iter().map(|axis| axis.map_or_else(|| "?".to_owned(), |a| format!("{:.6}", a.factor))),
        );
        let mut sources: Vec<&str> = body.axes.iter().flatten().map(|axis| axis.source.as_str()).collect();
        sources.dedup();
        cells.push(sources.join(", "));
        table.add_row(cells);
    }
    right(&mut table, &[1, 2, 3]);
    format!("{}\n", table.trim_fmt())
}

fn limbs(seen: &Inspected<'_>) -> String {
    match seen.limbs {
        Limbs::Known(limbs) => {
            let each: Vec<_> = limbs
                .iter()
                .map(|limb| format!("{} ({}, n = {})", limb.name, limb.side.as_str(), limb.spheres.len()))
                .collect();
            let uneven = seen.limbs.spheres_per_limb().err();
            let uneven = uneven.map(|why| format!("{why}\n")).unwrap_or_default();
            format!("limbs: {}\n{uneven}", each.join(", "))
        }
        Limbs::Unknown(why) => format!("limbs are not known: {why}\n"),
    }
}

fn spheres(seen: &Inspected<'_>) -> String {
    let mut table = table(&["sphere", "body", "radius m", "x", "y", "z"]);
    for sphere in &seen.model.spheres {
        let [x, y, z] = sphere.location_m;
        let body = sphere.body.clone().unwrap_or_else(|| sphere.frame.clone());
        table.add_row(vec![
            sphere.name.clone(),
            body,
            number(sphere.radius.number),
            number(x),
            number(y),
            number(z),
        ]);
    }
    right(&mut table, &[2, 3, 4, 5]);
    format!("{}\n", table.trim_fmt())
}

/// Four significant digits, to compare by eye.
fn four(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    number(rounded)
}

/// Parameters, one block for each group of forces that have the same.
fn forces(seen: &Inspected<'_>) -> String {
    let mut groups: Vec<(Vec<String>, Vec<String>)> = Vec::new();
    let mut any_default = false;
    for (index, force) in seen.model.forces.iter().enumerate() {
        for (number_of_set, _) in force.sets.iter().enumerate() {
            let mut cells = vec![force.kind.as_str().to_owned()];
            for property in Property::ALL {
                if let Some(value) = force.value(number_of_set, property) {
                    let mark = if value.origin == Origin::Element { "" } else { " *" };
                    any_default |= !mark.is_empty();
                    cells.push(format!("{property} {}{mark}", number(value.number)));
                }
            }
            if let Some(pure) = seen.dimensionless_of(index, number_of_set) {
                cells.push(format!(
                    "relative indentation at body weight on one limb (Hertz) {:.4}",
                    pure.relative_indentation()
                ));
                let optional = |value: Option<f64>, name: &str| {
                    value.map(|value| format!(", {name} {}", four(value))).unwrap_or_default()
                };
                cells.push(format!(
                    "without dimensions: modulus {}, dissipation {}{}{}{}",
                    four(pure.modulus()),
                    four(pure.dissipation()),
                    optional(pure.constant_indentation(), "cf"),
                    optional(pure.hertz_smoothing(), "bd"),
                    optional(pure.hunt_crossley_smoothing(), "bv")
                ));
            }
            let mut name = force.name.clone();
            if force.sets.len() > 1 {
                name.push_str(&format!(" (set {number_of_set})"));
            }
            if !force.applies {
                name.push_str(" (disabled)");
            }
            if !seen.selected.forces.contains(&index) {
                name.push_str(" (not ground contact)");
            }
            match groups.iter_mut().find(|(known, _)| *known == cells) {
                Some((_, names)) => names.push(name),
                None => groups.push((cells, vec![name])),
            }
        }
    }
    let mut text = String::new();
    for (cells, names) in groups {
        let mut cells = cells.into_iter();
        let kind = cells.next().unwrap_or_default();
        text.push_str(&format!("{} x {kind}: {}\n", names.len(), names.join(", ")));
        for cell in cells {
            text.push_str(&format!("  {cell}\n"));
        }
    }
    if any_default {
        text.push_str("  (* not in the file: from <defaults> or OpenSim's class default)\n");
    }
    text
}
