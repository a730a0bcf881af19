//! The trait of a language that spells requests, and the fields of a request for all languages.

use osim_model::Property;
use osim_model::messages::{Call, Dialect, Input, Verb, shortest};
use serde_json::{Map, Number, Value};

use crate::register::{FieldGroup, option_named};
use crate::request::{Request, verb_entry};

/// A front end, or another language that spells inputs, calls and whole requests.
///
/// Texts are unchanged, within the quotation marks of the language. A file name gets `./` before it if the language would take it
/// for something else. A name that is not UTF-8 contains U+FFFD, so that its call cannot be copied.
///
/// ```
/// use osim_requests::Request;
/// use osim_requests::spell::{CommandLine, FrontEnd, Matlab, Python};
///
/// let request = br#"{"verb": "rescale", "models": "human.osim", "target_mass": 500}"#;
/// let request = Request::from_json(request)?;
/// assert_eq!(CommandLine.request(&request), "osim-contact-scale rescale human.osim --target-mass 500");
/// assert_eq!(Python.request(&request), r#"ocs.rescale("human.osim", target_mass=500)"#);
/// assert_eq!(Matlab.request(&request), "osimcontact.rescale('human.osim', 'TargetMass', 500)");
/// # Ok::<(), osim_requests::RequestFault>(())
/// ```
pub trait FrontEnd: Dialect {
    /// A request as the reader would type it.
    fn request(&self, request: &Request) -> String;

    /// The lines that do everything in a request; they also write its files and show its results.
    fn script(&self, request: &Request) -> String {
        self.request(request)
    }

    /// A call on a line of its own, for copying: on a command line it begins with the name of the program.
    fn command(&self, call: &Call) -> String {
        self.call(call)
    }

    /// A name as one word of a call.
    fn word(&self, name: &str) -> String {
        name.to_owned()
    }

    /// The prompt before a call that the reader can copy.
    fn prompt(&self) -> &'static str {
        ""
    }

    /// A reference to more help, for the end of a message about a wrong call.
    fn see_also(&self) -> &'static str {
        ""
    }
}

// The fields of a request, as every language writes them.

/// A field that differs from its default: its name in requests, and its value.
pub(super) type Field = (String, FieldValue);

/// The fields of a request, in the order in which a call lists them.
pub(super) struct Fields {
    pub(super) verb: Verb,
    /// Whether the verb changes models that it names.
    pub(super) changes: bool,
    /// Fields without a name in a call, in the order of the call.
    pub(super) positional: Vec<Field>,
    /// All other given fields, in the order of requests, which is also the order of the help and of forms.
    pub(super) options: Vec<Field>,
}

/// The value of a field, for spelling.
pub(super) enum FieldValue {
    /// An option without a value.
    Flag,
    Number(Number),
    Text(String),
    List(Vec<FieldValue>),
    /// Properties or bodies, each with its value.
    Map(Vec<Field>),
}

impl Fields {
    /// The fields that a request gives, in the order of a call.
    pub(super) fn of(request: &Request) -> Self {
        let verb = request.verb();
        let fields = request.to_map().into_iter().filter(|(name, _)| name != "verb");
        let fields = fields.filter_map(|(name, value)| Some((name, FieldValue::of(value)?)));
        let place = |name: &str| verb_entry(verb).positional.iter().position(|known| *known == name);
        let (mut positional, options): (Vec<Field>, Vec<Field>) =
            fields.partition(|(name, _)| place(name).is_some());
        positional.sort_by_key(|(name, _)| place(name));
        Self { verb, changes: request.run_options().is_some(), positional, options }
    }

    /// The models, if they have no name in the call.
    pub(super) fn models(&self) -> &[FieldValue] {
        match self.positional.iter().find(|(name, _)| name == "models") {
            Some((_, FieldValue::List(models))) => models,
            _ => &[],
        }
    }

    /// The options that are in none of `groups`.
    pub(super) fn outside_groups(&self, groups: &[FieldGroup]) -> impl Iterator<Item = &Field> {
        self.options
            .iter()
            .filter(|(name, _)| self.group_of(name).is_none_or(|group| !groups.contains(&group)))
    }

    /// The options that belong to `group`.
    pub(super) fn in_group(&self, group: FieldGroup) -> impl Iterator<Item = &Field> {
        self.options.iter().filter(move |(name, _)| self.group_of(name) == Some(group))
    }

    fn group_of(&self, name: &str) -> Option<FieldGroup> {
        option_named(self.verb, name)?.group
    }

    /// The value of the option `name`.
    pub(super) fn option(&self, name: &str) -> Option<&FieldValue> {
        self.options.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }
}

