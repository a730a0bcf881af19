//! Reads values from texts as OpenSim 4.6 does. Only this module knows OpenSim's rules for white space, numbers, flags, lists and names.
//!
//! All rules were observed in OpenSim itself; `tests/oracle/test_words.py` checks them again.
//!
//! | text | how OpenSim reads it |
//! |---|---|
//! | white space | as in the language C: blank, tab, line feed, vertical tab, form feed, carriage return. A no-break space or a byte order mark counts as a letter |
//! | white space around a value | ignored, unless it comes from CDATA or a reference. After a number, a flag or a list, OpenSim then cannot read the value and uses the default (`12&#32;`); in a path or name, the white space counts as a letter |
//! | comments | before and after a value they are ignored. If a comment, an element, an instruction or a second CDATA section interrupts a value, or if there is text beside CDATA, OpenSim refuses the model ([`RawText::in_one_piece`]) |
//! | numbers or flags | words separated by white space. Each word is read from its start as far as possible (`1,5e6` is 1). If one word cannot be read at all, OpenSim uses the default for the whole text |
//! | number | the first word. `nan` and `inf` only as a whole word, in upper or lower case. A number beyond the range of a double cannot be read |
//! | three numbers | the first three words, if there are 3, 6, 9 ... words. Commas and brackets do not separate words (`0.1,0.2,0.3` is one word) |
//! | flag | `true` or `false` as a whole word, in upper or lower case; else a whole number at the start of the word: 0 is false, 1 is true (also `0.0`, `00`, `-0`, `0abc`, `1abc`). Other numbers cannot be read |
//! | `isDisabled` | like a flag, but the whole text is one word. A text that cannot be read is false, any whole number except 0 is true |
//! | list of names | words separated by white space; commas and brackets count as letters |
//! | path of a socket, name, `file=` | the whole text. In an attribute, white space at the ends is not removed |
//! | no text | the default: from `<defaults>`, else the default of the class |

use super::raw_text::{RawText, is_white_byte};
pub use super::raw_text::{is_white, trimmed};

/// Whole numbers with at most this many digits are exact as doubles.
const EXACT_DIGITS: usize = 15;
/// Powers of ten that are exact as doubles.
const POWERS_OF_TEN: [f64; EXACT_DIGITS + 1] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

/// Why a text is not one plain number, or why OpenSim reads another number from it.
///
/// Exhaustive: a text is empty, read in part, not read, or refused.
#[derive(Debug, Clone, PartialEq)]
pub enum NumberFault {
    /// The element has no text, or only white space.
    Empty,
    /// OpenSim reads a number from the start of the text and ignores the rest.
    Prefix { opensim_reads: f64 },
    /// OpenSim cannot read a number from the text and uses its default without a message.
    Unreadable,
    /// A comment or an element interrupts the number.
    Interrupted,
}

/// The words of `text`, which white space separates.
pub fn words(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let start = rest.bytes().position(|byte| !is_white_byte(byte))?;
        let word = rest.get(start..)?;
        let length = word.bytes().position(is_white_byte).unwrap_or(word.len());
        let (word, after) = word.split_at_checked(length)?;
        rest = after;
        Some(word)
    })
}

/// The words of a value that may be a list. There are none if the text ends with white space from CDATA or a reference, because OpenSim
/// then cannot read the value.
///
/// ```
/// use osim_model::xml::opensim_text::list_words;
///
/// assert_eq!(list_words("floor\u{b}heel_r").collect::<Vec<_>>(), ["floor", "heel_r"]);
/// assert_eq!(list_words("floor heel_r ").count(), 0);
/// ```
pub fn list_words(text: &str) -> impl Iterator<Item = &str> {
    words(if text.ends_with(is_white) { "" } else { text })
}

/// Reads one plain number. The error says what OpenSim reads from another text.
pub fn number(raw: &RawText<'_>) -> Result<f64, NumberFault> {
    if !raw.in_one_piece {
        return Err(NumberFault::Interrupted);
    }
    if trimmed(&raw.text).is_empty() {
        return Err(NumberFault::Empty);
    }
    let mut tokens = list_words(&raw.text);
    let (value, length, token) = tokens
        .next()
        .and_then(|token| number_at_start(token).map(|(value, length)| (value, length, token)))
        .ok_or(NumberFault::Unreadable)?;
    let mut alone = true;
    for other in tokens {
        alone = false;
        // One later word that is not a number spoils the whole text.
        if number_at_start(other).is_none() {
            return Err(NumberFault::Unreadable);
        }
    }
    if alone && length == token.len() { Ok(value) } else { Err(NumberFault::Prefix { opensim_reads: value }) }
}

