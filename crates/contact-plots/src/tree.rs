//! SVG as pixels and pages are made from it: read with a font of our own, so that pictures are the same on every machine.

use std::sync::{Arc, OnceLock};

use resvg::usvg::{self, Tree, fontdb::Database};

use crate::error::PlotError;
use crate::font::FONT;

/// The name of the font.
const FONT_NAME: &str = "Arimo";
/// Units to the inch in `usvg`.
pub(crate) const UNITS_PER_INCH: f32 = 96.0;

/// The font, read when the first picture is made.
fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let read = || {
        let mut fonts = Database::new();
        fonts.load_font_data(FONT.to_vec());
        fonts.set_sans_serif_family(FONT_NAME);
        Arc::new(fonts)
    };
    Arc::clone(FONTS.get_or_init(read))
}

/// A figure, read.
///
/// # Errors
/// [`PlotError::Picture`] where the SVG is none.
pub(crate) fn tree(svg: &str) -> Result<Tree, PlotError> {
    let options =
        usvg::Options { fontdb: fonts(), font_family: FONT_NAME.to_owned(), ..usvg::Options::default() };
    Tree::from_str(svg, &options).map_err(|error| PlotError::Picture(error.to_string()))
}
