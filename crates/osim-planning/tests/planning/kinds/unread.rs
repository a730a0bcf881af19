//! The kinds of damage in `kinds.md` that OpenSim refuses, ignores or reads as other values.

use osim_model::ElementId;

use super::damages::DamageKind;
use super::published::{BODY, Edited, FLOOR, FORCES, Published, SPHERE, is_left, three_numbers};

const CODES_OF_CONNECTIONS: &str = "connectee-by-name socket-nowhere body-without-joint";
const CODES_OF_MISREAD_NUMBERS: &str = "odd-number not-finite";
const TAGS_OF_PARAMETER_SETS: &[&str] = &["HuntCrossleyForce::ContactParameters"];

pub const DAMAGES_OF_UNREAD_PARTS: &[DamageKind] = &[
    ("all forces name one sphere", "sphere-in-two-forces sphere-of-other-side", |m| {
        let spheres = m.model.spheres();
        let first = &spheres.first()?.name;
        m.edit(FORCES, &["socket_sphere", "geometry"], |_, old| {
            let words = old.split_whitespace().map(|word| {
                let (path, name) = word.rsplit_once('/').map_or(("", word), |(path, name)| (path, name));
                let is_sphere = spheres.iter().any(|sphere| sphere.name == name);
                let name = if is_sphere { first.as_str() } else { name };
                if path.is_empty() { name.to_owned() } else { format!("{path}/{name}") }
            });
            Some(words.collect::<Vec<_>>().join(" "))
        })
    }),
    ("floor renamed, forces not", CODES_OF_CONNECTIONS, |m| {
        renamed(m, FLOOR, |_| Some("another_floor".to_owned()))
    }),
    ("one sphere renamed, force not", CODES_OF_CONNECTIONS, |m| {
        let first = m.model.spheres().first()?.name.clone();
        renamed(m, SPHERE, |name| (name == first).then(|| "another_sphere".to_owned()))
    }),
    ("HC geometry with commas", CODES_OF_CONNECTIONS, |m| {
        m.edit(TAGS_OF_PARAMETER_SETS, &["geometry"], |_, old| {
            Some(old.split_whitespace().collect::<Vec<_>>().join(","))
        })
    }),
    ("geometry named in HC with another case", CODES_OF_CONNECTIONS, |m| {
        m.edit(TAGS_OF_PARAMETER_SETS, &["geometry"], |_, old| {
            Some(old.to_uppercase()).filter(|new| new != old)
        })
    }),
    ("floor on /bodyset/ground", CODES_OF_CONNECTIONS, |m| {
        m.edit(FLOOR, &["socket_frame"], |_, _| Some("/bodyset/ground".to_owned()))
    }),
    ("socket path of another model name", CODES_OF_CONNECTIONS, |m| {
        m.edit(FORCES, &["socket_sphere"], |_, old| Some(format!("/another_model{}", old.trim())))
    }),
    ("socket path in capitals", CODES_OF_CONNECTIONS, |m| {
        m.edit(FORCES, &["socket_sphere"], |_, old| Some(old.to_uppercase()))
    }),
    ("two spheres of one name at two places", "duplicate-names left-right-missing one-side-only", |m| {
        let [first, second, ..] = m.model.spheres() else { return None };
        renamed(m, SPHERE, |name| (name == second.name).then(|| first.name.clone()))
    }),
    ("v3 body_name with path (/bodyset/calcn_r)", CODES_OF_CONNECTIONS, |m| {
        m.edit(SPHERE, &["body_name"], |_, old| Some(format!("/bodyset/{}", old.trim())))
    }),
    ("body calcn_r deleted, spheres kept", CODES_OF_CONNECTIONS, |m| without_bodies(m, is_calcn_r)),
    ("body calcn_r renamed, spheres not", CODES_OF_CONNECTIONS, |m| {
        renamed(m, BODY, |name| is_calcn_r(name).then(|| "another_body".to_owned()))
    }),
    ("whole left leg's bodies deleted, spheres kept", CODES_OF_CONNECTIONS, |m| without_bodies(m, is_left)),
    ("foot's joint hangs on ground", "odd-parent", super::skeleton::foot_on_ground),
    ("floor orientation as brackets", CODES_OF_MISREAD_NUMBERS, |m| m.floor("orientation", "(0 0 -1.5708)")),
    ("floor orientation as a word pi", CODES_OF_MISREAD_NUMBERS, |m| m.floor("orientation", "0 0 -pi/2")),
    ("floor orientation nan", CODES_OF_MISREAD_NUMBERS, |m| m.floor("orientation", "0 0 nan")),
    ("floor location with commas (0,-0.5,0)", CODES_OF_MISREAD_NUMBERS, |m| m.floor("location", "0,-0.5,0")),
    ("dissipation misspelt (0)", "unknown-name", |m| misspelt(m, "dissipation", "disipation")),
    ("stiffness misspelt", "unknown-name", |m| misspelt(m, "stiffness", "stifness")),
    ("cf misspelt, 1e-3 meant", "unknown-name", |m| {
        let text = m.smoothing("constant_contact_force", "1e-3")?;
        Some(text.replace("constant_contact_force>", "constant_contact_forse>"))
    }),
    ("radius misspelt", "unknown-name", |m| misspelt(m, "radius", "radus")),
    ("thousands with apostrophes", CODES_OF_MISREAD_NUMBERS, |m| m.forces("stiffness", "1'000'000")),
    ("pelvis mass empty", "odd-number mass-unknown", |m| {
        m.edit(BODY, &["mass"], |name, _| (name == "pelvis").then(String::new))
    }),
    ("Excel date in a radius (03.Jun)", CODES_OF_MISREAD_NUMBERS, |m| {
        m.edit(SPHERE, &["radius"], |_, _| Some("03.Jun".to_owned()))
    }),
    ("Python's [x y z] in a place", CODES_OF_MISREAD_NUMBERS, |m| {
        m.edit(SPHERE, &["location"], |_, old| Some(format!("[{}]", old.trim())))
    }),
    ("None of a script", CODES_OF_MISREAD_NUMBERS, |m| m.forces("dissipation", "None")),
    ("nan of pandas in a place", CODES_OF_MISREAD_NUMBERS, |m| {
        m.edit(SPHERE, &["location"], |_, old| three_numbers(old).map(|[x, _, z]| format!("{x} nan {z}")))
    }),
    ("MATLAB's '1.0e-03 * 3 2 1' in a place", CODES_OF_MISREAD_NUMBERS, |m| {
        m.edit(SPHERE, &["location"], |_, _| Some("1.0e-03 * 3 2 1".to_owned()))
    }),
    ("curly quotes in a name", CODES_OF_CONNECTIONS, |m| {
        Some(m.text.replacen("<ContactSphere name=\"", "<ContactSphere name=\u{201d}", 1))
    }),
    ("offset frame of the ankle unreadable (commas)", CODES_OF_MISREAD_NUMBERS, |m| {
        m.edit(&["PhysicalOffsetFrame"], &["translation"], |name, old| {
            name.contains("tibia_r").then(|| old.split_whitespace().collect::<Vec<_>>().join(","))
        })
    }),
    ("gravity one number only", CODES_OF_MISREAD_NUMBERS, |m| m.gravity("-9.81")),
    ("gravity with commas 0, -9,81, 0", CODES_OF_MISREAD_NUMBERS, |m| m.gravity("0, -9,81, 0")),
    ("empty &lt;ForceSet> pasted before the real one", "ignored-contacts", |m| {
        Some(m.text.replacen("<ForceSet", "<ForceSet name=\"empty\"><objects/></ForceSet><ForceSet", 1))
    }),
    ("empty &lt;ContactGeometrySet> pasted before the real one", "ignored-contacts", |m| {
        let empty = "<ContactGeometrySet name=\"empty\"><objects/></ContactGeometrySet><ContactGeometrySet";
        Some(m.text.replacen("<ContactGeometrySet", empty, 1))
    }),
    ("merge conflict markers", CODES_OF_CONNECTIONS, |m| {
        Some(m.text.replacen("<ContactSphere", "<<<<<<< HEAD\n<ContactSphere", 1))
    }),
    (
        "conflict solved by keeping both halves (forces twice)",
        "duplicate-names sphere-in-two-forces doubled-spheres",
        |m| {
            let forces = forces(m);
            moved(m, &[], |m| span_end(m, forces.last().copied()), &texts_of_elements(m, &forces))
        },
    ),
    ("forces pasted after &lt;/objects>", "ignored-contacts one-side-only", |m| {
        let forces = forces(m);
        moved(m, &forces, |m| span_end(m, list(m, "ForceSet")), &texts_of_elements(m, &forces))
    }),
    ("spheres pasted into the force set", "misplaced-object", |m| {
        let tree = m.model.document().tree();
        let spheres: Vec<ElementId> =
            tree.elements().filter(|&id| tree.name(id) == "ContactSphere").collect();
        moved(
            m,
            &spheres,
            |m| Some(tree.span(list(m, "ForceSet")?).start + "<objects>".len()),
            &texts_of_elements(m, &spheres),
        )
    }),
    ("Version 30000 written as 40000", "other-version", |m| {
        m.text.contains("Version=\"30000\"").then(|| m.text.replacen("\"30000\"", "\"40000\"", 1))
    }),
    ("forces' class misspelt HuntCrosleyForce", "unknown-name", |m| {
        let new = m.text.replace("<HuntCrossleyForce ", "<HuntCrosleyForce ");
        (new != m.text).then(|| new.replace("</HuntCrossleyForce>", "</HuntCrosleyForce>"))
    }),
    ("spheres' class misspelt ContactSpere", "unknown-name", |m| {
        Some(
            m.text
                .replace("<ContactSphere ", "<ContactSpere ")
                .replace("</ContactSphere>", "</ContactSpere>"),
        )
    }),
    ("smooth class of an old Moco (AckermannVanDenBogert2010Force)", "unknown-name", |m| {
        let new = m.text.replace("SmoothSphereHalfSpaceForce", "AckermannVanDenBogert2010Force");
        (new != m.text).then_some(new)
    }),
    ("file ends after the ForceSet (geometry lost), closed by hand", CODES_OF_CONNECTIONS, |m| {
        let tree = m.model.document().tree();
        let set = tree.elements().find(|&id| tree.name(id) == "ContactGeometrySet")?;
        Some(m.text.replacen(&m.text[tree.span(set)], "", 1))
    }),
];

