//! Models with damage as people cause it: by hand, by a wrong unit, or by scaling one thing and not another.

use osim_model::files::InMemory;
use osim_model::{FileId, Model, Side, without_side};
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::{Value, json};

use super::cases::NAME;

/// A model with one fault, and the name of the fault.
pub struct Damaged {
    pub what: &'static str,
    pub text: String,
}

/// The model with each damage that is possible in it, one at a time.
pub fn damages(text: &str, model: &Model) -> Vec<Damaged> {
    let left = names_of_side(model, Side::Left);
    let right = names_of_side(model, Side::Right);
    let first: Vec<&str> = left.first().copied().into_iter().collect();
    let set = |assignments: Value, select: &[&str]| {
        edited(text, &json!({"verb": "set", "set": assignments, "select": select}))
    };
    let made: Vec<(&'static str, Option<String>)> = vec![
        (
            "left ten times stiffer",
            (!left.is_empty()).then(|| set(json!({"stiffness": "x10"}), &left)).flatten(),
        ),
        (
            "right ten times stiffer",
            (!right.is_empty()).then(|| set(json!({"stiffness": "x10"}), &right)).flatten(),
        ),
        (
            "one ten times stiffer",
            (!first.is_empty()).then(|| set(json!({"stiffness": "x10"}), &first)).flatten(),
        ),
        ("one larger", (!first.is_empty()).then(|| set(json!({"radius": "x1.2"}), &first)).flatten()),
        ("mass x 3", numbers_multiplied(text, "mass", 3.0)),
        ("radii x 2", set(json!({"radius": "x2"}), &[])),
        ("dissipation 0", set(json!({"dissipation": 0}), &[])),
        ("dissipation 50", set(json!({"dissipation": 50}), &[])),
        ("stiffness / 30", set(json!({"stiffness": "x0.0333"}), &[])),
        ("constant force of another size", set(json!({"constant_contact_force": "x1000"}), &[])),
        ("smoothed too much", set(json!({"hertz_smoothing": "x0.05"}), &[])),
        (
            "one missing",
            (!first.is_empty()).then(|| edited(text, &json!({"verb": "remove", "select": first}))).flatten(),
        ),
        ("one doubled", with_doubled_force(text, model)),
        ("bones x 1.2", numbers_multiplied(text, "scale_factors", 1.2)),
        (
            "smoothed by 0",
            damage_each(text, model, "SmoothSphereHalfSpaceForce", &["constant_contact_force"], |_| {
                Some("0".into())
            }),
        ),
        ("gravity up", numbers_multiplied(text, "gravity", -1.0)),
        ("gravity in mm/s2", numbers_multiplied(text, "gravity", 1000.0)),
        ("gravity tilted", damage_each(text, model, "Model", &["gravity"], |_| Some("9.81 0 0".to_owned()))),
        ("floor upside down", with_turned_floor(text, model, "0 0 1.5707963267948966")),
        ("floor upright", with_turned_floor(text, model, "0 0 0")),
        ("floor sloping", with_turned_floor(text, model, "0 0 -1.3")),
        ("floor in degrees", with_turned_floor(text, model, "0 0 -90")),
        ("floor on a limb", with_floors_on_limb(text, model)),
        (
            "radii in millimetres",
            damage_each(text, model, "ContactSphere", &["radius"], |radius| scaled_numbers(radius, 1000.0)),
        ),
        (
            "places in millimetres",
            damage_each(text, model, "ContactSphere", PLACE_TAGS, |place| scaled_numbers(place, 1000.0)),
        ),
        ("one on the other side", with_spheres_on_other_side(text, model)),
        ("masses of a child", numbers_multiplied(text, "mass", 0.2)),
        ("heaviest body weighs nothing", without_heaviest_mass(text, model)),
        ("radii in feet", set(json!({"radius": "x3.28084"}), &[])),
        (
            "left forces deleted",
            (!left.is_empty()).then(|| edited(text, &json!({"verb": "remove", "select": left}))).flatten(),
        ),
        ("places rounded", damage_each(text, model, "ContactSphere", PLACE_TAGS, rounded_numbers)),
    ];
    made.into_iter().filter_map(|(what, text)| Some(Damaged { what, text: text? })).collect()
}

fn names_of_side(model: &Model, side: Side) -> Vec<&str> {
    let plain = |name: &&str| !name.contains(['*', '?', '[', '{', '\\', '!']);
    let forces = model.forces().iter().filter(|force| Side::of_name(&force.name) == Some(side));
    forces.map(|force| force.name.as_str()).filter(plain).collect()
}

/// The model after a request, without a note of the change; `None` if the request is refused.
fn edited(text: &str, fields: &Value) -> Option<String> {
    let mut fields = fields.as_object()?.clone();
    fields.retain(|_, value| *value != json!([]));
    fields.extend([("models".to_owned(), json!([NAME])), ("no_note".to_owned(), true.into())]);
    let request = Request::from_json(Value::Object(fields).to_string().as_bytes()).ok()?;
    let files = InMemory::from_iter([(NAME, text)]);
    let change = prepare(request, &files).ok()?;
    let opened = change.open(NAME.as_ref(), &files).ok()?;
    let plan = change.plan(&opened, &files).ok().filter(|plan| !plan.is_empty())?;
    String::from_utf8(plan.patched(&opened.model, FileId::MAIN).ok()?).ok()
}

