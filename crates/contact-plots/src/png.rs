//! PNG from SVG.

use resvg::tiny_skia;

use crate::error::PlotError;
use crate::tree::{UNITS_PER_INCH, tree};

/// Pixels of the largest picture. Making one takes 7 bytes a pixel.
const MOST_PIXELS: u64 = 100_000_000;

/// The picture of a figure, as the bytes of a PNG file: white below, `dpi` pixels to the inch of its size on paper.
///
/// # Errors
/// [`PlotError::Picture`] where the SVG is none, [`PlotError::TooManyPixels`] where the picture would be too large.
pub fn png(svg: &str, dpi: f32) -> Result<Vec<u8>, PlotError> {
    let raster = |error: &dyn std::fmt::Display| PlotError::Picture(error.to_string());
    let tree = tree(svg)?;
    let scale = dpi / UNITS_PER_INCH;
    let size = tree.size().to_int_size().scale_by(scale).ok_or_else(|| raster(&"no size"))?;
    let (width, height) = (size.width(), size.height());
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(PlotError::TooManyPixels { width, height, most: MOST_PIXELS });
    }
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(|| raster(&"it has no pixels"))?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    encoded(&pixels, dpi).map_err(|error| raster(&error))
}

/// PNG bytes that say how large a pixel is, so that word processors place the figure in its true size.
fn encoded(pixels: &tiny_skia::Pixmap, dpi: f32) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "some thousand pixels to the metre"
    )]
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
