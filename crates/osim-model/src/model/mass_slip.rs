//! What makes a mass look like a slip.

/// One pound, by its definition of 1959.
pub(crate) const POUND_KG: f64 = 0.453_592_37;

/// What makes a mass look like a slip.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum MassSlip {
    /// As many grams as the bodies have kilograms.
    Grams,
    /// As many tonnes.
    Tonnes,
    /// As many pounds.
    Pounds,
    /// The bodies have as many pounds as this has kilograms.
    BodiesInPounds,
    /// The other rows of its table have.
    OthersInPounds,
    /// Ten times what the other rows of its table have.
    TenTimes,
    /// A tenth of it.
    Tenth,
    /// No animal weighs that.
    NoAnimal,
}
