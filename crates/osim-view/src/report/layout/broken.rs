//! Lines of text, broken where a terminal ends.

use textwrap::core::display_width;
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

/// What begins a sentence for people: its other lines are further in.
const HEADS: [&str; 3] = ["error: ", "warning: ", "note: "];

/// What begins a command, which is copied as a whole. A terminal breaks it, too, but does not copy that.
const COMMANDS: [&str; 3] = ["$ ", "> ", "osim-contact-scale "];

/// Text with each line that is too long broken at blanks. A command stays one line, and so does a row of a table, but for a sentence in
/// its last cell: that goes on below its beginning. Names without a blank are never broken. Letters may be coloured.
///
/// ```
/// let text = "error: model.osim: a sentence that is too long\n  in a table  a sentence that is too long\n";
/// let broken = osim_view::report::layout::broken(text, 30);
/// assert_eq!(
///     broken,
///     "error: model.osim: a sentence\n  that is too long\n\
///      \x20 in a table  a sentence that\n              is too long\n"
/// );
/// assert_eq!(osim_view::report::layout::broken(text, 80), text);
/// ```
#[must_use]
pub fn broken(text: &str, width: usize) -> String {
    text.split_inclusive('\n').map(|line| line_broken(line, width)).collect()
}

fn line_broken(line: &str, width: usize) -> String {
    let (text, end) = line.strip_suffix('\n').map_or((line, ""), |text| (text, "\n"));
    let words = text.trim_start_matches(' ');
    if display_width(text) <= width || COMMANDS.iter().any(|command| words.starts_with(command)) {
        return line.to_owned();
    }
    let (head, sentence) = split(text);
    let hang = display_width(head) + if HEADS.iter().any(|head| text.starts_with(head)) { 2 } else { 0 };
    // Where hardly anything would fit beside the other cells, nothing is won.
    if hang > width / 2 {
        return line.to_owned();
    }
    let indent = " ".repeat(hang);
    let options = Options::new(width)
        .initial_indent(head)
        .subsequent_indent(&indent)
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .break_words(false);
    format!("{}{end}", textwrap::fill(sentence, options))
}

/// What stays in front of a line, indentation and cells of a table, and the sentence after it.
fn split(line: &str) -> (&str, &str) {
    let gap = line.rfind("  ").map_or(0, |at| at + 2);
    let sentence = line[gap..].trim_start_matches(' ');
    line.split_at(line.len() - sentence.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_and_rows_of_numbers_stay_whole() {
        for line in [
            "  $ osim-contact-scale design 'my model.osim' --indentation 0.16\n",
            "osim-contact-scale check model.osim --from generic.osim\n",
            " radius                   12 spheres    0.032     0.064171583      x2.005362  (8)\n",
            "/a/folder/with/a/long/name/and/another/one/model.osim\n",
        ] {
            assert_eq!(broken(line, 40), line);
        }
    }

    #[test]
    fn sentences_keep_their_place() {
        assert_eq!(
            broken("  Why: one two three four five six\n", 20),
            "  Why: one two three\n  four five six\n"
        );
        assert_eq!(broken("note: one two three four", 16), "note: one two\n  three four");
        // Two letters that fill no column, and a colour that fills none.
        assert_eq!(
            broken("\u{1b}[1mwarn\u{1b}[0m x̂ = x/R of the sphere", 17),
            "\u{1b}[1mwarn\u{1b}[0m x̂ = x/R of\nthe sphere"
        );
    }

    #[test]
    fn every_line_fits_and_no_word_is_lost() {
        let text = "error: a b cc ddd eeee fffff gggggg\n  good  floor  the floor leans by 0 degrees\n\n";
        // The sentence in the table has to have room for half a line.
        for width in 30..60 {
            let broken = broken(text, width);
            assert!(broken.lines().all(|line| line.len() <= width), "{width}: {broken}");
            let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
            assert_eq!(words(&broken), words(text));
            assert!(broken.ends_with("\n\n"));
        }
    }
}
