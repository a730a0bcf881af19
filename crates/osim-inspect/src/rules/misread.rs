//! Rules about the texts of numbers and flags: how they are written, and the domains of numbers.

use foldhash::{HashMap, HashMapExt};
use indexmap::IndexMap;
use osim_model::messages::three_significant;
use osim_model::opensim_text::{self, plain_numbers};
use osim_model::{
    Body, Document, ElementId, Example, FileId, Finding, ForceKind, LAST_VERSION_WITH_IS_DISABLED, Model,
    Property, Repair, Rule, Value, rule,
};

use crate::rules::refused_or_ignored::{find_unknown_name, known_children, probable_property_name};
use crate::rules::unlikely_numbers::is_default_stiffness;
use crate::rules::written_properties::TextForm::{self, Flag, List, Numbers, OldCount, OldFlag, OldNumbers};
use crate::rules::written_properties::{
    LAST_VERSION_WITH_ONE_COORDINATE, PARTS_OF_AXIS, WrittenProperties, known_parts, written_properties,
};

/// A function that describes the fault of a value, in words that follow the name of the value; `None` if the value has no fault.
type DescribeValue = fn(&Value) -> Option<String>;

/// Rules about single values. Only the first rule that applies to a value is reported.
const VALUE_RULES: [(&Rule, DescribeValue); 3] = [
    (&ODD_NUMBER, describe_odd_number),
    (&NOT_FINITE, |value| (!value.number.is_finite()).then(|| format!("is {}", value.number))),
    (&OUT_OF_DOMAIN, describe_out_of_domain),
];

/// Finds numbers of contacts, and masses, that are written oddly, are not finite, or are outside their domain.
pub(super) fn apply_value_rules(model: &Model) -> Vec<Finding> {
    let parameters = model.forces().iter().flat_map(|force| {
        // The older class has its transition velocity outside its parameter sets.
        let outside_sets = (force.kind == ForceKind::HuntCrossley).then_some(&force.transition_velocity);
        let in_sets = force.sets.iter().flat_map(|set| &set.values);
        in_sets.chain(outside_sets).map(move |value| (force.path.as_str(), force.file, value))
    });
    let radii = model.spheres().iter().map(|sphere| (sphere.path.as_str(), sphere.file, &sphere.radius));
    let masses = model.bodies().iter().map(|body| (body.path.as_str(), body.file, &body.mass));
    let finding = |(path, file, value): (&str, FileId, &Value)| {
        let (rule, text) = VALUE_RULES.iter().find_map(|(rule, describe)| Some((*rule, describe(value)?)))?;
        let position = model.file(file).position(value.offset);
        Some(Finding::at(rule, position, format!("{} of {path} {text}", value.property)).with_place(path))
    };
    parameters.chain(radii).chain(masses).filter_map(finding).collect()
}

const WRITTEN_TWICE: &str = "is written twice, and OpenSim reads the first: take one of them out";

