//! The layout of texts: lines as wide as the terminal, columns of a table, rows of CSV, colours.

use std::collections::HashSet;
use std::io;

use anstyle::{AnsiColor, Style};
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, presets};
use csv::{IntoInnerError, WriterBuilder};
use osim_inspect::Sign;
use osim_model::messages::{one_line, shown, shown_whole};
use osim_planning::with_text_mark;
use textwrap::core::{Word, display_width};
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};
use unicode_linebreak::linebreaks;

/// The width in columns of an old terminal. Texts in a file or a pipe are also this wide.
pub const WIDTH: usize = 80;

/// Options for breaking text into lines of at most `width` columns and of about equal length. Options of a command line are never
/// broken at their hyphens.
pub(crate) fn wrap_options<'o>(width: usize) -> Options<'o> {
    Options::new(width)
        .word_separator(WordSeparator::Custom(breakable_words))
        .word_splitter(WordSplitter::NoHyphenation)
}

/// A paragraph that may have names from files in it: line ends in names are escaped, and very long names are cut.
fn paragraph(text: &str) -> String {
    text.split(' ').map(|word| shown(word).to_string()).collect::<Vec<_>>().join(" ")
}

/// The text in lines of at most `width` columns. Line ends in names are escaped.
pub(crate) fn filled(text: &str, width: usize) -> String {
    textwrap::fill(&paragraph(text), wrap_options(width))
}

/// The text in lines of at most `width` columns. The second and later lines begin with `indent`. Line ends in the text are escaped.
pub fn wrapped(text: &str, indent: &str, width: usize) -> String {
    wrap_lines(&paragraph(text), indent, width)
}

/// Breaks a text about a file into lines. The path of the file is never cut, because the reader has to find the file.
pub(crate) fn wrapped_with_path(path: &str, text: &str, indent: &str, width: usize) -> String {
    wrap_lines(&format!("{}: {}", shown_whole(path), paragraph(text)), indent, width)
}

fn wrap_lines(text: &str, indent: &str, width: usize) -> String {
    let options = wrap_options(width).subsequent_indent(indent).break_words(false);
    format!("{}\n", textwrap::fill(text, options))
}

// Where a line of text may end: after a blank, and wherever else the Unicode line breaking algorithm has it; never at a
// hyphen, and never after the `/` of a path or a unit.

/// A hyphen that is seen only at the end of a line.
const SOFT_HYPHEN: char = '\u{ad}';

/// The pieces of a line between which it may be broken. Each has the blanks after it.
fn breakable_words(line: &str) -> Box<dyn Iterator<Item = Word<'_>> + '_> {
    Box::new(words_with_brackets_apart(line).flat_map(|part| {
        // Whether a word is broken at its hyphens is for the caller to say.
        let ends = linebreaks(part).map(|(end, _)| end);
        let ends = ends.filter(|&end| end == part.len() || !part[..end].ends_with(['-', '/', SOFT_HYPHEN]));
        split_at_ends(part, ends).map(Word::from)
    }))
}

/// Splits the line so that a bracket after a quoted name begins a new word. Older editions of the algorithm for line breaks, which the
/// library uses, take every quotation mark for an opening one.
fn words_with_brackets_apart(line: &str) -> impl Iterator<Item = &str> {
    let brackets = line.match_indices(['(', '[', '{']).map(|(at, _)| at);
    let begins = brackets.filter(|&at| {
        let before = line[..at].trim_end_matches(' ');
        before.len() < at && before.ends_with(['"', '\''])
    });
    split_at_ends(line, begins.chain([line.len()]))
}

fn split_at_ends(text: &str, ends: impl Iterator<Item = usize>) -> impl Iterator<Item = &str> {
    ends.scan(0, move |start, end| Some(&text[std::mem::replace(start, end)..end]))
}

// Lines of text, broken where a terminal ends.

/// Beginnings of sentences about findings. The second and later lines of such a sentence are indented.
const SEVERITY_BEGINNINGS: [&str; 3] = ["error: ", "warning: ", "remark: "];

