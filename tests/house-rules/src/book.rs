//! The size of the book, and the length of its sentences.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;

/// What the pages may have: `book.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Book {
    /// Words of all pages of `docs/` together.
    pub docs: usize,
    /// Words of a sentence, on average of a page.
    pub sentence: f64,
    /// Words of the longest one.
    pub longest: usize,
    /// Words of each page.
    pub pages: BTreeMap<String, usize>,
}

impl Book {
    /// What is too much of these pages, and which ones are in only one of the folder and the table.
    #[must_use]
    pub fn faults(&self, pages: &[(String, String)]) -> Vec<String> {
        let names: BTreeSet<&str> = pages.iter().map(|(name, _)| name.as_str()).collect();
        let lost = self.pages.keys().filter(|name| !names.contains(name.as_str()));
        let mut found: Vec<String> =
            lost.map(|name| format!("{name}: in book.toml, but not there")).collect();
        for (name, text) in pages {
            let words = words(text);
            match self.pages.get(name) {
                None => found.push(format!("{name}: not in book.toml ({words} words)")),
                Some(&most) if words > most => found.push(format!("{name}: {words} words, at most {most}")),
                Some(_) => {}
            }
            let sentences = sentences(text);
            let (mean, longest) = (mean(&sentences), sentences.into_iter().max().unwrap_or(0));
            if mean > self.sentence {
                found.push(format!("{name}: {mean:.1} words a sentence, at most {}", self.sentence));
            }
            if longest > self.longest {
                found.push(format!("{name}: a sentence of {longest} words, at most {}", self.longest));
            }
        }
        let docs: usize =
            pages.iter().filter(|(name, _)| name.starts_with("docs/")).map(|(_, text)| words(text)).sum();
        if docs > self.docs {
            found.push(format!("docs/: {docs} words, at most {}", self.docs));
        }
        found
    }
}

/// As `wc -w` counts them.
#[must_use]
pub fn words(text: &str) -> usize {
    text.split_whitespace().count()
}

/// Words of each sentence of the prose of a page. Code, tables and headings are no prose; a code span is one word.
#[must_use]
pub fn sentences(page: &str) -> Vec<usize> {
    paragraphs(page).iter().flat_map(|paragraph| lengths(&paragraph.replace("](", "] ("))).collect()
}

fn mean(lengths: &[usize]) -> f64 {
    let sum: usize = lengths.iter().sum();
    #[expect(clippy::cast_precision_loss, reason = "a page has few words")]
    let mean = sum as f64 / lengths.len().max(1) as f64;
    mean
}

/// Paragraphs and items of lists, without code, tables, headings and comments.
fn paragraphs(page: &str) -> Vec<String> {
    let (mut found, mut open, mut in_code) = (Vec::new(), String::new(), false);
    for line in page.lines().map(str::trim) {
        let is_fence = line.starts_with("```");
        in_code ^= is_fence;
        let is_prose = !in_code && !is_fence && !line.starts_with(['|', '#', '<', '!']);
        let item = ["- ", "* ", "> "]
            .into_iter()
            .find_map(|mark| line.strip_prefix(mark))
            .or_else(|| numbered(line));
        if !is_prose || line.is_empty() || item.is_some() {
            found.push(std::mem::take(&mut open));
        }
        if is_prose {
            open.push_str(item.unwrap_or(line));
            open.push(' ');
        }
    }
    found.push(open);
    found.retain(|paragraph| !paragraph.trim().is_empty());
    found
}

/// What comes after `1. `.
fn numbered(line: &str) -> Option<&str> {
    let (number, rest) = line.split_once(". ")?;
    number.parse::<u32>().ok().map(|_| rest)
}

