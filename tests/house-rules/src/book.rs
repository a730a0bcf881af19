//! The length of sentences in the book.

/// Words of each sentence of the prose of a page. Code, tables and headings are no prose; a code span is one word.
#[must_use]
pub fn sentences(page: &str) -> Vec<usize> {
    paragraphs(page).iter().flat_map(|paragraph| lengths(&paragraph.replace("](", "] ("))).collect()
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
