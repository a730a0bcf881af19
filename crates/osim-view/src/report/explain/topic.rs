//! Something that can be explained, by its name.

use contact_scaling::Equation;
use osim_model::messages::Verb;
use osim_model::{Question, Rule};
use osim_planning::rules;

use super::equations::{equation, equations};
use super::errors::{ErrorCode, errors};
use super::quantities::{QuantityTopic, quantities, quantity};
use osim_requests::spell::FrontEnd;

/// Something that can be explained.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Topic {
    /// An equation, or a rule of this project.
    Equation(&'static Equation),
    /// A property of a contact, or a figure.
    Quantity(&'static QuantityTopic),
    /// The rule of a warning or finding.
    Finding(&'static Rule),
    /// An error.
    Error(&'static ErrorCode),
}

/// A name that nothing has.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct UnknownTopic {
    /// The name.
    pub name: String,
    /// Names like it.
    pub near: Vec<&'static str>,
}

impl Topic {
    /// Everything that can be explained.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let findings = rules::all().iter().copied().map(Self::Finding);
        let numbers = equations().map(Self::Equation).chain(quantities().map(Self::Quantity));
        numbers.chain(findings).chain(errors().map(Self::Error)).collect()
    }

    /// All topics of `named`: one name, or several as the column "equation" has them (`11, B.2`).
    ///
    /// # Errors
    /// Something that is neither an equation, a quantity nor a code.
    pub fn find(named: &str) -> Result<Vec<Self>, UnknownTopic> {
        let by_comma: Vec<&str> =
            named.split(',').map(str::trim_ascii).filter(|name| !name.is_empty()).collect();
        let by_blank: Vec<&str> = named.split([',', ' ']).filter(|name| !name.is_empty()).collect();
        for names in [&[named][..], &by_comma, &by_blank] {
            let found: Vec<Vec<Self>> = names.iter().map(|name| called(name)).collect();
            if found.iter().all(|topics| !topics.is_empty()) {
                return Ok(found.concat());
            }
        }
        let unknown = by_comma.into_iter().find(|name| called(name).is_empty()).unwrap_or(named);
        Err(UnknownTopic::new(unknown))
    }

    /// The label of an equation, or a code.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Equation(equation) => equation.label,
            Self::Quantity(quantity) => quantity.name,
            Self::Finding(rule) => rule.code.as_str(),
            Self::Error(error) => error.code,
        }
    }
}

/// Everything called so: a code may be both a warning's and an error's.
fn called(name: &str) -> Vec<Topic> {
    let is_code = |code: &str| code == name.trim_matches(['[', ']', ' ']);
    let equation = equation(name).map(Topic::Equation);
    let quantity = quantity(name).map(Topic::Quantity);
    let warning = rules::all().iter().copied().find(|rule| is_code(rule.code.as_str())).map(Topic::Finding);
    let error = errors().find(|known| is_code(known.code)).map(Topic::Error);
    let found: Vec<Topic> = [equation, quantity, warning, error].into_iter().flatten().collect();
    if found.is_empty() && is_question(name) { questions() } else { found }
}

/// Whether `name` is the kind of all errors that ask, by the name that they have in the library.
fn is_question(name: &str) -> bool {
    name.trim_ascii().to_lowercase().replace(['-', '_', ' '], "") == "needsanswer"
}

/// The errors that ask.
fn questions() -> Vec<Topic> {
    let asks = |error: &&ErrorCode| Question::ALL.iter().any(|question| question.code() == error.code);
    errors().filter(asks).map(Topic::Error).collect()
}

/// A topic that is this like the name was probably meant; 1 is the same.
const NEAR: f64 = 0.7;

/// A shorter name is a part of too many.
const LONG: usize = 5;

/// So many names are named, at most, that a name is a part of.
const MOST: usize = 2;

impl UnknownTopic {
    fn new(name: &str) -> Self {
        let known: Vec<&'static str> = Topic::all().into_iter().map(Topic::name).collect();
        let likeness = |known: &str| strsim::normalized_damerau_levenshtein(name, known);
        let nearest = known.iter().copied().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        let mut near: Vec<&'static str> = nearest.into_iter().filter(|near| likeness(near) >= NEAR).collect();
        if near.is_empty() && name.len() >= LONG {
            near = known.into_iter().filter(|known| known.contains(name)).collect();
            near.dedup();
            near.truncate(MOST);
        }
        Self { name: name.to_owned(), near }
    }

    /// What is wrong, and a way out.
    #[must_use]
    pub fn message(&self, front_end: &dyn FrontEnd) -> String {
        let near: Vec<String> = self.near.iter().map(|near| format!("'{near}'")).collect();
        let near =
            if near.is_empty() { String::new() } else { format!(": did you mean {}?", near.join(" or ")) };
        let list = front_end.command(&Verb::Explain.call());
        format!("nothing called '{}' can be explained{near} (`{list}` lists all that can)", self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use osim_requests::spell::CommandLine;

    #[test]
    fn topics_are_found_as_they_are_printed() {
        let names = |named| Topic::find(named).map(|topics| topics.into_iter().map(Topic::name).collect());
        assert_eq!(names("11, B.2"), Ok(vec!["11", "B.2"]));
        assert_eq!(names("[included-file]"), Ok(vec!["included-file", "included-file"]));
    }

    #[test]
    fn what_is_unknown_is_named_with_what_is_near() {
        let unknown = Topic::find("11, sunk-inn").unwrap_err();
        assert_eq!(
            unknown.message(&CommandLine),
            "nothing called 'sunk-inn' can be explained: did you mean 'sunk-in'? (`osim-contact-scale explain` lists all that can)"
        );
        assert_eq!(
            Topic::find("smoothing").unwrap_err().near,
            ["hertz_smoothing", "hunt_crossley_smoothing"]
        );
    }
}
