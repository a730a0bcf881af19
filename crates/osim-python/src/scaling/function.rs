//! Equations as functions of numbers and of arrays of numbers, their arguments and results, and the macros that declare them.
//! Also the error of an equation without a value: the refused argument, the element of the argument, and the expected values; and
//! docstrings made of arguments, results and the register, in the layout of NumPy's docstrings.

use std::fmt;

use contact_scaling::DomainError;
use contact_scaling::equations::symbols::{P, Symbol};
use contact_scaling::equations::{self, Equation, Form, reference};
use contact_scaling::modulus::MixingRule;

pub(crate) fn rule_by_name(name: &str) -> Option<MixingRule> {
    MIXING_RULES.iter().find(|(rule_name, _)| *rule_name == name).map(|(_, rule)| *rule)
}

/// An equation with plain numbers in and one number out, all in SI units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Function {
    pub name: &'static str,
    /// The function of `contact-scaling` that computes the equation, as the register names it: `Hertz::force`.
    pub computes: &'static str,
    /// Arguments of the function in order; arguments with a default are last.
    pub parameters: &'static [Parameter],
    /// The kind of value that the function returns.
    pub returns: Returns,
    /// Whether the function takes one of two rules for the modulus of two surfaces: Python's keyword `rule`.
    pub takes_rule: bool,
    /// The Rust function that computes the values of the Python function.
    pub call: fn(MixingRule, &[f64]) -> Result<f64>,
}

impl Function {
    /// The value of the equation for one argument for each parameter. `rule` counts only for functions that take a rule.
    ///
    /// # Errors
    /// An argument lies outside of the equation's domain, or is not finite; or the result is not finite.
    pub(crate) fn value(&self, rule: MixingRule, arguments: &[f64]) -> Result<f64> {
        if arguments.len() != self.parameters.len() {
            return Err(EquationError::arguments(arguments.len()));
        }
        let named = self.parameters.iter().map(|parameter| parameter.name).zip(arguments.iter().copied());
        EquationError::unless_finite(named.clone())?;
        let value = (self.call)(rule, arguments).map_err(|failure| failure.with_argument(named))?;
        if value.is_finite() { Ok(value) } else { Err(EquationError::result(value)) }
    }

    /// The values for rows of arguments: `columns` has a list for each parameter, either of one element or as long as the others.
    ///
    /// # Errors
    /// As [`Function::value`], with the row of the refused argument; or lists that differ in length.
    pub(crate) fn values(&self, rule: MixingRule, columns: &[&[f64]]) -> Result<Vec<f64>> {
        let names = self.parameters.iter().map(|parameter| parameter.name);
        Columns::new(names, columns)?.each(|arguments| self.value(rule, arguments))
    }

    /// Every form of every equation that the function computes. One function may compute several: (8), (9) and (10).
    pub(crate) fn forms(&self) -> impl Iterator<Item = (&'static Equation, &'static Form)> {
        forms(self.computes)
    }

    /// Docstring of the function, without its examples.
    pub(crate) fn docstring(&self) -> String {
        let arguments = self.parameters.iter().map(|&parameter| Argument::new(parameter, ARRAY_TYPE));
        docstring(self.forms(), arguments.chain(self.takes_rule.then(Argument::rule)), self.returns)
    }
}

/// Every form in the register that this function of `contact-scaling` computes.
pub(super) fn forms(computes: &str) -> impl Iterator<Item = (&'static Equation, &'static Form)> {
    equations::all().flat_map(move |equation| {
        equation.forms.iter().filter(move |form| form.function == computes).map(move |form| (equation, form))
    })
}

// Lists of arguments as rows: each list has one element, or as many as the others.

/// Lists of arguments, one for each parameter.
pub(super) struct Columns<'c> {
    names: Vec<&'static str>,
    lists: &'c [&'c [f64]],
    rows: usize,
}

