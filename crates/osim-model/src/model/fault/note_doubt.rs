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
            Self::Absent => "the bodies were scaled, and the file has no note of this program",
            Self::Unreadable => "the note that this program left in the file is damaged",
            Self::MixedPair => "the force set and its geometry set come from different runs",
            Self::ValuesChanged => "contacts were changed after this program left its note in the file",
            Self::Partial => "the run that left the note in the file changed only some values",
            Self::MassUnknown => "the mass was not known when this program left its note in the file",
            Self::BodiesScaled => {
                "the note in the file gives no mass, and the bodies were scaled after it was written"
            }
        }
    }
}