/// All numbers in `text`; `None` if OpenSim can read none and uses its default.
pub fn numbers(text: &str) -> Option<Vec<f64>> {
    let all: Vec<f64> =
        list_words(text).map(|word| number_at_start(word).map(|(value, _)| value)).collect::<Option<_>>()?;
    (!all.is_empty()).then_some(all)
}

/// Three numbers, which may be infinite or NaN; `None` if OpenSim cannot read them and uses its default.
///
/// ```
/// use osim_model::xml::opensim_text::triple;
///
/// assert_eq!(triple("0.1, 0.2 0.3)"), Some([0.1, 0.2, 0.3]));
/// for text in ["0.1,0.2,0.3", "(0.1 0.2 0.3)", "0.1 0.2", "0.1 0.2 0.3 0.4"] {
///     assert_eq!(triple(text), None);
/// }
/// ```
pub fn triple(text: &str) -> Option<[f64; 3]> {
    let (mut first, mut count) = ([0.0; 3], 0_usize);
    for word in list_words(text) {
        let (value, _) = number_at_start(word)?;
        if let Some(place) = first.get_mut(count) {
            *place = value;
        }
        count += 1;
    }
    (count > 0 && count % 3 == 0).then_some(first)
}

/// The numbers of a text that a person and OpenSim read alike; `None` for another text. Commas after all numbers but the last are harmless.
///
/// ```
/// use osim_model::xml::opensim_text::plain_numbers;
///
/// assert_eq!(plain_numbers("0.1 -2e-3 inf"), Some(vec![0.1, -2e-3, f64::INFINITY]));
/// assert_eq!(plain_numbers("1, 2, 3"), Some(vec![1.0, 2.0, 3.0]));
/// for text in ["0.1,0.2,0.3", "0,5 1 2", "1 2 3,", "1x 2 3", ""] {
///     assert_eq!(plain_numbers(text), None, "{text}");
/// }
/// ```
pub fn plain_numbers(text: &str) -> Option<Vec<f64>> {
    let mut ends_with_comma = true;
    let number = |word: &str| {
        let (value, length) = number_at_start(word)?;
        ends_with_comma = word.len() > length;
        (word.get(length..).is_some_and(|rest| rest.is_empty() || rest == ",")).then_some(value)
    };
    let all: Vec<f64> = list_words(text).map(number).collect::<Option<_>>()?;
    (!ends_with_comma).then_some(all)
}

/// A flag, true or false; `None` if OpenSim cannot read it and uses its default.
///
/// ```
/// use osim_model::xml::opensim_text::flag;
///
/// assert_eq!((flag("FALSE"), flag("0abc"), flag("1.0")), (Some(false), Some(false), Some(true)));
/// assert_eq!((flag("2"), flag("yes"), flag("true yes")), (None, None, None));
/// ```
pub fn flag(text: &str) -> Option<bool> {
    let mut all = list_words(text).map(flag_of_word);
    let first = all.next()??;
    all.all(|flag| flag.is_some()).then_some(first)
}

fn flag_of_word(word: &str) -> Option<bool> {
    if let Some(spelled) = spelled_flag(word) {
        return Some(spelled);
    }
    match whole_number_at_start(word)? {
        "" => Some(false),
        "1" if !word.starts_with('-') => Some(true),
        _ => None,
    }
}

/// Whether `isDisabled`, an element of documents up to 30508, is true. OpenSim has a special rule for it.
pub fn is_disabled(text: &str) -> bool {
    let text = trimmed(text);
    spelled_flag(text).unwrap_or_else(|| whole_number_at_start(text).is_some_and(|digits| !digits.is_empty()))
}

/// The flag that the word `true` or `false` gives, in small or capital letters; `None` for another word, also for a number.
fn spelled_flag(word: &str) -> Option<bool> {
    let is = |flag: &str| word.eq_ignore_ascii_case(flag);
    if is("true") { Some(true) } else { is("false").then_some(false) }
}

