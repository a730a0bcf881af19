//! The six questions that are answered of every model, and one more of a model with a recording.

/// What a verdict is on. Each rule about a model belongs to one of them, or to none.
///
/// Exhaustive: there are six, and one more where a recording is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum VerdictOn {
    /// Whether the floor is one: its direction and place, what it hangs on, and gravity.
    Floor,
    /// Whether the model stands at its default pose, and what puts it on its feet.
    Standing,
    /// Whether the contacts fit the mass of the body.
    Mass,
    /// Whether left and right agree.
    Sides,
    /// Whether sizes and places of spheres are believable.
    Sizes,
    /// Whether a solver can live with the contacts: smoothing, speeds, restitution.
    Solver,
    /// Whether the contacts fit a recording: their forces beside those of force plates.
    Recording,
}

impl VerdictOn {
    /// Those of every model, in the order in which they are shown.
    pub const ALL: [Self; 6] =
        [Self::Floor, Self::Standing, Self::Mass, Self::Sides, Self::Sizes, Self::Solver];

    /// As in JSON and tables.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Standing => "standing",
            Self::Mass => "mass",
            Self::Sides => "sides",
            Self::Sizes => "sizes",
            Self::Solver => "solver",
            Self::Recording => "motion",
        }
    }

    /// The question that it answers.
    #[must_use]
    pub const fn question(self) -> &'static str {
        match self {
            Self::Floor => "Is the floor a floor?",
            Self::Standing => "Does it stand?",
            Self::Mass => "Do the contacts fit the mass?",
            Self::Sides => "Do left and right agree?",
            Self::Sizes => "Are sizes and places believable?",
            Self::Solver => "Can a solver live with it?",
            Self::Recording => "Does it fit the recording?",
        }
    }
}
