//! What options need and exclude: the same for the words of a command line and for a dictionary.

/// How options depend on each other; each is named by its field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// It is required.
    Required(&'static str),
    /// It is required in a dictionary; the command line asks for it in its own words.
    Expected(&'static str),
    /// It is required if the other is absent.
    RequiredUnless(&'static str, &'static str),
    /// The same; the command line asks for it in its own words.
    ExpectedUnless(&'static str, &'static str),
    /// It has no meaning without the other.
    Needs(&'static str, &'static str),
    /// Only one of the two can be given.
    Excludes(&'static str, &'static str),
}

impl Relation {
    /// The field that it is about.
    #[must_use]
    pub const fn field(self) -> &'static str {
        match self {
            Self::Required(field)
            | Self::Expected(field)
            | Self::RequiredUnless(field, _)
            | Self::ExpectedUnless(field, _)
            | Self::Needs(field, _)
            | Self::Excludes(field, _) => field,
        }
    }
}
