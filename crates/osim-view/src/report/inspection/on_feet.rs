//! A body over its floor and on its feet, in sentences: the text and the page share them.

use osim_inspect::{OnFeet, StandingBody, StandingSphere};
use osim_model::messages::{four_significant, listed, shown, three_significant};

/// Spheres that are named at most.
const NAMED: usize = 6;

/// The text about a body: where it is at the default pose, and where it stands on all its feet and on one limb.
pub fn sentences(body: &StandingBody) -> Vec<String> {
    let Some((lowest, place)) = body.lowest().zip(body.place()) else { return Vec::new() };
    let mut said = format!("at the default pose {}, the lowest sphere, is {place}", shown(&lowest.sphere));
    if let Some(why) = &body.why_no_coordinate {
        said.push_str(&format!("; no coordinate puts the body on its feet: {why}"));
    }
    let mut sentences = vec![said];
    let rests = [("on all feet", body.as_posed.as_ref()), ("on one limb", other_than_all(body))];
    let known = rests.into_iter().filter_map(|(how, rest)| Some((how, rest?)));
    sentences.extend(known.map(|(how, rest)| on_feet(body, how, rest)));
    if body.as_posed.is_none() {
        let why = match body.weight_n {
            None => "a mass or gravity is missing",
            Some(_) => "a contact cannot be read, or no depth carries the weight",
        };
        sentences.push(format!("what puts the body on its feet is not known: {why}"));
    }
    sentences
}

/// The body on one limb, unless it has no other.
fn other_than_all(body: &StandingBody) -> Option<&OnFeet> {
    let (one, all) = (body.on_one_limb.as_ref()?, body.as_posed.as_ref()?);
    (one.spheres != all.spheres).then_some(one)
}

fn on_feet(body: &StandingBody, how: &str, rest: &OnFeet) -> String {
    let limb = rest.limb.as_deref().map(|limb| format!(", {}", shown(limb))).unwrap_or_default();
    let load = four_significant(rest.load_n);
    if !rest.carried {
        return format!("{how}{limb}: its spheres cannot carry the {load} N; {}", depths(rest));
    }
    let place = body.coordinate_on(rest).map(|set| format!(" with {set}")).unwrap_or_default();
    format!("{how}{limb}: carries {load} N{place}; {}", depths(rest))
}

/// Which spheres touch, and how deep they are.
fn depths(rest: &OnFeet) -> String {
    let touching: Vec<&StandingSphere> = rest.touching().collect();
    let deep = |one: &StandingSphere| three_significant(one.relative_indentation);
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
        (some, of) => format!("{some} of {of} spheres touch ({}), {x}", named(&touching)),
    }
}

fn named(spheres: &[&StandingSphere]) -> String {
    let names: Vec<String> = spheres.iter().map(|one| shown(&one.sphere).to_string()).collect();
    listed(&names, NAMED)
}
