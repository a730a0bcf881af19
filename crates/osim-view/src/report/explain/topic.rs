//! Something that can be explained, by its name: equations, codes, and everything that has a number.

use std::sync::LazyLock;

use contact_scaling::Equation;
use osim_inspect::{Figure, Quantity};
use osim_model::messages::{Phrase, Verb};
use osim_model::{Property, Question, Rule};
use osim_planning::{DesignQuantity, DropColumn, DropFigure, rules};
use osim_requests::spell::FrontEnd;

use crate::report::explain::equations::{equation, equations};
use crate::report::explain::errors::{ErrorCode, errors};
use crate::report::explain::traps;

/// Something that can be explained.
#[derive(Debug, Clone, Copy, PartialEq)]
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
pub struct UnknownTopic {
    /// The name.
    pub name: String,
    /// Names like it.
    pub near: Vec<&'static str>,
}

impl Topic {
    /// Everything that can be explained.
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
    pub fn message(&self, front_end: &dyn FrontEnd) -> String {
        let near: Vec<String> = self.near.iter().map(|near| format!("'{near}'")).collect();
        let near =
            if near.is_empty() { String::new() } else { format!(": did you mean {}?", near.join(" or ")) };
        let list = front_end.command(&Verb::Explain.call());
        format!("nothing called '{}' can be explained{near} (`{list}` lists all that can)", self.name)
    }
}

// Everything that has a number: OpenSim's properties, and the figures of every register.

/// A quantity, as it is explained.
#[derive(Debug, Clone, PartialEq)]
pub struct QuantityTopic {
    /// OpenSim's name of a property, or the name in JSON and CSV.
    pub name: &'static str,
    /// Other names that people know it by.
    pub symbols: &'static [&'static str],
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Number of the equation in the paper; empty where there is none.
    pub equation: &'static str,
    /// Its limit in words, where it has one.
    pub limit: Option<String>,
    what: String,
    trap: &'static str,
}

static QUANTITIES: LazyLock<Vec<QuantityTopic>> = LazyLock::new(|| {
    let properties = Property::ALL.into_iter().chain([Property::Mass]).map(QuantityTopic::of_property);
    let figures = Figure::ALL.iter().map(|figure| figure.info());
    let designs = DesignQuantity::ALL.iter().map(|quantity| quantity.info());
    let drops = DropFigure::ALL.iter().map(|figure| figure.info());
    let columns = DropColumn::ALL.iter().map(|column| column.info());
    let registers = figures.chain(designs).chain(drops).chain(columns).map(QuantityTopic::of_register);
    let mut all: Vec<QuantityTopic> = Vec::new();
    // What several registers have is explained once.
    let mut first = "";
    for mut topic in properties.chain(registers) {
        // Registers say "The same ..." about what is before.
        match topic.what.strip_prefix("The same ") {
            Some(rest) => topic.what = format!("As {first}, but {rest}"),
            None => first = topic.name,
        }
        if !all.iter().any(|known| known.name == topic.name) {
            all.push(topic);
        }
    }
    all
});

/// Every quantity: properties first, then figures in the order of their registers.
pub(super) fn quantities() -> impl Iterator<Item = &'static QuantityTopic> {
    QUANTITIES.iter()
}

/// The quantity of this name, symbol or label.
pub(super) fn quantity(name: &str) -> Option<&'static QuantityTopic> {
    let flat = |text: &str| text.trim_ascii().to_lowercase().replace(['-', ' '], "_");
    let by_name = || quantities().find(|topic| topic.name == flat(name));
    // Symbols differ in capitals: R is a radius, k a stiffness.
    let exact = || quantities().find(|topic| topic.symbols.contains(&name.trim_ascii()));
    exact()
        .or_else(by_name)
        .or_else(|| quantities().find(|topic| topic.symbols.iter().any(|it| flat(it) == flat(name))))
}

impl QuantityTopic {
    fn new(name: &'static str, unit: &'static str, what: &'static str) -> Self {
        let known = traps::ALL.iter().find(|known| known.name == name);
        let (symbols, trap) = known.map_or((&[][..], ""), |known| (known.symbols, known.trap));
        Self { name, symbols, unit, equation: "", limit: None, what: without_code(what), trap }
    }

