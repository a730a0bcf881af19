//! The contents of a note: masses, sizes, changes (steps), and digests that record the contacts.

use std::collections::BTreeMap;

use crate::messages::{Verb, readable};
use crate::model::property::Property;

/// Whether all contacts of a model were made for one mass.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Scope {
    /// All contacts were made for the mass in the note or, if the note has none, for the mass of the bodies at that time.
    All,
    /// Some contacts were not changed, or it is not known.
    #[default]
    Partial,
}

/// The contents of a note, which a change writes into the file: the mass and gravity for which the contacts were made, and more.
///
/// ```
/// use osim_model::{Document, Note, Scope};
///
/// let text = r#"<OpenSimDocument Version="40000"><Model name="walker">
/// <credits>A. Author; [contacts made for 500 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; sizes calcn_r=0.9,1,1; record 0123456789abcdef 00112233 fedcba98 1:11223344 1:22334455 3344.-.-.-.-.-.-.-.-; made -)]</credits>
/// </Model></OpenSimDocument>"#;
/// let note = Note::find(&Document::parse(text)?).expect("there is a note");
/// assert_eq!((note.contacts_mass_kg, note.gravity_m_s2, note.scope), (Some(500.0), Some(9.81), Scope::All));
/// assert_eq!((note.sizes[0].body.as_str(), note.sizes[0].factors), ("calcn_r", [0.9, 1.0, 1.0]));
/// // It is written as it was read.
/// assert!(text.contains(&note.text()));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Note {
    pub version: String,
    /// Mass for which the contacts were made, kg; `None` if it was not known.
    pub contacts_mass_kg: Option<f64>,
    /// Gravity for which the contacts were made, m/s²; `None` if the model has none.
    pub gravity_m_s2: Option<f64>,
    pub scope: Scope,
    /// The changes of the contacts, the oldest first: at least one.
    pub steps: Vec<Step>,
    /// Number of limbs that share the body weight; `None` if the caller did not give it.
    pub stance_limbs: Option<f64>,
    /// Mass of all bodies together when the note was written, kg; `None` if it was not known, or the earlier note could not be read.
    pub weighed_kg: Option<f64>,
    /// Mesh scale factors of the bodies with spheres when the note was written.
    pub sizes: Vec<BodySize>,
    /// Digest of all contact values when the note was written: the first 16 digits of their SHA-256.
    pub digest: String,
    /// Digest of the radii alone: its first 8 digits.
    pub radii: String,
    /// Names of the spheres and forces as digests, and digests of their properties.
    pub parts: NotedParts,
    /// The first 8 digits of a digest of the spheres' locations; `None` if the earlier note could not be read.
    pub places: Option<String>,
    /// A letter for each thing that was added to the file, so that it can be removed together with the contacts; `-` for nothing.
    pub added_to_file: String,
    /// Names of the forces that were added to existing ones, as [`Note::operation_text`] writes them; empty if all forces were added.
    pub added_forces: Vec<String>,
}

impl Note {
    pub fn operation(&self) -> &str {
        self.steps.last().map_or("", |step| step.operation.as_str())
    }
}

/// The mesh scale factors of one body along x, y and z.
#[derive(Debug, Clone, PartialEq)]
pub struct BodySize {
    pub body: String,
    /// Factors along x, y and z of the body, above 0.
    pub factors: [f64; 3],
}

/// An error: the text begins like a note, but cannot be read as a note.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UnreadableNote;

// One step of what a note says: what was done, from what, and when.
//
// `by transfer radius=x2 with level=true from 62 kg of reference falisse2022.osim 0123456789abcdef on 2026-11-25`

/// The text in a step before the options of the change.
const BEFORE_OPTIONS: &str = " with ";
/// The text in a step before the mass for which the contacts were made earlier.
const BEFORE_OLD_MASS: &str = " from ";
/// The text in a step before the name and the digest of the reference.
const BEFORE_REFERENCE: &str = " of reference ";
/// The text in a step before the date.
const BEFORE_DATE: &str = " on ";

/// A change of the contacts, as a note records it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Step {
    /// The kind of change, for example `rescale` or `set stiffness=x2`: from [`Note::operation_text`].
    pub operation: String,
    /// Options that influenced the change, for example `level=true only=radius`; empty if there were none.
    pub options: String,
    /// Mass for which the contacts were made before the change, kg, if it was known and different.
    pub from_mass_kg: Option<f64>,
    /// The model or preset from which the change took contacts.
    pub reference: Option<Source>,
    /// Date of the change, for example `2026-11-25`.
    pub date: Option<String>,
}