/// The words of each sentence in a paragraph.
fn lengths(paragraph: &str) -> Vec<usize> {
    let (mut found, mut length, mut is_in_code) = (Vec::new(), 0, false);
    for word in paragraph.split_whitespace() {
        // Addresses of links come after their text.
        let is_address =
            word.starts_with('(') && (word.contains(".md") || word.contains("://") || word.starts_with("(#"));
        let begins_in_code = is_in_code;
        is_in_code ^= word.matches('`').count() % 2 == 1;
        let counts = !begins_in_code && !is_address && word.chars().any(char::is_alphanumeric);
        length += usize::from(counts);
        if !is_in_code && length > 0 && is_end(word) {
            found.push(length);
            length = 0;
        }
    }
    found.extend((length > 0).then_some(length));
    found
}

/// Whether a sentence ends with a word: not after `Fig.`, `e.g.` and the letter of a first name.
fn is_end(word: &str) -> bool {
    let word = word.trim_end_matches([')', '*', '_', '"', '\'', '`', ']']);
    let Some(before) = word.strip_suffix(['.', '!', '?']) else { return false };
    let is_initial = before.len() == 1 && before.chars().all(char::is_uppercase);
    !is_initial
        && !["Fig", "Figs", "e.g", "i.e", "al", "Eq", "No"].contains(&before.trim_start_matches(['(', '*']))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn book() -> Book {
        Book {
            docs: 8,
            sentence: 5.0,
            longest: 6,
            pages: [("README.md".to_owned(), 4), ("docs/a.md".to_owned(), 6)].into(),
        }
    }

    #[track_caller]
    fn finds(pages: [(&str, &str); 2], expected: &[&str]) {
        let pages = pages.map(|(name, text)| (name.to_owned(), text.to_owned()));
        assert_eq!(book().faults(&pages), expected);
    }

    #[test]
    fn small_pages_pass() {
        finds([("README.md", "# Title\n\nOne two."), ("docs/a.md", "One.\nTwo three four five.")], &[]);
    }

    #[test]
    fn pages_that_are_too_large() {
        finds(
            [("README.md", "One. Two. Three. Four. Five."), ("docs/a.md", "One. Two.\n\n| three | four |")],
            &["README.md: 5 words, at most 4", "docs/a.md: 7 words, at most 6"],
        );
    }

    #[test]
    fn a_book_that_is_too_large() {
        let mut book = book();
        book.docs = 1;
        let pages = [("README.md", "One."), ("docs/a.md", "One two.")];
        let pages = pages.map(|(name, text)| (name.to_owned(), text.to_owned()));
        assert_eq!(book.faults(&pages), ["docs/: 2 words, at most 1"]);
    }

    #[test]
    fn long_sentences() {
        finds(
            [("README.md", "A."), ("docs/a.md", "one two three\nfour five six")],
            &["docs/a.md: 6.0 words a sentence, at most 5"],
        );
    }

    #[test]
    fn a_long_sentence_among_short_ones() {
        let mut book = book();
        book.longest = 3;
        let pages = [("README.md", "One two. Three."), ("docs/a.md", "One two three four. Five.")];
        let pages = pages.map(|(name, text)| (name.to_owned(), text.to_owned()));
        assert_eq!(book.faults(&pages), ["docs/a.md: a sentence of 4 words, at most 3"]);
    }

    #[test]
    fn pages_without_a_limit_and_limits_without_a_page() {
        finds(
            [("README.md", ""), ("docs/b.md", "")],
            &["docs/a.md: in book.toml, but not there", "docs/b.md: not in book.toml (0 words)"],
        );
    }

    #[test]
    fn what_a_sentence_is() {
        let lengths = |text: &str| sentences(text);
        assert_eq!(lengths("One two. Three (four)? Five"), [2, 2, 1]);
        assert_eq!(lengths("One\ntwo.\n\nThree"), [2, 1]);
        assert_eq!(lengths("- one two\n- three\n  four\n1. five"), [2, 2, 1]);
        assert_eq!(lengths("# Title\n\n|a b|\n\n```text\nc d. e.\n```\n<!-- f -->"), Vec::<usize>::new());
        assert_eq!(lengths("See `a b c. d`, Fig. 4 of P. A. Writer."), [8]);
        assert_eq!(lengths("A 1.5 [link here](../a.md#b) and [b](https://c.org/d.)."), [6]);
        assert_eq!(lengths("one - two = three"), [3]);
    }
}
