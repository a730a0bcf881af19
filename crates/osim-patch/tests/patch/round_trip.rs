//! Tests of the round trip: without edits every byte stays; edits change only their spans; a written number is read again as the
//! same double. The inputs are all fixtures, whole and damaged.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::sync::OnceLock;

use crate::given::{fixture, fixtures};
use osim_model::{Document, FileId, MassRequest, Model, Property, RadiusRule, Selection, SetId, Value};
use osim_patch::{Edit, Plan, Rescale, rescale, splice};
use proptest::prelude::*;

/// Bytes of the small files in `fixtures/format` and `fixtures/bad`, which are then damaged.
fn bytes_of_fixtures() -> &'static [Vec<u8>] {
    static FIXTURE_BYTES: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    FIXTURE_BYTES.get_or_init(|| {
        let names = fixtures("format").into_iter().chain(fixtures("bad"));
        names.map(|name| fixture(&name)).filter(|bytes| bytes.len() < 16_000).collect()
    })
}

/// A way to damage the bytes of a file, with the place and what happens there.
#[derive(Debug, Clone)]
enum Damage {
    Replace(usize, u8),
    Remove(usize, usize),
    Insert(usize, &'static str),
    Double(usize, usize),
    Cut(usize),
}

const TEXTS_TO_INSERT: [&str; 24] = [
    "<",
    ">",
    "/",
    "&",
    "\"",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "&#49;",
    "&#x110000;",
    "\u{feff}",
    "\r\n",
    "\0",
    "1e400",
    "-0",
    "inf",
    "</stiffness>",
    "<radius>0.1</radius>",
    "<defaults/>",
    "<?x?>",
    "é",
    "<a b='",
    "e6",
];

fn any_damage() -> impl Strategy<Value = Damage> {
    let at = 0..1_000_000_usize;
    prop_oneof![
        4 => (at.clone(), any::<u8>()).prop_map(|(at, byte)| Damage::Replace(at, byte)),
        2 => (at.clone(), 1..60_usize).prop_map(|(at, length)| Damage::Remove(at, length)),
        4 => (at.clone(), prop::sample::select(&TEXTS_TO_INSERT[..])).prop_map(|(at, text)| Damage::Insert(at, text)),
        2 => (at.clone(), 1..400_usize).prop_map(|(at, length)| Damage::Double(at, length)),
        1 => at.prop_map(Damage::Cut),
    ]
}

fn damaged_bytes(seed: usize, damages: &[Damage]) -> Vec<u8> {
    let seeds = bytes_of_fixtures();
    let mut bytes = seeds[seed % seeds.len()].clone();
    for spoil in damages {
        let place = |at: usize| at % (bytes.len() + 1);
        match *spoil {
            Damage::Replace(at, byte) => {
                let at = place(at);
                if let Some(old) = bytes.get_mut(at) {
                    *old = byte;
                }
            }
            Damage::Remove(at, length) => {
                let at = place(at);
                let end = bytes.len().min(at + length);
                bytes.drain(at..end);
            }
            Damage::Insert(at, text) => {
                let at = place(at);
                bytes.splice(at..at, text.bytes());
            }
            Damage::Double(at, length) => {
                let at = place(at);
                let piece = bytes[at..bytes.len().min(at + length)].to_vec();
                bytes.splice(at..at, piece);
            }
            Damage::Cut(at) => bytes.truncate(place(at)),
        }
    }
    bytes
}

/// The plan of a rescaling by `factor`; `None` if the model is refused.
fn plan_of_rescaling(model: &Model, factor: f64, radius: RadiusRule) -> Option<Plan> {
    let selected = Selection::default().apply(model).ok()?;
    let (contacts_mass, _) = MassRequest::default().contacts_mass(model).ok()?;
    let mut wanted = Rescale::new(contacts_mass.kg * factor, contacts_mass);
    wanted.radius = radius;
    wanted.properties = osim_model::PropertySet::default().with_friction();
    rescale(model, &selected, &wanted).ok()
}

/// Asserts that the pieces of a document cover the file without gaps or overlaps.
fn assert_pieces_cover_file(document: &Document) {
    let tree = document.tree();
    let mut at = 0;
    for piece in tree.pieces() {
        let span = piece.span;
        assert_eq!(span.start, at, "a gap or an overlap at byte {at}");
        assert!(span.end > span.start, "an empty piece at byte {at}");
        at = span.end;
    }
    assert_eq!(at, document.bytes().len(), "the last piece does not reach the end");
}

/// Asserts that the output is the input with only the spans of `edits` replaced.
fn assert_only_edits_change_bytes(before: &[u8], after: &[u8], edits: &[Edit]) {
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| edit.span.start);
    let (mut old, mut new) = (0, 0);
    for edit in edits {
        let kept = edit.span.start - old;
        assert_eq!(&before[old..old + kept], &after[new..new + kept], "bytes before {:?} changed", edit.span);
        new += kept;
        assert_eq!(&after[new..new + edit.text.len()], edit.text.as_bytes());
        new += edit.text.len();
        old = edit.span.end;
    }
    assert_eq!(&before[old..], &after[new..], "bytes after the last edit changed");
}

