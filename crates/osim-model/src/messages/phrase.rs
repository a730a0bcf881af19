//! Message texts that contain inputs and calls as data, and how front ends write these.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt;

use foldhash::{HashSet, HashSetExt};

use super::input::{Call, Example, Input, PhrasePart, Verb};
use super::printable::one_line;

/// A message text. Inputs and calls in it are data until a front end writes them in its own way.
///
/// ```
/// use osim_model::messages::{Input, Phrase};
///
/// let phrase = Phrase::template("Say `mass=KG`, or look at the model with `inspect MODEL`");
/// // A page shows a field for each input.
/// assert_eq!(phrase.inputs(), [Input::Mass]);
/// // Without a dialect, inputs have the names of their fields.
/// assert_eq!(phrase.to_string(), "Say `mass`, or look at the model with `inspect`");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Phrase(Vec<PhrasePart>);

impl Phrase {
    /// A text in which inputs and calls are in backticks: `` `mass` ``, `` `contacts_mass=KG` ``, `` `design MODEL indentation=0.16` ``.
    /// Other text in backticks is not changed.
    pub fn template(text: &str) -> Self {
        let mut phrase = Self::default();
        for (index, piece) in text.split('`').enumerate() {
            match (index % 2 == 1).then(|| template_part(piece)).flatten() {
                Some(part) => phrase.push(part),
                None if index % 2 == 1 => phrase.push(format!("`{piece}`")),
                None if piece.is_empty() => {}
                None => phrase.push(piece.to_owned()),
            }
        }
        phrase
    }

    /// Several phrases joined by `mark`; `None` if there are no phrases.
    pub fn joined(phrases: impl IntoIterator<Item = Self>, mark: &'static str) -> Option<Self> {
        phrases.into_iter().reduce(|mut all, next| {
            all.push(mark);
            all.push(&next);
            all
        })
    }

    /// Adds a part at the end.
    pub fn push(&mut self, part: impl IntoParts) {
        self.0.extend(part.into_parts());
    }

    pub fn parts(&self) -> &[PhrasePart] {
        &self.0
    }

    /// The inputs that the phrase names, each once, in order.
    pub fn inputs(&self) -> Vec<Input> {
        let mut named = Vec::new();
        name_inputs(&self.0, &mut named);
        let mut seen = HashSet::new();
        named.retain(|input| seen.insert(*input));
        named
    }

    /// The phrase as the text of a front end.
    pub fn spelled(&self, dialect: &dyn Dialect) -> String {
        let mut text = String::new();
        spell_into(&mut text, &self.0, dialect);
        text
    }

    /// Chooses one of the two texts of each [`Input::either`] in the phrase: the first if `takes` is true for the input, else the second.
    /// Before this call, the first text counts.
    ///
    /// ```
    /// use osim_model::messages::{Input, phrase};
    ///
    /// let file = phrase![", or give the ScaleSet that was applied with ", Input::BodyScaleFile.with_placeholder("FILE")];
    /// let mut way_out = phrase!["say it with ", Input::BodyScale.with_placeholder("BODY=x,y,z"), Input::BodyScaleFile.either(&file, "")];
    /// way_out.choose_alternatives(&|input| input != Input::BodyScaleFile);
    /// assert_eq!(way_out.to_string(), "say it with `body_scale`");
    /// ```
    pub fn choose_alternatives(&mut self, takes: &dyn Fn(Input) -> bool) {
        if self.0.iter().any(|part| matches!(part, PhrasePart::Either(..))) {
            let parts = std::mem::take(&mut self.0);
            choose_texts(parts, takes, &mut self.0);
        }
    }

    /// Names the file of the model in calls that have one, and in calls of `check` also the model it was scaled from, if there is one.
    pub fn name_files(&mut self, model: &str, from: Option<&str>) {
        for part in &mut self.0 {
            if let PhrasePart::Call(call) = part
                && call.with_model
            {
                call.files = vec![model.to_owned()];
                let from = from.filter(|_| call.verb == Verb::Check);
                let asked = call.inputs.iter_mut().filter(|(input, _)| *input == Input::From);
                asked.zip(from).for_each(|((_, value), name)| *value = Some(Example::Value(name.to_owned())));
            }
        }
    }

