//! Paths and texts in tokens: what stands in the call of a macro, in `macro_rules!` and in attributes.
//!
//! Nobody but the macro knows what its tokens mean, so everything that looks like a path is taken for one.

use proc_macro2::{Delimiter, Group, Ident, Literal as Token, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::Parser;
use syn::punctuated::Punctuated;

use super::facts::{Facts, Literal, Mention, Path, Spaces};
use super::imports::leaves;

/// Keys of attributes whose text is Rust: those of serde.
const KEYS: [&str; 12] = [
    "with",
    "serialize_with",
    "deserialize_with",
    "default",
    "skip_serializing_if",
    "getter",
    "remote",
    "from",
    "into",
    "try_from",
    "bound",
    "as",
];

/// Words before a name that is defined here, not used.
const DEFINING: [&str; 10] =
    ["fn", "struct", "enum", "union", "trait", "type", "const", "static", "mod", "macro_rules"];

/// Adds what stands in the tokens of a macro.
pub(crate) fn scan_macro(tokens: TokenStream, facts: &mut Facts) {
    Scan { facts, attribute: false, line: None }.stream(tokens);
}

/// Adds what stands in the tokens of an attribute, with the paths in its texts.
pub(crate) fn scan_attribute(tokens: TokenStream, facts: &mut Facts) {
    Scan { facts, attribute: true, line: None }.stream(tokens);
}

struct Scan<'f> {
    facts: &'f mut Facts,
    attribute: bool,
    /// The line of the text that is scanned, where the tokens are those of a text.
    line: Option<usize>,
}

impl Scan<'_> {
    fn stream(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at = match token {
                TokenTree::Ident(_) => self.path(&tokens, at),
                TokenTree::Group(group) => {
                    if is_doc(&tokens, at, group) {
                        self.doc(group);
                    } else if !is_visibility(&tokens, at, group) {
                        self.stream(group.stream());
                    }
                    at + 1
                }
                TokenTree::Literal(literal) => {
                    self.literal(&tokens, at, literal);
                    at + 1
                }
                TokenTree::Punct(_) => at + 1,
            };
        }
    }

    /// Takes the path that begins at `at`; returns where to go on.
    fn path(&mut self, tokens: &[TokenTree], at: usize) -> usize {
        let (names, next) = read_path(tokens, at);
        let Some(first) = names.first() else { return at + 1 };
        let line = self.line.unwrap_or(first.span().start().line);
        let mut segments: Vec<String> = names.iter().map(|name| name.unraw().to_string()).collect();
        let dollar = at.checked_sub(1).is_some_and(|at| is_punct(tokens.get(at), '$'));
        if dollar && segments[0] == "crate" {
            segments[0].insert(0, '$');
        }
        if !is_whole(tokens, at, &segments) {
            return next;
        }
        if let (true, Some(TokenTree::Group(group))) = (is_path_separator(tokens, next), tokens.get(next + 2))
        {
            self.group(&segments, group, line);
            return next + 3;
        }
        if let Some(want) = self.wanted(tokens, at, next, &segments) {
            self.mention(segments, want, line);
        }
        next
    }

    fn mention(&mut self, segments: Vec<String>, want: Spaces, line: usize) {
        self.facts.mentions.push(Mention { path: Path::of(segments), want, line });
    }

    /// `a::{b, c}`, as in a `use` in a macro.
    fn group(&mut self, prefix: &[String], group: &Group, line: usize) {
        let parser = Punctuated::<syn::UseTree, syn::Token![,]>::parse_terminated;
        match parser.parse2(group.stream()) {
            Ok(trees) => {
                for leaf in trees.iter().flat_map(|tree| leaves(tree, prefix)) {
                    self.mention(leaf.segments, Spaces::ALL, self.line.unwrap_or(leaf.line));
                }
            }
            Err(_) => {
                self.mention(prefix.to_vec(), Spaces::ALL, line);
                self.stream(group.stream());
            }
        }
    }

    /// What a path can mean; `None` for a lone word that is no name of an item, as far as one can see.
    fn wanted(&self, tokens: &[TokenTree], at: usize, next: usize, segments: &[String]) -> Option<Spaces> {
        let called = is_group(tokens.get(next), Delimiter::Parenthesis);
        if is_punct(tokens.get(next), '!') && matches!(tokens.get(next + 1), Some(TokenTree::Group(_))) {
            return Some(Spaces::MACROS);
        }
        let [word] = segments else { return Some(if called { Spaces::VALUES } else { Spaces::ALL }) };
        if self.line.is_some() && tokens.len() == 1 {
            return Some(Spaces::ALL);
        }
        let given = self.attribute && at.checked_sub(1).is_some_and(|at| is_punct(tokens.get(at), '='));
        let shouted = word.starts_with(char::is_uppercase);
        (called || given || shouted).then_some(if called { Spaces::VALUES } else { Spaces::ITEMS })
    }

    /// `[doc = "…"]`
    fn doc(&mut self, group: &Group) {
        if let Some(TokenTree::Literal(literal)) = group.stream().into_iter().nth(2)
            && let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string())
        {
            self.facts.doc(&text.value(), group.span_open().start().line);
        }
    }

    fn literal(&mut self, tokens: &[TokenTree], at: usize, literal: &Token) {
        let source = literal.to_string();
        if !source.contains('"') {
            return;
        }
        let line = self.line.unwrap_or(literal.span().start().line);
        if self.attribute {
            self.path_in_text(tokens, at, &source, line);
        }
        self.facts.literals.push(Literal { source, line });
    }

    /// `with = "crate::numbers"`: the text is a path.
    fn path_in_text(&mut self, tokens: &[TokenTree], at: usize, source: &str, line: usize) {
        let Some([TokenTree::Ident(key), TokenTree::Punct(equals)]) =
            at.checked_sub(2).and_then(|start| tokens.get(start..at))
        else {
            return;
        };
        let Ok(text) = syn::parse_str::<syn::LitStr>(source).map(|text| text.value()) else { return };
        let is_rust = KEYS.iter().any(|known| key == known)
            || ["crate::", "self::", "super::"].iter().any(|start| text.starts_with(start));
        if equals.as_char() == '='
            && is_rust
            && let Ok(inner) = text.parse::<TokenStream>()
        {
            Scan { facts: self.facts, attribute: false, line: Some(line) }.stream(inner);
        }
    }
}