/// The value of a changed number in the model that was read again.
fn value_after_change<'m>(model: &'m Model, change: &osim_patch::NumberChange) -> Option<&'m Value> {
    if change.property == Property::Radius {
        return model.spheres().iter().find(|sphere| sphere.path == change.path).map(|sphere| &sphere.radius);
    }
    let force = model.forces().iter().find(|force| force.path == change.path)?;
    let set = force.sets.iter().find(|set| set.number == change.set).map_or(SetId::FIRST, |set| set.id);
    force.value(set, change.property)
}

/// Rescales one file, and asserts that only the edits change bytes and that each new number is read back; `true` if the file was rescaled.
fn check_round_trip(bytes: &[u8], factor: f64, radius: RadiusRule) -> bool {
    let Ok(document) = Document::parse(bytes) else { return false };
    assert_eq!(document.bytes(), bytes);
    assert_pieces_cover_file(&document);
    assert_eq!(splice(bytes, &[]).unwrap(), bytes, "without edits the bytes changed");
    let Ok(model) = Model::read(document) else { return false };
    let _ = model.limbs(&model.force_ids());
    let Some(plan) = plan_of_rescaling(&model, factor, radius) else { return false };
    let (edits, patched) =
        (plan.edits(&model, FileId::MAIN).unwrap(), plan.patched(&model, FileId::MAIN).unwrap());
    assert_only_edits_change_bytes(bytes, &patched, &edits);
    if plan.is_empty() {
        assert_eq!(patched, bytes);
        return true;
    }
    let model = Model::parse(patched).expect("what was written is a model");
    for change in &plan.changes {
        assert!(change.to.is_finite());
        let value = value_after_change(&model, change).unwrap_or_else(|| panic!("{} is gone", change.path));
        assert_eq!(value.number.to_bits(), change.to.to_bits(), "{} of {}", change.property, change.path);
        assert!(value.span.is_some() && value.fault.is_none(), "{} of {}", change.property, change.path);
    }
    let note = model.note.as_ref().expect("the note is found again");
    assert_eq!(Some(note), plan.note());
    true
}

#[test]
fn rescaling_a_fixture_changes_only_the_edited_bytes() {
    let mut rescaled = 0;
    for name in fixtures("format").into_iter().chain(fixtures("table1")).chain(fixtures("bad")) {
        let bytes = fixture(&name);
        for radius in
            [RadiusRule::Isometric, RadiusRule::Keep, RadiusRule::Metres(0.0456), RadiusRule::Factor(0.3)]
        {
            rescaled += usize::from(check_round_trip(&bytes, 3.7, radius));
        }
    }
    assert!(rescaled > 400, "only {rescaled} of the fixtures were rescaled");
}

#[test]
fn rescaling_back_restores_the_numbers_up_to_rounding() {
    // Each way multiplies once, by a ratio that is right to a few last bits.
    for name in fixtures("table1") {
        let bytes = fixture(&name);
        let model = Model::parse(bytes).unwrap();
        let there = plan_of_rescaling(&model, 19.3, RadiusRule::Isometric).unwrap();
        let patched = there.patched(&model, FileId::MAIN).unwrap();
        let model = Model::parse(patched).unwrap();
        // The note says what the contacts are made for, so 1/19.3 leads back.
        let back = plan_of_rescaling(&model, 1.0 / 19.3, RadiusRule::Isometric).unwrap();
        assert_eq!(back.changes.len(), there.changes.len(), "{name}");
        for (change, original) in back.changes.iter().zip(&there.changes) {
            let error = (change.to - original.from).abs() / original.from;
            assert!(
                error <= crate::given::TIGHT_TOLERANCE,
                "{name}: {} of {} is off by {error}",
                change.property,
                change.path
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_keep_the_round_trip_or_are_refused(
        seed: usize,
        damages in prop::collection::vec(any_damage(), 1..6),
        factor in 0.001..1000.0_f64,
    ) {
        check_round_trip(&damaged_bytes(seed, &damages), factor, RadiusRule::Isometric);
    }

    #[test]
    fn reading_random_bytes_never_panics(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        check_round_trip(&bytes, 2.0, RadiusRule::Isometric);
    }

    #[test]
    fn reading_random_markup_never_panics(shards in prop::collection::vec(prop::sample::select(&TEXTS_TO_INSERT[..]), 0..40)) {
        let text = format!("<OpenSimDocument Version='40000'><Model>{}</Model></OpenSimDocument>", shards.concat());
        check_round_trip(text.as_bytes(), 2.0, RadiusRule::Isometric);
    }

    #[test]
    fn any_number_is_written_so_that_it_reads_the_same(number in prop::num::f64::POSITIVE | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO) {
        let text = osim_model::messages::shortest(number);
        prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), number.to_bits(), "{}", text);
        prop_assert!(text.len() <= 24, "{}", text);
        // As short as any exact spelling.
        let digits = |text: &str| text.split('e').next().unwrap().chars().filter(char::is_ascii_digit).collect::<String>().trim_matches('0').len();
        prop_assert_eq!(digits(&text), digits(&format!("{number:e}")));
    }
}