/// Finds texts of numbers and flags that OpenSim reads as other values than are written, or that are not finite. OpenSim silently takes its
/// default if it cannot read a text.
pub(super) fn find_misread_texts(model: &Model) -> Vec<Finding> {
    let (mut found, mut kinds) = (Vec::new(), HashMap::<_, IndexMap<&str, ChildKind>>::new());
    let components = model.components();
    for (id, component) in components.tree.iter() {
        let tag = components.tag(id);
        if !is_read(tag) {
            continue;
        }
        let document = components.document(component.file);
        let tree = document.tree();
        tree.walk(component.element, |element| {
            let class = tree.name(element);
            // Names of properties are in lower case. Only an object can have properties that are not written in it.
            let is_object = class.starts_with(|letter: char| letter.is_ascii_uppercase());
            if !is_object && tree.children(element).next().is_none() {
                return true;
            }
            let parent = tree.parent(element).filter(|_| element != component.element);
            // Other components are in these elements.
            let is_component_list = || match tag {
                "Model" => class != "ControllerSet",
                _ => ["components", "frames", "Joint"].contains(&class),
            };
            if parent == Some(component.element) && is_component_list() {
                return false;
            }
            // Of controllers, only functions are looked at.
            let is_of_controller = tag == "Model" && parent.is_some();
            let is_looked_at = is_object && (!is_of_controller || PARTS_OF_AXIS.contains(&class));
            let all = if is_looked_at { written_properties(class) } else { &[] };
            let above = || parent.map_or("", |parent| tree.name(parent));
            let parts = if is_of_controller { &[] } else { known_parts(class, above) };
            if all.is_empty() && parts.is_empty() {
                return true;
            }
            // Most objects of a class have the same children, in the same order.
            let kinds = kinds.entry((document.version(), class, parts.is_empty())).or_default();
            let kind_of = |name| {
                let are_known_elsewhere =
                    || known_children(document, element).is_some_and(|all| !all.is_empty());
                let is_checked = class == "Model" || !are_known_elsewhere();
                let old = document.version() <= LAST_VERSION_WITH_ONE_COORDINATE;
                ChildKind::of(name, all, is_checked.then_some((parts, old)))
            };
            let inherited_of = document.defaults_of(element).map_or(&[][..], |_| all);
            let inherited = inherited_of.iter().flat_map(|(tags, ..)| tags.iter()).filter_map(|tag| {
                document.inherited_element(element, tag).filter(|_| tree.child(element, tag).is_none())
            });
            for (at, of_text) in tree.children(element).chain(inherited).enumerate() {
                let property = tree.name(of_text);
                let index = match kinds.get_index(at) {
                    Some((known, _)) if *known == property => at,
                    _ => {
                        let entry = kinds.entry(property);
                        let index = entry.index();
                        entry.or_insert_with(|| kind_of(property));
                        index
                    }
                };
                let Some((_, kind)) = kinds.get_index_mut(index) else { continue };
                let is_repeated = kind.last_object.replace(element) == Some(element);
                let meant = kind.meant.filter(|_| tree.parent(of_text) == Some(element));
                found.extend(
                    meant.and_then(|meant| find_unknown_name(model, component.file, element, of_text, meant)),
                );
                let misread = kind.form.and_then(|form| misread_text(document, element, of_text, form));
                // Of several elements OpenSim reads the first.
                let first = || tree.child(element, property).filter(|&first| first != of_text);
                let unread = || {
                    // A model can have several lines of thanks.
                    let is_text = kind.form.is_some() || class != "Model";
                    let is_one = |_: &ElementId| is_text && tree.children(of_text).next().is_none();
                    let [read, own] = [first().filter(is_one)?, of_text].map(|id| tree.text_of(id));
                    let numbers = plain_numbers(&read);
                    let differs = read != own && (numbers.is_none() || numbers != plain_numbers(&own));
                    differs.then(|| (&ODD_NUMBER, WRITTEN_TWICE.to_owned()))
                };
                let fault = misread.filter(|_| first().is_none());
                if let Some((rule, text)) = fault.or_else(|| is_repeated.then(unread).flatten()) {
                    let whole = if tag == "Model" { String::new() } else { components.tree.path(id) };
                    let path = path_of_part(document, whole, component.element, element);
                    let of = if path.is_empty() { "the model" } else { &path };
                    let position = document.position_of(of_text);
                    let finding = Finding::at(rule, position, format!("{property} of {of} {text}"));
                    found.push(if path.is_empty() { finding } else { finding.with_place(&path) });
                }
            }
            true
        });
    }
    found
}

/// What an element is, by its name and the class of the object that it is in.
struct ChildKind {
    /// How its text is read, and the default; `None` if it is not a property whose text is looked at.
    form: Option<(TextForm, Option<&'static str>)>,
    /// The name that was probably meant by its name.
    meant: Option<&'static str>,
    /// The last object in which an element of this name was seen.
    last_object: Option<ElementId>,
}

impl ChildKind {
    /// The kind of an element `name` in an object with these properties. `parts` are the other elements that the object can have, and whether
    /// `coordinate` is one of them; `None` if its names are not looked at.
    fn of(
        name: &str,
        properties: &'static [WrittenProperties],
        parts: Option<(&'static [&'static str], bool)>,
    ) -> Self {
        let written = properties.iter().find(|(tags, ..)| tags.contains(&name));
        let meant = parts.and_then(|(parts, old)| {
            let numbers = properties.iter().flat_map(|(tags, ..)| tags.iter());
            let known = parts.iter().chain(numbers).copied().chain(old.then_some("coordinate"));
            probable_property_name(name, &known.collect::<Vec<_>>())
        });
        Self { form: written.map(|&(_, form, default)| (form, default)), meant, last_object: None }
    }
}

