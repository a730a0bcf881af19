//! A panel as text for a terminal: each Braille letter holds two by four dots.

use crate::axis::Ticks;
use crate::error::PlotError;
use crate::figure::{self, Frame, Panel, Point};
use crate::style::float;

/// The curves of a panel with its axes, as text lines of at most `columns` letters; `rows` of the lines are between the axes.
///
/// Areas, limits, marks and the looks of curves are left out, because letters could not distinguish them.
///
/// ```
/// use contact_plots::{Axis, Curve, Look, Panel, text};
///
/// let points = (0..=100).map(|i| f64::from(i) / 10.0).map(|t| (t, 1.0 - (-t).exp())).collect();
/// let mut panel = Panel::new("", Axis::new("time (s)"), Axis::new("force / body weight"));
/// panel.curves.push(Curve::new("", points, Look::series(0)));
/// let text = text(&panel, 80, 16)?;
/// assert!(text.contains("time (s)") && text.contains('┤'));
/// # Ok::<(), contact_plots::PlotError>(())
/// ```
///
/// # Errors
/// A point is not finite, or no curve has two points.
pub fn text(panel: &Panel, columns: usize, rows: usize) -> Result<String, PlotError> {
    panel.check()?;
    let frame = Frame::of(panel);
    let (x, y) = (frame.x, frame.y);
    let y_ticks = panel.y.ticks(y, rows / 2 + 1);
    let longest = y_ticks.marks.iter().map(|(_, label)| label.chars().count()).max();
    let margin = longest.unwrap_or(0) + 1;
    let across = columns.saturating_sub(margin + 1).max(1);
    let mut dots = BrailleDots { columns: across, letters: vec![0; across * rows.max(1)] };
    let place = |(x_value, y_value): Point| {
        let share = |value: f64, (low, high): (f64, f64)| (value - low) / (high - low);
        (
            share(x_value, x) * float(dots.columns * DOTS_ACROSS - 1),
            share(y_value, (y.1, y.0)) * float(dots.letters.len() / dots.columns * DOTS_DOWN - 1),
        )
    };
    let parts =
        panel.curves.iter().flat_map(|curve| figure::clip_polyline(&frame.places(&curve.points), x, y));
    let lines: Vec<(Point, Point)> = parts
        .flat_map(|part| part.windows(2).map(|ends| (place(ends[0]), place(ends[1]))).collect::<Vec<_>>())
        .collect();
    let labels = |ticks: Ticks, letter: &dyn Fn(f64) -> usize| -> Vec<(usize, String)> {
        ticks.marks.into_iter().map(|(at, label)| (letter(at), label)).collect()
    };
    let y_labels = labels(y_ticks, &|at| rounded_index(place((x.0, at)).1) / DOTS_DOWN);
    let x_ticks = panel.x.ticks(x, dots.columns / 10 + 1);
    let x_labels = labels(x_ticks, &|at| rounded_index(place((at, y.0)).0) / DOTS_ACROSS);
    lines.into_iter().for_each(|(from, to)| dots.draw_line(from, to));

    let mut text = format!("{}\n", panel.y.label);
    for (row, letters) in dots.lines().enumerate() {
        let label = y_labels.iter().find(|(at, _)| *at == row).map(|(_, label)| label.as_str());
        let axis = if label.is_some() { '┤' } else { '│' };
        let line =
            format!("{:>margin$}{axis}{letters}", label.map(|label| format!("{label} ")).unwrap_or_default());
        text.push_str(&format!("{}\n", line.trim_end_matches(' ')));
    }
    let tick = |column| if x_labels.iter().any(|(at, _)| *at == column) { '┬' } else { '─' };
    let axis: String = (0..dots.columns).map(tick).collect();
    text.push_str(&format!("{:margin$}└{axis}\n", ""));
    text.push_str(&format!(
        "{}\n{:>columns$}\n",
        line_of_labels(&x_labels, margin + 1, columns),
        panel.x.label
    ));
    Ok(text)
}