impl<'c> Columns<'c> {
    /// Lists for the parameters of these names, in the same order.
    ///
    /// # Errors
    /// Lists that differ in length, or too many or too few lists.
    pub(super) fn new(names: impl Iterator<Item = &'static str>, lists: &'c [&'c [f64]]) -> Result<Self> {
        let names: Vec<_> = names.collect();
        if lists.len() != names.len() {
            return Err(EquationError::arguments(lists.len()));
        }
        let rows = lists.iter().map(|list| list.len()).find(|&length| length != 1).unwrap_or(1);
        let other = names.iter().zip(lists).find(|(_, list)| ![1, rows].contains(&list.len()));
        match other {
            Some((name, list)) => Err(EquationError::length(name, list.len())),
            None => Ok(Self { names, lists, rows }),
        }
    }

    /// The results of `call` for each row.
    ///
    /// # Errors
    /// The first error of `call`, with the refused element.
    pub(super) fn each<T>(&self, call: impl Fn(&[f64]) -> Result<T>) -> Result<Vec<T>> {
        let mut arguments = vec![0.0; self.lists.len()];
        let mut one = |row: usize| {
            for (argument, list) in arguments.iter_mut().zip(self.lists) {
                *argument = list.get(row).or(list.first()).copied().unwrap_or(f64::NAN);
            }
            call(&arguments)
                .map_err(|failure| if self.is_listed(&failure) { failure.at(row) } else { failure })
        };
        (0..self.rows).map(&mut one).collect()
    }

    /// Whether the refused value is an element of a list, and not a number that is the same in all rows.
    fn is_listed(&self, failure: &EquationError) -> bool {
        let mut named = self.names.iter().zip(self.lists);
        named.any(|(&name, list)| list.len() > 1 && failure.parameter.is_none_or(|about| about == name))
    }
}

// How a function is declared: its name and arguments once, each argument with its symbol in the register.

/// A [`Parameter`](super::Parameter): `name: SYMBOL`, or `name: SYMBOL = 1.0`.
macro_rules! parameter {
    ($name:ident: $symbol:ident $(= $default:literal)?) => {
        $crate::scaling::Parameter {
            name: stringify!($name),
            symbol: contact_scaling::equations::symbols::$symbol,
            default: $crate::scaling::function::parameter!(@default $($default)?),
        }
    };
    (@default) => { None };
    (@default $default:literal) => { Some($default) };
}

/// A [`Function`](super::Function): `name(argument: SYMBOL, another: SYMBOL = 1.0) -> what it gives, "the function of
/// contact-scaling", value`; `module::function` alone is called with the arguments as they are. With `[rule]` in front it also takes
/// the rule by which two surfaces make one modulus.
macro_rules! function {
    ([$rule:ident] $name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes, true,
            |$rule, values| function!(@value values, $arguments, $value))
    };
    ($name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes, false,
            |_, values| function!(@value values, $arguments, $value))
    };
    ($name:ident($($argument:ident: $symbol:ident $(= $default:literal)?),+) -> $returns:expr, $module:ident::$of:ident) => {
        function!(@of $name, ($($argument: $symbol $(= $default)?),+), $returns,
            concat!(stringify!($module), "::", stringify!($of)), false,
            |_, values| function!(@value values, ($($argument: $symbol),+), $module::$of($($argument),+)?))
    };
    (@of $name:ident, ($($argument:ident: $symbol:ident $(= $default:literal)?),+), $returns:expr, $computes:expr,
        $takes_rule:literal, $call:expr) => {
        $crate::scaling::Function {
            name: stringify!($name),
            computes: $computes,
            parameters: &[$($crate::scaling::function::parameter!($argument: $symbol $(= $default)?)),+],
            returns: $returns,
            takes_rule: $takes_rule,
            call: $call,
        }
    };
    (@value $values:ident, ($($argument:ident: $symbol:ident $(= $default:literal)?),+), $value:expr) => {{
        let &[$($argument),+] = $values else {
            return Err($crate::scaling::EquationError::arguments($values.len()));
        };
        Ok($value)
    }};
}

pub(super) use {function, parameter};

/// The name of the quantity in an error about a list that is too long or too short.
const NUMBER_OF_ELEMENTS: &str = "the number of elements";

/// An argument: its name and its value.
type NamedValue = (&'static str, f64);

/// The value of an equation, or the reason why it has none.
pub(super) type Result<T, E = EquationError> = std::result::Result<T, E>;

/// The reason why an equation has no value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EquationError {
    /// The refused argument; `None` if several arguments together were refused.
    pub parameter: Option<&'static str>,
    /// Name of the refused quantity.
    pub quantity: &'static str,
    /// The refused value, in SI units.
    pub value: f64,
    /// Description of the allowed values.
    pub expected: &'static str,
    /// Index from 0 of the refused element in a list or flattened array; `None` if the argument is one number.
    pub index: Option<usize>,
}