impl FieldValue {
    /// The value for spelling; `None` for null or false, because a call omits such a field.
    fn of(value: Value) -> Option<Self> {
        Some(match value {
            Value::Null | Value::Bool(false) => return None,
            Value::Bool(true) => Self::Flag,
            Value::Number(number) => Self::Number(number),
            Value::String(text) => Self::Text(text),
            Value::Array(items) => Self::List(items.into_iter().filter_map(Self::of).collect()),
            Value::Object(entries) => match bytes_of(&entries) {
                Some(bytes) => Self::Text(String::from_utf8_lossy(&bytes).into_owned()),
                None => Self::Map(
                    entries.into_iter().filter_map(|(name, value)| Some((name, Self::of(value)?))).collect(),
                ),
            },
        })
    }

    /// The value as text; the items of a list are separated by commas.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Number(number) => digits(number),
            Self::Text(text) => text.clone(),
            Self::List(items) => items.iter().map(Self::text).collect::<Vec<_>>().join(","),
            Self::Flag | Self::Map(_) => String::new(),
        }
    }

    /// The items of a list; for a single value, only this value.
    pub(super) fn items(&self) -> &[Self] {
        match self {
            Self::List(items) => items,
            one => std::slice::from_ref(one),
        }
    }
}

/// Whether `input` has no name in calls.
pub(super) fn is_positional(input: Input) -> bool {
    matches!(input, Input::Kind | Input::Topics)
}

/// Whether `input` is a property that `call` sets.
pub(super) fn is_assignment(call: &Call, input: Input) -> bool {
    call.verb == Verb::Set && input.name().parse::<Property>().is_ok()
}

/// The shortest decimal number that is read as the same double.
pub(super) fn digits(number: &Number) -> String {
    match number.as_f64().filter(|_| number.is_f64()) {
        Some(value) => shortest(value),
        None => number.to_string(),
    }
}

/// The bytes of a name that is not UTF-8, from `{"bytes": [...]}`; `None` if the entries are factors of a body called `bytes`,
/// which are not whole numbers in JSON.
fn bytes_of(entries: &Map<String, Value>) -> Option<Vec<u8>> {
    let bytes = entries.get("bytes").filter(|_| entries.len() == 1)?.as_array()?;
    bytes.iter().map(|byte| byte.as_u64().and_then(|byte| u8::try_from(byte).ok())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(values: &[FieldValue]) -> Vec<String> {
        values.iter().map(FieldValue::text).collect()
    }

    #[test]
    fn models_and_options_are_apart_and_numbers_are_short() {
        let request = br#"{"verb": "add", "models": ["a.osim", "b.osim"], "count": 3, "pad": 0.010, "feet": ["calcn_r"], "replace": true,
    "load": null, "force": false}"#;
        let fields = Fields::of(&Request::from_json(request).unwrap());
        assert_eq!(texts(fields.models()), ["a.osim", "b.osim"]);
        let options: Vec<(&str, String)> =
            fields.options.iter().map(|(name, value)| (name.as_str(), value.text())).collect();
        let expected = [("feet", "calcn_r"), ("count", "3"), ("pad", "0.01"), ("replace", "")];
        assert_eq!(options, expected.map(|(name, text)| (name, text.to_owned())));
    }

    #[test]
    fn positional_fields_have_the_order_of_the_call() {
        let request = br#"{"output": "a.svg", "models": "a.osim", "verb": "plot", "kind": "force"}"#;
        let fields = Fields::of(&Request::from_json(request).unwrap());
        let names: Vec<&str> = fields.positional.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["kind", "models"]);
        // A sweep's model has no name in a call; that of a force set has one.
        let sweep = br#"{"verb": "sweep", "model": "a.osim", "grid": "stiffness=x2"}"#;
        assert_eq!(Fields::of(&Request::from_json(sweep).unwrap()).positional[0].0, "model");
        let set = br#"{"verb": "set", "models": "a.xml", "set": "stiffness=x2", "model": "a.osim"}"#;
        assert!(Fields::of(&Request::from_json(set).unwrap()).option("model").is_some());
    }

    #[test]
    #[cfg(unix)]
    fn bytes_of_a_name_are_not_factors_of_a_body() {
        let request = br#"{"verb": "add", "models": {"bytes": [97, 255]}, "from": "b.osim", "body_scale": {"bytes": [1, 2, 1]}}"#;
        let fields = Fields::of(&Request::from_json(request).unwrap());
        assert_eq!(texts(fields.models()), ["a\u{fffd}"]);
        assert!(matches!(&fields.options[1], (name, FieldValue::Map(_)) if name == "body_scale"));
    }
}