pub fn is_calcn_r(name: &str) -> bool {
    ["calcn_r", "calc_r", "foot_r"].contains(&name)
}

/// The text with other names of objects of some classes.
fn renamed(m: &Published, classes: &[&str], new: impl Fn(&str) -> Option<String>) -> Edited {
    let tree = m.model.document().tree();
    let mut text = m.text.clone();
    let objects = tree.elements().filter(|&id| classes.contains(&tree.name(id)));
    for id in objects.collect::<Vec<_>>().into_iter().rev() {
        let name = tree.attribute(id, "name").unwrap_or_default();
        if let Some(new) = new(&name) {
            let open = tree.open_span(id);
            let tag = m.text[open.clone()].replacen(&format!("\"{name}\""), &format!("\"{new}\""), 1);
            text.replace_range(open, &tag);
        }
    }
    (text != m.text).then_some(text)
}

/// The text with another tag of a property of contacts.
fn misspelt(m: &Published, property: &str, new: &str) -> Edited {
    let tree = m.model.document().tree();
    let owners = [FORCES, SPHERE].concat();
    let mut text = m.text.clone();
    for owner in
        tree.elements().filter(|&id| owners.contains(&tree.name(id))).collect::<Vec<_>>().into_iter().rev()
    {
        let Some(element) = tree.child(owner, property) else { continue };
        let span = tree.span(element);
        text.replace_range(span.clone(), &m.text[span].replace(property, new));
    }
    (text != m.text).then_some(text)
}

