//! The arguments and results of equations, and docstrings made of them and the register, in the layout of NumPy's docstrings.

use contact_scaling::equations::symbols::{P, Symbol};
use contact_scaling::equations::{Equation, Form, reference};
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
pub(crate) const MIXING_RULES: [(&str, MixingRule); 2] =
    [("sherman", MixingRule::Sherman), ("johnson", MixingRule::Johnson)];

/// The type of an argument that is an array or one number, in docstrings.
pub(super) const ARRAY_TYPE: &str = "float or array_like";

/// An argument in a docstring, with the types of its values.
pub(super) struct Argument {
    name: &'static str,
    kind: String,
    symbol: Symbol,
}

impl Argument {
    /// Describes the argument for the rule for the common modulus of two surfaces.
    pub(super) fn rule() -> Self {
        let names = MIXING_RULES.map(|(name, _)| format!("\"{name}\""));
        let [first, ..] = &names;
        Self { name: "rule", kind: format!("{{{}}}, default {first}", names.join(", ")), symbol: P }
    }

    /// Describes an argument with values of the type `kind`.
    pub(super) fn new(parameter: Parameter, kind: &str) -> Self {
        let default = parameter.default.map(|value| format!(", default {value}")).unwrap_or_default();
        Self { name: parameter.name, kind: format!("{kind}{default}"), symbol: parameter.symbol }
    }
}

/// The docstring of an equation: its formulas with their numbers, its arguments, its result, and its source.
pub(super) fn docstring(
    forms: impl Iterator<Item = (&'static Equation, &'static Form)>,
    arguments: impl Iterator<Item = Argument>,
    returns: Returns,
) -> String {
    let forms: Vec<_> = forms.collect();
    let arguments: Vec<_> = arguments.collect();
    let mut text = format!("{}\n\n", summary(&forms));
    for (equation, form) in &forms {
        text.push_str(&format!("    {}    {}\n", form.formula, reference(equation.label)));
    }
    text.push_str(&other_symbols(&forms, &arguments, returns));
    text.push_str("\nParameters\n----------\n");
    for Argument { name, kind, symbol } in &arguments {
        text.push_str(&format!("{name} : {kind}\n    {}.\n", meaning_with_unit(symbol, symbol.unit)));
    }
    let is_array = arguments.iter().any(|argument| argument.kind.starts_with(ARRAY_TYPE));
    let kind = if is_array { "float or numpy.ndarray" } else { "float" };
    text.push_str(&format!("\nReturns\n-------\n{kind}\n    {}.\n", computed_quantity(&forms, returns)));
    text.push_str("\nReferences\n----------\n");
    for (index, (equation, _)) in forms.iter().enumerate() {
        // One function may compute several forms of an equation.
        if forms.iter().position(|(other, _)| other == equation) == Some(index) {
            text.push_str(&format!("{}: {}.\n", reference(equation.label), equation.source));
        }
    }
    text
}

/// Symbols in the formulas that are neither arguments nor the computed quantity.
fn other_symbols(
    forms: &[(&'static Equation, &'static Form)],
    arguments: &[Argument],
    returns: Returns,
) -> String {
    let mut known: Vec<Symbol> = arguments.iter().map(|argument| argument.symbol).collect();
    known.push(returns.symbol());
    let mut text = String::new();
    for (equation, form) in forms {
        for symbol in equation.symbols.iter().filter(|symbol| is_symbol_in(symbol.symbol, form.formula)) {
            if !known.contains(symbol) {
                known.push(*symbol);
                text.push_str(&format!("    {}\n", meaning_with_unit(symbol, symbol.unit)));
            }
        }
    }
    if text.is_empty() { text } else { format!("\nwhere\n\n{text}") }
}

/// The name of the quantity that the function computes.
fn computed_quantity(forms: &[(&'static Equation, &'static Form)], returns: Returns) -> String {
    let unit = forms.first().map_or("", |(_, form)| form.unit);
    match returns {
        Returns::Value(symbol) => meaning_with_unit(&symbol, unit),
        Returns::Factor(symbol) => {
            format!("The factor, without unit, of {}: {}", symbol.symbol, symbol.meaning)
        }
    }
}

/// The statement of the equation in one line.
fn summary(forms: &[(&'static Equation, &'static Form)]) -> String {
    let Some((equation, form)) = forms.first() else { return String::new() };
    let title = equation.title;
    match form.variant {
        "" => format!("{title}."),
        "a to b" => format!("{title}, from a to b."),
        variant if variant.starts_with("for ") => format!("{title}, solved {variant}."),
        variant => format!("{title}, {variant}."),
    }
}

fn meaning_with_unit(symbol: &Symbol, unit: &str) -> String {
    let unit = if unit == "1" { "without unit".to_owned() } else { format!("in {unit}") };
    format!("{}: {}; {unit}", symbol.symbol, symbol.meaning)
}

/// Whether a formula has a symbol, and not only as the beginning of another symbol: x is not in x̂, nor E* in E*_i.
fn is_symbol_in(symbol: &str, formula: &str) -> bool {
    formula.match_indices(symbol).any(|(start, _)| {
        let before = formula.get(..start).and_then(|before| before.chars().next_back());
        let after = formula.get(start + symbol.len()..).and_then(|after| after.chars().next());
        let is_resumed = |c: char| c.is_alphanumeric() || "_*₁₂\u{302}".contains(c);
        !before.is_some_and(|c| c.is_alphabetic() || c == '_') && !after.is_some_and(is_resumed)
    })
}
