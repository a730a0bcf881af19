//! Where a line of text may end: after a blank, after the `/` of a path, and wherever else the Unicode line breaking
//! algorithm has it; never at a hyphen.

use textwrap::core::Word;
use unicode_linebreak::linebreaks;

const SOFT_HYPHEN: char = '\u{ad}';

/// The pieces of a line between which it may be broken, each with the blanks after it.
pub(super) fn find(line: &str) -> Box<dyn Iterator<Item = Word<'_>> + '_> {
    Box::new(behind_quotes(line).flat_map(|part| {
        // Whether a word is broken at its hyphens is for the caller to say.
        let ends = linebreaks(part).map(|(end, _)| end);
        let ends = ends.filter(|&end| end == part.len() || !part[..end].ends_with(['-', SOFT_HYPHEN]));
        cut(part, ends).map(Word::from)
    }))
}

/// A bracket after a quoted name begins a word. The algorithm's older editions, that of the library among them, took
/// every quotation mark for one that opens, and a bracket for what it quotes.
fn behind_quotes(line: &str) -> impl Iterator<Item = &str> {
    let brackets = line.match_indices(['(', '[', '{']).map(|(at, _)| at);
    let begins = brackets.filter(|&at| {
        let before = line[..at].trim_end_matches(' ');
        before.len() < at && before.ends_with(['"', '\''])
    });
    cut(line, begins.chain([line.len()]))
}

fn cut(text: &str, ends: impl Iterator<Item = usize>) -> impl Iterator<Item = &str> {
    ends.scan(0, move |start, end| Some(&text[std::mem::replace(start, end)..end]))
}

#[cfg(test)]
mod tests {
    fn words(line: &str) -> Vec<String> {
        super::find(line).map(|word| format!("{}{}", word.word, word.whitespace)).collect()
    }

    #[test]
    fn lines_end_behind_blanks_and_slashes_but_not_at_hyphens() {
        assert_eq!(words("see  --contacts-mass KG"), ["see  ", "--contacts-mass ", "KG"]);
        assert_eq!(words("out/even/a_1.osim, 2 N/m^2"), ["out/", "even/", "a_1.osim, ", "2 ", "N/", "m^2"]);
        assert_eq!(words("f(x) [a] 1/2"), ["f(x) ", "[a] ", "1/2"]);
    }

    #[test]
    fn punctuation_stays_with_its_word() {
        assert_eq!(words("really ! ( so )"), ["really ! ", "( so )"]);
        assert_eq!(words("the 'heel' (right)"), ["the ", "'heel' ", "(right)"]);
        assert_eq!(words("\"a b\"  [c]"), ["\"a ", "b\"  ", "[c]"]);
    }

    #[test]
    fn letters_beyond_ascii_are_letters() {
        assert_eq!(words("Füße x̂ = x / R"), ["Füße ", "x̂ ", "= ", "x / ", "R"]);
        assert_eq!(words("左足"), ["左", "足"]);
        assert!(words("").is_empty());
    }
}
