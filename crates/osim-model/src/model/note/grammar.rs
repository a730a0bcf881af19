//! The text form of a note: printable ASCII with single blanks, because OpenSim changes white space and other letters. The grammar is frozen
//! as format 1 for version 0.1.0: all later versions read it.
//!
//! `[contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale from 70 kg on 2026-11-25; stance limbs 2;
//! weighed 62 kg; sizes calcn_r=1 calcn_l=0.9,1,1; record 0123456789abcdef 01234567 01234567 6:01234567 6:01234567
//! 0123.4567.-.-.-.-.-.-.-; made -)]`
//!
//! Each step has its own `by`, the oldest step first. Facts that nobody gave are left out. The record is for programs: digests of all
//! numbers, of radii, of places, of the names of spheres and forces, and of each property.

use foldhash::HashSet;

use crate::messages::{readable, shortest};
use crate::model::note::content::{
    BodySize, DIGEST_DIGITS, NO_ENTRY, Note, NotedParts, PART_DIGITS, Scope, Step, UNKNOWN_VALUE, digest,
    gravity_m_s2, in_note_letters, is_note_letter, mass_kg, number_above_zero,
};

/// The text with which every note begins; the mass follows.
pub(super) const NOTE_BEGIN: &str = "[contacts made for ";
/// The text with which every note ends.
pub(super) const NOTE_END: &str = ")]";
/// The text after mass and gravity in every note. Text in square brackets without it is not a note.
pub(super) const PROGRAM_MARK: &str = " (osim-contact-scale ";
/// The text in a note in place of body sizes, if it has none.
const NO_BODY_SIZES: &str = "none";
/// The text in a note before each step.
const BEFORE_STEP: &str = "by ";
/// The text in a note before the number of limbs that share the weight.
const BEFORE_STANCE_LIMBS: &str = "stance limbs ";
/// The text in a note before the mass of all bodies together.
const BEFORE_WEIGHT: &str = "weighed ";
/// The text in a note before the digests of contacts, radii, places and names.
const BEFORE_RECORD: &str = "record ";
/// The text in a note before the names of forces that were added to existing ones.
const BEFORE_ADDED_FORCES: &str = "added ";

impl Note {
    /// The text of the note, from its first bracket to its last.
    pub fn text(&self) -> String {
        let known = |value: Option<f64>, unit: &str| {
            value.map_or(UNKNOWN_VALUE.to_owned(), |value| format!("{} {unit}", shortest(value)))
        };
        let scope = match self.scope {
            Scope::All => "all",
            Scope::Partial => "partial",
        };
        let sizes: Vec<String> = self.sizes.iter().map(BodySize::text).collect();
        let steps: String = self.steps.iter().map(|step| format!("; {BEFORE_STEP}{}", step.text())).collect();
        let optional = |name: &str, value: Option<String>| {
            value.map(|value| format!("; {name}{value}")).unwrap_or_default()
        };
        let added = (!self.added_forces.is_empty()).then(|| self.added_forces.join(" "));
        format!(
            "{NOTE_BEGIN}{} at {}{PROGRAM_MARK}{}; {scope}{steps}{}{}; sizes {}; {BEFORE_RECORD}{} {} {} {}; made {}{}{NOTE_END}",
            known(self.contacts_mass_kg, "kg"),
            known(self.gravity_m_s2, "m/s2"),
            self.version,
            optional(BEFORE_STANCE_LIMBS, self.stance_limbs.map(shortest)),
            optional(BEFORE_WEIGHT, self.weighed_kg.map(|kg| format!("{} kg", readable(kg)))),
            if sizes.is_empty() { NO_BODY_SIZES.to_owned() } else { sizes.join(" ") },
            self.digest,
            self.radii,
            self.places.as_deref().unwrap_or(NO_ENTRY),
            self.parts.text(),
            self.added_to_file,
            optional(BEFORE_ADDED_FORCES, added),
        )
    }

