//! The change as a unified diff, as version control shows it.

use std::fmt;

use imara_diff::{Algorithm, Diff, InternedInput, Interner, Token, UnifiedDiffConfig, UnifiedDiffPrinter};

/// Lines before and after each change.
const CONTEXT: u32 = 1;

/// Differences between the bytes of a model before and after, under these names.
#[must_use]
pub fn unified_diff(old: &[u8], new: &[u8], old_name: &str, new_name: &str) -> String {
    // Bytes that are not UTF-8 are the same on both sides; a diff is for reading, so they may be shown as replacements.
    let (old, new) = (String::from_utf8_lossy(old), String::from_utf8_lossy(new));
    let input = InternedInput::new(old.as_ref(), new.as_ref());
    let mut diff = Diff::compute(Algorithm::Myers, &input);
    diff.postprocess_no_heuristic(&input);
    if diff.count_additions() + diff.count_removals() == 0 {
        return String::new();
    }
    let mut config = UnifiedDiffConfig::default();
    config.context_len(CONTEXT);
    let lines = diff.unified_diff(&Lines(&input.interner), config, &input).to_string();
    format!("--- {old_name}\n+++ {new_name}\n{lines}")
}

/// Prints lines as `diff -u` does.
struct Lines<'i>(&'i Interner<&'i str>);

impl Lines<'_> {
    fn line(&self, f: &mut impl fmt::Write, sign: char, token: Token) -> fmt::Result {
        let line = self.0[token];
        write!(f, "{sign}{line}")?;
        if line.ends_with('\n') { Ok(()) } else { writeln!(f, "\n\\ No newline at end of file") }
    }
}

/// Where lines begin, from 1, and how many they are. Without lines, it is the line before them.
struct Place(u32, u32);

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self(start, 1) => write!(f, "{}", start + 1),
            Self(start, 0) => write!(f, "{start},0"),
            Self(start, lines) => write!(f, "{},{lines}", start + 1),
        }
    }
}

impl UnifiedDiffPrinter for Lines<'_> {
    fn display_header(
        &self,
        mut f: impl fmt::Write,
        start_before: u32,
        start_after: u32,
        len_before: u32,
        len_after: u32,
    ) -> fmt::Result {
        writeln!(f, "@@ -{} +{} @@", Place(start_before, len_before), Place(start_after, len_after))
    }

    fn display_context_token(&self, mut f: impl fmt::Write, token: Token) -> fmt::Result {
        self.line(&mut f, ' ', token)
    }

    fn display_hunk(&self, mut f: impl fmt::Write, before: &[Token], after: &[Token]) -> fmt::Result {
        before.iter().try_for_each(|token| self.line(&mut f, '-', *token))?;
        after.iter().try_for_each(|token| self.line(&mut f, '+', *token))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_change_stand_between_their_neighbours() {
        let old = b"a\nb\nc\nd\ne\nf\ng\n";
        let new = b"a\nB\nc\nd\ne\nF\ng\n";
        let expected = "--- x\n+++ y\n@@ -1,3 +1,3 @@\n a\n-b\n+B\n c\n@@ -5,3 +5,3 @@\n e\n-f\n+F\n g\n";
        assert_eq!(unified_diff(old, new, "x", "y"), expected);
    }

    #[test]
    fn an_end_without_a_line_end_is_told_and_equal_files_say_nothing() {
        let expected =
            "--- x\n+++ y\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+b\n\\ No newline at end of file\n";
        assert_eq!(unified_diff(b"a", b"b", "x", "y"), expected);
        assert_eq!(unified_diff(b"a\r\n", b"a\r\n", "x", "y"), "");
    }

    #[test]
    fn a_line_that_is_added_at_the_end_of_one() {
        assert_eq!(unified_diff(b"", b"a\n", "x", "y"), "--- x\n+++ y\n@@ -0,0 +1 @@\n+a\n");
    }
}
