//! A body of another size that is similar to the original in every respect stands as the original does. No change of its contacts is
//! refused.

use osim_model::files::InMemory;
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::{Value, json};

const HUMAN: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");

/// The model with all numbers in elements called `tag` changed. `change` gets the index in the element and the number.
fn with_numbers(text: &str, tag: &str, change: impl Fn(usize, f64) -> f64) -> String {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let mut parts = text.split(open.as_str());
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |made, part| {
        let (inside, rest) = part.split_once(close.as_str()).unwrap();
        let numbers = inside.split_whitespace().map(|word| word.parse::<f64>().unwrap());
        let new: Vec<String> =
            numbers.enumerate().map(|(at, number)| change(at, number).to_string()).collect();
        format!("{made}{open}{}{close}{rest}", new.join(" "))
    })
}

/// The human, with the first sphere of each foot so low that it carries the body alone.
fn with_hanging_spheres() -> String {
    let mut parts = HUMAN.split("<ContactSphere ");
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |made, part| {
        let up_m = if part.starts_with("name=\"s1_") { 0.0 } else { 0.045 };
        let (sphere, rest) = part.split_once("</ContactSphere>").unwrap();
        let sphere =
            with_numbers(sphere, "location", |at, metres| if at == 1 { metres + up_m } else { metres });
        format!("{made}<ContactSphere {sphere}</ContactSphere>{rest}")
    })
}

/// A copy of the model whose bones have lengths multiplied by `ratio` and the same density, with spheres that followed the bones. Other
/// numbers of the contacts stay as they are.
fn scaled_copy(text: &str, ratio: f64) -> String {
    let lengths = ["translation", "location", "scale_factors"];
    let copy =
        lengths.iter().fold(text.to_owned(), |text, tag| with_numbers(&text, tag, |_, one| one * ratio));
    with_numbers(&copy, "mass", |_, kg| kg * ratio.powi(3))
}

fn codes_of_plan(call: &Value, files: &InMemory) -> Result<Vec<&'static str>, String> {
    let request = Request::from_json(call.to_string().as_bytes()).unwrap();
    let change = prepare(request, files).map_err(|error| format!("{error:?}"))?;
    let opened = change.open("copy.osim".as_ref(), files).unwrap();
    let plan = change.plan(&opened, files).map_err(|failure| failure.message.to_string())?;
    Ok(plan.findings.iter().map(|finding| finding.code().as_str()).collect())
}

#[test]
fn a_similar_copy_is_not_refused_though_some_of_its_spheres_hang_lower() {
    let original = with_hanging_spheres();
    for ratio in [0.2_f64, 2.5] {
        let copy = scaled_copy(&original, ratio);
        let files = InMemory::from_iter([("original.osim", original.as_str()), ("copy.osim", copy.as_str())]);
        let kg = 62.0 * ratio.powi(3);
        for call in [
            json!({"verb": "rescale", "models": ["copy.osim"], "target_mass": kg, "contacts_mass": 62}),
            json!({"verb": "transfer", "models": ["copy.osim"], "from": "original.osim", "radius": "isometric"}),
        ] {
            let codes = codes_of_plan(&call, &files).unwrap_or_else(|why| panic!("{ratio} {call}: {why}"));
            assert!(codes.contains(&"sunk-in"), "{ratio} {call}: {codes:?}");
        }
    }
}
