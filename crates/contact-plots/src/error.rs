//! Errors of figures: their points, axes, names and sizes.

/// The reason why a figure was not drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A point of the curve with this label is not a number.
    #[error("the curve '{0}' has a point that is not a finite number, expected numbers only")]
    NotFinite(String),
    /// There is nothing to draw: the named part of the figure is missing.
    #[error("nothing to draw: {0}")]
    Empty(&'static str),
    /// A panel has more curves than a reader can distinguish by colour and dash.
    #[error("{count} curves cannot be distinguished, expected at most {most}")]
    TooMany {
        /// Number of curves in the panel.
        count: usize,
        /// Largest number of curves that can be distinguished.
        most: usize,
    },
    /// A logarithmic axis, by its label, has a value that is not above 0.
    #[error("the axis '{0}' is logarithmic, expected values above 0")]
    NotPositive(String),
    /// The caller gave more names than the figure has curves.
    #[error(
        "{wanted} names were given, and the figure has {} to name{}",
        counted_curves(.curves.len()),
        quoted_names(.curves)
    )]
    Names {
        /// Number of names that the caller gave for the curves.
        wanted: usize,
        /// Names of the curves in the figure.
        curves: Vec<String>,
    },
    /// The figure has no axis in the given direction, or several different axes.
    #[error("the figure has no single {which} axis to limit{}", quoted_names(.found))]
    NoAxis {
        /// The direction of the axis: `horizontal` or `vertical`.
        which: &'static str,
        /// Labels of the axes that the figure has.
        found: Vec<String>,
    },
    /// The values along an axis of cells, by its label, do not rise.
    #[error(
        "the values along the axis '{0}' do not rise, expected each once, from the smallest to the largest"
    )]
    NotRising(String),
    /// The limits of an axis, by its label, do not go from a smaller number to a larger one.
    #[error("the axis '{0}' has limits that are none, expected a number and a larger one")]
    Limits(String),
    /// There is not enough room on the paper.
    #[error(
        "{width_mm} mm are too narrow for letters of {text_pt} pt, expected a width of at least {least_mm:.0} mm"
    )]
    TooNarrow {
        /// The width of the figure that the caller wants, mm.
        width_mm: f64,
        /// The size of the letters, points.
        text_pt: f64,
        /// The smallest possible width for these letters, mm.
        least_mm: f64,
    },
    /// A picture with more pixels than may fit into memory.
    #[error(
        "{width} × {height} pixels are more than the {} million that a picture may have: say a smaller dpi or width",
        .most / 1_000_000
    )]
    TooManyPixels {
        /// Number of pixels from left to right.
        width: u32,
        /// Number of pixels from top to bottom.
        height: u32,
        /// Largest number of pixels that a picture may have.
        most: u64,
    },
    /// The plotting library reports this error.
    #[error("the figure could not be drawn: {0}")]
    Drawing(String),
    /// The PNG or the PDF could not be made.
    #[error("the picture could not be made: {0}")]
    Picture(String),
}

impl PlotError {
    pub(crate) fn drawing(error: impl std::fmt::Display) -> Self {
        Self::Drawing(error.to_string())
    }
}

fn counted_curves(curves: usize) -> String {
    match curves {
        0 => "no curve".to_owned(),
        1 => "1 curve".to_owned(),
        more => format!("{more} curves"),
    }
}

/// The names in quotation marks, after a colon; an empty text if there are no names.
fn quoted_names(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
    if quoted.is_empty() { String::new() } else { format!(": {}", quoted.join(", ")) }
}