/// Whether poses, masses or contact forces depend on components of the class `tag`.
fn is_read(tag: &str) -> bool {
    // Parameters are read with their force.
    tag == "Ground" || (!written_properties(tag).is_empty() && !tag.contains("::"))
}

/// The path of `part`, which is `whole` or an object inside it, from the path of `whole`.
fn path_of_part(document: &Document, path: String, whole: ElementId, part: ElementId) -> String {
    let tree = document.tree();
    let inside = std::iter::successors(Some(part), |&id| tree.parent(id)).take_while(|&id| id != whole);
    let names: Vec<_> =
        inside.filter_map(|id| tree.attribute(id, "name").filter(|name| !name.is_empty())).collect();
    names.iter().rev().fold(path, |path, name| format!("{path}/{name}"))
}

/// What is wrong with the text of `element`, a property of `object` with this form and default: the rule, and words that follow the
/// property's name.
fn misread_text(
    document: &Document,
    object: ElementId,
    element: ElementId,
    (form, default): (TextForm, Option<&str>),
) -> Option<(&'static Rule, String)> {
    if matches!(form, OldFlag) && document.version() > LAST_VERSION_WITH_IS_DISABLED {
        return None;
    }
    let (tag, raw) = (document.tree().name(element), document.tree().raw_text(element));
    if raw.in_one_piece && form.has_decimals_alone(&raw.text) {
        return None;
    }
    if (document.tree().name(object), tag) == ("ContactSphere", "orientation") {
        // A sphere may be turned about its centre.
        let read =
            opensim_text::triple(&raw.text).filter(|all| !all.iter().all(|angle| angle.is_finite()))?;
        return Some((&NOT_FINITE, format!("is {}", in_words(&read))));
    }
    if let Some(read) = raw.in_one_piece.then(|| form.plain_numbers(&raw.text)).flatten() {
        if let Some(text) = unequal_counts(document, object, tag, &raw.text) {
            return Some((&ODD_NUMBER, text));
        }
        // A coordinate may be without bounds.
        let bounds: &[f64] = if tag == "range" { &[f64::NEG_INFINITY, f64::INFINITY] } else { &[] };
        let is_fine = |(at, value): (usize, &f64)| value.is_finite() || bounds.get(at) == Some(value);
        let listed = || format!("is {}", in_words(&read));
        return (!read.iter().enumerate().all(is_fine)).then(|| (&NOT_FINITE, listed()));
    }
    let inherited = || document.inherited_element(object, tag).filter(|&inherited| inherited != element);
    // Of other lists with another count OpenSim refuses the model.
    if let (OldNumbers(Some(expected)), "coefficients") = (form, tag)
        && raw.in_one_piece
        && are_old_numbers(&raw.text, None)
    {
        let count = words_of_old_numbers(&raw.text).len();
        return Some((&ODD_NUMBER, format!("has {count} numbers, expected {expected}")));
    }
    let read = raw.in_one_piece.then(|| {
        let inherited = || form.read(&document.tree().raw_text(inherited()?).text);
        form.read(&raw.text).or_else(inherited).or(default.map(str::to_owned))
    });
    let meaning = match read.flatten() {
        Some(read) => format!("which OpenSim reads as {read}"),
        None => "with which OpenSim refuses the model".to_owned(),
    };
    Some((&ODD_NUMBER, format!("is '{}', {meaning}", shown_text(&raw.text))))
}