    /// Reads a note from `text`, which contains nothing else and has single blanks.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.strip_prefix(NOTE_BEGIN)?.strip_suffix(NOTE_END)?;
        let (made_for, fields) = text.split_once(PROGRAM_MARK)?;
        let (mass, gravity) = made_for.split_once(" at ")?;
        let mut fields = fields.split("; ").peekable();
        let version = fields.next()?.to_owned();
        let scope = match fields.next()? {
            "all" => Scope::All,
            "partial" => Scope::Partial,
            _ => return None,
        };
        let mut next_if = |name: &str| fields.next_if(|field| field.starts_with(name))?.strip_prefix(name);
        let steps: Vec<Step> = std::iter::from_fn(|| next_if(BEFORE_STEP)).map(Step::parse).collect();
        let stance_limbs = next_if(BEFORE_STANCE_LIMBS).map(number_above_zero);
        let weighed_kg = next_if(BEFORE_WEIGHT).map(|text| mass_kg(text).flatten());
        let sizes = read_sizes(next_if("sizes ")?)?;
        let mut record = next_if(BEFORE_RECORD)?.split(' ');
        let all = digest(record.next()?, DIGEST_DIGITS)?;
        let radii = digest(record.next()?, PART_DIGITS)?;
        let places = match record.next()? {
            NO_ENTRY => None,
            text => Some(digest(text, PART_DIGITS)?),
        };
        let parts = NotedParts::parse(record)?;
        if steps.is_empty() {
            return None;
        }
        let added_to_file = fields.next()?.strip_prefix("made ")?.to_owned();
        if added_to_file != NO_ENTRY && !added_to_file.chars().all(|letter| letter.is_ascii_alphabetic()) {
            return None;
        }
        let note = Self {
            version,
            contacts_mass_kg: mass_kg(mass)?,
            gravity_m_s2: gravity_m_s2(gravity)?,
            scope,
            steps,
            // One that is there can be read.
            stance_limbs: stance_limbs.map_or(Some(None), |limbs| limbs.map(Some))?,
            weighed_kg: weighed_kg.map_or(Some(None), |kg| kg.map(Some))?,
            sizes,
            digest: all,
            radii,
            parts,
            places,
            added_to_file,
            added_forces: fields.next().map_or(Some(Vec::new()), names)?,
        };
        fields.next().is_none().then_some(note)
    }

    /// `operation` in letters that a note can contain. Letters that would end a field, or that OpenSim would change when it saves the file,
    /// become `_`.
    pub fn operation_text(operation: &str) -> String {
        in_note_letters(operation)
    }

    /// The letter in `made` which says that all spheres were placed by the scaling of their bodies.
    pub const PLACED_MARK: char = 'p';

    /// Whether all spheres were placed by the scaling of their bodies when the note was written, or earlier and not moved later.
    pub fn has_placed_spheres(&self) -> bool {
        self.added_to_file.contains(Self::PLACED_MARK)
    }

    /// The letter in `made` which says that all contacts of the model were added.
    pub const ALL_ADDED_MARK: char = 'n';

    /// Says of the name of a force whether a change added the force.
    pub fn is_added_force(&self) -> impl Fn(&str) -> bool + use<'_> {
        let names: HashSet<&String> = self.added_forces.iter().collect();
        move |force| names.contains(&in_note_letters(force))
    }

    pub fn nothing_added() -> String {
        NO_ENTRY.to_owned()
    }
}

impl BodySize {
    /// The text for a body, such as `calcn_r=0.9,1,1`, or `calcn_r=0.9` if all three factors are equal. Eight digits: sizes that differ by
    /// less count as equal.
    fn text(&self) -> String {
        let [x, y, z] = self.factors.map(readable);
        let factors = if x == y && y == z { x } else { [x, y, z].join(",") };
        format!("{}={factors}", self.body)
    }

    fn parse(text: &str) -> Option<Self> {
        let (body, factors) = text.split_once('=').filter(|(body, _)| !body.is_empty())?;
        let mut numbers = factors.split(',').map(|number| {
            let factor: f64 = number.parse().ok()?;
            (factor.is_finite() && factor > 0.0).then_some(factor)
        });
        let x = numbers.next()??;
        let factors = match numbers.next() {
            Some(y) => [x, y?, numbers.next()??],
            None => [x; 3],
        };
        numbers.next().is_none().then(|| Self { body: body.to_owned(), factors })
    }

    /// Whether a note can contain the name of the body.
    pub(crate) fn can_name(body: &str) -> bool {
        body.chars().all(|letter| is_note_letter(letter) && !"=,".contains(letter))
    }
}

fn read_sizes(text: &str) -> Option<Vec<BodySize>> {
    if text == NO_BODY_SIZES {
        return Some(Vec::new());
    }
    text.split(' ').map(BodySize::parse).collect()
}

