//! Why a note is not believed.

/// Why the note in a file no longer describes its contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoteDoubt {
    /// There is none, and the sum of the bodies is not the mass: they were scaled.
    Absent,
    /// It cannot be read.
    Unreadable,
    /// Force set and geometry set carry notes of different runs.
    MixedPair,
    /// Values were changed since.
    ValuesChanged,
    /// The run that left it changed only some values.
    Partial,
    /// It says itself that the mass is not known.
    MassUnknown,
    /// It gives no mass because nobody said one, and the bodies, whose mass was taken, were scaled since.
    BodiesScaled,
}

impl NoteDoubt {
    /// In words.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Absent => "there is no note in the file, and the bodies were scaled",
            Self::Unreadable => "the note in the file cannot be read",
            Self::MixedPair => "the force set and its geometry set were not written by the same run",
            Self::ValuesChanged => "the values are no longer those the note was written for",
            Self::Partial => "only some values were changed by the run that left the note",
            Self::MassUnknown => "the mass was not known when the note was written",
            Self::BodiesScaled => "the note gives no mass, and the bodies were scaled since it was written",
        }
    }
}
