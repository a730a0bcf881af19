//! What can be wrong with the points of a figure.

/// Why a figure was not drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A point is not a number.
    #[error("the curve '{curve}' has a point that is not a finite number, expected numbers only")]
    NotFinite {
        /// The curve's label.
        curve: String,
    },
    /// There is nothing to draw.
    #[error("nothing to draw: {what}")]
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// More curves than can be distinguished.
    #[error("{count} curves cannot be distinguished, expected at most {most}")]
    TooMany {
        /// How many there are.
        count: usize,
        /// How many may be.
        most: usize,
    },
    /// A logarithmic axis has a value that is not above 0.
    #[error("the axis '{axis}' is logarithmic, expected values above 0")]
    NotPositive {
        /// The axis's label.
        axis: String,
    },
    /// The plotting library did not get through.
    #[error("the figure could not be drawn: {0}")]
    Drawing(String),
    /// The pixels could not be made.
    #[error("the picture could not be made: {0}")]
    Raster(String),
}

impl PlotError {
    pub(crate) fn drawing(error: impl std::fmt::Display) -> Self {
        Self::Drawing(error.to_string())
    }
}
