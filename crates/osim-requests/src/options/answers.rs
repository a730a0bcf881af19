//! Answers to questions that a run asks.

use osim_model::{FaultKind, NeedsAnswer, Question};
#[cfg(feature = "schemas")]
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use crate::values::serial;

/// Answers to questions.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema))]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "Output"))]
#[serde(default)]
pub struct AnswerOptions {
    /// Go on where a number looks like a slip: the code of the error that asks; may be repeated
    #[cfg_attr(feature = "clap", arg(long, value_name = "CODE", hide_short_help = true))]
    #[serde(deserialize_with = "serial::from_texts", serialize_with = "serial::as_texts")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<QuestionSchema>"))]
    pub yes: Vec<Question>,
}

impl AnswerOptions {
    /// These answers.
    #[must_use]
    pub fn new(yes: Vec<Question>) -> Self {
        Self { yes }
    }

    /// Whether this question is answered.
    #[must_use]
    pub fn has(&self, question: Question) -> bool {
        self.yes.contains(&question)
    }

    /// Asks, unless it is answered or there is nothing to ask.
    ///
    /// # Errors
    /// The question.
    pub fn ask(&self, asks: Option<NeedsAnswer>) -> Result<(), FaultKind> {
        match asks {
            Some(asks) if !self.has(asks.question()) => Err(asks.into()),
            _ => Ok(()),
        }
    }
}

/// The code of a question.
#[cfg(feature = "schemas")]
struct QuestionSchema;

#[cfg(feature = "schemas")]
impl JsonSchema for QuestionSchema {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Question".into()
    }

    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({"type": "string", "enum": Question::ALL.map(|question| question.code())})
    }

    fn inline_schema() -> bool {
        true
    }
}