/// The model with all numbers in elements called `tag` multiplied by `factor`.
fn numbers_multiplied(text: &str, tag: &str, factor: f64) -> Option<String> {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let mut parts = text.split(open.as_str());
    let mut out = parts.next()?.to_owned();
    let mut found = false;
    for part in parts {
        let (inner, rest) = part.split_once(close.as_str())?;
        let numbers: Option<Vec<f64>> = inner.split_whitespace().map(|word| word.parse().ok()).collect();
        let new = numbers.filter(|numbers| !numbers.is_empty()).map(|numbers| {
            found = true;
            numbers.iter().map(|number| (number * factor).to_string()).collect::<Vec<_>>().join(" ")
        });
        out.push_str(&format!("{open}{}{close}{rest}", new.unwrap_or_else(|| inner.to_owned())));
    }
    found.then_some(out)
}

/// Tags of the place of a geometry, and of its frame, in all document versions.
const PLACE_TAGS: &[&str] = &["location", "translation"];
const FRAME: &[&str] = &["socket_frame", "body_name", "socket_frame_connectee_name"];

/// The model with other texts for the properties `names` in all elements called `tag`, if `new` returns a text.
fn damage_each(
    text: &str,
    model: &Model,
    tag: &str,
    names: &[&str],
    new: impl Fn(&str) -> Option<String>,
) -> Option<String> {
    let tree = model.document().tree();
    let owners = tree.elements().filter(|&id| tree.name(id) == tag);
    let properties = owners.flat_map(|id| names.iter().filter_map(move |name| tree.child(id, name)));
    let mut made = text.to_owned();
    let mut changed = false;
    for id in properties.collect::<Vec<_>>().into_iter().rev() {
        let inside = tree.open_span(id).end..tree.close_span(id).start;
        if let Some(new) = text.get(inside.clone()).and_then(&new) {
            made.replace_range(inside, &new);
            changed = true;
        }
    }
    changed.then_some(made)
}

/// The model with a mass of 0 for its heaviest body.
fn without_heaviest_mass(text: &str, model: &Model) -> Option<String> {
    let heaviest = model.bodies().iter().map(|body| body.mass.number).fold(0.0, f64::max);
    damage_each(text, model, "Body", &["mass"], |mass| {
        (mass.trim().parse::<f64>().ok()? == heaviest).then(|| "0".to_owned())
    })
}

/// Numbers rounded to a tenth of a millimetre, as scripts write them.
fn rounded_numbers(numbers: &str) -> Option<String> {
    let numbers: Option<Vec<f64>> = numbers.split_whitespace().map(|word| word.parse().ok()).collect();
    Some(numbers?.iter().map(|number| format!("{number:.4}")).collect::<Vec<_>>().join(" "))
}

fn scaled_numbers(numbers: &str, factor: f64) -> Option<String> {
    let numbers: Option<Vec<f64>> = numbers.split_whitespace().map(|word| word.parse().ok()).collect();
    Some(numbers?.iter().map(|number| (number * factor).to_string()).collect::<Vec<_>>().join(" "))
}

fn with_turned_floor(text: &str, model: &Model, orientation: &str) -> Option<String> {
    damage_each(text, model, "ContactHalfSpace", &["orientation"], |_| Some(orientation.to_owned()))
}

/// The model with all floors on the body that carries the first sphere.
fn with_floors_on_limb(text: &str, model: &Model) -> Option<String> {
    let body = model.spheres().iter().find_map(|sphere| sphere.body.clone())?;
    damage_each(text, model, "ContactHalfSpace", FRAME, |frame| name_of_body(frame, &body))
}

/// The model with the spheres of the first body on the counterpart of this body.
fn with_spheres_on_other_side(text: &str, model: &Model) -> Option<String> {
    let body = model.spheres().iter().find_map(|sphere| sphere.body.clone())?;
    let is_counterpart = |other: &str| {
        let side = Side::of_name(&body);
        side.is_some()
            && Side::of_name(other).is_some_and(|of| Some(of) != side)
            && without_side(other) == without_side(&body)
    };
    let other = model.bodies().iter().map(|one| one.name.as_str()).find(|name| is_counterpart(name))?;
    let first = std::cell::Cell::new(true);
    damage_each(text, model, "ContactSphere", FRAME, |frame| {
        let is_it = frame.trim().rsplit('/').next() == Some(body.as_str());
        (is_it && first.replace(false)).then(|| name_of_body(frame, other)).flatten()
    })
}

/// The path or name `frame` with the name `body` at its end.
fn name_of_body(frame: &str, body: &str) -> Option<String> {
    let frame = frame.trim();
    Some(match frame.rsplit_once('/') {
        Some((_, "ground")) => format!("/bodyset/{body}"),
        Some((before, _)) => format!("{before}/{body}"),
        None => body.to_owned(),
    })
}

/// The model with a copy of its first force.
fn with_doubled_force(text: &str, model: &Model) -> Option<String> {
    let force = model.forces().iter().find(|force| force.file == FileId::MAIN)?;
    let span = model.document().tree().span(force.element);
    let piece = text.get(span.clone())?;
    let named = piece.replacen(&format!("\"{}\"", force.name), &format!("\"{}_0\"", force.name), 1);
    (named != piece).then(|| format!("{}{named}{}", &text[..span.end], &text[span.end..]))
}
