//! The parts of a page around the models: head, contents, sections with their headings, the command, and the origin of the page.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use osim_model::messages::Verb;
use osim_requests::verb_entry;

const STYLE_SHEET: &str = include_str!("style.css");

/// Id and title of the section with the command that made the page.
pub(super) const COMMAND_SECTION: (&str, &str) = ("asked", "The command of this page");
/// Id and title of the section about the program and its citation.
pub(super) const ORIGIN_SECTION: (&str, &str) = ("origin", "Program and citation");

/// The text by which pages of this program are recognised; the version number follows.
pub const GENERATOR: &str = "<meta name=\"generator\" content=\"osim-contact-scale ";

/// The reference of the paper, van Bijlert (2026), as in CITATION.cff.
const PAPER_CITATION: &str = "van Bijlert, P. A. (2026). Scaling contact force parameters across body size, limb \
                                count, and number of contact spheres. Journal of Biomechanics.";
/// The DOI of the paper.
const PAPER_DOI: &str = "10.1016/j.jbiomech.2026.113420";

/// The beginning of the page, up to the first section.
pub(super) fn opening(title: &str, class: &str, sections: &[(&str, &str)]) -> String {
    let head = html! {
        meta charset="utf-8";
        meta name="viewport" content="width=device-width, initial-scale=1";
        meta name="color-scheme" content="light dark";
        (PreEscaped(GENERATOR)) (env!("CARGO_PKG_VERSION")) (PreEscaped("\">"))
        title { (title) }
        style { (PreEscaped(STYLE_SHEET)) }
    };
    let top = html! {
        a.skip href="#content" { "Skip to the content" }
        header {
            h1 { (title) }
            p.quiet { "Made by osim-contact-scale " (env!("CARGO_PKG_VERSION"))
                ". Contacts of OpenSim models by the equations of van Bijlert (2026)." }
        }
        nav aria-label="Contents" {
            ul { @for (id, name) in sections { li { a href={ "#" (id) } { (name) } } } }
        }
    };
    let (doctype, head, top) = (DOCTYPE.0, head.0, top.0);
    format!(
        "{doctype}\n<html lang=\"en\">\n<head>{head}</head>\n<body class=\"{class}\">\n{top}\n<main id=\"content\">\n"
    )
}

/// The purpose of the verb, and the `command` that makes the page again.
pub(super) fn purpose(verb: Verb, command: &str) -> String {
    let body = html! {
        p { (verb_entry(verb).purpose) }
        (command_line(command))
    };
    section(COMMAND_SECTION, &body).0
}

/// The beginning of a section with this id and title, and its heading.
pub(super) fn section_opening((id, title): (&str, &str)) -> String {
    format!("<section id=\"{id}\" aria-labelledby=\"{id}-title\"><h2 id=\"{id}-title\">{title}</h2>")
}

/// A section of the page with its heading.
pub(super) fn section(head: (&str, &str), body: &Markup) -> Markup {
    html! { (PreEscaped(section_opening(head))) (body) (PreEscaped("</section>")) }
}

/// A command in a box. A long command breaks between words, but never after the dashes of an option.
pub(super) fn command_line(command: &str) -> Markup {
    html! {
        pre.command { code {
            @for (index, word) in command.split(' ').enumerate() {
                @if index > 0 { " " }
                span { (word) }
            }
        } }
    }
}

/// The end of the page, after the last model.
pub(super) fn origin_and_closing() -> String {
    let body = html! {
        dl {
            dt { "Program" } dd { "osim-contact-scale " (env!("CARGO_PKG_VERSION")) }
            dt { "Cite the paper" }
            dd { (PAPER_CITATION) " " a href={ "https://doi.org/" (PAPER_DOI) } { "doi:" (PAPER_DOI) } }
            dt { "Cite the software" }
            dd { "The osim-contact-scale developers. osim-contact-scale, version " (env!("CARGO_PKG_VERSION")) "." }
        }
        p.quiet { "The page holds no date: the same call on the same files gives the same page." }
    };
    format!("{}\n</main>\n</body>\n</html>\n", section(ORIGIN_SECTION, &body).0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_plots::{Axis, Curve, Figure, Limit, Look, Panel, Paper, figure};

    /// The `text` on one line, because CITATION.cff folds texts over several lines.
    fn on_one_line(text: &str) -> String {
        text.split_ascii_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// A colour without a rule for the dark mode would be drawn with its colour for a white page.
    #[test]
    fn every_colour_of_a_plot_has_a_dark_one() {
        let looks = (0..Look::MOST_SERIES).map(Look::series);
        let mut colours: Vec<String> = looks
            .chain([Look::HERTZ, Look::WITH_CONSTANT, Look::OWN])
            .map(|look| format!("{:02X}{:02X}{:02X}", look.colour.0, look.colour.1, look.colour.2))
            .collect();
        let mut panel = Panel::new("", Axis::new("x"), Axis::new("y"));
        panel.curves.push(Curve::new("a", vec![(0.0, 0.0), (1.0, 1.0)], Look::OWN));
        panel.limits.push(Limit::vertical("limit", 0.5));
        let drawn = Figure::in_column("a", String::new(), vec![panel]);
        let drawn = figure(&drawn, Paper::default()).unwrap();
        colours.extend(drawn.split("=\"#").skip(1).filter_map(|rest| Some(rest.get(..6)?.to_owned())));
        for colour in colours {
            for attribute in ["fill", "stroke"] {
                let rule = format!(".plot [{attribute}=\"#{colour}\"]{{{attribute}:");
                assert!(STYLE_SHEET.contains(&rule), "{rule}");
            }
        }
    }

    #[test]
    fn the_citation_is_that_of_the_citation_file() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../CITATION.cff");
        let Ok(file) = std::fs::read_to_string(path) else { return };
        let file = on_one_line(&file);
        assert!(
            file.contains(PAPER_DOI)
                && file.contains("Journal of Biomechanics")
                && file.contains("year: 2026")
        );
        let title = PAPER_CITATION.split("). ").nth(1).and_then(|rest| rest.split(". ").next()).unwrap();
        assert!(file.contains(title), "{title}");
        assert!(file.contains(&format!("version: {}", env!("CARGO_PKG_VERSION"))));
    }
}
