//! Values as OpenSim reads their text, and as a strict reader reads them.

use osim_xml::RawText;

/// Why a text is not one plain number.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum NumberFault {
    /// Nothing there, or only white space.
    Empty,
    /// OpenSim reads a number from the start of the text and ignores the rest.
    Prefix {
        /// What OpenSim makes of it.
        opensim_reads: f64,
    },
    /// OpenSim cannot read the text either and silently takes its default.
    Unreadable,
    /// A comment or element interrupts the number.
    Interrupted,
}

/// Reads one number strictly; where OpenSim reads something else, says what.
pub(crate) fn number(raw: &RawText) -> Result<f64, NumberFault> {
    if !raw.whole {
        return Err(NumberFault::Interrupted);
    }
    let mut tokens = raw.text.split_ascii_whitespace();
    let Some(token) = tokens.next() else { return Err(NumberFault::Empty) };
    let Some((value, length)) = prefix(token) else { return Err(NumberFault::Unreadable) };
    let mut alone = true;
    for other in tokens {
        alone = false;
        // One later word that is no number spoils the whole text.
        if prefix(other).is_none() {
            return Err(NumberFault::Unreadable);
        }
    }
    if alone && length == token.len() { Ok(value) } else { Err(NumberFault::Prefix { opensim_reads: value }) }
}

/// What a C++ stream reads from the start of `token`, and how many bytes of it.
///
/// `None` where the stream fails (no digits, an exponent without digits, out of the range of a double).
pub(crate) fn prefix(token: &str) -> Option<(f64, usize)> {
    let bytes = token.as_bytes();
    let word = match token.to_ascii_lowercase().as_str() {
        "nan" => Some(f64::NAN),
        "inf" | "infinity" | "+inf" | "+infinity" => Some(f64::INFINITY),
        "-inf" | "-infinity" => Some(f64::NEG_INFINITY),
        _ => None,
    };
    if let Some(value) = word {
        return Some((value, token.len()));
    }
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let whole = digits(sign);
    let mut end = sign + whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent == 0 {
            return None;
        }
        end += 1 + sign + exponent;
    }
    let text = token.get(..end)?;
    let value: f64 = text.parse().ok()?;
    value.is_finite().then_some((value, end))
}

#[cfg(test)]
mod tests {
    use super::*;
    use osim_xml::{ElementId, Tree};

    fn raw(xml: &str) -> RawText {
        Tree::scan(xml).unwrap().raw_text(ElementId::ROOT)
    }

    #[track_caller]
    fn reads(content: &str, expected: &Result<f64, NumberFault>) {
        assert_eq!(&number(&raw(&format!("<a>{content}</a>"))), expected, "{content}");
    }

    // Expected readings are those seen from OpenSim 4.6 on the same texts.
    #[test]
    fn plain_numbers_are_read_as_opensim_reads_them() {
        for (text, value) in [
            ("1000000", 1e6),
            ("+8e6", 8e6),
            (".5E+6", 5e5),
            ("  10000.00000000 ", 1e4),
            ("0.80000000000000004", 0.8),
            ("&#49;e6", 1e6),
            ("1&#46;5", 1.5),
            ("<![CDATA[2e6]]>", 2e6),
            ("<!-- before -->3e6<!-- after -->", 3e6),
            ("5.", 5.0),
            ("inf", f64::INFINITY),
            ("-Infinity", f64::NEG_INFINITY),
        ] {
            reads(text, &Ok(value));
        }
        assert!(number(&raw("<a>NaN</a>")).unwrap().is_nan());
    }

    #[test]
    fn where_opensim_reads_something_else_the_text_is_refused() {
        for (text, value) in [("1,5e6", 1.0), ("2e6N", 2e6), (" 3e6 4e6 ", 3e6), ("1d6", 1.0), ("0x10", 0.0)]
        {
            reads(text, &Err(NumberFault::Prefix { opensim_reads: value }));
        }
        reads("", &Err(NumberFault::Empty));
        reads(" \n ", &Err(NumberFault::Empty));
        reads("abc", &Err(NumberFault::Unreadable));
        reads("1e400", &Err(NumberFault::Unreadable));
        for text in ["1e", "1e+", "-NaN", "+nan", "inf5", "3e6 abc", "3 1e400"] {
            reads(text, &Err(NumberFault::Unreadable));
        }
        reads("3 4x", &Err(NumberFault::Prefix { opensim_reads: 3.0 }));
        reads("1e-400", &Ok(0.0));
        reads("2<![CDATA[e6]]>", &Err(NumberFault::Interrupted));
        reads("2e6<x/>", &Err(NumberFault::Interrupted));
        reads("1<!-- in -->e6", &Err(NumberFault::Interrupted));
    }
}
