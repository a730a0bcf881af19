//! Rust as tokens, without plain comments and without code that only tests compile.

use std::sync::LazyLock;

use regex::Regex;

/// A token: a name, keyword or number, a sign, `::`, a string that begins with `"`, or a doc comment that begins with `//`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Token {
    /// Its text. In strings, escapes are blanks; doc comments that follow each other are one.
    pub text: String,
    /// The line on which it begins, from 1.
    pub line: usize,
}

impl Token {
    /// The name, keyword or number that it is.
    #[must_use]
    pub fn word(&self) -> Option<&str> {
        self.text.starts_with(|c: char| c == '_' || c.is_alphanumeric()).then_some(&self.text)
    }

    /// Whether it is a string.
    #[must_use]
    pub fn is_string(&self) -> bool {
        self.text.starts_with('"')
    }

    /// Whether it is a doc comment.
    #[must_use]
    pub fn is_doc(&self) -> bool {
        self.text.starts_with("//")
    }
}

#[expect(clippy::expect_used, reason = "a constant, which each test of this crate uses")]
static TOKEN: LazyLock<Regex> = LazyLock::new(|| {
    let parts = [
        r"//[^\n]*|/\*.*?\*/",
        r####"[bc]?r"[^"]*"|[bc]?r#".*?"#|[bc]?r##".*?"##|[bc]?r###".*?"###"####,
        r#"[bc]?"(?:[^"\\]|\\.)*""#,
        r"b?'(?:[^'\\]|\\[^u]|\\x..|\\u\{\w+\})'|'\w+",
        r"(?:r#)?\w+|::|\S",
    ];
    Regex::new(&format!("(?s){}", parts.join("|"))).expect("a regular expression")
});

/// The tokens of a source, with those of tests.
#[must_use]
pub fn tokens(source: &str) -> Vec<Token> {
    let mut found: Vec<Token> = Vec::new();
    let (mut line, mut end) = (1, 0);
    for part in TOKEN.find_iter(source) {
        line += source[end..part.start()].matches('\n').count();
        let text = part.as_str();
        let is_doc = text.starts_with("///") && !text.starts_with("////") || text.starts_with("//!");
        match found.last_mut() {
            Some(before)
                if is_doc
                    && before.is_doc()
                    && before.line + before.text.matches('\n').count() + 1 == line =>
            {
                before.text.push('\n');
                before.text.push_str(&text[3..]);
            }
            _ if text.starts_with("//") && !is_doc
                || text.starts_with("/*")
                || text.ends_with('\'')
                || text.starts_with('\'') => {}
            _ => found.push(Token { text: plain(text), line }),
        }
        line += text.matches('\n').count();
        end = part.end();
    }
    found
}

/// A token as it is kept.
fn plain(text: &str) -> String {
    let Some(begin) = text.find('"').filter(|_| text.ends_with(['"', '#']) && text.len() > 1) else {
        return text.trim_start_matches("r#").to_owned();
    };
    let inside = text[begin..].trim_end_matches('#');
    if text[..begin].contains('r') {
        return inside.to_owned();
    }
    let mut escaped = false;
    let blanks = inside.chars().map(|c| {
        let is_escape = escaped || c == '\\';
        escaped = !escaped && c == '\\';
        if is_escape && c != '\n' { ' ' } else { c }
    });
    blanks.collect()
}

/// Whether the tokens at `at` are these.
#[must_use]
pub fn are(tokens: &[Token], at: usize, wanted: &[&str]) -> bool {
    let found = tokens.get(at..at + wanted.len());
    found.is_some_and(|found| found.iter().zip(wanted).all(|(token, wanted)| token.text == *wanted))
}

/// The tokens without those of items that only tests compile, and how many lines these have.
#[must_use]
pub fn without_tests(tokens: &[Token]) -> (Vec<Token>, usize) {
    let (mut left, mut lines, mut at) = (Vec::new(), 0, 0);
    while at < tokens.len() {
        if !are(tokens, at, &["#", "["]) || !is_of_tests(&tokens[at..group_end(tokens, at + 1)]) {
            left.push(tokens[at].clone());
            at += 1;
            continue;
        }
        let mut end = at;
        while are(tokens, end, &["#", "["]) {
            end = group_end(tokens, end + 1);
        }
        end = item_end(tokens, end);
        lines += tokens[end - 1].line + 1 - tokens[at].line;
        at = end;
    }
    (left, lines)
}

/// `#[test]`, or `#[cfg(…)]` with a condition that holds in tests alone.
fn is_of_tests(attribute: &[Token]) -> bool {
    let has = |word: &str| attribute.iter().any(|token| token.text == word);
    are(attribute, 2, &["test"]) || (are(attribute, 2, &["cfg"]) && has("test") && !has("not") && !has("any"))
}

/// The place after the group that begins at `at`.
#[must_use]
pub fn group_end(tokens: &[Token], at: usize) -> usize {
    let mut depth = 0_usize;
    for (place, token) in tokens.iter().enumerate().skip(at) {
        match token.text.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return place + 1;
        }
    }
    tokens.len()
}

/// The place after an item or a statement: after its `;`, its `{…}`, or before the end of what it is in.
fn item_end(tokens: &[Token], mut at: usize) -> usize {
    while let Some(token) = tokens.get(at) {
        match token.text.as_str() {
            ";" => return at + 1,
            "{" => return group_end(tokens, at),
            "(" | "[" => at = group_end(tokens, at),
            "}" | ")" | "]" => return at,
            _ => at += 1,
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(tokens: &[Token]) -> String {
        tokens.iter().map(|token| token.text.as_str()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn strings_comments_and_lifetimes() {
        let source = r####"/// one
/// two
fn r#f<'a>(x: &'a str) { g('"', '\'', b'\x00', b"b\n", r#"r"#, "--x\
  y", a::b) } // not "this" /* nor */
/* nor "that" */ r##"a"#b"## z"####;
        let expected = "/// one\n two fn f < > ( x : & str ) { g ( , , , \"b  \" , \"r\" , \"--x \n  y\" , a :: b ) } \"a\"#b\" z";
        let found = tokens(source);
        assert_eq!(shown(&found), expected);
        assert_eq!(found.last().map(|token| token.line), Some(5));
    }

    #[test]
    fn code_of_tests_is_left_out() {
        let source = "a;\n#[cfg(test)]\n#[rustfmt::skip]\nmod tests { fn f() -> [u8; 2] {} }\n#[cfg(not(test))]\nb; \
                      #[cfg(all(test, unix))] use c::{d, e}; #[test] fn g(x: [u8; 3]) { h } #[cfg(any(test, unix))] i;";
        let (left, lines) = without_tests(&tokens(source));
        assert_eq!(
            shown(&left),
            "a ; # [ cfg ( not ( test ) ) ] b ; ; # [ cfg ( any ( test , unix ) ) ] i ;"
        );
        assert_eq!(lines, 5);
    }
}
