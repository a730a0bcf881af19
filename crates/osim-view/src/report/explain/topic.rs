//! The topics that `explain` can explain, by their names: equations, codes of findings and errors, and quantities.

use std::sync::LazyLock;

use contact_scaling::Equation;
use osim_inspect::{Figure, Quantity};
use osim_model::messages::{Phrase, Verb};
use osim_model::{Property, Rule, YesQuestion, nearest_names};
use osim_planning::{DesignQuantity, DropColumn, DropFigure, rules};
use osim_requests::spell::FrontEnd;

use crate::report::explain::equations::{equation, equations};
use crate::report::explain::errors::{ErrorCode, errors};
use crate::report::explain::traps;

/// Something that `explain` can explain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Topic {
    /// An equation, or a rule of this project.
    Equation(&'static Equation),
    /// A property of a contact, or a figure.
    Quantity(&'static QuantityTopic),
    /// The rule of a finding.
    Finding(&'static Rule),
    /// An error, by its code.
    Error(&'static ErrorCode),
}

/// The fault that no topic has the given name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownTopic {
    /// The given name.
    pub name: String,
    /// Names of topics that are similar to the given name.
    pub similar_names: Vec<&'static str>,
}

impl Topic {
    /// All topics that `explain` can explain.
    pub fn all() -> Vec<Self> {
        let findings = rules::all().iter().copied().map(Self::Finding);
        let numbers = equations().map(Self::Equation).chain(quantities().map(Self::Quantity));
        numbers.chain(findings).chain(errors().map(Self::Error)).collect()
    }

    /// All topics with the name `named`; or with several names, as in the column "equation" of a table (`11, B.2`).
    ///
    /// # Errors
    /// Something that is neither an equation, a quantity nor a code.
    pub fn find(named: &str) -> Result<Vec<Self>, UnknownTopic> {
        let by_comma: Vec<&str> =
            named.split(',').map(str::trim_ascii).filter(|name| !name.is_empty()).collect();
        let by_blank: Vec<&str> = named.split([',', ' ']).filter(|name| !name.is_empty()).collect();
        for names in [&[named][..], &by_comma, &by_blank] {
            let topics_by_name: Vec<Vec<Self>> = names.iter().map(|name| topics_called(name)).collect();
            if topics_by_name.iter().all(|topics| !topics.is_empty()) {
                return Ok(topics_by_name.concat());
            }
        }
        let unknown = by_comma.into_iter().find(|name| topics_called(name).is_empty()).unwrap_or(named);
        Err(UnknownTopic::new(unknown))
    }

    /// The label of an equation, or the code of a finding or error.
    pub fn name(self) -> &'static str {
        match self {
            Self::Equation(equation) => equation.label,
            Self::Quantity(quantity) => quantity.name,
            Self::Finding(rule) => rule.code.as_str(),
            Self::Error(error) => error.code,
        }
    }
}

/// All topics called `name`. A finding and an error can have the same code.
fn topics_called(name: &str) -> Vec<Topic> {
    let is_code = |code: &str| code == name.trim_matches(['[', ']', ' ']);
    let equation = equation(name).map(Topic::Equation);
    let quantity = quantity(name).map(Topic::Quantity);
    let warning = rules::all().iter().copied().find(|rule| is_code(rule.code.as_str())).map(Topic::Finding);
    let error = errors().find(|known| is_code(known.code)).map(Topic::Error);
    let topics: Vec<Topic> = [equation, quantity, warning, error].into_iter().flatten().collect();
    // Python's name of all errors that ask the user something is `NeedsAnswer`.
    if topics.is_empty() && name.trim_ascii().to_lowercase().replace(['-', '_', ' '], "") == "needsanswer" {
        let asks =
            |error: &&ErrorCode| YesQuestion::ALL.iter().any(|question| question.as_str() == error.code);
        return errors().filter(asks).map(Topic::Error).collect();
    }
    topics
}

/// If a given name has at least this many letters, longer names that contain it are proposed. A shorter name is contained in too many
/// names.
const LEAST_LETTERS_OF_PART: usize = 4;

/// The largest number of names that are proposed because they contain the given name.
const MOST_PROPOSED_NAMES: usize = 2;

impl UnknownTopic {
    /// The fault about this name, with the names of similar topics.
    fn new(name: &str) -> Self {
        let topics: Vec<&'static str> = Topic::all().into_iter().map(Topic::name).collect();
        let mut similar_names = nearest_names(name, topics.iter().copied(), name.len() * 3 / 10);
        similar_names.truncate(1);
        if similar_names.is_empty() && name.len() >= LEAST_LETTERS_OF_PART {
            similar_names = topics.into_iter().filter(|topic| topic.contains(name)).collect();
            similar_names.dedup();
            similar_names.truncate(MOST_PROPOSED_NAMES);
        }
        Self { name: name.to_owned(), similar_names }
    }

    /// The message that no topic has this name, with the names of similar topics and the command that lists all topics.
    pub fn message(&self, front_end: &dyn FrontEnd) -> String {
        let quoted: Vec<String> = self.similar_names.iter().map(|name| format!("'{name}'")).collect();
        let proposal = if quoted.is_empty() {
            String::new()
        } else {
            format!(": did you mean {}?", quoted.join(" or "))
        };
        let list = front_end.command(&Verb::Explain.call());
        format!("nothing called '{}' can be explained{proposal} (`{list}` lists all that can)", self.name)
    }
}

// Everything that has a number: OpenSim's properties, and the figures of every register.

/// A quantity of the registers, with its explanation.
#[derive(Debug, Clone, PartialEq)]
pub struct QuantityTopic {
    /// The name of a property in OpenSim; or the name of a figure in JSON and CSV.
    pub name: &'static str,
    /// Symbols of the quantity. A symbol also is a name of the topic.
    pub symbols: &'static [&'static str],
    /// Unit of the quantity; empty for a pure number.
    pub unit: &'static str,
    /// Number that the paper gives the equation of the quantity; empty where the paper has none.
    pub equation: &'static str,
    /// Limit of the quantity in words, where it has one.
    pub limit: Option<String>,
    what: String,
    trap: &'static str,
}

