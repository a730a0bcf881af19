//! One line of JSON.

use std::io::{self, Write};

use osim_model::messages::is_seen;
use serde::Serialize;
use serde_json::ser::{CharEscape, CompactFormatter, Formatter, Serializer};

/// A value as one JSON object and a line end. Numbers that are not finite become null.
///
/// Letters that are not seen as they are, from names in models, are escaped as JSON has it: a terminal shows the line as it is,
/// and a program reads back the same text.
pub fn line(value: &impl Serialize) -> String {
    let mut bytes = Vec::new();
    // Serialising owned strings, numbers and lists cannot fail; an empty line would be seen at once if it did.
    let done = value.serialize(&mut Serializer::with_formatter(&mut bytes, Seen));
    let mut text = done.ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default();
    text.push('\n');
    text
}

/// Writes compact JSON in which every letter is seen.
struct Seen;

impl Formatter for Seen {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        if fragment.bytes().all(|byte| matches!(byte, b' '..=b'~')) {
            return writer.write_all(fragment.as_bytes());
        }
        fragment.chars().try_for_each(|letter| match is_seen(letter) {
            true => write!(writer, "{letter}"),
            false => {
                letter.encode_utf16(&mut [0; 2]).iter().try_for_each(|unit| write!(writer, "\\u{unit:04x}"))
            }
        })
    }

    fn write_char_escape<W: ?Sized + Write>(&mut self, writer: &mut W, escape: CharEscape) -> io::Result<()> {
        CompactFormatter.write_char_escape(writer, escape)
    }
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn a_line_has_no_letter_that_is_not_seen_and_reads_back_the_same() {
        // A line end, ESC, C1's CSI, a mark that turns the direction, one beyond 16 bits, and letters that stay.
        let text = "a\nb\u{1b}\u{7f}\u{9b}\u{202e}\u{e0001} Füße x\u{302} \"\\";
        let written = line(&text);
        assert!(
            written.chars().all(|letter| letter == '\n' || osim_model::messages::is_seen(letter)),
            "{written:?}"
        );
        assert_eq!(written.matches('\n').count(), 1);
        assert!(written.contains("Füße x\u{302}"));
        assert_eq!(serde_json::from_str::<String>(&written).unwrap(), text);
    }
}