/// The names from `at` on that are joined by `::`, and where they end.
fn read_path(tokens: &[TokenTree], at: usize) -> (Vec<&Ident>, usize) {
    let mut names = Vec::new();
    let mut next = at;
    while let Some(TokenTree::Ident(name)) = tokens.get(next) {
        names.push(name);
        next += 1;
        if !is_path_separator(tokens, next) || !matches!(tokens.get(next + 2), Some(TokenTree::Ident(_))) {
            break;
        }
        next += 2;
    }
    (names, next)
}

/// Whether the path at `at` begins there, and is no field, lifetime, metavariable, definition or path of another crate.
fn is_whole(tokens: &[TokenTree], at: usize, segments: &[String]) -> bool {
    let before = |back: usize| at.checked_sub(back).and_then(|at| tokens.get(at));
    let first = segments.first().map_or("", String::as_str);
    if matches!(first, "crate" | "$crate" | "super") || (first == "self" && segments.len() > 1) {
        return true;
    }
    match before(1) {
        Some(TokenTree::Punct(mark)) => match mark.as_char() {
            '\'' | '$' => false,
            '.' => is_punct(before(2), '.'),
            ':' => !is_punct(before(2), ':'),
            // `macro_rules! name`
            '!' => !matches!(before(2), Some(TokenTree::Ident(word)) if word == "macro_rules"),
            _ => true,
        },
        Some(TokenTree::Ident(word)) => segments.len() > 1 || !DEFINING.iter().any(|known| word == known),
        _ => true,
    }
}

/// `#[doc = …]`, which is what a doc comment becomes.
fn is_doc(tokens: &[TokenTree], at: usize, group: &Group) -> bool {
    group.delimiter() == Delimiter::Bracket
        && at.checked_sub(1).is_some_and(|at| is_punct(tokens.get(at), '#') || is_punct(tokens.get(at), '!'))
        && matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc")
}

/// `pub(crate)`, `pub(in crate::x)`.
fn is_visibility(tokens: &[TokenTree], at: usize, group: &Group) -> bool {
    let Some(TokenTree::Ident(word)) = at.checked_sub(1).and_then(|at| tokens.get(at)) else { return false };
    let Some(TokenTree::Ident(inside)) = group.stream().into_iter().next() else { return false };
    word == "pub" && ["crate", "self", "super", "in"].iter().any(|known| inside == known)
}

fn is_path_separator(tokens: &[TokenTree], at: usize) -> bool {
    is_punct(tokens.get(at), ':') && is_punct(tokens.get(at + 1), ':')
}

fn is_punct(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

fn is_group(token: Option<&TokenTree>, delimiter: Delimiter) -> bool {
    matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == delimiter)
}
