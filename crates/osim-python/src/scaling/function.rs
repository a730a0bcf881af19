//! Equations as functions of numbers and of arrays of numbers, their arguments and results, and the macros that declare them.

use contact_scaling::equations::{self, Equation, Form};
use contact_scaling::modulus::MixingRule;

use crate::scaling::docstring::{ARRAY_TYPE, Argument, MIXING_RULES, Parameter, Returns, docstring};
use crate::scaling::equation_error::EquationError;

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
    /// The Rust function that computes the values of the Python function.
    pub call: RustFunction,
}

/// The Rust function that computes the values of a Python function.
#[derive(Debug, Clone, Copy)]
pub(crate) enum RustFunction {
    Numbers(fn(&[f64]) -> Result<f64, EquationError>),
    /// A function of numbers and one of two rules for the modulus of two surfaces: Python's keyword `rule`.
    WithRule(fn(MixingRule, &[f64]) -> Result<f64, EquationError>),
}

impl Function {
    /// The value of the equation for one argument for each parameter. `rule` counts only for functions that take a rule.
    ///
    /// # Errors
    /// An argument lies outside of the equation's domain, or is not finite; or the result is not finite.
    pub(crate) fn value(&self, rule: MixingRule, arguments: &[f64]) -> Result<f64, EquationError> {
        if arguments.len() != self.parameters.len() {
            return Err(EquationError::arguments(arguments.len()));
        }
        let named = self.parameters.iter().map(|parameter| parameter.name).zip(arguments.iter().copied());
        EquationError::unless_finite(named.clone())?;
        let value = match self.call {
            RustFunction::Numbers(call) => call(arguments),
            RustFunction::WithRule(call) => call(rule, arguments),
        };
        let value = value.map_err(|failure| failure.with_argument(named))?;
        if value.is_finite() { Ok(value) } else { Err(EquationError::result(value)) }
    }

    /// The values for rows of arguments: `columns` has a list for each parameter, either of one element or as long as the others.
    ///
    /// # Errors
    /// As [`Function::value`], with the row of the refused argument; or lists that differ in length.
    pub(crate) fn values(&self, rule: MixingRule, columns: &[&[f64]]) -> Result<Vec<f64>, EquationError> {
        let names = self.parameters.iter().map(|parameter| parameter.name);
        Columns::new(names, columns)?.each(|arguments| self.value(rule, arguments))
    }

    /// Whether the function takes the keyword `rule`.
    pub(crate) fn takes_rule(&self) -> bool {
        matches!(self.call, RustFunction::WithRule(_))
    }

    /// Every form of every equation that the function computes. One function may compute several: (8), (9) and (10).
    pub(crate) fn forms(&self) -> impl Iterator<Item = (&'static Equation, &'static Form)> {
        forms(self.computes)
    }

    /// Docstring of the function, without its examples.
    pub(crate) fn docstring(&self) -> String {
        let arguments = self.parameters.iter().map(|&parameter| Argument::new(parameter, ARRAY_TYPE));
        docstring(self.forms(), arguments.chain(self.takes_rule().then(Argument::rule)), self.returns)
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
    pub(super) fn new(
        names: impl Iterator<Item = &'static str>,
        lists: &'c [&'c [f64]],
    ) -> Result<Self, EquationError> {
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
    pub(super) fn each<T>(
        &self,
        call: impl Fn(&[f64]) -> Result<T, EquationError>,
    ) -> Result<Vec<T>, EquationError> {
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
/// contact-scaling", value`. With `[rule]` in front it also takes the rule by which two surfaces make one modulus.
macro_rules! function {
    ([$rule:ident] $name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes,
            $crate::scaling::RustFunction::WithRule(|$rule, values| function!(@value values, $arguments, $value)))
    };
    ($name:ident $arguments:tt -> $returns:expr, $computes:literal, $value:expr) => {
        function!(@of $name, $arguments, $returns, $computes,
            $crate::scaling::RustFunction::Numbers(|values| function!(@value values, $arguments, $value)))
    };
    (@of $name:ident, ($($argument:ident: $symbol:ident $(= $default:literal)?),+), $returns:expr, $computes:literal, $call:expr) => {
        $crate::scaling::Function {
            name: stringify!($name),
            computes: $computes,
            parameters: &[$($crate::scaling::function::parameter!($argument: $symbol $(= $default)?)),+],
            returns: $returns,
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
