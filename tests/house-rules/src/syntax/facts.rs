//! What a module defines, imports, names and quotes.

use std::fmt;

/// The name spaces of Rust, as a set: a module and a function may share a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Spaces(u8);

impl Spaces {
    /// Structs, enums, traits, modules.
    pub(crate) const TYPES: Self = Self(1);
    /// Functions, constants, and what constructs a tuple struct.
    pub(crate) const VALUES: Self = Self(2);
    /// Both: where the source does not say which.
    pub(crate) const ITEMS: Self = Self(3);
    /// `macro_rules!`.
    pub(crate) const MACROS: Self = Self(4);
    /// Everything, modules as a whole too.
    pub(crate) const ALL: Self = Self(7);
    /// Nothing.
    pub(crate) const NONE: Self = Self(0);

    /// Whether they have a name space in common.
    pub(crate) const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// What is in one of them.
    pub(crate) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// From where something can be seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sight {
    /// From the module so many steps up, and all below it: 0 is private.
    Up(usize),
    /// From the ancestor at this depth, and all below it: 0 is the whole crate.
    Depth(usize),
}

impl Sight {
    /// Whether nobody but the module and those below it sees it.
    pub(crate) fn is_private(self) -> bool {
        self == Self::Up(0)
    }
}

/// A path as it is written, without generic arguments.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Path {
    /// It begins with `::`, so it is about another crate.
    pub(crate) global: bool,
    /// Its names.
    pub(crate) segments: Vec<String>,
}

impl Path {
    /// A path that does not begin with `::`.
    pub(crate) const fn of(segments: Vec<String>) -> Self {
        Self { global: false, segments }
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let start = if self.global { "::" } else { "" };
        write!(f, "{start}{}", self.segments.join("::"))
    }
}

/// Something that a module defines.
#[derive(Debug, Clone)]
pub(crate) struct Item {
    pub(crate) name: String,
    pub(crate) spaces: Spaces,
    /// A trait is used without being named, by calling its methods.
    pub(crate) is_trait: bool,
    /// Of an enum.
    pub(crate) variants: Vec<String>,
    pub(crate) sight: Sight,
    /// It stands in a function.
    pub(crate) local: bool,
}

/// One name, or all names, brought in by a `use`.
#[derive(Debug, Clone)]
pub(crate) struct Import {
    pub(crate) path: Path,
    /// What it is called here; `None` for `as _` and for a glob.
    pub(crate) name: Option<String>,
    /// It ends in `*`.
    pub(crate) glob: bool,
    /// `a::{self}` brings in the module `a` and no function of that name.
    pub(crate) spaces: Spaces,
    pub(crate) sight: Sight,
    /// It stands in a function.
    pub(crate) local: bool,
    pub(crate) line: usize,
}

/// A path outside of `use`.
#[derive(Debug, Clone)]
pub(crate) struct Mention {
    pub(crate) path: Path,
    /// What can be meant at this place. A module as a whole is meant only where this is [`Spaces::ALL`].
    pub(crate) want: Spaces,
    pub(crate) line: usize,
}

/// A string literal.
#[derive(Debug, Clone)]
pub(crate) struct Literal {
    /// As it stands in the source, with quotes and escapes.
    pub(crate) source: String,
    pub(crate) line: usize,
}

impl Literal {
    /// The source with blanks in the place of escapes, so that the `n` of `\n` is no letter of a word. Lines stay.
    pub(crate) fn without_escapes(&self) -> String {
        if self.source.trim_start_matches(['b', 'c']).starts_with('r') {
            return self.source.clone();
        }
        let mut text = String::with_capacity(self.source.len());
        let mut escaped = false;
        for c in self.source.chars() {
            let blank = escaped || c == '\\';
            escaped = !escaped && c == '\\';
            text.push(if blank && c != '\n' { ' ' } else { c });
        }
        text
    }
}

/// A doc comment: lines that follow each other are one.
#[derive(Debug, Clone)]
pub(crate) struct Doc {
    /// Its text, without the marks of the comment.
    pub(crate) text: String,
    pub(crate) line: usize,
}

/// A `macro_rules!`.
#[derive(Debug, Clone)]
pub(crate) struct MacroRules {
    pub(crate) name: String,
    /// Items whose names stand in its body: they come to be where it is called.
    pub(crate) defines: Vec<Item>,
}

/// All that the source of one module says, without test code.
#[derive(Debug, Default)]
pub(crate) struct Facts {
    pub(crate) items: Vec<Item>,
    pub(crate) imports: Vec<Import>,
    pub(crate) mentions: Vec<Mention>,
    pub(crate) literals: Vec<Literal>,
    pub(crate) docs: Vec<Doc>,
    pub(crate) macros: Vec<MacroRules>,
    /// Macros called where items stand.
    pub(crate) called: Vec<String>,
}

impl Facts {
    /// Adds a doc comment, to the one before it where that ends on the line above.
    pub(crate) fn doc(&mut self, text: &str, line: usize) {
        if let Some(last) = self.docs.last_mut()
            && last.line + last.text.matches('\n').count() + 1 == line
        {
            last.text.push('\n');
            last.text.push_str(text);
        } else {
            self.docs.push(Doc { text: text.to_owned(), line });
        }
    }
}