fn without_bodies(m: &Published, of: impl Fn(&str) -> bool) -> Edited {
    let tree = m.model.document().tree();
    let bodies = tree.elements().filter(|&id| tree.name(id) == "Body");
    let gone = bodies.filter(|&id| of(&tree.attribute(id, "name").unwrap_or_default()));
    moved(m, &gone.collect::<Vec<_>>(), |_| None, "")
}

/// The elements of all contact forces.
fn forces(m: &Published) -> Vec<ElementId> {
    m.model.forces().iter().map(|force| force.element).collect()
}

fn texts_of_elements(m: &Published, elements: &[ElementId]) -> String {
    elements.iter().map(|&id| &m.text[m.model.document().tree().span(id)]).collect()
}

/// The `<objects>` of a set.
fn list(m: &Published, set: &str) -> Option<ElementId> {
    let tree = m.model.document().tree();
    tree.child(tree.elements().find(|&id| tree.name(id) == set)?, "objects")
}

fn span_end(m: &Published, element: Option<ElementId>) -> Option<usize> {
    Some(m.model.document().tree().span(element?).end)
}

/// The text without the elements `gone`, and with `text` at a place.
pub fn moved(
    m: &Published,
    gone: &[ElementId],
    at: impl Fn(&Published) -> Option<usize>,
    text: &str,
) -> Edited {
    let tree = m.model.document().tree();
    let mut edits: Vec<(std::ops::Range<usize>, &str)> = gone.iter().map(|&id| (tree.span(id), "")).collect();
    edits.extend(at(m).map(|at| (at..at, text)));
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    (!edits.is_empty()).then(|| {
        edits.into_iter().fold(m.text.clone(), |mut all, (span, new)| {
            all.replace_range(span, new);
            all
        })
    })
}
