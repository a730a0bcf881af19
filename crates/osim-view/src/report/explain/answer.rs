//! What a request to explain gives.

use osim_requests::ExplainRequest;
use osim_requests::options::Format;

use super::letters::Letters;
use super::record::TopicRecord;
use super::text::{list, text};
use super::topic::{Topic, UnknownTopic};
use crate::report::json::line;
use osim_requests::spell::FrontEnd;

/// Explains what is named; where nothing is, lists everything.
///
/// # Errors
/// Something that is neither an equation, a quantity nor a code.
pub fn answer(
    request: &ExplainRequest,
    letters: Letters,
    front_end: &dyn FrontEnd,
) -> Result<String, UnknownTopic> {
    let named = request.topics.join(" ");
    let topics = if named.is_empty() { Topic::all() } else { Topic::find(&named)? };
    let letters = if request.ascii { Letters::Ascii } else { letters };
    Ok(match request.format {
        Format::Json => topics.into_iter().map(|topic| line(&TopicRecord::new(topic, front_end))).collect(),
        _ if named.is_empty() => list(&topics, front_end, letters),
        _ => {
            let each: Vec<String> = topics.into_iter().map(|topic| text(topic, front_end, letters)).collect();
            each.join("\n")
        }
    })
}
