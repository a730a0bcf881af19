//! An argument of an equation.

use contact_scaling::equations::symbols::Symbol;

/// An argument of an equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Parameter {
    /// As Python calls it.
    pub name: &'static str,
    /// As the formula has it, with its meaning and unit.
    pub symbol: Symbol,
    /// What it is where it is left out.
    pub default: Option<f64>,
}

/// What an equation gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Returns {
    /// A value of this kind.
    Value(Symbol),
    /// What a value of this kind is multiplied by, from one animal to another.
    Factor(Symbol),
}

impl Returns {
    /// The symbol of the value.
    pub(crate) fn symbol(&self) -> Symbol {
        match self {
            Self::Value(symbol) | Self::Factor(symbol) => *symbol,
        }
    }
}