/// The model or preset from which contacts were taken.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Name of the file, without folders and blanks.
    pub name: String,
    /// The first 16 digits of the SHA-256 of the file; `None` for a preset.
    pub digest: Option<String>,
}

impl Step {
    /// A step of a note that has an operation, and neither options nor a source.
    pub fn new(operation: &str) -> Self {
        Self { operation: in_note_letters(operation), ..Self::default() }
    }

    /// The verb that made the change of this step; `None` if its operation is not a verb's.
    pub fn verb(&self) -> Option<Verb> {
        Verb::find(self.operation.split(' ').next()?)
    }

    /// The text of the step in a note, without `by`.
    pub(super) fn text(&self) -> String {
        let mut text = in_note_letters(&self.operation);
        if !self.options.is_empty() {
            text.push_str(&format!("{BEFORE_OPTIONS}{}", in_note_letters(&self.options)));
        }
        if let Some(kg) = self.from_mass_kg {
            text.push_str(&format!("{BEFORE_OLD_MASS}{} kg", readable(kg)));
        }
        if let Some(source) = &self.reference {
            text.push_str(&format!("{BEFORE_REFERENCE}{}", source.text()));
        }
        if let Some(date) = &self.date {
            text.push_str(&format!("{BEFORE_DATE}{date}"));
        }
        text
    }

    /// Reads a step. Its parts are separated from the end; the remaining text is the operation.
    pub(super) fn parse(text: &str) -> Self {
        let (rest, date) = split_last(text, BEFORE_DATE, |date| is_date(date).then(|| date.to_owned()));
        let (rest, reference) = split_last(rest, BEFORE_REFERENCE, Source::parse);
        let (rest, from_mass_kg) = split_last(rest, BEFORE_OLD_MASS, |kg| mass_kg(kg).flatten());
        let (operation, options) = split_last(rest, BEFORE_OPTIONS, |options| Some(options.to_owned()));
        let operation = operation.to_owned();
        Self { operation, options: options.unwrap_or_default(), from_mass_kg, reference, date }
    }
}

impl Source {
    /// The source as a note has it: its name, and the digest of its file.
    fn text(&self) -> String {
        let name: String = in_note_letters(&self.name).replace(' ', "_");
        match &self.digest {
            Some(digest) => format!("{name} {digest}"),
            None => name,
        }
    }

    fn parse(text: &str) -> Option<Self> {
        let (name, digest) = match text.split_once(' ') {
            Some((name, text)) => (name, Some(digest(text, DIGEST_DIGITS)?)),
            None => (text, None),
        };
        Some(Self { name: name.to_owned(), digest })
    }
}

/// Splits `text` at the last `mark`, if `read` accepts the text after it.
fn split_last<'t, T>(text: &'t str, mark: &str, read: impl Fn(&str) -> Option<T>) -> (&'t str, Option<T>) {
    let parts = text.rsplit_once(mark).and_then(|(before, part)| Some((before, read(part)?)));
    parts.map_or((text, None), |(before, part)| (before, Some(part)))
}

/// Whether `text` is a date like `2026-11-25`.
fn is_date(text: &str) -> bool {
    let is_as = |(index, byte): (usize, u8)| match index {
        4 | 7 => byte == b'-',
        _ => byte.is_ascii_digit(),
    };
    text.len() == "2026-11-25".len() && text.bytes().enumerate().all(is_as)
}

// What a note records of its contacts so that it can show later which of their properties, or only their names, changed.
//
// `12:01234567 6:89abcdef 0123.4567.-.-.-.-.-.-.-`: spheres, forces, and the properties of forces in their order.

/// The text in a note for a value that does not exist or is not known, such as the digest of a property that no force has.
pub(super) const NO_ENTRY: &str = "-";
/// Digits of the digest of one property. It only names the changed property, after the digest of all numbers has found a change.
const PROPERTY_DIGITS: usize = 4;

/// Digests of the names of spheres and forces, and of the values of their properties.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NotedParts {
    /// Number and digest of the names of the spheres of contact forces.
    pub spheres: NotedNames,
    pub forces: NotedNames,
    /// The first 4 digits of the SHA-256 of the values of each property of the forces.
    pub properties: BTreeMap<Property, String>,
}

/// The number and a digest of names of spheres or forces, in a note.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NotedNames {
    pub count: usize,
    /// The first 8 digits of the SHA-256 of the names.
    pub digest: String,
}

impl NotedParts {
    /// The digests as a note has them, with blanks between.
    pub(super) fn text(&self) -> String {
        let digest = |property| self.properties.get(&property).map_or(NO_ENTRY, String::as_str);
        let digests: Vec<&str> = properties_of_forces().map(digest).collect();
        format!("{} {} {}", self.spheres.text(), self.forces.text(), digests.join("."))
    }

