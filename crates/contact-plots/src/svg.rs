//! The SVG document around what the plotting library drew: size on paper, title and description.

use crate::error::PlotError;

/// What a document is called and shows, for those who do not see it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Names<'n> {
    pub(crate) title: &'n str,
    pub(crate) description: &'n str,
}

impl<'n> Names<'n> {
    /// The title; of a figure without one the first sentence of its description, as every picture needs a name.
    fn title(self) -> &'n str {
        if self.title.chars().any(|letter| !letter.is_ascii_whitespace()) {
            return self.title;
        }
        let first = self.description.split_inclusive(". ").next().unwrap_or_default();
        first.trim_end_matches(' ')
    }
}

/// Gives the library's document its width in millimetres, a role, a title and a description.
pub(crate) fn finished(
    drawn: &str,
    (width, height): (u32, u32),
    width_mm: f64,
    names: Names<'_>,
) -> Result<String, PlotError> {
    let body = drawn
        .find('>')
        .and_then(|end| drawn.get(end + 1..))
        .ok_or_else(|| PlotError::Drawing("the library wrote no document".to_owned()))?;
    // An opacity of 1 is what SVG takes anyway; half the size of a figure is attributes.
    let body = joined(&body.replace(" opacity=\"1\"", "").replace(" \"/>", "\"/>"));
    // As high as its units are wide: nothing is stretched.
    let height_mm = width_mm * f64::from(height) / f64::from(width.max(1));
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{}mm\" height=\"{}mm\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n<desc>{}</desc>{body}",
        rounded(width_mm),
        rounded(height_mm),
        escaped(names.title()),
        escaped(names.description),
    ))
}

/// To a thousandth, without zeros that say nothing.
fn rounded(mm: f64) -> f64 {
    (1000.0 * mm).round() / 1000.0
}

/// Lines of one look that follow each other, as one path: the library draws each dash as an element of its own, which
/// would be most of the document.
fn joined(body: &str) -> String {
    const POINTS: &str = " points=\"";
    let mut out = String::with_capacity(body.len());
    let mut run: (&str, Vec<&str>) = ("", Vec::new());
    for line in body.lines() {
        let parts = line
            .strip_prefix("<polyline")
            .and_then(|rest| rest.strip_suffix("\"/>"))
            .and_then(|rest| rest.split_once(POINTS));
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

fn write_run(out: &mut String, (look, lines): &(&str, Vec<&str>)) {
    match lines.as_slice() {
        [] => {}
        [line] => out.push_str(&format!("<polyline{look} points=\"{line}\"/>\n")),
        lines => out.push_str(&format!("<path{look} d=\"M{}\"/>\n", lines.join("M"))),
    }
}

/// Text as XML holds it. Characters that XML cannot hold at all are left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            other => out.extend(allowed(other)),
        }
    }
    out
}

fn allowed(letter: char) -> Option<char> {
    let control = letter < ' ' && !matches!(letter, '\n' | '\t');
    (!control && !matches!(letter, '\u{fffe}' | '\u{ffff}')).then_some(letter)
}

/// The text without what XML cannot hold, for the library, which escapes the rest itself.
pub(crate) fn printable(text: &str) -> String {
    text.chars().filter_map(allowed).collect()
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
            joined(&drawn.concat()),
            "<path stroke=\"red\" d=\"M0,0 1,1M2,2 3,3\"/>\n<polyline stroke=\"blue\" points=\"4,4 5,5\"/>\n<g/>\n"
        );
    }
}
