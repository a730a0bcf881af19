//! Everything that has a number: OpenSim's properties, and the figures of every register.

use std::sync::LazyLock;

use osim_inspect::{Figure, Quantity};
use osim_model::Property;
use osim_model::messages::Phrase;
use osim_planning::{DesignQuantity, DropColumn, DropFigure};

use super::traps;

/// A quantity, as it is explained.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
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

static ALL: LazyLock<Vec<QuantityTopic>> = LazyLock::new(|| {
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
    ALL.iter()
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
    #[must_use]
    pub fn what(&self) -> Phrase {
        Phrase::template(&self.what)
    }

    /// What is easily misunderstood about it.
    #[must_use]
    pub fn trap(&self) -> Phrase {
        Phrase::template(self.trap)
    }

    /// The unit, in words.
    #[must_use]
    pub fn unit_in_words(&self) -> &'static str {
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
    use super::*;

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
