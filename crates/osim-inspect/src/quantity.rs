//! What a number is, apart from its value; and registers of such.

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
    /// Name in JSON and in the series of a drop; it ends in the unit, where there is one. What a model has is named as OpenSim
    /// names it.
    pub name: &'static str,
    /// In tables, without unit and equation.
    pub label: &'static str,
    /// Its unit, for people; empty for a pure number.
    pub unit: &'static str,
    /// Number of the equation in the paper; empty where there is none.
    pub equation: &'static str,
    /// Its limit, where it has one.
    pub limit: Option<&'static Limit>,
    /// What it is, in a sentence.
    meaning: &'static str,
    /// Name of its column without the unit, if it is not [`name`](Self::name).
    column: &'static str,
}

impl Quantity {
    /// A quantity without equation and limit.
    pub const fn new(name: &'static str, label: &'static str, unit: &'static str) -> Self {
        Self { name, label, unit, equation: "", limit: None, meaning: "", column: "" }
    }

    /// A number of a model, named as OpenSim names it.
    pub const fn property(property: Property) -> Self {
        Self::new(property.name(), property.name(), property.unit())
    }

    /// The same, with another label.
    pub const fn labelled(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    /// The same, by an equation; an empty text means none.
    pub const fn by(self, equation: &'static str) -> Self {
        Self { equation, ..self }
    }

    /// The same, with a limit.
    pub const fn within(self, limit: &'static Limit) -> Self {
        Self { limit: Some(limit), ..self }
    }

    /// The same, with what it is, in a sentence.
    pub const fn meaning_that(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// The same, with the name of its column in the tables of models: in words, without the unit.
    pub const fn in_column(self, column: &'static str) -> Self {
        Self { column, ..self }
    }

    /// Name of its column in the tables of models. It ends in the unit as one says it, which no other name has: `load_N`,
    /// `contact_stiffness_N_per_m`.
    pub fn column(&self) -> String {
        let unit = match self.unit.split_once('/') {
            None => self.unit.to_owned(),
            Some(("1", per)) => format!("per_{per}"),
            Some((unit, per)) => format!("{unit}_per_{per}"),
        };
        let in_name = self.unit.replace('/', "_").to_ascii_lowercase();
        let stem = self.name.strip_suffix(in_name.as_str()).and_then(|stem| stem.strip_suffix('_'));
        let stem = if self.column.is_empty() { stem.unwrap_or(self.name) } else { self.column };
        if unit.is_empty() { stem.to_owned() } else { format!("{stem}_{unit}") }
    }

    /// The label with unit and equation, as the first column of a table has it.
    pub fn heading(&self) -> String {
        format!("{}{}{}", self.label, self.in_unit(), self.by_equation())
    }

    /// The label with the equation, for tables that have a column of units.
    pub fn heading_without_unit(&self) -> String {
        format!("{}{}", self.label, self.by_equation())
    }

    /// What it is, for schemas; equation and unit stand after the first part of the sentence.
    pub fn described(&self) -> String {
        let meaning = self.meaning.trim_ascii();
        let end = [": ", "; ", ". "].iter().filter_map(|mark| meaning.find(mark)).min();
        let (first, rest) = meaning.split_at(end.unwrap_or(meaning.trim_end_matches('.').len()));
        format!("{first}{}{}{rest}", self.by_equation(), self.in_unit())
    }

    /// What it is, in a sentence.
    pub fn meaning(&self) -> Phrase {
        Phrase::template(self.meaning_text())
    }

    /// The same, with inputs in backticks.
    pub fn meaning_text(&self) -> &'static str {
        self.meaning.trim_ascii()
    }

    fn in_unit(&self) -> String {
        if self.unit.is_empty() { String::new() } else { format!(", {}", self.unit) }
    }

    fn by_equation(&self) -> String {
        if self.equation.is_empty() { String::new() } else { format!(" ({})", self.equation) }
    }
}

/// What several registers have.
impl Quantity {
    /// Radius R.
    pub const RADIUS: Self = Self::new("radius_m", "radius", "m");
    /// Composite modulus E*.
    pub const COMPOSITE_MODULUS: Self =
        Self::new("composite_modulus_n_m2", "composite modulus", "N/m2").by("A.3");
    /// x̂ under body weight by the Hertz law.
    pub const INDENTATION_HERTZ: Self =
        Self::new("relative_indentation_hertz", "x/R, Hertz", "").by("11").within(&limits::INDENTATION);
    /// x̂ under body weight by the model's law.
    pub const INDENTATION_MODEL_LAW: Self =
        Self::new("relative_indentation_model_law", "x/R, the model's law", "")
            .by("C.9")
            .within(&limits::INDENTATION);
    /// Stiffness k of a sphere under its load, by the Hertz law.
    pub const CONTACT_STIFFNESS: Self =
        Self::new("contact_stiffness_n_m", "contact stiffness", "N/m").by("B.2");
    /// k̂ = k R n / F.
    pub const DIMENSIONLESS_STIFFNESS: Self =
        Self::new("dimensionless_stiffness", "dimensionless stiffness", "").by("B.3");
    /// Natural frequency f_n.
    pub const NATURAL_FREQUENCY: Self =
        Self::new("natural_frequency_hz", "natural frequency", "Hz").by("B.4");
    /// Mean contact stress σ.
    pub const MEAN_CONTACT_STRESS: Self =
        Self::new("mean_contact_stress_n_m2", "mean contact stress", "N/m2").by("15");
    /// Force of a smoothed sphere that just touches.
    pub const FORCE_JUST_TOUCHING: Self =
        Self::new("force_just_touching_n", "force just touching", "N").by("C.9");
    /// Speed before an impact.
    pub const IMPACT_SPEED: Self = Self::new("impact_speed_m_s", "impact speed", "m/s");
    /// Restitution of the law itself.
    pub const RESTITUTION_EXACT: Self = Self::new("restitution_exact", "restitution, exact", "");
    /// Restitution by (13).
    pub const RESTITUTION_APPROXIMATE: Self =
        Self::new("restitution_approximate", "restitution by (13)", "").within(&limits::RESTITUTION);
}

/// Makes a register of quantities: an enum of them with `ALL` and `info`, and, where each entry has more (after `=>`), a private
/// `entry`. The doc comment of an entry is its meaning.
///
/// ```
/// use osim_inspect::Quantity;
///
/// osim_inspect::quantities! {
///     /// Loads.
///     Load: f64 {
///         /// The weight of the body.
///         Weight = Quantity::new("weight_n", "weight", "N") => 1.0;
///         /// Twice that.
///         Double = Quantity::new("double_n", "double", "N") => 2.0;
///     }
/// }
/// assert_eq!(Load::ALL, [Load::Weight, Load::Double]);
/// assert_eq!((Load::Double.info().name, *Load::Double.entry()), ("double_n", 2.0));
/// assert_eq!(Load::Double.info().described(), "Twice that, N.");
/// ```
#[macro_export]
macro_rules! quantities {
    ($(#[doc = $about:literal])+ $register:ident {
        $($(#[doc = $doc:literal])+ $variant:ident = $quantity:expr;)+
    }) => {
        $(#[doc = $about])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $register {
            $($(#[doc = $doc])+ $variant,)+
        }

        impl $register {
            /// Every one, in the order in which it is shown.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Everything about it but its value.
            pub const fn info(self) -> &'static $crate::Quantity {
                match self {
                    $(Self::$variant => &const { $quantity.meaning_that(concat!($($doc),+)) },)+
                }
            }
        }
    };
    ($(#[doc = $about:literal])+ $register:ident: $entry:ty {
        $($(#[doc = $doc:literal])+ $variant:ident = $quantity:expr => $beside:expr;)+
    }) => {
        $crate::quantities! {
            $(#[doc = $about])+
            $register { $($(#[doc = $doc])+ $variant = $quantity;)+ }
        }

        impl $register {
            const fn entry(self) -> &'static $entry {
                match self {
                    $(Self::$variant => &const { $beside },)+
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
        assert_eq!(Quantity::new("load_n", "", "N").in_column("load_at_rest").column(), "load_at_rest_N");
    }
}
