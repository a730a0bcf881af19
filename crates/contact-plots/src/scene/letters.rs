//! How wide a text is, letter by letter: names that must not touch need more than an estimate.

/// Widths of the letters from blank to tilde, in thousandths of the size of the text: Arial's, Helvetica's and Arimo's.
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556,
    556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278,
    500, 667, 556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469,
    556, 333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500,
    278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,
];
/// A letter that is not in the table: none of the font's is wider.
const WIDEST: u16 = 1000;
const ELLIPSIS: char = '…';

/// The width of a text, in points.
pub(super) fn width_pt(text: &str, size_pt: f64) -> f64 {
    let thousandths: u32 = text.chars().map(|letter| u32::from(width(letter))).sum();
    f64::from(thousandths) / 1000.0 * size_pt
}

fn width(letter: char) -> u16 {
    let place = u32::from(letter).checked_sub(0x20).and_then(|place| usize::try_from(place).ok());
    place.and_then(|place| WIDTHS.get(place)).copied().unwrap_or(WIDEST)
}

/// The text, cut with an ellipsis where it would be wider than `most_pt`.
pub(super) fn cut(text: &str, size_pt: f64, most_pt: f64) -> String {
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
    short.push(ELLIPSIS);
    short
}

/// Lines of at most `most_pt`, broken at blanks; a longer word is cut.
pub(super) fn lines(text: &str, size_pt: f64, most_pt: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_ascii_whitespace() {
        let joined = lines.last().map(|line| format!("{line} {word}"));
        match (joined.filter(|joined| width_pt(joined, size_pt) <= most_pt), lines.last_mut()) {
            (Some(joined), Some(line)) => *line = joined,
            _ => lines.push(cut(word, size_pt, most_pt)),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_those_of_the_font() {
        // Helvetica's metrics: W 944, i 222, blank 278.
        assert!((width_pt("Wi i", 10.0) - (9.44 + 2.22 + 2.78 + 2.22)).abs() < 1e-12);
        assert!((width_pt("足", 10.0) - 10.0).abs() < 1e-12);
    }

    #[test]
    fn long_names_are_cut_and_short_ones_stay() {
        assert_eq!(cut("heel_r", 7.0, 40.0), "heel_r");
        let short = cut(&"W".repeat(99), 7.0, 40.0);
        assert!(short.ends_with('…') && width_pt(&short, 7.0) <= 40.0, "{short}");
        assert_eq!(cut("heel", 7.0, 0.0), "…");
    }

    #[test]
    fn remarks_are_broken_at_blanks() {
        let broken = lines("one two three", 10.0, width_pt("one two", 10.0));
        assert_eq!(broken, ["one two", "three"]);
        assert!(lines("", 10.0, 50.0).is_empty());
    }
}
