//! One renderer each for people and for scripts; all of them read the plan or the model and decide nothing.

pub(crate) mod changes;
pub(crate) mod diff;
pub(crate) mod json;
pub(crate) mod paint;

pub(crate) use osim_patch::readable as number;

/// A table that fits a terminal of 80 columns, without lines that old consoles cannot draw.
pub(crate) fn table(header: &[&str]) -> comfy_table::Table {
    let mut table = comfy_table::Table::new();
    table.load_style(comfy_table::presets::NOTHING).set_header(header.to_vec());
    table
}

/// Aligns columns `columns` to the right.
pub(crate) fn right(table: &mut comfy_table::Table, columns: &[usize]) {
    for &index in columns {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(comfy_table::CellAlignment::Right);
        }
    }
}

/// Columns of an old terminal.
pub(crate) const WIDTH: usize = 80;

/// Text in lines of at most [`WIDTH`] columns, the second and later ones behind `indent`.
pub(crate) fn wrapped(text: &str, indent: &str) -> String {
    // Options such as --contacts-mass are never parted at their hyphens.
    let options = textwrap::Options::new(WIDTH)
        .subsequent_indent(indent)
        .break_words(false)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    format!("{}\n", textwrap::fill(text, options))
}

/// A name in at most `width` columns: its middle is left out, since names differ at their ends.
pub(crate) fn clipped(name: &str, width: usize) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= width || width < 3 {
        return name.to_owned();
    }
    let end = width / 2;
    let start = width - end - 1;
    let (first, last) = (letters.iter().take(start), letters.iter().skip(letters.len() - end));
    first.chain(&['~']).chain(last).collect()
}

/// Four significant digits, to compare by eye.
pub(crate) fn four(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    number(rounded)
}

/// As a shell takes it for one word.
pub(crate) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_-./:,+=@%".contains(c) || (cfg!(windows) && c == '\\');
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    if cfg!(windows) { format!("\"{text}\"") } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_one_word() {
        assert_eq!(quoted("models/a_1.osim"), "models/a_1.osim");
        if !cfg!(windows) {
            assert_eq!(quoted("my model.osim"), "'my model.osim'");
            assert_eq!(quoted("it's"), r"'it'\''s'");
        }
    }

    #[test]
    fn names_keep_both_ends() {
        assert_eq!(clipped("heel_r", 10), "heel_r");
        assert_eq!(clipped("SmoothSphere_forefoot_med_r", 11), "Smoot~med_r");
        assert_eq!(clipped("SmoothSphere_forefoot_med_r", 11).chars().count(), 11);
    }

    #[test]
    fn four_digits_are_kept() {
        assert_eq!(four(0.353_300_157), "0.3533");
        assert_eq!(four(13_449.52), "13450");
    }
}