/// A line with labels below their ticks, without labels that would overlap.
fn line_of_labels(labels: &[(usize, String)], margin: usize, columns: usize) -> String {
    let mut line = String::new();
    for (at, label) in labels {
        let (used, width) = (line.chars().count(), label.chars().count());
        let begin = (margin + at).saturating_sub(width / 2).min(columns.saturating_sub(width));
        if used == 0 || begin > used {
            line.push_str(&format!("{}{label}", " ".repeat(begin - used)));
        }
    }
    line
}

/// Number of dots in a Braille letter from left to right.
const DOTS_ACROSS: usize = 2;
/// Number of dots in a Braille letter from top to bottom.
const DOTS_DOWN: usize = 4;
/// The bit of each dot in a Braille letter, row by row, in Unicode's numbering.
const DOT_BITS: [[u8; DOTS_ACROSS]; DOTS_DOWN] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

/// A picture of dots for a terminal: each Braille letter has two dots across and four down.
struct BrailleDots {
    columns: usize,
    letters: Vec<u8>,
}

impl BrailleDots {
    /// Draws a line between two points, in dots.
    fn draw_line(&mut self, from: Point, to: Point) {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let steps = rounded_index(dx.abs().max(dy.abs())).max(1);
        for step in 0..=steps {
            let part = float(step) / float(steps);
            let (x, y) = (rounded_index(from.0 + part * dx), rounded_index(from.1 + part * dy));
            if let Some(letter) = self.letters.get_mut(y / DOTS_DOWN * self.columns + x / DOTS_ACROSS) {
                *letter |= DOT_BITS[y % DOTS_DOWN][x % DOTS_ACROSS];
            }
        }
    }

    fn lines(&self) -> impl Iterator<Item = String> {
        // A letter without dots is a blank: some fonts draw all eight places.
        let drawn = |&dots: &u8| {
            if dots == 0 { ' ' } else { char::from_u32(0x2800 + u32::from(dots)).unwrap_or(' ') }
        };
        self.letters.chunks(self.columns).map(move |line| line.iter().map(drawn).collect())
    }
}

fn rounded_index(value: f64) -> usize {
    value.round() as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Axis, Curve, Look};

    fn panel(points: Vec<Point>) -> Panel {
        let mut panel =
            Panel::new("", Axis::covering("time (s)", 0.0, 2.0), Axis::covering("force", 0.0, 4.0));
        panel.curves.push(Curve::new("", points, Look::series(0)));
        panel
    }

    #[test]
    fn a_line_goes_from_corner_to_corner() {
        let text = text(&panel(vec![(0.0, 0.0), (2.0, 4.0)]), 23, 5).unwrap();
        let drawn = [
            "force",
            "4 ┤                ⣀⠤⠒⠉",
            "  │            ⣀⠤⠒⠉",
            "2 ┤        ⣀⠤⠒⠉",
            "  │    ⣀⠤⠒⠉",
            "0 ┤⣀⠤⠒⠉",
            "  └┬─────────┬────────┬",
            "   0         1        2",
            "               time (s)",
        ];
        assert_eq!(text.lines().collect::<Vec<_>>(), drawn);
    }

    #[test]
    fn every_line_fits_the_width_of_the_terminal() {
        for columns in [20, 40, 80, 132] {
            let points =
                (0..1000).map(|i| f64::from(i) / 500.0).map(|t| (t, 4e6 * (9.0 * t).sin().abs())).collect();
            let mut panel = panel(points);
            panel.y = Axis::new("force (N)");
            let text = text(&panel, columns, 12).unwrap();
            assert!(text.lines().all(|line| line.chars().count() <= columns), "{text}");
            assert_eq!(text.lines().count(), 12 + 4, "{text}");
        }
    }

    #[test]
    fn a_figure_without_points_says_that_nothing_can_be_drawn() {
        assert!(text(&panel(vec![(0.0, 1.0)]), 80, 16).is_err());
        assert!(text(&panel(vec![(0.0, 1.0), (f64::NAN, 1.0)]), 80, 16).is_err());
    }
}
