//! Figures as PNG and PDF. Both are made from the SVG with the same built-in font, so that they are equal on every machine.

use std::sync::{Arc, OnceLock};

#[cfg(feature = "pdf")]
use krilla::{Document, geom::Size, metadata::Metadata, page::PageSettings};
#[cfg(feature = "pdf")]
use krilla_svg::{SurfaceExt, SvgSettings};
#[cfg(feature = "png")]
use resvg::tiny_skia;
use resvg::usvg::{self, Tree, fontdb::Database};

use crate::error::PlotError;
use crate::text_width::FONT;

/// Family name of the built-in font.
const FONT_NAME: &str = "Arimo";
/// Units of `usvg` per inch.
const UNITS_PER_INCH: f32 = 96.0;

/// The built-in font, which is read when the first picture is made.
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

/// The parsed SVG of a figure.
///
/// # Errors
/// [`PlotError::Picture`]: `svg` is not a valid SVG.
fn parsed_svg(svg: &str) -> Result<Tree, PlotError> {
    let options =
        usvg::Options { fontdb: fonts(), font_family: FONT_NAME.to_owned(), ..usvg::Options::default() };
    Tree::from_str(svg, &options).map_err(|error| PlotError::Picture(error.to_string()))
}

/// The largest number of pixels in a picture. Memory for 7 bytes per pixel is needed.
#[cfg(feature = "png")]
const MOST_PIXELS: u64 = 100_000_000;

/// A figure as the bytes of a PNG file with a white background and `dpi` pixels per inch of its size on paper.
///
/// # Errors
/// [`PlotError::Picture`]: `svg` is not a valid SVG; [`PlotError::TooManyPixels`]: the picture would be too large.
#[cfg(feature = "png")]
pub fn png(svg: &str, dpi: f32) -> Result<Vec<u8>, PlotError> {
    let raster = |error: &dyn std::fmt::Display| PlotError::Picture(error.to_string());
    let tree = parsed_svg(svg)?;
    let scale = dpi / UNITS_PER_INCH;
    let size = tree.size().to_int_size().scale_by(scale).ok_or_else(|| raster(&"no size"))?;
    let (width, height) = (size.width(), size.height());
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(PlotError::TooManyPixels { width, height, most: MOST_PIXELS });
    }
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(|| raster(&"it has no pixels"))?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    encoded_png(&pixels, dpi).map_err(|error| raster(&error))
}

/// The bytes of a PNG file that contains the size of a pixel, so that word processors place the figure in its true size.
#[cfg(feature = "png")]
fn encoded_png(pixels: &tiny_skia::Pixmap, dpi: f32) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let per_metre = (dpi / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    // Nothing shows through white: colours are plain already.
    let rgb: Vec<u8> =
        pixels.data().chunks_exact(4).flat_map(|pixel| pixel.iter().take(3).copied()).collect();
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(bytes)
}

/// Points per inch in PDF.
#[cfg(feature = "pdf")]
const POINTS_PER_INCH: f32 = 72.0;

/// A figure as the bytes of a PDF file with one page of the figure's size on paper. Its text can be selected and searched, and
/// the file contains the used letters of the font. `title` is the document title that a PDF reader shows.
///
/// # Errors
/// [`PlotError::Picture`]: `svg` is not a valid SVG, or it has no size.
#[cfg(feature = "pdf")]
pub fn pdf(svg: &str, title: &str) -> Result<Vec<u8>, PlotError> {
    let failed = |why: &str| PlotError::Picture(why.to_owned());
    let tree = parsed_svg(svg)?;
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