impl EquationError {
    /// An error about the value of a quantity, not about an element of a list.
    fn new(
        parameter: Option<&'static str>,
        quantity: &'static str,
        value: f64,
        expected: &'static str,
    ) -> Self {
        Self { parameter, quantity, value, expected, index: None }
    }

    /// Refuses arguments that are not finite.
    ///
    /// # Errors
    /// The first argument without a finite value: a gap in an array, or the result of a division by 0.
    pub(super) fn unless_finite(mut arguments: impl Iterator<Item = NamedValue>) -> Result<(), Self> {
        let Some((name, value)) = arguments.find(|(_, value)| !value.is_finite()) else { return Ok(()) };
        Err(Self::new(Some(name), name, value, "a finite number"))
    }

    /// The error that the result is too large for a float, although every argument is allowed.
    pub(super) fn result(value: f64) -> Self {
        let expected = "a finite number: an argument is far too large or too small";
        Self::new(None, "the result", value, expected)
    }

    /// The error that an equation got `found` arguments, and takes another number of arguments.
    pub(super) fn arguments(found: usize) -> Self {
        let expected = "a number for each argument of the equation";
        Self::new(None, "the number of arguments", count(found), expected)
    }

    /// The error that a body has no spheres to rest on.
    pub(super) fn no_sphere() -> Self {
        Self::new(None, "the number of spheres", 0.0, "1 or more")
    }

    /// The error that heights of spheres are not measured from the lowest sphere.
    pub(super) fn lowest(parameter: &'static str, value: f64) -> Self {
        let expected = "0 for the lowest sphere: heights are above that one";
        Self::new(Some(parameter), "height of the lowest sphere", value, expected)
    }

    /// The error that a list has neither one element nor as many elements as the other lists.
    pub(super) fn length(parameter: &'static str, found: usize) -> Self {
        let expected = "one, or as many as the other arguments have";
        Self::new(Some(parameter), NUMBER_OF_ELEMENTS, count(found), expected)
    }

    /// Finds the refused argument: its value is the refused value, and its name is the refused quantity or ends with the same word.
    pub(super) fn with_argument<'a>(self, arguments: impl Iterator<Item = NamedValue> + Clone + 'a) -> Self {
        if self.parameter.is_some() {
            return self;
        }
        let quantity = self.quantity.replace('\'', "");
        let last = quantity.rsplit(' ').next().unwrap_or_default();
        let mut alike = arguments.filter(|(_, value)| *value == self.value);
        let same = alike.clone().find(|(name, _)| name.replace('_', " ") == quantity);
        let found = same.or_else(|| alike.find(|(name, _)| name.rsplit('_').next() == Some(last)));
        Self { parameter: found.map(|(name, _)| name), ..self }
    }

    /// The error about the element of this index.
    pub(super) fn at(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }

    /// The message in one sentence; `place` has the indices of the refused element, such as `[2, 0]`, or is empty.
    pub(crate) fn message(&self, place: &str) -> String {
        let Self { parameter, quantity, value, expected, .. } = *self;
        match parameter {
            Some(name) if quantity == NUMBER_OF_ELEMENTS => {
                format!("{name}: {quantity} is {value}, expected {expected}")
            }
            Some(name) => format!("{name}{place} is {value:?}, expected {expected}"),
            None if place.is_empty() => format!("{quantity} is {value:?}, expected {expected}"),
            None => format!("{quantity} at {place} is {value:?}, expected {expected}"),
        }
    }
}

impl From<DomainError> for EquationError {
    fn from(error: DomainError) -> Self {
        Self::new(None, error.quantity(), error.value(), error.expected())
    }
}

impl fmt::Display for EquationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message(&self.index.map(|index| format!("[{index}]")).unwrap_or_default()))
    }
}

/// A number of things as a float, because the values in errors are floats.
fn count(things: usize) -> f64 {
    u32::try_from(things).map_or(f64::INFINITY, f64::from)
}

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