fn in_words(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

/// Words about a curve whose points have more or fewer numbers `tag` than numbers of the other axis; `None` if they have as many.
fn unequal_counts(document: &Document, curve: ElementId, tag: &str, text: &str) -> Option<String> {
    let other_tag = match tag {
        "x" => "y",
        "y" => "x",
        _ => return None,
    };
    let tree = document.tree();
    let count = |text: &str| words_of_old_numbers(text).len();
    let other = tree.child(curve, other_tag).map(|other| tree.raw_text(other).text);
    let (own, others) = (count(text), other.map_or(0, |other| count(&other)));
    (own != others).then(|| format!("has {own} numbers, and {other_tag} {others}"))
}

/// The largest number of letters of a text that a message shows.
const MOST_LETTERS_SHOWN: usize = 60;

/// A text on one line. Letters that are not ASCII are shown by their codes, because a blank that is not ASCII is none for OpenSim.
fn shown_text(text: &str) -> String {
    let text: String =
        text.chars().map(|letter| if letter.is_ascii_whitespace() { ' ' } else { letter }).collect();
    let text = if text.is_ascii() { text } else { text.escape_default().to_string() };
    match text.get(..MOST_LETTERS_SHOWN) {
        Some(start) if text.len() > MOST_LETTERS_SHOWN => format!("{start}..."),
        _ => text,
    }
}

/// A number with no more letters than these is finite if it has no exponent.
const MOST_LETTERS_OF_FINITE: usize = 300;

impl TextForm {
    /// Whether a text is the right count of numbers without exponents, which OpenSim reads as they look. Most texts are.
    fn has_decimals_alone(self, text: &str) -> bool {
        let (Numbers(count) | OldNumbers(Some(count))) = self else { return false };
        let is_decimal = |word: &str| {
            let letters = word.strip_prefix('-').unwrap_or(word).as_bytes();
            let points = letters.iter().filter(|letter| **letter == b'.').count();
            let are_plain = || letters.iter().all(|&letter| letter == b'.' || letter.is_ascii_digit());
            points <= 1 && (points + 1..=MOST_LETTERS_OF_FINITE).contains(&letters.len()) && are_plain()
        };
        let mut words = 0;
        let mut are_decimal = || opensim_text::list_words(text).inspect(|_| words += 1).all(is_decimal);
        are_decimal() && words == count
    }

    /// The numbers of a text, none if it is a flag; `None` if a person and OpenSim do not read the text alike.
    fn plain_numbers(self, text: &str) -> Option<Vec<f64>> {
        let is_flag = || ["true", "false", "0", "1"].iter().any(|flag| flag.eq_ignore_ascii_case(text));
        match self {
            Numbers(count) => plain_numbers(text).filter(|numbers| numbers.len() == count),
            Flag | OldFlag => is_flag().then(Vec::new),
            OldNumbers(count) => are_old_numbers(text, count).then(Vec::new),
            List => plain_numbers(text),
            OldCount => text.parse::<u32>().is_ok().then(Vec::new),
        }
    }

    /// The value that OpenSim reads, in words; `None` if it cannot read the text.
    fn read(self, text: &str) -> Option<String> {
        match self {
            Numbers(count) => {
                let mut all = opensim_text::numbers(text)?;
                // A vector needs whole vectors, a pair its two numbers.
                let fits = if count == 2 { all.len() >= 2 } else { all.len() % count == 0 };
                all.truncate(count);
                fits.then(|| in_words(&all))
            }
            Flag => opensim_text::flag(text).map(|flag| flag.to_string()),
            OldFlag => Some(opensim_text::is_disabled(text).to_string()),
            List => opensim_text::numbers(text).map(|all| in_words(&all)),
            OldNumbers(_) | OldCount => None,
        }
    }
}

/// Whether a text is `count` finite numbers, separated by blanks or by commas, perhaps in brackets.
fn are_old_numbers(text: &str, count: Option<usize>) -> bool {
    let words = words_of_old_numbers(text);
    let is_finite = |word: &&str| {
        plain_numbers(word).is_some_and(|numbers| matches!(numbers[..], [one] if one.is_finite()))
    };
    count.is_none_or(|count| words.len() == count) && !words.is_empty() && words.iter().all(is_finite)
}

/// The words of a list of numbers that may be in brackets and have commas.
fn words_of_old_numbers(text: &str) -> Vec<&str> {
    let brackets = [('(', ')'), ('[', ']')];
    let inside = brackets.iter().find_map(|&(open, close)| text.strip_prefix(open)?.strip_suffix(close));
    let text = inside.unwrap_or(text);
    if text.contains(',') { text.split(',').collect() } else { opensim_text::words(text).collect() }
}

rule! { pub(super) NOT_FINITE: NotFinite, Error, Sizes;
    what: "A number in the file is not finite.",
    why: "JSON has no NaN and no infinity: such a number is null there. What OpenSim computes from it is meaningless.",
    advice: "Correct the number in the model",
    repair: Repair::NotPossible("only you know which number is right"),
    example: Example::ElementText { tag: "radius", good: "0.0325", bad: "nan" },
}

rule! { pub(super) ODD_NUMBER: OddNumber, Error, Sizes;
    what: "A number or flag is written in a way that OpenSim reads differently from what it looks like.",
    why: "OpenSim reads the start of a text as far as it looks like a number and ignores the rest, or silently takes its default. This holds for contacts, for masses, and for all that a pose depends on: frames, joints, coordinates.",
    advice: "Write numbers plainly, like 1.5e6, with blanks between them, and flags as true or false",
    repair: Repair::NotPossible("only you know which value is right"),
    example: Example::ElementText { tag: "radius", good: "0.0325", bad: "0,0325" },
}

/// What is odd about the writing of a value, in words that follow the name of the value.
fn describe_odd_number(value: &Value) -> Option<String> {
    value.fault.as_ref()?;
    let meaning = match value.property {
        // The default is not a number.
        Property::Mass if value.number.is_nan() => "with which OpenSim refuses the model".to_owned(),
        _ => format!("which OpenSim reads as {}", value.number),
    };
    Some(format!("is '{}', {meaning}", value.text))
}

rule! { pub(super) OUT_OF_DOMAIN: OutOfDomain, Error, Sizes;
    what: "A number lies outside the domain of the contact laws, or no body can have it.",
    why: "OpenSim accepts it and computes NaN or meaningless numbers; contacts with such a number are not changed.",
    advice: "Correct the number in the model",
    repair: Repair::NotPossible("only you know which number is right"),
    example: Example::ElementText { tag: "radius", good: "0.0325", bad: "-0.0325" },
}

/// A centre of mass that is farther than this from all joints of its body, m, is in another unit. No body of an animal is so long.
const FARTHEST_CENTRE_M: f64 = 10.0;
/// No body of an animal weighs more than this, kg: the mass is in grams.
const LARGEST_MASS_KG: f64 = 1e5;
/// Moments of inertia below this, kg m², are not a rounding error.
const LEAST_INERTIA: f64 = -1e-9;

/// One finding for all bodies with a mass, a moment of inertia or a centre of mass that no body can have. OpenSim 4.6 simulates with them.
/// A platform can have any.
pub(super) fn find_impossible_bodies(model: &Model) -> Vec<Finding> {
    let finding = |body: &Body| {
        let (shape, path) = (model.body_shapes().get(&body.name)?, &body.path);
        let [xx, yy, zz, ..] = shape.inertia_kg_m2.unwrap_or_default();
        let distances_m = shape.joints_m.iter().map(|joint_m| joint_m.distance(shape.centre_m));
        let nearest_m = distances_m.reduce(f64::min).unwrap_or_default();
        let kg = body.mass_kg().unwrap_or_default();
        let text = if let Some(moment) = [xx, yy, zz].into_iter().find(|&moment| moment < LEAST_INERTIA) {
            format!("inertia of {path} is {moment}, expected 0 or more")
        } else if nearest_m > FARTHEST_CENTRE_M {
            let far = three_significant(nearest_m);
            format!("mass_center of {path} is {far} m from a joint, expected at most {FARTHEST_CENTRE_M} m")
        } else if kg > LARGEST_MASS_KG {
            format!("mass of {path} is {kg} kg, expected at most {LARGEST_MASS_KG} kg")
        } else {
            return None;
        };
        let position = model.file(body.file).position(body.mass.offset);
        Some(Finding::at(&OUT_OF_DOMAIN, position, text).with_place(path))
    };
    let counted = model.bodies().iter().filter(|body| !body.excluded_from_mass);
    Finding::join_cases(&counted.filter_map(finding).collect::<Vec<_>>()).into_iter().collect()
}

/// Why a value is outside its domain, in words that follow the name of the value. A default stiffness is left to another rule.
fn describe_out_of_domain(value: &Value) -> Option<String> {
    (!value.property.allows(value.number) && !is_default_stiffness(value))
        .then(|| format!("is {}, expected {}", value.number, value.property.domain()))
}
