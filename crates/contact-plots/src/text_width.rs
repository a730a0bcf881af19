//! Widths of texts from the widths of their letters, and the breaking of texts into lines. An estimate is not enough, because
//! names must not touch and must not be cut.

use std::sync::OnceLock;

use textwrap::core::Fragment;
use textwrap::wrap_algorithms::wrap_first_fit;
use ttf_parser::Face;

/// The width of a letter that the font does not have, as a share of the text size. No letter of a plain font is wider.
const WIDEST_LETTER: f64 = 1.0;
/// Factor by which the letters of a viewer without Arial may be wider.
const OTHER_FONT_FACTOR: f64 = 1.06;
/// The letter at the end of a text that was cut.
const ELLIPSIS: char = '…';
/// A word too long for a line is broken after one of these characters, which separate the parts of file names.
const LETTERS_TO_BREAK_AFTER: [char; 6] = ['_', '-', '/', '\\', '.', ','];

/// The width of a text in Arial, or a font of the same metrics, in points.
pub(crate) fn width_pt(text: &str, size_pt: f64) -> f64 {
    text.chars().map(letter_width).sum::<f64>() * size_pt
}

/// The width of a text in points, with a reserve for viewers without Arial.
pub(crate) fn width_with_reserve_pt(text: &str, size_pt: f64) -> f64 {
    OTHER_FONT_FACTOR * width_pt(text, size_pt)
}

fn letter_width(letter: char) -> f64 {
    /// The built-in font, which is read when the first text is measured.
    static PARSED_FONT: OnceLock<Option<Face<'static>>> = OnceLock::new();
    // A combining mark takes no room.
    if ('\u{300}'..='\u{36f}').contains(&letter) {
        return 0.0;
    }
    let advance = || {
        let face = PARSED_FONT.get_or_init(|| Face::parse(FONT, 0).ok()).as_ref()?;
        let advance = face.glyph_hor_advance(face.glyph_index(letter)?)?;
        Some(f64::from(advance) / f64::from(face.units_per_em()))
    };
    advance().unwrap_or(WIDEST_LETTER)
}

/// The text, cut and ended with an ellipsis if it is wider than `most_pt`.
pub(crate) fn cut_to_width(text: &str, size_pt: f64, most_pt: f64) -> String {
    if width_pt(text, size_pt) <= most_pt {
        return text.to_owned();
    }
    let room = most_pt - width_pt(&ELLIPSIS.to_string(), size_pt);
    let mut short = String::new();
    for letter in text.chars() {
        short.push(letter);
        if width_pt(&short, size_pt) > room {
            short.pop();
            break;
        }
    }
    short.truncate(short.trim_end_matches(' ').len());
    short.push(ELLIPSIS);
    short
}

/// Lines of at most `most_pt`, but of at least one letter, broken at blanks. A longer word is broken after the parts of a name,
/// or anywhere. No line for a text without letters.
pub(crate) fn lines(text: &str, size_pt: f64, most_pt: f64) -> Vec<String> {
    let words = text.split_ascii_whitespace();
    let pieces: Vec<WordPiece<'_>> = words.flat_map(|word| pieces_of_word(word, size_pt, most_pt)).collect();
    let rows = wrap_first_fit(&pieces, &[most_pt]);
    rows.into_iter().filter(|row| !row.is_empty()).map(join_pieces).collect()
}

/// A word of a text, or a part of a long word.
#[derive(Debug)]
struct WordPiece<'t> {
    text: &'t str,
    width: f64,
    /// Width of the blank after the word, pt; 0 within a word.
    blank: f64,
}

impl Fragment for WordPiece<'_> {
    fn width(&self) -> f64 {
        self.width
    }

    fn whitespace_width(&self) -> f64 {
        self.blank
    }

    fn penalty_width(&self) -> f64 {
        0.0
    }
}

