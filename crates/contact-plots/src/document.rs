//! An SVG document of a figure: its size on paper, its title, and the area in which the rest is drawn.

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::style::{TEXT_PT, TITLE_PT, text, units};
use crate::text_width::lines;
use crate::{PlotError, Width};

/// The width of a figure on paper, and the size of its letters.
///
/// Margins, dashes and gaps of a figure have sizes in proportion to its letters. A figure with larger letters is laid out on
/// smaller paper and then enlarged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paper {
    /// The width of the figure in mm; `None` for the figure's default width.
    pub width_mm: Option<f64>,
    /// The size of the figure's letters in points (1/72 inch); titles are a little larger.
    pub text_pt: f64,
}

impl Default for Paper {
    fn default() -> Self {
        Self { width_mm: None, text_pt: TEXT_PT }
    }
}

/// The smallest useful distance between the two vertical edges of a plot, in points for letters of 7 points.
const LEAST_PLOT_WIDTH_PT: f64 = 60.0;

impl Paper {
    /// The width in mm of a figure with the default width `default`.
    pub(crate) fn width_mm(self, default: Width) -> f64 {
        self.width_mm.unwrap_or(default.mm())
    }

    /// The width in which a figure is laid out, in points for letters of [`TEXT_PT`].
    pub(crate) fn layout_pt(self, default: Width) -> f64 {
        self.width_mm(default) / 25.4 * 72.0 / self.enlargement()
    }

    /// The factor by which the layout is enlarged on the paper.
    fn enlargement(self) -> f64 {
        self.text_pt / TEXT_PT
    }

    /// Refuses a paper that leaves too little room between the axes; `beside_pt` is the room that tick labels and axis labels
    /// need beside the plot.
    ///
    /// # Errors
    /// [`PlotError::TooNarrow`].
    pub(crate) fn check(self, default: Width, beside_pt: f64) -> Result<(), PlotError> {
        let least_mm = (beside_pt + LEAST_PLOT_WIDTH_PT) * self.enlargement() / 72.0 * 25.4;
        let width_mm = self.width_mm(default);
        if width_mm.is_finite() && self.text_pt > 0.0 && width_mm >= least_mm {
            return Ok(());
        }
        Err(PlotError::TooNarrow { width_mm, text_pt: self.text_pt, least_mm: least_mm.ceil() })
    }
}

// The SVG document around what the plotting library drew: size on paper, title and description.

/// A number rounded to a thousandth, without zeros at its end.
fn rounded_to_thousandth(mm: f64) -> f64 {
    (1000.0 * mm).round() / 1000.0
}

/// Joins consecutive lines with the same colour and width to one path. The library draws each dash as an element, and these
/// elements would be most of the document.
fn join_polylines(body: &str) -> String {
    /// The text before the points of a polyline in SVG.
    const POINTS_ATTRIBUTE: &str = " points=\"";
    let mut out = String::with_capacity(body.len());
    let mut run: (&str, Vec<&str>) = ("", Vec::new());
    for line in body.lines() {
        let parts = line
            .strip_prefix("<polyline")
            .and_then(|rest| rest.strip_suffix("\"/>"))
            .and_then(|rest| rest.split_once(POINTS_ATTRIBUTE));
        match parts {
            Some((look, points)) if look == run.0 => run.1.push(points),
            Some((look, points)) => {
                write_run(&mut out, &run);
                run = (look, vec![points]);
            }
            None => {
                write_run(&mut out, &run);
                run = ("", Vec::new());
                out.push_str(line);
                out.push('\n');
            }
        }
    }
    write_run(&mut out, &run);
    out
}

/// Writes consecutive polylines of one look as one path.
fn write_run(out: &mut String, (look, lines): &(&str, Vec<&str>)) {
    match lines.as_slice() {
        [] => {}
        [line] => out.push_str(&format!("<polyline{look} points=\"{line}\"/>\n")),
        lines => out.push_str(&format!("<path{look} d=\"M{}\"/>\n", lines.join("M"))),
    }
}

