//! Describes a number apart from its value: name, label, unit, equation, meaning and limit. A macro makes registers of such quantities.

use contact_scaling::limits::{self, Limit};
use osim_model::Property;
use osim_model::messages::Phrase;

/// A quantity: its name, label, unit, equation, meaning and limit.
///
/// Everything that shows one takes this from its register (see [`quantities!`](crate::quantities)): tables, pages, CSV, JSON,
/// schemas and documents. What several registers have is a constant here, so that they agree in name, unit and equation.
///
/// ```
/// use osim_inspect::Quantity;
///
/// let stiffness = Quantity::CONTACT_STIFFNESS.labelled("stiffness k");
/// assert_eq!(stiffness.heading(), "stiffness k, N/m (B.2)");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Name in JSON and in the series of a drop test. It ends in the unit, if the quantity has a unit. A property of a model has the name
    /// that OpenSim uses.
    pub name: &'static str,
    /// Name in tables for people, without unit and equation.
    pub label: &'static str,
    /// The unit as people write it; empty for a pure number.
    pub unit: &'static str,
    /// Number that the paper gives the equation of the quantity; empty if the paper has no such equation.
    pub equation: &'static str,
    pub limit: Option<&'static Limit>,
    /// A sentence that says what the quantity is, with names of options in backquotes.
    pub meaning: &'static str,
    /// Name of the quantity's column in tables of models, without the unit; empty if it is [`name`](Self::name).
    column: &'static str,
}

impl Quantity {
    /// A quantity without equation, limit and meaning.
    pub const fn new(name: &'static str, label: &'static str, unit: &'static str) -> Self {
        Self { name, label, unit, equation: "", limit: None, meaning: "", column: "" }
    }

    /// A property of a contact, with OpenSim's name and unit.
    pub const fn property(property: Property) -> Self {
        Self::new(property.as_str(), property.as_str(), property.unit())
    }

