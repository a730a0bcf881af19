//! A document with its title above, into which the rest is drawn.

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::error::PlotError;
use crate::figure::Width;
use crate::letters::lines;
use crate::paper::Paper;
use crate::style::{TITLE_PT, text, units};
use crate::svg::{Names, finished, printable};

pub(crate) const MARGIN_PT: f64 = 4.0;
const TITLE_LINE_PT: f64 = 9.6;
/// Below the last line of a title.
const TITLE_GAP_PT: f64 = 3.4;

pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A title, broken into lines where it is wider than its figure; none takes no room.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Title(Vec<String>);

impl Title {
    pub(crate) fn new(title: &str, width_pt: f64) -> Self {
        Self(lines(&printable(title), TITLE_PT, width_pt - 2.0 * MARGIN_PT))
    }

    /// Where what is below the title begins.
    pub(crate) fn bottom_pt(&self) -> f64 {
        let lines = f64::from(u32::try_from(self.0.len()).unwrap_or(u32::MAX));
        MARGIN_PT + if self.0.is_empty() { 0.0 } else { lines * TITLE_LINE_PT + TITLE_GAP_PT }
    }

    fn draw(&self, root: &Area<'_>, width_pt: f64) -> Result<(), PlotError> {
        let mut top = MARGIN_PT;
        for line in &self.0 {
            let style = text(TITLE_PT).pos(Pos::new(HPos::Center, VPos::Top));
            root.draw_text(line, &style, (units(width_pt / 2.0), units(top))).map_err(PlotError::drawing)?;
            top += TITLE_LINE_PT;
        }
        Ok(())
    }
}

/// The title and the names of a document, and how large it is.
pub(crate) struct Sheet<'s> {
    /// As wide as `paper` makes a figure of this width.
    pub(crate) width: Width,
    pub(crate) paper: Paper,
    /// The height of the layout, in points for letters of 7 points.
    pub(crate) height_pt: f64,
    pub(crate) title: &'s Title,
    pub(crate) names: Names<'s>,
}

/// An SVG document with its title drawn at the top; `draw` draws the rest.
pub(crate) fn document(
    sheet: &Sheet<'_>,
    draw: impl FnOnce(&Area<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let width_pt = sheet.paper.layout_pt(sheet.width);
    let size = (units(width_pt).unsigned_abs(), units(sheet.height_pt).unsigned_abs());
    let mut drawn = String::new();
    {
        let root = SVGBackend::with_string(&mut drawn, size).into_drawing_area();
        root.fill(&RGBColor(255, 255, 255)).map_err(PlotError::drawing)?;
        sheet.title.draw(&root, width_pt)?;
        draw(&root)?;
        root.present().map_err(PlotError::drawing)?;
    }
    finished(&drawn, size, sheet.paper.width_mm(sheet.width), sheet.names)
}