fn join_pieces(row: &[WordPiece<'_>]) -> String {
    let mut line = String::new();
    for piece in row {
        line.push_str(piece.text);
        if piece.blank > 0.0 {
            line.push(' ');
        }
    }
    line.truncate(line.trim_end_matches(' ').len());
    line
}

/// The pieces of a word; each fits into a line.
fn pieces_of_word(word: &str, size_pt: f64, most_pt: f64) -> Vec<WordPiece<'_>> {
    let parts: Vec<&str> = if width_with_reserve_pt(word, size_pt) <= most_pt {
        vec![word]
    } else {
        let parts = word.split_inclusive(LETTERS_TO_BREAK_AFTER);
        parts.flat_map(|part| letter_by_letter(part, size_pt, most_pt)).collect()
    };
    let count = parts.len();
    let blank = |index: usize| if index + 1 == count { width_with_reserve_pt(" ", size_pt) } else { 0.0 };
    let piece = |(index, text)| {
        let (width, blank) = (width_with_reserve_pt(text, size_pt), blank(index));
        WordPiece { text, width, blank }
    };
    parts.into_iter().enumerate().map(piece).collect()
}

/// The pieces of a `part` that is too long for a line; it is cut between any two letters.
fn letter_by_letter(part: &str, size_pt: f64, most_pt: f64) -> Vec<&str> {
    let (mut cuts, mut width) = (vec![0], 0.0);
    for (at, letter) in part.char_indices() {
        let next = width_with_reserve_pt(letter.encode_utf8(&mut [0; 4]), size_pt);
        if width + next > most_pt && width > 0.0 {
            cuts.push(at);
            width = 0.0;
        }
        width += next;
    }
    cuts.push(part.len());
    cuts.windows(2).filter_map(|pair| part.get(pair[0]..pair[1])).collect()
}

/// The font Arimo (SIL Open Font License 1.1) with the letters that figures need; `fonts/README.md` describes how it was made.
/// Its letters have the same widths as Arial's.
pub(crate) const FONT: &[u8] = include_bytes!("../fonts/Arimo-subset.ttf");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_of_letters_are_those_of_arial() {
        // In thousandths of the size, as in Adobe's tables of Helvetica: W 944, i 222, blank 278, M 833, alpha 578 (Arial).
        assert!((width_pt("Wi i", 1000.0) - (944.0 + 222.0 + 278.0 + 222.0)).abs() < 2.0);
        assert!((width_pt("M", 1000.0) - 833.0).abs() < 1.0);
        assert!((width_pt("x\u{302}", 1000.0) - 500.0).abs() < 1.0, "a mark over a letter takes no room");
        assert!((width_pt("足", 10.0) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn long_texts_are_cut_to_a_width() {
        assert_eq!(cut_to_width("toe", 7.0, 40.0), "toe");
        let short = cut_to_width("a name without end", 7.0, 40.0);
        assert!(short.ends_with('…') && width_pt(&short, 7.0) <= 40.0, "{short}");
    }

    #[test]
    fn lines_break_at_blanks_and_then_where_parts_of_names_end() {
        let broken = lines("one two three", 10.0, width_with_reserve_pt("one two", 10.0) + 0.1);
        assert_eq!(broken, ["one two", "three"]);
        let name = "gait2392_scaled_by_the_tool";
        let broken = lines(name, 7.0, 60.0);
        assert!(broken.len() > 1 && broken.concat() == name, "{broken:?}");
        assert!(broken.iter().all(|line| width_pt(line, 7.0) <= 60.0), "{broken:?}");
        assert!(broken.first().is_some_and(|line| line.ends_with('_')), "{broken:?}");
        let endless = lines("WWWWWWWWWWWWWWWWWWWW", 7.0, 30.0);
        assert_eq!(endless.concat(), "WWWWWWWWWWWWWWWWWWWW");
        assert!(lines("  ", 7.0, 30.0).is_empty());
    }
}