    /// The quantity with another label.
    pub const fn labelled(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    /// The quantity with the number of its equation in the paper; an empty text means none.
    pub const fn by_equation(self, equation: &'static str) -> Self {
        Self { equation, ..self }
    }

    /// The quantity with a limit.
    pub const fn with_limit(self, limit: &'static Limit) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// The quantity with a name of its column in tables of models, in words and without the unit.
    pub(crate) const fn with_column(self, column: &'static str) -> Self {
        Self { column, ..self }
    }

    /// Name of the quantity's column in tables of models. It ends in the unit as people say it: `load_N`, `contact_stiffness_N_per_m`.
    pub fn column(&self) -> String {
        let unit = match self.unit.split_once('/') {
            None => self.unit.to_owned(),
            Some(("1", per)) => format!("per_{per}"),
            Some((unit, per)) => format!("{unit}_per_{per}"),
        };
        let unit_in_name = self.unit.replace('/', "_").to_ascii_lowercase();
        let stem = self.name.strip_suffix(unit_in_name.as_str()).and_then(|stem| stem.strip_suffix('_'));
        let stem = if self.column.is_empty() { stem.unwrap_or(self.name) } else { self.column };
        if unit.is_empty() { stem.to_owned() } else { format!("{stem}_{unit}") }
    }

    /// The label with unit and equation, as the first column of a table has it.
    pub fn heading(&self) -> String {
        format!("{}{}{}", self.label, self.unit_suffix(), self.equation_suffix())
    }

    /// The label with the equation, for tables that show units in a column of their own.
    pub fn heading_without_unit(&self) -> String {
        format!("{}{}", self.label, self.equation_suffix())
    }

    /// The meaning, with equation and unit after the first part of the sentence: the description in JSON schemas.
    pub fn schema_description(&self) -> String {
        let meaning = self.meaning;
        let end = [": ", "; ", ". "].iter().filter_map(|mark| meaning.find(mark)).min();
        let (first, rest) = meaning.split_at(end.unwrap_or(meaning.trim_end_matches('.').len()));
        format!("{first}{}{}{rest}", self.equation_suffix(), self.unit_suffix())
    }

    /// A sentence that says what the quantity is.
    pub fn meaning(&self) -> Phrase {
        Phrase::template(self.meaning)
    }

    /// The unit after a comma, for a label; empty without a unit.
    fn unit_suffix(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!(", {}", self.unit) }
    }

    /// The number of the equation in brackets, for a label; empty without an equation.
    fn equation_suffix(&self) -> String {
        if self.equation.is_empty() { String::new() } else { format!(" ({})", self.equation) }
    }

    // Quantities that several registers list.

    /// Radius of a sphere.
    pub const RADIUS: Self = Self::new("radius_m", "radius", "m");
    /// E* of sphere and plane together (A.3).
    pub const COMPOSITE_MODULUS: Self =
        Self::new("composite_modulus_n_m2", "composite modulus", "N/m2").by_equation("A.3");
    /// x̂ under body weight by the Hertz law.
    pub const INDENTATION_HERTZ: Self = Self::new("relative_indentation_hertz", "x/R, Hertz", "")
        .by_equation("11")
        .with_limit(&limits::INDENTATION);
    /// x̂ under body weight by the model's law.
    pub const INDENTATION_MODEL_LAW: Self =
        Self::new("relative_indentation_model_law", "x/R, the model's law", "")
            .by_equation("C.9")
            .with_limit(&limits::INDENTATION);
    /// Stiffness k of a sphere under its load, by the Hertz law.
    pub const CONTACT_STIFFNESS: Self =
        Self::new("contact_stiffness_n_m", "contact stiffness", "N/m").by_equation("B.2");
    /// k̂ = k R n / F.
    pub const DIMENSIONLESS_STIFFNESS: Self =
        Self::new("dimensionless_stiffness", "dimensionless stiffness", "").by_equation("B.3");
    /// Natural frequency of small oscillations (B.4).
    pub const NATURAL_FREQUENCY: Self =
        Self::new("natural_frequency_hz", "natural frequency", "Hz").by_equation("B.4");
    /// Mean stress on the contact patch (15).
    pub const MEAN_CONTACT_STRESS: Self =
        Self::new("mean_contact_stress_n_m2", "mean contact stress", "N/m2").by_equation("15");
    /// Force of a smoothed sphere that just touches.
    pub const FORCE_JUST_TOUCHING: Self =
        Self::new("force_just_touching_n", "force just touching", "N").by_equation("C.9");
    /// Speed just before an impact.
    pub const IMPACT_SPEED: Self = Self::new("impact_speed_m_s", "impact speed", "m/s");
    /// Restitution of the contact law, without approximation.
    pub const RESTITUTION_EXACT: Self = Self::new("restitution_exact", "restitution, exact", "");
    /// Restitution by the approximate equation (13).
    pub const RESTITUTION_APPROXIMATE: Self =
        Self::new("restitution_approximate", "restitution by (13)", "").with_limit(&limits::RESTITUTION);
}

/// Makes a register of quantities: an enum with `ALL` and `info`; if each variant has further data after `=>`, also a private method
/// `entry` that returns them. Each row is `Variant = "its meaning", its quantity => further data;`. The meaning is also the doc comment of
/// the variant.
///
/// ```
/// use osim_inspect::Quantity;
///
/// osim_inspect::quantities! {
///     /// Loads.
///     Load: f64 {
///         Weight = "The weight of the body.", Quantity::new("weight_n", "weight", "N") => 1.0;
///         Double = "Twice that.", Quantity::new("double_n", "double", "N") => 2.0;
///     }
/// }
/// assert_eq!(Load::ALL, [Load::Weight, Load::Double]);
/// assert_eq!((Load::Double.info().name, *Load::Double.entry()), ("double_n", 2.0));
/// assert_eq!(Load::Double.info().schema_description(), "Twice that, N.");
/// ```
#[macro_export]
macro_rules! quantities {
    ($(#[doc = $about:literal])+ $register:ident {
        $($variant:ident = $meaning:literal, $quantity:expr;)+
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $register {
            $(#[doc = $meaning] $variant,)+
        }

        impl $register {
            /// All variants, in the order in which they are shown.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Name, label, unit, equation, meaning and limit.
            pub const fn info(self) -> &'static $crate::Quantity {
                match self {
                    $(Self::$variant => &const {
                        let mut quantity = $quantity;
                        quantity.meaning = $meaning;
                        quantity
                    },)+
                }
            }
        }
    };
    ($(#[doc = $about:literal])+ $register:ident: $entry:ty {
        $($variant:ident = $meaning:literal, $quantity:expr => $data:expr;)+
    }) => {
        $crate::quantities! {
            $(#[doc = $about])+
            $register { $($variant = $meaning, $quantity;)+ }
        }

        impl $register {
            const fn entry(self) -> &'static $entry {
                match self {
                    $(Self::$variant => &const { $data },)+
                }
            }
        }
    };
}

#[cfg(test)]
mod tests {
    use super::Quantity;

    #[test]
    fn columns_end_in_their_unit() {
        for (name, unit, column) in [
            ("mass_kg", "kg", "mass_kg"),
            ("load_n", "N", "load_N"),
            ("contact_stiffness_n_m", "N/m", "contact_stiffness_N_per_m"),
            ("hertz_smoothing", "1/m", "hertz_smoothing_per_m"),
            ("constant_contact_force", "m2", "constant_contact_force_m2"),
            ("touching_share", "", "touching_share"),
        ] {
            assert_eq!(Quantity::new(name, "", unit).column(), column);
        }
        assert_eq!(Quantity::new("load_n", "", "N").with_column("load_at_rest").column(), "load_at_rest_N");
    }
}