/// Text with XML escapes; characters that XML does not allow are left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            other => out.extend(allowed_in_xml(other)),
        }
    }
    out
}

/// The letter; `None` for a letter that XML does not allow.
fn allowed_in_xml(letter: char) -> Option<char> {
    let control = letter < ' ' && !matches!(letter, '\n' | '\t');
    (!control && !matches!(letter, '\u{fffe}' | '\u{ffff}')).then_some(letter)
}

/// The text without characters that XML does not allow, for the library, which adds the XML escapes.
pub(crate) fn text_allowed_in_xml(text: &str) -> String {
    text.chars().filter_map(allowed_in_xml).collect()
}

// A document with its title above, into which the rest is drawn.

/// Room between the edge of a figure and its content, pt.
pub(crate) const MARGIN_PT: f64 = 4.0;
/// Distance between two lines of a title, pt.
const TITLE_LINE_PT: f64 = 9.6;
/// Distance below the last line of a title.
const TITLE_GAP_PT: f64 = 3.4;

pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A title, broken into lines if it is wider than its figure. An empty title takes no room.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Title(Vec<String>);

impl Title {
    /// The lines of `title` on a figure that is `width_pt` wide.
    pub(crate) fn new(title: &str, width_pt: f64) -> Self {
        Self(lines(&text_allowed_in_xml(title), TITLE_PT, width_pt - 2.0 * MARGIN_PT))
    }

    /// Distance from the top of the page to the content below the title, in points.
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

/// An SVG document with its title at the top; `draw` draws the content below the title.
///
/// `default` is the width of the figure if `paper` gives none, and `height_pt` the height of the layout, in points for letters of
/// 7 points. `name` is the title before it was broken into lines. `description` says what the figure shows, for readers who cannot
/// see it.
pub(crate) fn document(
    (paper, default): (Paper, Width),
    height_pt: f64,
    title: &Title,
    [name, description]: [&str; 2],
    draw: impl FnOnce(&Area<'_>) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let width_pt = paper.layout_pt(default);
    let (width, height) = (units(width_pt).unsigned_abs(), units(height_pt).unsigned_abs());
    let mut drawn = String::new();
    {
        let root = SVGBackend::with_string(&mut drawn, (width, height)).into_drawing_area();
        root.fill(&RGBColor(255, 255, 255)).map_err(PlotError::drawing)?;
        title.draw(&root, width_pt)?;
        draw(&root)?;
        root.present().map_err(PlotError::drawing)?;
    }
    let body = drawn
        .find('>')
        .and_then(|end| drawn.get(end + 1..))
        .ok_or_else(|| PlotError::Drawing("the library wrote no document".to_owned()))?;
    // An opacity of 1 is what SVG takes anyway; half the size of a figure is attributes.
    let body = join_polylines(&body.replace(" opacity=\"1\"", "").replace(" \"/>", "\"/>"));
    // As high as its units are wide: nothing is stretched.
    let width_mm = paper.width_mm(default);
    let height_mm = width_mm * f64::from(height) / f64::from(width.max(1));
    // Every picture needs a name: if the figure has no title, the first sentence of its description.
    let first_sentence = description.split_inclusive(". ").next().unwrap_or_default().trim_end_matches(' ');
    let name = if name.trim_ascii().is_empty() { first_sentence } else { name };
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n<desc>{}</desc>{body}",
        rounded_to_thousandth(width_mm),
        rounded_to_thousandth(height_mm),
        escaped(name),
        escaped(description),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_of_one_look_become_one_path() {
        let dash =
            |colour: &str, points: &str| format!("<polyline stroke=\"{colour}\" points=\"{points}\"/>\n");
        let drawn =
            [dash("red", "0,0 1,1"), dash("red", "2,2 3,3"), dash("blue", "4,4 5,5"), "<g/>\n".to_owned()];
        assert_eq!(
            join_polylines(&drawn.concat()),
            "<path stroke=\"red\" d=\"M0,0 1,1M2,2 3,3\"/>\n<polyline stroke=\"blue\" points=\"4,4 5,5\"/>\n<g/>\n"
        );
    }
}
