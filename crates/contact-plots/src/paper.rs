//! How large a figure is on paper.

use crate::error::PlotError;
use crate::figure::Width;
use crate::style::TEXT_PT;

/// How wide a figure is on paper, and how large its letters are.
///
/// Everything of a figure (margins, dashes, gaps) grows with its letters, so that a figure with larger letters is drawn as
/// one on smaller paper and then enlarged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paper {
    /// The width in mm; `None` for the figure's own.
    pub width_mm: Option<f64>,
    /// The size of its letters in points (1/72 inch); titles are a little larger.
    pub text_pt: f64,
}

impl Default for Paper {
    fn default() -> Self {
        Self { width_mm: None, text_pt: TEXT_PT }
    }
}

/// Less than this between the axes, in points for letters of 7 points, shows nothing.
const LEAST_PLOT_PT: f64 = 60.0;

impl Paper {
    /// The width in mm of a figure that is `own` by itself.
    pub(crate) fn width_mm(self, own: Width) -> f64 {
        self.width_mm.unwrap_or(own.mm())
    }

    /// The width to lay a figure out in, in points for letters of [`TEXT_PT`].
    pub(crate) fn layout_pt(self, own: Width) -> f64 {
        self.width_mm(own) / 25.4 * 72.0 / self.enlarged()
    }

    /// How much what was laid out is enlarged.
    fn enlarged(self) -> f64 {
        self.text_pt / TEXT_PT
    }

    /// Refuses a paper on which `beside_pt` leaves too little room for what is drawn between the axes.
    ///
    /// # Errors
    /// [`PlotError::TooNarrow`].
    pub(crate) fn check(self, own: Width, beside_pt: f64) -> Result<(), PlotError> {
        let least_mm = (beside_pt + LEAST_PLOT_PT) * self.enlarged() / 72.0 * 25.4;
        let width_mm = self.width_mm(own);
        if width_mm.is_finite() && self.text_pt > 0.0 && width_mm >= least_mm {
            return Ok(());
        }
        Err(PlotError::TooNarrow { width_mm, text_pt: self.text_pt, least_mm: least_mm.ceil() })
    }
}