    fn of_property(property: Property) -> Self {
        let (equation, what) = described(property);
        Self { equation, ..Self::new(property.name(), property.unit(), what) }
    }

    fn of_register(quantity: &'static Quantity) -> Self {
        let limit = quantity.limit.map(|limit| format!("{} ({})", limit.in_words(), limit.source));
        let topic = Self::new(quantity.name, quantity.unit, quantity.meaning_text());
        Self { equation: quantity.equation, limit, ..topic }
    }

    /// What it is.
    pub fn what(&self) -> Phrase {
        Phrase::template(&self.what)
    }

    /// What is easily misunderstood about it.
    pub fn trap(&self) -> Phrase {
        Phrase::template(self.trap)
    }

    /// The unit, in words.
    pub(crate) fn unit_in_words(&self) -> &'static str {
        if self.unit.is_empty() { "none, it is a pure number" } else { self.unit }
    }
}

/// Without the backticks around names of classes, which nobody types.
fn without_code(text: &str) -> String {
    let is_class = |piece: &str| piece.starts_with(|c: char| c.is_ascii_uppercase());
    let pieces = text.split('`').enumerate().map(|(index, piece)| match index % 2 == 1 && !is_class(piece) {
        true => format!("`{piece}`"),
        false => piece.to_owned(),
    });
    pieces.collect()
}

/// What a property of a contact is, and the equation by which it is scaled.
const fn described(property: Property) -> (&'static str, &'static str) {
    match property {
        Property::Stiffness => {
            ("10", "Plane strain modulus E₁* of one of two equal surfaces, as OpenSim takes it")
        }
        Property::Dissipation => {
            ("14", "Hunt–Crossley dissipation α: how much of the force follows the speed of indentation (12)")
        }
        Property::StaticFriction => ("", "Coefficient of friction of a sphere that does not slip"),
        Property::DynamicFriction => ("", "Coefficient of friction of a sphere that slips"),
        Property::ViscousFriction => ("friction", "How much friction grows with the slip speed"),
        Property::TransitionVelocity => {
            ("friction", "Slip speed at which friction changes from static to dynamic")
        }
        Property::ConstantContactForce => (
            "C.2",
            "cf of SmoothSphereHalfSpaceForce: added to the squared indentation, so that the force has no kink (C.1)",
        ),
        Property::HertzSmoothing => (
            "C.5",
            "bd of SmoothSphereHalfSpaceForce: how sharply the force sets in with the indentation (C.4)",
        ),
        Property::HuntCrossleySmoothing => (
            "C.10",
            "bv of SmoothSphereHalfSpaceForce: how sharply the force ends when the sphere leaves the ground fast (C.9)",
        ),
        Property::Radius => ("8", "Radius R of a ContactSphere"),
        _ => ("", "Mass of a body; the sum over all bodies is what the model weighs"),
    }
}

#[cfg(test)]
mod tests {
    use osim_requests::spell::CommandLine;

    use super::*;
    use crate::report::explain::traps;

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

    #[test]
    fn every_quantity_has_a_trap_and_every_trap_its_quantity() {
        for topic in quantities() {
            assert!(!topic.trap.is_empty() && !topic.what.is_empty(), "{}", topic.name);
        }
        for known in traps::ALL {
            assert!(quantities().any(|topic| topic.name == known.name), "{}", known.name);
        }
    }

    #[test]
    fn quantities_are_found_by_name_symbol_and_table() {
        for (said, name) in [
            ("stiffness", "stiffness"),
            ("alpha", "dissipation"),
            ("α", "dissipation"),
            ("Alpha", "dissipation"),
            ("R", "radius"),
            ("cf", "constant_contact_force"),
            ("hertz-smoothing", "hertz_smoothing"),
            ("x/R", "relative_indentation_hertz"),
            ("k", "contact_stiffness_n_m"),
            ("peak_force_bw", "peak_force_bw"),
        ] {
            assert_eq!(quantity(said).map(|topic| topic.name), Some(name), "{said}");
        }
    }

    #[test]
    fn no_symbol_means_two_quantities() {
        let mut all: Vec<&str> = traps::ALL.iter().flat_map(|known| known.symbols).copied().collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
    }
}
