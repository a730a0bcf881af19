//! Explanations for scripts: one object per topic and line.

use serde::Serialize;

use super::ascii::ascii;
use super::{Topic, uses};
use crate::report::json;
use osim_patch::Seen;

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum Explained {
    Equation {
        schema_version: u32,
        label: &'static str,
        title: &'static str,
        formulas: Vec<Formula>,
        symbols: Vec<Symbol>,
        source: &'static str,
        used: &'static str,
    },
    Warning {
        schema_version: u32,
        code: &'static str,
        severity: &'static str,
        /// Whether `check` looks for it; else it is said of changes alone.
        checked: bool,
        what: &'static str,
        why: &'static str,
        remedy: &'static str,
    },
    Error {
        schema_version: u32,
        code: &'static str,
        means: &'static str,
        way_out: &'static str,
    },
}

#[derive(Serialize)]
struct Formula {
    note: &'static str,
    formula: &'static str,
    ascii: String,
    unit: &'static str,
}

#[derive(Serialize)]
struct Symbol {
    symbol: &'static str,
    ascii: String,
    meaning: &'static str,
    unit: &'static str,
}

/// One topic as one line.
pub(super) fn of(topic: Topic) -> String {
    let schema_version = 1;
    json::line(&match topic {
        Topic::Equation(equation) => Explained::Equation {
            schema_version,
            label: equation.label,
            title: equation.title,
            formulas: equation.forms.iter().map(formula).collect(),
            symbols: equation.symbols.iter().map(symbol).collect(),
            source: equation.source,
            used: uses::of(equation.label),
        },
        Topic::Warning(code) => Explained::Warning {
            schema_version,
            code: code.as_str(),
            severity: code.severity().as_str(),
            checked: code.seen() == Seen::Model,
            what: code.what().trim(),
            why: code.why(),
            remedy: code.remedy(),
        },
        Topic::Error(error) => {
            Explained::Error { schema_version, code: error.code, means: error.means, way_out: error.way_out }
        }
    })
}

fn formula(form: &contact_scaling::equations::Form) -> Formula {
    Formula { note: form.note, formula: form.formula, ascii: ascii(form.formula), unit: form.unit }
}

fn symbol(symbol: &contact_scaling::equations::Symbol) -> Symbol {
    Symbol { symbol: symbol.symbol, ascii: ascii(symbol.symbol), meaning: symbol.meaning, unit: symbol.unit }
}