/// Beginnings of commands, which the reader copies as a whole. A terminal breaks long lines, too, but does not copy these breaks.
const COMMAND_BEGINNINGS: [&str; 3] = ["$ ", "> ", "osim-contact-scale "];

/// Text with each line that is too long broken at blanks. A command stays one line, and so does a row of a table, but for a sentence in
/// its last cell: that goes on below its beginning. Names without a blank are never broken. Letters may be coloured.
///
/// ```
/// let text = "error: model.osim: a sentence that is too long\n  in a table  a sentence that is too long\n";
/// let broken = osim_view::report::layout::break_long_lines(text, 30);
/// assert_eq!(
///     broken,
///     "error: model.osim: a sentence\n  that is too long\n\
///      \x20 in a table  a sentence that\n              is too long\n"
/// );
/// assert_eq!(osim_view::report::layout::break_long_lines(text, 80), text);
/// ```
pub fn break_long_lines(text: &str, width: usize) -> String {
    text.split_inclusive('\n').map(|line| break_long_line(line, width)).collect()
}

fn break_long_line(line: &str, width: usize) -> String {
    let (text, end) = line.strip_suffix('\n').map_or((line, ""), |text| (text, "\n"));
    let words = text.trim_start_matches(' ');
    if display_width(text) <= width || COMMAND_BEGINNINGS.iter().any(|command| words.starts_with(command)) {
        return line.to_owned();
    }
    let (head, sentence) = split_sentence(text);
    let hang = display_width(head)
        + if SEVERITY_BEGINNINGS.iter().any(|head| text.starts_with(head)) { 2 } else { 0 };
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

/// Splits a line into two parts: the indentation with the first cells of a table, and the sentence after these.
fn split_sentence(line: &str) -> (&str, &str) {
    let gap = line.rfind("  ").map_or(0, |at| at + 2);
    let sentence = line[gap..].trim_start_matches(' ');
    line.split_at(line.len() - sentence.len())
}

// Tables of text.

/// A table drawn only with letters that old consoles have. A cell is one line; invisible letters in it are escaped. Empty columns are left
/// out.
pub struct TextTable {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
    right_aligned: Vec<usize>,
    unbroken: Option<usize>,
}

pub fn table(header: &[&str]) -> TextTable {
    let header = header.iter().map(|text| (*text).to_owned()).collect();
    TextTable { header, rows: Vec::new(), right_aligned: Vec::new(), unbroken: None }
}

/// The width in columns that a shortened name has at least.
const LEAST_NAME_WIDTH: usize = 8;

impl TextTable {
    pub(crate) fn add_row(&mut self, cells: impl IntoIterator<Item = impl AsRef<str>>) {
        self.rows.push(cells.into_iter().map(|text| one_line(text.as_ref().to_owned())).collect());
    }

    /// Aligns these columns, counted from 0, to the right.
    pub(crate) fn right_aligned(&mut self, columns: &[usize]) {
        self.right_aligned = columns.to_vec();
    }

    /// Never breaks the texts of this column, counted from 0, into lines.
    pub(crate) fn unbroken(&mut self, index: usize) {
        self.unbroken = Some(index);
    }

    /// The table in lines of at most `width` columns. Longer cells are broken into several lines.
    pub fn fitted(self, width: usize) -> String {
        let mut table = self.laid_out();
        let width = u16::try_from(width).unwrap_or(u16::MAX);
        table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
        table.trim_fmt()
    }

    /// The table in lines of at most `columns`. Long names are cut in the middle, and columns that do not fit are put below the others;
    /// `None` means lines without a limit. There are no blanks at the ends of lines.
    pub(crate) fn into_lines(mut self, columns: Option<usize>) -> String {
        while let Some(excess) = columns.and_then(|columns| self.width().checked_sub(columns + 2)) {
            let names = (0..self.header.len()).filter(|index| !self.right_aligned.contains(index));
            let longest = names.map(|index| (self.column_width(index), index)).max();
            let Some((width, index)) = longest.filter(|(width, _)| *width > LEAST_NAME_WIDTH) else { break };
            let names: Vec<&str> = self.column(index).collect();
            let cut = cut_names(&names, width.saturating_sub(excess + 1).max(LEAST_NAME_WIDTH));
            if cut == names {
                break;
            }
            for (cell, name) in self.rows.iter_mut().filter_map(|row| row.get_mut(index)).zip(cut) {
                *cell = name;
            }
        }
        match columns.filter(|columns| self.width() > columns + 1) {
            Some(columns) => self.into_parts(columns),
            None => self.trim_fmt(),
        }
    }

    /// The table in lines, with a `note` below; empty without rows.
    pub(crate) fn text_if_any(self, columns: Option<usize>, note: &str) -> String {
        if self.rows.is_empty() { String::new() } else { format!("{}\n{note}", self.into_lines(columns)) }
    }

    /// The table in parts: as many columns as fit, and below them the first column with the next ones.
    fn into_parts(self, columns: usize) -> String {
        let all = self.header.len();
        let fit = (2..all).take_while(|&end| self.with_columns(0..end).width() <= columns + 1).last();
        let end = fit.unwrap_or(2);
        if end >= all {
            return self.trim_fmt();
        }
        let below = self.with_columns(std::iter::once(0).chain(end..all));
        format!("{}\n\n{}", self.with_columns(0..end).trim_fmt(), below.into_lines(Some(columns)))
    }

    fn with_columns(&self, chosen: impl Iterator<Item = usize>) -> Self {
        let chosen: Vec<usize> = chosen.collect();
        let cells = |row: &Vec<String>| -> Vec<String> {
            chosen.iter().map(|&index| row.get(index).cloned().unwrap_or_default()).collect()
        };
        let is_right =
            |place: &usize| chosen.get(*place).is_some_and(|index| self.right_aligned.contains(index));
        Self {
            header: cells(&self.header),
            rows: self.rows.iter().map(cells).collect(),
            right_aligned: (0..chosen.len()).filter(is_right).collect(),
            unbroken: None,
        }
    }

    /// The table without blanks at the ends of its lines.
    pub(crate) fn trim_fmt(&self) -> String {
        self.laid_out().trim_fmt()
    }

    fn column(&self, index: usize) -> impl Iterator<Item = &str> {
        self.rows.iter().map(move |row| row.get(index).map_or("", String::as_str))
    }

    fn is_empty_column(&self, index: usize) -> bool {
        !self.rows.is_empty() && self.column(index).all(|cell| cell.trim_ascii().is_empty())
    }

    fn column_width(&self, index: usize) -> usize {
        let header = self.header.get(index).map_or("", String::as_str);
        self.column(index).chain([header]).map(display_width).max().unwrap_or_default()
    }

    /// The width of a line in columns. Each cell has a blank on both sides.
    fn width(&self) -> usize {
        let shown = (0..self.header.len()).filter(|&index| !self.is_empty_column(index));
        shown.map(|index| self.column_width(index) + 2).sum()
    }

    fn laid_out(&self) -> Table {
        let shown: Vec<usize> =
            (0..self.header.len()).filter(|&index| !self.is_empty_column(index)).collect();
        let cells = |row: &[String]| -> Vec<String> {
            shown.iter().map(|&index| row.get(index).cloned().unwrap_or_default()).collect()
        };
        let mut table = Table::new();
        table.load_style(presets::NOTHING).set_header(cells(&self.header));
        table.add_rows(self.rows.iter().map(|row| cells(row)));
        for (place, index) in shown.iter().enumerate() {
            let Some(column) = table.column_mut(place) else { continue };
            if self.right_aligned.contains(index) {
                column.set_cell_alignment(CellAlignment::Right);
            }
            if self.unbroken == Some(*index) {
                column.set_constraint(ColumnConstraint::ContentWidth);
            }
        }
        table
    }
}

/// Names in at most `width` columns. They are cut in the middle so that different names stay different; if no cut does this, they are
/// longer.
pub(crate) fn cut_names(names: &[&str], width: usize) -> Vec<String> {
    let different = names.iter().collect::<HashSet<_>>().len();
    let longest = names.iter().map(|name| display_width(name)).max().unwrap_or_default();
    for width in width..longest {
        for end in [width / 2, width * 3 / 4, width / 4] {
            let cut: Vec<String> = names.iter().map(|name| cut_name(name, width, end)).collect();
            if cut.iter().collect::<HashSet<_>>().len() == different {
                return cut;
            }
        }
    }
    names.iter().map(|name| (*name).to_owned()).collect()
}

/// A name in at most `width` columns, of which the letters in the last `end` columns are kept.
fn cut_name(name: &str, width: usize, end: usize) -> String {
    if display_width(name) <= width || width < 3 {
        return name.to_owned();
    }
    let first = bytes_within(name.chars(), width - end - 1);
    let last = name.len() - bytes_within(name.chars().rev(), end);
    format!("{}~{}", &name[..first], &name[last..])
}

/// The number of bytes of the first `letters` that fit into `columns`.
fn bytes_within(letters: impl Iterator<Item = char>, columns: usize) -> usize {
    let fitting = letters.scan(columns, |left, letter| {
        *left = left.checked_sub(display_width(letter.encode_utf8(&mut [0; 4])))?;
        Some(letter.len_utf8())
    });
    fitting.sum()
}

/// A name in at most `width` columns. Its middle is left out, because names differ at their ends. Invisible letters are escaped.
pub(crate) fn shorten(name: &str, width: usize) -> String {
    cut_name(&shown(name).to_string(), width, width / 2)
}

// Tables as CSV.

/// The records as CSV. Cells are quoted if this is necessary.
///
/// # Errors
/// None in practice: the records are written into memory, and all of one table are equally long.
pub(crate) fn csv_text(records: impl IntoIterator<Item = Vec<String>>) -> Result<String, csv::Error> {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    for record in records {
        // One line for each record, whatever names hold.
        writer.write_record(
            record.iter().map(|text| with_text_mark(&shown_whole(text).to_string()).into_owned()),
        )?;
    }
    let bytes = writer.into_inner().map_err(IntoInnerError::into_error)?;
    String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error).into())
}

