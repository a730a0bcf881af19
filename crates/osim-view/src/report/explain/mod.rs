//! Explanations of equations, quantities, findings and errors: the answer to an `explain` request. For scripts, a JSON object for each
//! topic, one on a line; texts for people are in `text.rs`.

mod equations;
mod errors;
mod text;
mod topic;
mod traps;

use contact_scaling::equations::{Form, Symbol};
use osim_inspect::SCHEMA_VERSION;
use osim_model::Repair;
use osim_model::messages::{Dialect, Phrase};
use osim_requests::ExplainRequest;
use osim_requests::options::Format;
use osim_requests::spell::FrontEnd;
use serde::Serialize;

use crate::report::explain::equations::sentence_of_use;
use crate::report::explain::text::ascii;
use crate::report::json::line;

pub use equations::{equation, equations};
pub use errors::{ErrorCode, ErrorGroup, error, errors};
pub use text::{Alphabet, list, text};
pub use topic::{QuantityTopic, Topic, UnknownTopic};

/// One topic. `docs/reference/json.md` describes every field.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "lowercase")]
#[cfg_attr(feature = "schemas", schemars(deny_unknown_fields))]
pub enum TopicRecord {
    /// An equation, or a rule of this project.
    Equation {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32,
        /// The paper's number without brackets, or a name.
        label: &'static str,
        /// What the equation says, in a few words.
        title: &'static str,
        /// The equation as printed first, then in other forms.
        formulas: Vec<FormulaRecord>,
        /// Every symbol of the formulas.
        symbols: Vec<SymbolRecord>,
        /// Source of the equation.
        source: String,
        /// Which part of the project uses the equation.
        used: String,
    },
    /// A property of a contact, or a figure.
    Quantity {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32,
        /// OpenSim's name of a property, or the name of the field in JSON and CSV.
        name: &'static str,
        /// Symbols and other words for the quantity.
        symbols: &'static [&'static str],
        /// Unit of the quantity; empty for a pure number.
        unit: &'static str,
        /// Number that the paper gives the equation of the quantity; empty where the paper has none.
        equation: &'static str,
        /// Limit of the quantity in words; null where it has none.
        limit: Option<String>,
        /// What the quantity is, in a sentence.
        what: String,
        /// What is easily misunderstood about the quantity.
        trap: String,
    },
    /// A finding, of a model or of a change.
    Finding {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32,
        /// Stable short name of the finding.
        code: &'static str,
        /// Severity of the finding.
        severity: &'static str,
        /// Whether a check looks for this fault; else only changes report it.
        checked: bool,
        /// What the finding is, in a sentence.
        what: String,
        /// Why the finding matters.
        why: String,
        /// What to do about the finding.
        advice: String,
        /// What the command does that `check` proposes; null where it cannot propose one.
        fix: Option<String>,
        /// Why no request repairs the fault.
        why_no_fix: Option<String>,
    },
    /// An error that the command can end with.
    Error {
        /// Version of this JSON, which rises when a field changes its meaning or goes away.
        schema_version: u32,
        /// Stable short name of the error.
        code: &'static str,
        /// What the error means.
        means: String,
        /// What to do about the error.
        way_out: String,
    },
}

osim_inspect::json_records! {
    /// One way to write an equation.
    FormulaRecord from form: &Form {
        /// What sets the form apart, such as `for x`; empty for the first form.
        variant: &'static str = form.variant,
        /// The formula in Unicode.
        formula: &'static str = form.formula,
        /// The formula in ASCII.
        ascii: String = ascii(form.formula),
        /// Unit of the result; `1` for a pure number, empty where nothing is computed.
        unit: &'static str = form.unit,
    }

    /// One symbol of a formula.
    SymbolRecord from (symbol, dialect): (&Symbol, &dyn Dialect) {
        /// The symbol in Unicode.
        symbol: &'static str = symbol.symbol,
        /// The symbol in ASCII.
        ascii: String = ascii(symbol.symbol),
        /// Meaning of the symbol.
        meaning: String = Phrase::template(symbol.meaning).spelled(dialect),
        /// Unit of the formula's value; `1` for a pure number.
        unit: &'static str = symbol.unit,
    }
}

impl TopicRecord {
    /// The explanation of a topic in the words of `dialect`.
    pub fn new(topic: Topic, dialect: &dyn Dialect) -> Self {
        match topic {
            Topic::Equation(equation) => Self::Equation {
                schema_version: SCHEMA_VERSION,
                label: equation.label,
                title: equation.title,
                formulas: equation.forms.iter().map(Into::into).collect(),
                symbols: equation.symbols.iter().map(|symbol| (symbol, dialect).into()).collect(),
                source: Phrase::template(equation.source).spelled(dialect),
                used: sentence_of_use(equation.label).spelled(dialect),
            },
            Topic::Quantity(quantity) => Self::Quantity {
                schema_version: SCHEMA_VERSION,
                name: quantity.name,
                symbols: quantity.symbols,
                unit: quantity.unit,
                equation: quantity.equation,
                limit: quantity.limit.clone(),
                what: quantity.what().spelled(dialect),
                trap: quantity.trap().spelled(dialect),
            },
            Topic::Finding(rule) => {
                let (fix, why_no_fix) = match rule.repair {
                    Repair::Command(what) => (Some(what.to_owned()), None),
                    Repair::NotPossible(why) | Repair::OnlyInChange(why) => (None, Some(why.to_owned())),
                };
                Self::Finding {
                    schema_version: SCHEMA_VERSION,
                    code: rule.code.as_str(),
                    severity: rule.severity.as_str(),
                    checked: !matches!(rule.repair, Repair::OnlyInChange(_)),
                    what: rule.what().spelled(dialect),
                    why: rule.why().spelled(dialect),
                    advice: rule.advice().spelled(dialect),
                    fix,
                    why_no_fix,
                }
            }
            Topic::Error(error) => Self::Error {
                schema_version: SCHEMA_VERSION,
                code: error.code,
                means: error.means().spelled(dialect),
                way_out: error.way_out().spelled(dialect),
            },
        }
    }
}

/// The explanations of the topics that a request names; if it names none, the list of all topics. Lines have at most
/// `width` columns.
///
/// # Errors
/// Something that is neither an equation, a quantity nor a code.
pub fn answer(
    request: &ExplainRequest,
    letters: Alphabet,
    front_end: &dyn FrontEnd,
    width: usize,
) -> Result<String, UnknownTopic> {
    let named = request.topics.join(" ");
    let topics = if named.is_empty() { Topic::all() } else { Topic::find(&named)? };
    let letters = if request.ascii { Alphabet::Ascii } else { letters };
    Ok(match request.format {
        Format::Json => topics.into_iter().map(|topic| line(&TopicRecord::new(topic, front_end))).collect(),
        _ if named.is_empty() => list(&topics, front_end, letters, width),
        _ => {
            let each: Vec<String> =
                topics.into_iter().map(|topic| text(topic, front_end, letters, width)).collect();
            each.join("\n")
        }
    })
}