static QUANTITIES: LazyLock<Vec<QuantityTopic>> = LazyLock::new(|| {
    let properties = Property::ALL.iter().copied().map(QuantityTopic::of_property);
    let figures = Figure::ALL.iter().map(|figure| figure.info());
    let designs = DesignQuantity::ALL.iter().map(|quantity| quantity.info());
    let drops = DropFigure::ALL.iter().map(|figure| figure.info());
    let columns = DropColumn::ALL.iter().map(|column| column.info());
    let registers = figures.chain(designs).chain(drops).chain(columns).map(QuantityTopic::of_register);
    let mut all: Vec<QuantityTopic> = Vec::new();
    // What several registers have is explained once.
    for topic in properties.chain(registers) {
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

/// The quantity with this name, symbol or label.
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
    /// A quantity with its trap, if the list of traps has one.
    fn new(name: &'static str, unit: &'static str, what: &'static str) -> Self {
        let trap = traps::ALL.iter().find(|trap| trap.name == name);
        let (symbols, trap) = trap.map_or((&[][..], ""), |trap| (trap.symbols, trap.trap));
        let what = without_backticks_of_classes(what);
        Self { name, symbols, unit, equation: "", limit: None, what, trap }
    }

    fn of_property(property: Property) -> Self {
        let (equation, what) = equation_and_meaning(property);
        Self { equation, ..Self::new(property.as_str(), property.unit(), what) }
    }

    fn of_register(quantity: &'static Quantity) -> Self {
        let limit = quantity.limit.map(|limit| format!("{} ({})", limit.in_words(), limit.source));
        let topic = Self::new(quantity.name, quantity.unit, quantity.meaning);
        Self { equation: quantity.equation, limit, ..topic }
    }

    /// What the quantity is, in words.
    pub fn what(&self) -> Phrase {
        Phrase::template(&self.what)
    }

    /// A sentence about what is easily misunderstood about the quantity.
    pub(super) fn trap(&self) -> Phrase {
        Phrase::template(self.trap)
    }

    pub(crate) fn unit_in_words(&self) -> &'static str {
        if self.unit.is_empty() { "none, it is a pure number" } else { self.unit }
    }
}

/// The text without the backquotes around names of classes, which users do not type.
fn without_backticks_of_classes(text: &str) -> String {
    let is_class = |piece: &str| piece.starts_with(|c: char| c.is_ascii_uppercase());
    let pieces = text.split('`').enumerate().map(|(index, piece)| match index % 2 == 1 && !is_class(piece) {
        true => format!("`{piece}`"),
        false => piece.to_owned(),
    });
    pieces.collect()
}

/// The equation that scales a property of a contact, and the meaning of the property.
const fn equation_and_meaning(property: Property) -> (&'static str, &'static str) {
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
            "bd of SmoothSphereHalfSpaceForce: how sharply the force begins with the indentation (C.4)",
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
    fn an_unknown_name_is_reported_with_similar_names() {
        let unknown = Topic::find("11, sunk-inn").unwrap_err();
        assert_eq!(
            unknown.message(&CommandLine),
            "nothing called 'sunk-inn' can be explained: did you mean 'sunk-in'? (`osim-contact-scale explain` lists all that can)"
        );
        assert_eq!(Topic::find("sunk").unwrap_err().similar_names, ["sunk-in"]);
        assert_eq!(
            Topic::find("smoothing").unwrap_err().similar_names,
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
        for (asked, name) in [
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
            assert_eq!(quantity(asked).map(|topic| topic.name), Some(name), "{asked}");
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