// Colours for verdicts that are readable without them.

/// The mark after a figure that is outside its limit.
pub(crate) const OUTSIDE_MARK: char = '!';

/// The colour of a figure that is outside its limit.
const STYLE_OF_OUTSIDE: Style = AnsiColor::Yellow.on_default().bold();

/// Whether a text has colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Colour {
    #[default]
    Plain,
    /// The text has colours, as escape sequences for terminals.
    Ansi,
}

/// A table with every figure that has an [`OUTSIDE_MARK`] mark in colour.
pub(crate) fn colour_marks(text: &str, colour: Colour) -> String {
    if colour == Colour::Plain {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(" !") {
        // The figure begins after the blanks between the columns.
        let (skipped, figure) = before.rsplit_once("  ").unwrap_or(("", before));
        let gap = if skipped.len() + figure.len() < before.len() { "  " } else { "" };
        out.push_str(&format!("{skipped}{gap}{STYLE_OF_OUTSIDE}{figure} {OUTSIDE_MARK}{STYLE_OF_OUTSIDE:#}"));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The word for a verdict's `sign` or for a severity, in its colour.
pub(crate) fn sign(sign: impl Into<Sign>, colour: Colour) -> String {
    let sign: Sign = sign.into();
    let style = match (colour, sign) {
        (Colour::Ansi, Sign::Error) => AnsiColor::Red.on_default().bold(),
        (Colour::Ansi, Sign::Warning) => STYLE_OF_OUTSIDE,
        _ => Style::new(),
    };
    format!("{style}{}{style:#}", sign.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(line: &str) -> Vec<String> {
        breakable_words(line).map(|word| format!("{}{}", word.word, word.whitespace)).collect()
    }

    #[test]
    fn lines_end_behind_blanks_but_not_at_hyphens_and_slashes() {
        assert_eq!(words("see  --contacts-mass KG"), ["see  ", "--contacts-mass ", "KG"]);
        assert_eq!(words("out/even/a_1.osim, 2 N/m^2"), ["out/even/a_1.osim, ", "2 ", "N/m^2"]);
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

    #[test]
    fn commands_and_rows_of_numbers_stay_whole() {
        for line in [
            "  $ osim-contact-scale design 'my model.osim' --indentation 0.16\n",
            "osim-contact-scale check model.osim --from generic.osim\n",
            " radius                   12 spheres    0.032     0.064171583      x2.005362  (8)\n",
            "/a/folder/with/a/long/name/and/another/one/model.osim\n",
        ] {
            assert_eq!(break_long_lines(line, 40), line);
        }
    }

    #[test]
    fn sentences_keep_their_place() {
        assert_eq!(
            break_long_lines("  Why: one two three four five six\n", 20),
            "  Why: one two three\n  four five six\n"
        );
        assert_eq!(break_long_lines("remark: one two three four", 16), "remark: one two\n  three four");
        // Two letters that fill no column, and a colour that fills none.
        assert_eq!(
            break_long_lines("\u{1b}[1mwarn\u{1b}[0m x̂ = x/R of the sphere", 17),
            "\u{1b}[1mwarn\u{1b}[0m x̂ = x/R of\nthe sphere"
        );
    }

    #[test]
    fn every_line_fits_and_no_word_is_lost() {
        let text = "error: a b cc ddd eeee fffff gggggg\n  good  floor  the floor leans by 0 degrees\n\n";
        // The sentence in the table has to have room for half a line.
        for width in 30..60 {
            let broken = break_long_lines(text, width);
            assert!(broken.lines().all(|line| line.len() <= width), "{width}: {broken}");
            let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
            assert_eq!(words(&broken), words(text));
            assert!(broken.ends_with("\n\n"));
        }
    }

    #[test]
    fn names_keep_both_ends() {
        assert_eq!(shorten("heel_r", 10), "heel_r");
        assert_eq!(shorten("SmoothSphere_forefoot_med_r", 11), "Smoot~med_r");
        assert_eq!(shorten("SmoothSphere_forefoot_med_r", 11).chars().count(), 11);
        // These letters have two columns each.
        assert_eq!(cut_names(&["足の接触球_踵_右", "足の接触球_踵_左"], 11), ["足の~踵_右", "足の~踵_左"]);
    }

    #[test]
    fn a_table_fits_and_its_names_stay_different() {
        let names = ["contact_of_the_left_heel_1_a", "contact_of_the_left_heel_2_a", "toe"];
        let rows = |columns| {
            let mut table = table(&["name", "", "value"]);
            names.iter().for_each(|name| table.add_row([name, "", "1.234"]));
            table.right_aligned(&[2]);
            table.into_lines(columns)
        };
        assert!(rows(None).contains(names[0]) && rows(Some(80)) == rows(None));
        for columns in 20..36 {
            let text = rows(Some(columns));
            assert!(text.lines().all(|line| line.chars().count() <= columns), "{columns}:\n{text}");
            assert!(text.lines().collect::<HashSet<_>>().len() == 4, "{columns}:\n{text}");
        }
    }

    #[test]
    fn only_what_is_outside_is_painted() {
        let style = AnsiColor::Yellow.on_default().bold();
        let text = "x/R   <= 0.16  0.12    0.35 !\nnext  1\n";
        let expected = format!("x/R   <= 0.16  0.12    {style}0.35 !{style:#}\nnext  1\n");
        assert_eq!(colour_marks(text, Colour::Ansi), expected);
        assert_eq!(colour_marks(text, Colour::Plain), text);
    }
}