/// The digits at the start of `word`, after a sign, without leading zeros. For 0, the result is empty.
fn whole_number_at_start(word: &str) -> Option<&str> {
    let digits = word.strip_prefix(['+', '-']).unwrap_or(word);
    let end = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
    let digits = digits.get(..end).filter(|digits| !digits.is_empty())?;
    Some(digits.trim_start_matches('0'))
}

/// The number that a C++ stream reads from the start of `token`, and the number of bytes that it has.
///
/// `None` if the stream fails: there are no digits, an exponent has no digits, or the number is beyond the range of a double.
pub(crate) fn number_at_start(token: &str) -> Option<(f64, usize)> {
    let bytes = token.as_bytes();
    let sign = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    if bytes.get(sign).is_some_and(u8::is_ascii_alphabetic) {
        return spelled_number(token).map(|value| (value, token.len()));
    }
    let is_digit = |byte: &&u8| byte.is_ascii_digit();
    let digits = |from| bytes.get(from..).map_or(0, |rest| rest.iter().take_while(is_digit).count());
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
    if whole + fraction <= EXACT_DIGITS && !matches!(bytes.get(end), Some(b'e' | b'E')) {
        return Some((short_number(bytes.get(..end)?, fraction)?, end));
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

/// A number with at most [`EXACT_DIGITS`] digits, `fraction` of them after the decimal point. It is the quotient of two exact numbers, and
/// so the double nearest to the text. This is faster than a general parser; models contain hundreds of such short numbers.
fn short_number(text: &[u8], fraction: usize) -> Option<f64> {
    let digits = text.iter().filter(|byte| byte.is_ascii_digit());
    let whole = digits.fold(0_u64, |sum, digit| sum * 10 + u64::from(digit - b'0'));
    let size = whole as f64 / POWERS_OF_TEN.get(fraction)?;
    Some(if text.first() == Some(&b'-') { -size } else { size })
}

/// Reads `nan` and `inf`, in upper or lower case. Only infinity may have a sign.
fn spelled_number(token: &str) -> Option<f64> {
    if token.eq_ignore_ascii_case("nan") {
        return Some(f64::NAN);
    }
    let (sign, word) = match token.strip_prefix('-') {
        Some(word) => (-1.0, word),
        None => (1.0, token.strip_prefix('+').unwrap_or(token)),
    };
    let is_infinite = word.eq_ignore_ascii_case("inf") || word.eq_ignore_ascii_case("infinity");
    is_infinite.then_some(sign * f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xml::{ElementId, Tree};

    #[track_caller]
    fn assert_number(content: &str, expected: &Result<f64, NumberFault>) {
        let tree = Tree::scan(format!("<a>{content}</a>")).unwrap();
        assert_eq!(&number(&tree.raw_text(ElementId::ROOT)), expected, "{content}");
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
            assert_number(text, &Ok(value));
        }
        let tree = Tree::scan("<a>NaN</a>").unwrap();
        assert!(number(&tree.raw_text(ElementId::ROOT)).unwrap().is_nan());
    }

    #[test]
    fn a_text_that_opensim_reads_as_another_number_is_refused() {
        for (text, value) in [("1,5e6", 1.0), ("2e6N", 2e6), (" 3e6 4e6 ", 3e6), ("1d6", 1.0), ("0x10", 0.0)]
        {
            assert_number(text, &Err(NumberFault::Prefix { opensim_reads: value }));
        }
        assert_number("", &Err(NumberFault::Empty));
        assert_number(" \n ", &Err(NumberFault::Empty));
        assert_number("abc", &Err(NumberFault::Unreadable));
        assert_number("1e400", &Err(NumberFault::Unreadable));
        for text in ["1e", "1e+", "-NaN", "+nan", "inf5", "3e6 abc", "3 1e400"] {
            assert_number(text, &Err(NumberFault::Unreadable));
        }
        assert_number("3 4x", &Err(NumberFault::Prefix { opensim_reads: 3.0 }));
        assert_number("1e-400", &Ok(0.0));
        assert_number("2<![CDATA[e6]]>", &Err(NumberFault::Interrupted));
        assert_number("2e6<x/>", &Err(NumberFault::Interrupted));
        assert_number("1<!-- in -->e6", &Err(NumberFault::Interrupted));
        for text in
            ["\u{a0}1e6", "\u{feff}12", "12&#32;", "12&#10;", "<![CDATA[1e6 ]]>", "&#160;1", "12 &bogus;"]
        {
            assert_number(text, &Err(NumberFault::Unreadable));
        }
        for text in ["<![CDATA[1]]><![CDATA[2]]>", "1<?pi?>2", "<![CDATA[]]>1e6"] {
            assert_number(text, &Err(NumberFault::Interrupted));
        }
    }

    #[test]
    fn white_space_is_that_of_c() {
        for text in [
            "\u{b}1e6\u{b}",
            "\u{c}1e6",
            "&#10;1e6",
            "&#11;1e6",
            "<![CDATA[ 1e6]]> ",
            "<?pi?>1e6 <!-- x --> ",
        ] {
            assert_number(text, &Ok(1e6));
        }
        assert_number("1\u{b}2", &Err(NumberFault::Prefix { opensim_reads: 1.0 }));
        assert_number("12\u{a0}", &Err(NumberFault::Prefix { opensim_reads: 12.0 }));
    }

    /// Short numbers have their own parser: it must agree with the standard library to the last bit.
    #[test]
    fn short_numbers_are_read_exactly() {
        let mut seed = 1_u64;
        for _ in 0..50_000 {
            // Marsaglia's xorshift.
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            let digits = format!("{:017}", seed % 100_000_000_000_000_000);
            let digits = &digits[..1 + (seed >> 57) as usize % 17];
            for point in 0..=digits.len() {
                let (whole, fraction) = digits.split_at(point);
                let text = format!("-{whole}.{fraction}");
                for text in [&text[1..], text.as_str()] {
                    let (value, length) = number_at_start(text).unwrap();
                    let expected: f64 = text.parse().unwrap();
                    assert_eq!((value.to_bits(), length), (expected.to_bits(), text.len()), "{text}");
                }
            }
        }
        assert_eq!(number_at_start("-0").unwrap().0.to_bits(), (-0.0_f64).to_bits());
    }

    #[test]
    fn a_location_has_three_numbers() {
        let read = "0.1 0.2 0.3|0.1\u{b}0.2\u{c}0.3|0.1x 0.2 0.3)(|0.1, 0.2, 0.3|0.1 0.2 0.3 4 5 6";
        for text in read.split('|') {
            assert_eq!(triple(text), Some([0.1, 0.2, 0.3]), "{text}");
        }
        let unread = "0.1,0.2,0.3|(0.1 0.2 0.3)|[0.1,0.2,0.3]|~[0.1 0.2 0.3]|0.1\u{a0}0.2 0.3|0.1 0.2|0.1 0.2 0.3 x|0.1 0.2 0.3 4 5|\
        0.1 , 0.2 , 0.3|0.1 0.2 0.3 ,||0.1 0.2 -nan|0.1 0.2 1e400|0.1 0.2 0.3 ";
        for text in unread.split('|') {
            assert_eq!(triple(text), None, "{text}");
        }
        assert!(triple("1 2 nan").unwrap()[2].is_nan());
    }

    #[test]
    fn flags_are_words_or_whole_numbers() {
        let yes = "true|TRUE|tRuE|1|+1|01|1.0|1e0|1abc|1,1|true false|1\u{a0}x| true|1 0";
        let no = "false|0|-0|+0|00|0.0|0.5|0abc|0x1|0e5|0true|false true|false 1abc|\u{b}false";
        let neither = "| |2|-1|abc|t|yes|true abc|true 2|truex|true,|true |\u{a0}true|nan|+|-|99999999999999999999|(false)|+false|\
        true\u{a0}";
        for (texts, expected) in [(yes, Some(true)), (no, Some(false)), (neither, None)] {
            for text in texts.split('|') {
                assert_eq!(flag(text), expected, "{text}");
            }
        }
    }

    #[test]
    fn is_disabled_is_not_read_like_other_flags() {
        for text in "true|TRUE|1|1abc|true | true|2|-1|01|99999999999999999999".split('|') {
            assert!(is_disabled(text), "{text}");
        }
        for text in "false|0|0.0|-0|true false|true 2|abc||t|yes|\u{a0}true|+|false 1".split('|') {
            assert!(!is_disabled(text), "{text}");
        }
    }
}
