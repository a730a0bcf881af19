//! One step of what a note says: what was done, from what, and when.
//!
//! `by transfer radius=x2 with level=true from 62 kg of reference falisse2022.osim 0123456789abcdef on 2026-11-25`

use crate::messages::shortest;

use super::spelling::{is_digest, mass_kg, plain};

/// Before the options that mattered.
const WITH: &str = " with ";
/// Before the mass that the contacts were made for until then.
const FROM: &str = " from ";
/// Before the name and the digest of the reference.
const OF: &str = " of reference ";
/// Before the date.
const ON: &str = " on ";

/// One change of the contacts, as the note records it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Step {
    /// What was done, for example `rescale` or `set stiffness=x2`: from [`Note::operation_text`](super::Note::operation_text).
    pub operation: String,
    /// Options that mattered, for example `level=true only=radius`; empty where there were none.
    pub options: String,
    /// Mass the contacts were made for before, kg, where another was known.
    pub from_mass_kg: Option<f64>,
    /// What the contacts were taken from.
    pub reference: Option<Source>,
    /// When, as `2026-11-25`.
    pub date: Option<String>,
}

/// The model or the preset that contacts were taken from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Its name, without folders and blanks.
    pub name: String,
    /// The first 16 digits of the SHA-256 of its file; `None` of a preset.
    pub digest: Option<String>,
}

impl Step {
    /// A step of which nothing else is known.
    #[must_use]
    pub fn new(operation: &str) -> Self {
        Self { operation: plain(operation), ..Self::default() }
    }

    /// As a note has it, without `by`.
    pub(super) fn text(&self) -> String {
        let mut text = plain(&self.operation);
        if !self.options.is_empty() {
            text.push_str(&format!("{WITH}{}", plain(&self.options)));
        }
        if let Some(kg) = self.from_mass_kg {
            text.push_str(&format!("{FROM}{} kg", shortest(kg)));
        }
        if let Some(source) = &self.reference {
            text.push_str(&format!("{OF}{}", source.text()));
        }
        if let Some(date) = &self.date {
            text.push_str(&format!("{ON}{date}"));
        }
        text
    }

    /// Reads a step. Its parts are taken from the end; what is none of them belongs to the operation.
    pub(super) fn parse(text: &str) -> Self {
        let (rest, date) = split(text, ON, |date| is_date(date).then(|| date.to_owned()));
        let (rest, reference) = split(rest, OF, Source::parse);
        let (rest, from_mass_kg) = split(rest, FROM, |kg| mass_kg(kg).flatten());
        let (operation, options) = split(rest, WITH, |options| Some(options.to_owned()));
        let operation = operation.to_owned();
        Self { operation, options: options.unwrap_or_default(), from_mass_kg, reference, date }
    }
}

impl Source {
    fn text(&self) -> String {
        let name: String = plain(&self.name).replace(' ', "_");
        match &self.digest {
            Some(digest) => format!("{name} {digest}"),
            None => name,
        }
    }

    fn parse(text: &str) -> Option<Self> {
        let (name, digest) = match text.split_once(' ') {
            Some((name, digest)) => (name, is_digest(digest).then(|| Some(digest.to_owned()))?),
            None => (text, None),
        };
        Some(Self { name: name.to_owned(), digest })
    }
}

/// `text` before the last `mark` and what `read` makes of the rest; all of `text` where that is none.
fn split<'t, T>(text: &'t str, mark: &str, read: impl Fn(&str) -> Option<T>) -> (&'t str, Option<T>) {
    let parts = text.rsplit_once(mark).and_then(|(before, part)| Some((before, read(part)?)));
    parts.map_or((text, None), |(before, part)| (before, Some(part)))
}

/// Whether `text` is a date like `2026-11-25`.
pub(super) fn is_date(text: &str) -> bool {
    let is_as = |(index, byte): (usize, u8)| match index {
        4 | 7 => byte == b'-',
        _ => byte.is_ascii_digit(),
    };
    text.len() == "2026-11-25".len() && text.bytes().enumerate().all(is_as)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn full() -> Step {
        Step {
            operation: "transfer radius=x2".into(),
            options: "level=true only=radius".into(),
            from_mass_kg: Some(62.5),
            reference: Some(Source { name: "falisse.osim".into(), digest: Some("0123456789abcdef".into()) }),
            date: Some("2026-11-25".into()),
        }
    }

    #[test]
    fn a_step_reads_back_as_written() {
        let spelled = "transfer radius=x2 with level=true only=radius from 62.5 kg of reference falisse.osim 0123456789abcdef on 2026-11-25";
        assert_eq!(full().text(), spelled);
        let preset = Some(Source { name: "falisse2022".into(), digest: None });
        for step in [
            full(),
            Step { reference: preset, ..full() },
            Step { options: String::new(), from_mass_kg: None, ..full() },
            Step { date: None, reference: None, ..full() },
            Step::new("rescale"),
        ] {
            assert_eq!(Step::parse(&step.text()), step);
        }
    }

    #[test]
    fn other_words_belong_to_the_operation() {
        for operation in ["ladder step 1 of 2", "transfer from a file on Monday", "set a=1 + set b=2"] {
            assert_eq!(Step::parse(operation).date, None);
            assert_eq!(Step::parse(operation).from_mass_kg, None);
            assert_eq!(Step::parse(operation).text(), operation);
        }
    }
}