    /// Reads the names and digests from `words`, all of which must be used.
    pub(super) fn parse<'t>(mut words: impl Iterator<Item = &'t str>) -> Option<Self> {
        let (spheres, forces) = (NotedNames::parse(words.next()?)?, NotedNames::parse(words.next()?)?);
        let digests: Vec<&str> = words.next()?.split('.').collect();
        let is_whole = words.next().is_none() && digests.len() == properties_of_forces().count();
        let recorded = properties_of_forces().zip(digests).filter(|(_, digest)| *digest != NO_ENTRY);
        let recorded = recorded.map(|(property, text)| Some((property, digest(text, PROPERTY_DIGITS)?)));
        let properties = recorded.collect::<Option<_>>()?;
        is_whole.then_some(Self { spheres, forces, properties })
    }
}

fn properties_of_forces() -> impl Iterator<Item = Property> {
    Property::changeable().filter(|property| *property != Property::Radius)
}

impl NotedNames {
    /// The number and the digest as a note has them.
    fn text(&self) -> String {
        format!("{}:{}", self.count, self.digest)
    }

    fn parse(text: &str) -> Option<Self> {
        let (count, names) = text.split_once(':')?;
        Some(Self { count: count.parse().ok()?, digest: digest(names, PART_DIGITS)? })
    }
}

// How words and numbers are spelled in a note.

/// The text for a mass or gravity that was not known.
pub(super) const UNKNOWN_VALUE: &str = "unknown";
/// Digits of the digest of all numbers, and of the digest of a reference file.
pub(super) const DIGEST_DIGITS: usize = 16;
/// Digits of the digests of radii, places and names.
pub(super) const PART_DIGITS: usize = 8;

/// Reads `unknown`, or a mass above 0 with its unit. The outer `None` means another text.
pub(super) fn mass_kg(text: &str) -> Option<Option<f64>> {
    if text == UNKNOWN_VALUE {
        return Some(None);
    }
    number_above_zero(text.strip_suffix(" kg")?).map(Some)
}

/// Reads `text` as a number above 0.
pub(super) fn number_above_zero(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite() && *number > 0.0)
}

/// Reads `unknown`, or a gravity of at least 0 with its unit. The outer `None` means another text.
pub(super) fn gravity_m_s2(text: &str) -> Option<Option<f64>> {
    if text == UNKNOWN_VALUE {
        return Some(None);
    }
    let gravity: f64 = text.strip_suffix(" m/s2")?.parse().ok()?;
    (gravity.is_finite() && gravity >= 0.0).then_some(Some(gravity))
}

/// `text`, if it consists of exactly this many hexadecimal digits.
pub(super) fn digest(text: &str, digits: usize) -> Option<String> {
    let is_digest = text.len() == digits && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    is_digest.then(|| text.to_owned())
}

/// Whether a field of a note can contain `letter`. `-` is allowed, but two of them would end an XML comment: see [`in_note_letters`].
pub(super) fn is_note_letter(letter: char) -> bool {
    letter.is_ascii_graphic() && !";[]()<>&'\"".contains(letter)
}

/// `text` with `_` for every letter that a note cannot contain, `__` for `--`, and single blanks.
pub(super) fn in_note_letters(text: &str) -> String {
    let words = text.split_ascii_whitespace().map(|word| {
        let letters = word.chars().map(|letter| if is_note_letter(letter) { letter } else { '_' });
        letters.collect::<String>()
    });
    words.collect::<Vec<_>>().join(" ").replace("--", "__")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step_with_every_field() -> Step {
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
        assert_eq!(step_with_every_field().text(), spelled);
        let preset = Some(Source { name: "falisse2022".into(), digest: None });
        for step in [
            step_with_every_field(),
            Step { reference: preset, ..step_with_every_field() },
            Step { options: String::new(), from_mass_kg: None, ..step_with_every_field() },
            Step { date: None, reference: None, ..step_with_every_field() },
            Step::new("rescale"),
        ] {
            assert_eq!(Step::parse(&step.text()), step);
        }
    }

    #[test]
    fn unknown_words_belong_to_the_operation() {
        for operation in ["ladder step 1 of 2", "transfer from a file on Monday", "set a=1 + set b=2"] {
            assert_eq!(Step::parse(operation).date, None);
            assert_eq!(Step::parse(operation).from_mass_kg, None);
            assert_eq!(Step::parse(operation).text(), operation);
        }
    }
}