    /// Converts the phrase to plain text in the `dialect` of a front end. It has no inputs and calls any more.
    pub fn spell(&mut self, dialect: &dyn Dialect) {
        if self.0.iter().any(|part| !matches!(part, PhrasePart::Text(_))) {
            *self = Self::from(self.spelled(dialect));
        }
    }
}

impl Input {
    /// Two alternative texts: `taken` for a verb that takes this input, `otherwise` for other verbs. [`Phrase::choose_alternatives`]
    /// decides.
    pub fn either(self, taken: impl Into<Phrase>, otherwise: impl Into<Phrase>) -> PhrasePart {
        PhrasePart::Either(self, Box::new([taken.into().0, otherwise.into().0]))
    }
}

/// Adds the inputs in `parts` to `named`, in their order.
fn name_inputs(parts: &[PhrasePart], named: &mut Vec<Input>) {
    for part in parts {
        match part {
            PhrasePart::Text(_) => {}
            PhrasePart::Input(input, _) => named.push(*input),
            PhrasePart::Call(call) => named.extend(call.inputs.iter().map(|(input, _)| *input)),
            PhrasePart::Either(_, words) => name_inputs(&words[0], named),
        }
    }
}

/// Appends the `parts`, written in the `dialect` of a front end, to `text`.
fn spell_into(text: &mut String, parts: &[PhrasePart], dialect: &dyn Dialect) {
    for part in parts {
        match part {
            PhrasePart::Text(words) => text.push_str(words),
            PhrasePart::Input(input, example) => {
                text.push_str(&one_line(dialect.input(*input, example.as_ref())));
            }
            PhrasePart::Call(call) => text.push_str(&one_line(dialect.call(call))),
            PhrasePart::Either(_, words) => spell_into(text, &words[0], dialect),
        }
    }
}

/// Moves the `parts` to `kept`. Of each [`PhrasePart::Either`], only the chosen text is kept.
fn choose_texts(parts: Vec<PhrasePart>, takes: &dyn Fn(Input) -> bool, kept: &mut Vec<PhrasePart>) {
    for part in parts {
        match part {
            PhrasePart::Either(input, words) => {
                let [taken, otherwise] = *words;
                choose_texts(if takes(input) { taken } else { otherwise }, takes, kept);
            }
            part => kept.push(part),
        }
    }
}

/// Reads the text between two backticks of a template as an input or a call; `None` if it is neither.
fn template_part(text: &str) -> Option<PhrasePart> {
    let mut words = text.split(' ');
    let first = words.next()?;
    // The verb `motion` is always written with its model; alone the word is the option.
    let Some(verb) = Verb::find(first).filter(|_| text != Verb::Motion.name()) else {
        let (input, example) = template_input(first)?;
        return words.next().is_none().then_some(PhrasePart::Input(input, example));
    };
    let mut call = verb.call();
    for word in words {
        match word {
            "MODEL" => call.with_model = true,
            word => call.inputs.push(template_input(word)?),
        }
    }
    Some(PhrasePart::Call(call))
}

/// Reads `name` or `name=VALUE`. A value that begins with a capital letter is a placeholder.
fn template_input(word: &str) -> Option<(Input, Option<Example>)> {
    let (name, value) = word.split_once('=').map_or((word, None), |(name, value)| (name, Some(value)));
    let input = Input::find(name)?;
    let example = value.map(|value| match value.starts_with(|c: char| c.is_ascii_uppercase()) {
        true => Example::Placeholder(Cow::Owned(value.to_owned())),
        false => Example::Value(value.to_owned()),
    });
    Some((input, example))
}

/// Writes each input as the name of its field ([`FieldNames`]).
impl fmt::Display for Phrase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.spelled(&FieldNames))
    }
}