/// Reads names of added forces from a text such as `added heel toe`.
fn names(text: &str) -> Option<Vec<String>> {
    Some(text.strip_prefix(BEFORE_ADDED_FORCES)?.split(' ').map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::note::content::NotedNames;
    use crate::model::property::Property;

    fn example_note() -> Note {
        Note {
            version: "0.1.0".into(),
            contacts_mass_kg: Some(0.0209),
            gravity_m_s2: Some(9.80665),
            scope: Scope::Partial,
            steps: vec![
                Step { date: Some("2026-11-25".into()), ..Step::new("transfer") },
                Step::new("set stiffness=x2"),
            ],
            stance_limbs: Some(2.0),
            weighed_kg: Some(0.021),
            sizes: vec![BodySize { body: "calcn_r".into(), factors: [0.913_924, 1.0, 1e-3] }],
            digest: "0123456789abcdef".into(),
            radii: "00112233".into(),
            parts: NotedParts {
                spheres: NotedNames { count: 12, digest: "11223344".into() },
                forces: NotedNames { count: 6, digest: "22334455".into() },
                properties: [(Property::Stiffness, "3344".into()), (Property::Dissipation, "4455".into())]
                    .into(),
            },
            places: Some("fedcba98".into()),
            added_to_file: "c".into(),
            added_forces: vec![],
        }
    }

    #[test]
    fn a_note_has_the_agreed_text() {
        assert_eq!(
            example_note().text(),
            "[contacts made for 0.0209 kg at 9.80665 m/s2 (osim-contact-scale 0.1.0; partial; by transfer on 2026-11-25; \
         by set stiffness=x2; stance limbs 2; weighed 0.021 kg; sizes calcn_r=0.913924,1,0.001; \
         record 0123456789abcdef 00112233 fedcba98 12:11223344 6:22334455 3344.4455.-.-.-.-.-.-.-; made c)]"
        );
    }

    #[test]
    fn a_note_reads_back_as_written() {
        let nothing_known = Note {
            contacts_mass_kg: None,
            gravity_m_s2: None,
            steps: vec![Step::new("rescale")],
            stance_limbs: None,
            weighed_kg: None,
            sizes: vec![],
            places: None,
            added_to_file: Note::nothing_added(),
            ..example_note()
        };
        let no_numbers =
            Note { parts: NotedParts { properties: [].into(), ..example_note().parts }, ..example_note() };
        let beside_others = Note { added_forces: vec!["heel".into(), "toe".into()], ..example_note() };
        assert!(beside_others.text().ends_with("; made c; added heel toe)]"), "{}", beside_others.text());
        let one_size = BodySize { body: "calcn_r".into(), factors: [0.9; 3] };
        let alike = Note { sizes: vec![one_size], ..example_note() };
        assert!(alike.text().contains("; sizes calcn_r=0.9; "), "{}", alike.text());
        for note in [example_note(), nothing_known, no_numbers, beside_others, alike] {
            assert_eq!(Note::parse(&note.text()), Some(note));
        }
    }

    #[test]
    fn letters_that_a_note_cannot_contain_are_replaced() {
        for (operation, expected) in [
            ("rescale radius=x2", "rescale radius=x2"),
            (
                "transfer  from 'T. rex [2]; (é).osim'\t--level",
                "transfer from _T. rex _2__ ___.osim_ __level",
            ),
        ] {
            assert_eq!(Note::operation_text(operation), expected);
            let note = Note { steps: vec![Step::new(operation)], ..example_note() };
            assert_eq!(Note::parse(&note.text()), Some(note));
        }
    }

    #[test]
    fn text_that_breaks_the_grammar_is_no_note() {
        let text = example_note().text();
        for (from, to) in [
            ("0.0209 kg", "-1 kg"),
            ("0.0209 kg", "0.0209"),
            ("9.80665 m/s2", "NaN m/s2"),
            ("partial", "half"),
            ("; made c", ""),
            ("; by transfer on 2026-11-25; by set stiffness=x2", ""),
            ("limbs 2", "limbs two"),
            ("weighed 0.021 kg", "weighed 0.021"),
            ("00112233", "0011"),
            (" 00112233", ""),
            (" 12:11223344 6:22334455 3344.4455.-.-.-.-.-.-.-", ""),
            ("12:", "many:"),
            ("11223344", "1122"),
            (" 6:22334455", ""),
            ("3344.4455", "33.4455"),
            (".-.-.-.-.-.-.-", ""),
            ("-; made", "- 0123; made"),
            ("made c", "made c; more"),
            ("0123456789abcdef", "0123"),
            ("fedcba98", "fedcba9z"),
            ("=0.913924,1,0.001", "=0.913924,1"),
            ("=0.913924,1,0.001", "=0.913924,1,0"),
            ("calcn_r=", "="),
        ] {
            let changed = text.replacen(from, to, 1);
            assert_ne!(changed, text);
            assert_eq!(Note::parse(&changed), None, "{changed}");
        }
    }
}
