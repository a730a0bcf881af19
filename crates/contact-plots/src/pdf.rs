//! PDF from SVG: one page of the figure's size, lines as lines, text as text.

use krilla::Document;
use krilla::geom::Size;
use krilla::metadata::Metadata;
use krilla::page::PageSettings;
use krilla_svg::{SurfaceExt, SvgSettings};

use crate::error::PlotError;
use crate::tree::{UNITS_PER_INCH, tree};

/// Points to the inch in PDF.
const POINTS_PER_INCH: f32 = 72.0;

/// A figure as the bytes of a PDF file with one page of its size on paper. Its text can be selected and searched, and the
/// letters of the font that are used are in the file. `title` is what a reader shows as the title of the document.
///
/// # Errors
/// [`PlotError::Picture`] where the SVG is none, or has no size.
pub fn pdf(svg: &str, title: &str) -> Result<Vec<u8>, PlotError> {
    let failed = |why: &str| PlotError::Picture(why.to_owned());
    let tree = tree(svg)?;
    let points = |units: f32| units * POINTS_PER_INCH / UNITS_PER_INCH;
    let (width, height) = (points(tree.size().width()), points(tree.size().height()));
    let size = Size::from_wh(width, height).ok_or_else(|| failed("it has no size"))?;
    let mut document = Document::new();
    document.set_metadata(Metadata::new().title(title.to_owned()).creator("osim-contact-scale".to_owned()));
    {
        let mut page = document.start_page_with(PageSettings::new(size));
        let mut surface = page.surface();
        let drawn = surface.draw_svg(&tree, size, SvgSettings::default());
        surface.finish();
        page.finish();
        drawn.ok_or_else(|| failed("its lines could not be put on a page"))?;
    }
    document.finish().map_err(|error| PlotError::Picture(format!("{error:?}")))
}
