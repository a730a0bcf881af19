//! Arguments and results of equations, and the rules for the common modulus of two surfaces.

use contact_scaling::equations::symbols::Symbol;
use contact_scaling::modulus::MixingRule;

/// An argument of an equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parameter {
    /// Name of the argument in Python.
    pub name: &'static str,
    /// Symbol of the argument in the formula, with its meaning and unit.
    pub symbol: Symbol,
    /// Value of the argument if the call leaves it out.
    pub default: Option<f64>,
}

/// The kind of result that an equation has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Returns {
    /// A value of the quantity that the symbol means.
    Value(Symbol),
    /// A factor of this symbol from one animal to another.
    Factor(Symbol),
}

impl Returns {
    pub(crate) fn symbol(&self) -> Symbol {
        match self {
            Self::Value(symbol) | Self::Factor(symbol) => *symbol,
        }
    }
}

/// The rules for the common modulus of two surfaces, by their names in Python. The first is OpenSim's rule, and the default.
pub(crate) const RULES: [(&str, MixingRule); 2] =
    [("sherman", MixingRule::Sherman), ("johnson", MixingRule::Johnson)];

pub(crate) fn rule_by_name(name: &str) -> Option<MixingRule> {
    RULES.iter().find(|(rule_name, _)| *rule_name == name).map(|(_, rule)| *rule)
}

/// A [`Parameter`](super::Parameter): `name: SYMBOL`, or `name: SYMBOL = 1.0`.
macro_rules! parameter {
    ($name:ident: $symbol:ident $(= $default:literal)?) => {
        $crate::scaling::Parameter {
            name: stringify!($name),
            symbol: contact_scaling::equations::symbols::$symbol,
            default: $crate::scaling::parameter::parameter!(@default $($default)?),
        }
    };
    (@default) => { None };
    (@default $default:literal) => { Some($default) };
}

pub(super) use parameter;