impl<T: IntoParts> From<T> for Phrase {
    fn from(parts: T) -> Self {
        Self(parts.into_parts())
    }
}

/// A type that can be converted to parts of a [`Phrase`].
pub trait IntoParts {
    fn into_parts(self) -> Vec<PhrasePart>;
}

/// The parts of each type, made from its value.
macro_rules! into_parts {
    ($($from:ty: $value:ident => $parts:expr;)+) => {$(
        impl IntoParts for $from {
            fn into_parts(self) -> Vec<PhrasePart> {
                let $value = self;
                $parts
            }
        }
    )+};
}

into_parts! {
    &'static str: text => vec![PhrasePart::Text(Cow::Borrowed(text))];
    // A computed text may contain names from files. It is shown on one line, with invisible letters escaped.
    String: text => vec![PhrasePart::Text(Cow::Owned(one_line(text)))];
    PhrasePart: part => vec![part];
    Input: input => vec![PhrasePart::Input(input, None)];
    Call: call => vec![PhrasePart::Call(call)];
    &Phrase: phrase => phrase.0.clone();
}

/// Makes a [`Phrase`] from texts, inputs, calls and other phrases.
///
/// ```
/// use osim_model::messages::{Input, phrase};
///
/// let way_out = phrase!["give the mass of the model with ", Input::Mass.with_placeholder("KG")];
/// assert_eq!(way_out.to_string(), "give the mass of the model with `mass`");
/// ```
///
/// A text with `{}` for each part after the `;`, and `{name}` for values, as in [`format!`]:
///
/// ```
/// use osim_model::messages::{Input, phrase};
///
/// let kg = 70;
/// let way_out = phrase!["with {} you say {kg} kg"; Input::Mass];
/// assert_eq!(way_out, phrase!["with ", Input::Mass, " you say 70 kg"]);
/// ```
#[macro_export]
macro_rules! phrase {
    ($text:literal; $($part:expr),+ $(,)?) => {{
        let parts = $crate::messages::PartsInText::default();
        let phrase = parts.phrase(format_args!($text, $(parts.part($part)),+));
        phrase
    }};
    ($($part:expr),* $(,)?) => {{
        #[allow(unused_mut, reason = "an empty phrase gets no parts")]
        let mut phrase = $crate::messages::Phrase::default();
        $(phrase.push($part);)*
        phrase
    }};
}

/// The text of [`phrase!`] while it is written: a [`PartInText`] in it becomes a part of the phrase, all else is text.
#[derive(Debug, Default)]
pub struct PartsInText(RefCell<(Phrase, String)>);

/// A part that [`phrase!`] puts into a text.
pub struct PartInText<'t>(&'t PartsInText, Vec<PhrasePart>);

impl PartsInText {
    pub fn part(&self, part: impl IntoParts) -> PartInText<'_> {
        PartInText(self, part.into_parts())
    }

    pub fn phrase(&self, text: fmt::Arguments<'_>) -> Phrase {
        fmt::write(&mut &*self, text).unwrap_or_default();
        self.add(&[]);
        self.0.take().0
    }

    /// Adds the text that was written until now, then the parts.
    fn add(&self, parts: &[PhrasePart]) {
        let (phrase, text) = &mut *self.0.borrow_mut();
        if !text.is_empty() {
            phrase.push(std::mem::take(text));
        }
        phrase.0.extend_from_slice(parts);
    }
}

impl fmt::Write for &PartsInText {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.borrow_mut().1.push_str(text);
        Ok(())
    }
}

/// Writes no text: adds its part to the phrase.
impl fmt::Display for PartInText<'_> {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.add(&self.1);
        Ok(())
    }
}

// How front ends spell inputs and calls.

