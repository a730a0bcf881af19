//! What was measured, and what of it is fitted.

/// What was measured, one value per row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement<'a> {
    /// Indentation x, in m; the zero may be anywhere if the onset is fitted.
    pub indentation_m: &'a [f64],
    /// Force of all spheres together, in N; above 0 where they are pressed.
    pub force_n: &'a [f64],
    /// How fast the indentation changes, if that is known. Without it α is not fitted.
    pub rate: Rate<'a>,
}

/// How fast the indentation changes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Rate<'a> {
    /// Not known: the force is taken as the elastic one.
    Unknown,
    /// ẋ, in m/s, positive while going in.
    Speed(&'a [f64]),
    /// Time, in s, rising from row to row; ẋ is taken from it by differences over three rows.
    Time(&'a [f64]),
}

/// Where contact begins: it is known or it is not, so that a match on it is complete.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Onset {
    /// At this indentation, in m: usually 0.
    At(f64),
    /// Not known, to be fitted.
    Fitted,
}

/// The part of the measurement to fit: one way, the other, or both; there is no fourth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// All of it.
    Both,
    /// Going in: ẋ ≥ 0, or the rows up to the deepest where no rate is known.
    Loading,
    /// Coming out: ẋ < 0, or the rows after the deepest where no rate is known.
    Unloading,
}

/// What the fit has to know, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitValues {
    /// Sphere radius R, in m.
    pub radius_m: f64,
    /// Spheres n that share the force.
    pub sphere_count: f64,
    /// Where contact begins.
    pub onset: Onset,
    /// The part of the measurement to fit.
    pub branch: Branch,
}
