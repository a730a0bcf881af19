//! Sizes, colours and dashes.
//!
//! The plotting library draws in whole pixels. A figure is therefore drawn with [`UNITS_PER_PT`] pixels per point, and its
//! `viewBox` scales it to its size.

use plotters::style::{Color, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle};
use plotters::style::{FontDesc, IntoFont};

/// Drawing units per point (1/72 inch).
pub(crate) const UNITS_PER_PT: f64 = 20.0;
/// Size of letters of ticks, labels and legends, pt; journals ask for at least this size.
pub(crate) const TEXT_PT: f64 = 7.0;
/// Size of letters of titles, pt.
pub(crate) const TITLE_PT: f64 = 8.0;
/// Fonts for the texts: Arial, or a font of the same metrics: Helvetica on macOS, Liberation Sans or Arimo (also used for PNG) on
/// Linux.
pub(crate) const FONT_FAMILIES: &str = "Arial, Helvetica, 'Liberation Sans', Arimo, sans-serif";

/// The colour of axes and texts.
pub(crate) const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
/// The colour of the lines at limits.
pub(crate) const LIMIT: RGBColor = RGBColor(0x66, 0x66, 0x66);
/// The colour of a shaded area.
pub(crate) const SHADE_COLOUR: RGBColor = RGBColor(0xD5, 0x5E, 0x00);
/// Opacity of a shaded area, from 0 to 1.
pub(crate) const SHADE_OPACITY: f64 = 0.28;

/// Converts points to drawing units.
pub(crate) fn units(pt: f64) -> i32 {
    (pt * UNITS_PER_PT).round() as i32
}

/// Converts a count to a floating-point number.
pub(crate) fn float(count: usize) -> f64 {
    count as f64
}

/// A text style with letters of `size_pt`; never bold, because the font of PNG pictures has no bold letters.
pub(crate) fn text<'a>(size_pt: f64) -> TextStyle<'a> {
    // The library divides every font size by 1.24 when it writes SVG.
    let size = size_pt * UNITS_PER_PT * 1.24;
    let font: FontDesc<'a> = FontDesc::new(FontFamily::Name(FONT_FAMILIES), size, FontStyle::Normal);
    TextStyle::from(font.into_font()).color(&INK).transform(FontTransform::None)
}

/// A line style with a width in points.
pub(crate) fn stroke(colour: RGBColor, width_pt: f64) -> ShapeStyle {
    colour.stroke_width(units(width_pt).unsigned_abs())
}

/// The dashes of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Dash {
    /// A line without gaps.
    Solid,
    /// A line of long dashes.
    Dashed,
    /// A line of longer dashes.
    LongDashed,
    /// A line of short dashes, like dots.
    Dotted,
}

impl Dash {
    /// Lengths of dash and gap, in points; `None` for a solid line.
    pub(crate) fn lengths_pt(self) -> Option<(f64, f64)> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some((4.0, 2.0)),
            Self::LongDashed => Some((10.0, 2.2)),
            Self::Dotted => Some((1.5, 1.5)),
        }
    }
}

/// The look of a curve: a colour (red, green, blue), a dash, a width in points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Red, green and blue, 0 to 255.
    pub colour: (u8, u8, u8),
    /// Dash of the line.
    pub dash: Dash,
    /// Width of the line, in points.
    pub width_pt: f64,
}

impl Look {
    /// The look of the Hertz law without smoothing.
    pub const HERTZ: Self = Self::of((0x00, 0x72, 0xB2), Dash::Solid, 1.1);
    /// The look of the Hertz law with the constant indentation.
    pub const WITH_CONSTANT: Self = Self::of((0xD5, 0x5E, 0x00), Dash::Dashed, 1.1);
    /// The look of a model's own smoothed law.
    pub const OWN: Self = Self::of((0x22, 0x22, 0x22), Dash::Dotted, 1.5);

    /// The colours of Okabe and Ito that are dark enough for thin lines on white. Also without colour, dash and width
    /// distinguish them.
    const SERIES: [Self; 8] = [
        Self::of((0x00, 0x72, 0xB2), Dash::Solid, 1.2),
        Self::of((0xD5, 0x5E, 0x00), Dash::Dashed, 1.2),
        Self::of((0x00, 0x80, 0x60), Dash::Dotted, 1.5),
        Self::of((0x22, 0x22, 0x22), Dash::Solid, 0.6),
        Self::of((0xA8, 0x4F, 0x84), Dash::LongDashed, 1.2),
        Self::of((0x00, 0x72, 0xB2), Dash::Dashed, 0.7),
        Self::of((0xD5, 0x5E, 0x00), Dash::LongDashed, 0.7),
        Self::of((0x22, 0x22, 0x22), Dash::Dotted, 0.8),
    ];

    /// Number of series that can be distinguished.
    pub const MOST_SERIES: usize = Self::SERIES.len();

    /// A look with this colour (red, green, blue), dash and width.
    const fn of(colour: (u8, u8, u8), dash: Dash, width_pt: f64) -> Self {
        Self { colour, dash, width_pt }
    }

    /// The look of the series number `index`, from 0; looks repeat after [`Look::MOST_SERIES`].
    pub fn series(index: usize) -> Self {
        Self::SERIES.get(index % Self::MOST_SERIES).copied().unwrap_or(Self::HERTZ)
    }

    pub(crate) fn stroke(self) -> ShapeStyle {
        stroke(self.rgb(), self.width_pt)
    }

    pub(crate) fn rgb(self) -> RGBColor {
        RGBColor(self.colour.0, self.colour.1, self.colour.2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_series_look_alike() {
        for first in 0..Look::MOST_SERIES {
            for second in 0..first {
                let (first, second) = (Look::series(first), Look::series(second));
                assert!(
                    first.dash != second.dash || first.width_pt != second.width_pt,
                    "alike without colour"
                );
            }
        }
    }

    /// Relative luminance and contrast on white, as WCAG 2.1 defines them: thin lines need a contrast of 3 : 1.
    #[test]
    fn every_line_stands_out_from_white() {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        for look in Look::SERIES.iter().chain([&Look::HERTZ, &Look::WITH_CONSTANT, &Look::OWN]) {
            let (r, g, b) = look.colour;
            let luminance = 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
            assert!(1.05 / (luminance + 0.05) >= 3.0, "{look:?}");
        }
    }
}