/// The way in which a front end writes inputs and calls.
///
/// ```
/// use osim_model::messages::{Call, Dialect, Example, Input, phrase};
///
/// /// `mass=KG`, as in a call of a Python function.
/// struct Python;
///
/// impl Dialect for Python {
///     fn input(&self, input: Input, example: Option<&Example>) -> String {
///         match example {
///             Some(example) => format!("{}={example}", input.name()),
///             None => input.name().to_owned(),
///         }
///     }
///
///     fn call(&self, call: &Call) -> String {
///         let inputs = call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref()));
///         format!("{}({})", call.verb.name(), inputs.collect::<Vec<_>>().join(", "))
///     }
/// }
///
/// let way_out = phrase!["give the mass of the model with ", Input::Mass.with_placeholder("KG")];
/// assert_eq!(way_out.spelled(&Python), "give the mass of the model with mass=KG");
/// ```
pub trait Dialect {
    /// The text for an input, with an example of its value, as the reader types it.
    fn input(&self, input: Input, example: Option<&Example>) -> String;

    fn call(&self, call: &Call) -> String;
}

/// A dialect that writes each input as the name of its field in a request. For callers without a dialect of their own.
#[derive(Debug, Clone, Copy, Default)]
pub struct FieldNames;

impl Dialect for FieldNames {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        match example {
            Some(Example::Value(value)) => format!("`{}` {value}", input.name()),
            _ => format!("`{}`", input.name()),
        }
    }

    fn call(&self, call: &Call) -> String {
        let inputs: Vec<String> =
            call.inputs.iter().map(|(input, example)| self.input(*input, example.as_ref())).collect();
        let with = if inputs.is_empty() { String::new() } else { format!(" with {}", inputs.join(" and ")) };
        format!("`{}`{with}", call.verb.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Uppercase;

    impl Dialect for Uppercase {
        fn input(&self, input: Input, example: Option<&Example>) -> String {
            let example = example.map(|example| format!(" {example}")).unwrap_or_default();
            format!("{}{example}", input.name().to_uppercase())
        }

        fn call(&self, call: &Call) -> String {
            call.verb.name().to_uppercase()
        }
    }

    #[test]
    fn a_front_end_spells_inputs_and_calls() {
        let phrase = phrase![
            "say ",
            Input::Mass.with_placeholder("KG"),
            " or ",
            Verb::Check.call_with_model(),
            ", ",
            62.to_string()
        ];
        assert_eq!(phrase.spelled(&Uppercase), "say MASS KG or CHECK, 62");
        assert_eq!(phrase.inputs(), [Input::Mass]);
    }

    #[test]
    fn a_spelled_phrase_has_no_inputs() {
        let mut phrase = phrase!["say ", Input::Radius.with_value("keep")];
        phrase.spell(&Uppercase);
        assert_eq!(phrase.to_string(), "say RADIUS keep");
        assert_eq!(phrase, Phrase::from("say RADIUS keep".to_owned()));
    }

    #[test]
    fn a_template_names_inputs_and_calls_in_backticks() {
        let phrase = Phrase::template(
            "`mass`, `radius=keep`, `load=N` or `design MODEL indentation=0.16`: see `docs`",
        );
        assert_eq!(phrase.spelled(&Uppercase), "MASS, RADIUS keep, LOAD N or DESIGN: see `docs`");
        assert_eq!(phrase.inputs(), [Input::Mass, Input::Radius, Input::Load, Input::Indentation]);
    }

    #[test]
    fn text_from_outside_is_never_taken_for_an_input() {
        assert_eq!(Phrase::from("{mass} `mass`".to_owned()).spelled(&Uppercase), "{mass} `mass`");
    }

    #[test]
    fn text_from_outside_cannot_begin_a_line_or_steer_a_terminal() {
        let name = "a\nerror: \u{1b}[2J\u{202e}";
        let phrase =
            phrase![format!("the sphere {name} has no radius, say "), Input::Radius.with_value(name)];
        let printed = phrase.spelled(&Uppercase);
        assert_eq!(
            printed,
            r"the sphere a\nerror: \u{1b}[2J\u{202e} has no radius, say RADIUS a\nerror: \u{1b}[2J\u{202e}"
        );
        assert!(Phrase::from("a".repeat(5_000_000)).to_string().len() < 5100);
    }
}
