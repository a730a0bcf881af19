//! The checks themselves.

use std::collections::HashMap;

use osim_model::messages::readable;
use osim_model::{Document, ElementId, FileId, ForceId, Limbs, MassRequest, MassSource, Model, Note, PieceKind, RadiusRule, Scope, Selection, SetId, SphereId, Value};
use osim_patch::{Edit, Plan, Reference, Transfer, reference_of_model, rescale, splice, transfer};

use crate::accept;
use crate::request::Request;

/// Scanning never panics; pieces tile the file; elements nest.
pub fn scan(bytes: &[u8]) {
    let document = match Document::parse(bytes) {
        Ok(document) => document,
        Err(fault) => {
            let offset = fault.offset.unwrap_or(0);
            assert!(offset <= bytes.len(), "a fault beyond the end of the file");
            return accept(&fault);
        }
    };
    let tree = document.tree();
    let mut at = 0;
    for (index, piece) in tree.pieces().enumerate() {
        assert_eq!(piece.span.start, at, "a gap or an overlap before piece {index}");
        assert!(piece.span.end > piece.span.start, "piece {index} is empty");
        at = piece.span.end;
    }
    assert_eq!(at, bytes.len(), "the pieces do not reach the end");
    let mut open = vec![ElementId::ROOT];
    let mut seen = 0;
    while let Some(id) = open.pop() {
        seen += 1;
        let outer = tree.span(id);
        for child in tree.children(id) {
            let inner = tree.span(child);
            assert!(outer.start < inner.start && inner.end <= outer.end, "a child outside its parent");
            assert_eq!(tree.parent(child), Some(id));
            open.push(child);
        }
    }
    assert_eq!(seen, tree.element_count());
    for offset in [0, bytes.len() / 2, bytes.len()] {
        let lines = 1 + bytes[..offset].iter().filter(|&&byte| byte == b'\n').count();
        assert_eq!(document.position(offset).line, lines);
    }
}

/// Without edits, and with a plan that changes nothing, the output is the input.
pub fn no_edit(bytes: &[u8]) {
    assert_eq!(splice(bytes, &[]).expect("no edits cannot overlap"), bytes);
    with_model(bytes, |model| {
        let Ok(selected) = Selection::default().apply(model) else { return };
        let Ok(mut request) = Request::of(bytes, model) else { return };
        request.wanted.target_mass_kg = request.wanted.contacts_mass.kg;
        request.wanted.target_gravity_m_s2 = None;
        // Radii in metres or times a factor are asked for whatever the mass.
        request.wanted.radius = RadiusRule::Isometric;
        let plan = rescale(model, &selected, &request.wanted).expect("nothing to do is always possible");
        assert!(plan.is_empty() && plan.note().is_none());
        assert_eq!(plan.patched(model, FileId::MAIN).expect("no edits cannot overlap"), bytes);
    });
}

/// The edits of a plan touch their own spans and no byte outside.
pub fn edits(bytes: &[u8]) {
    with_plan(bytes, |model, _, mut plan| {
        for note in [true, false] {
            if !note {
                plan.drop_note();
            }
            let edits = plan.edits(model, FileId::MAIN).expect("every number can be written");
            assert_eq!(edits.is_empty(), plan.is_empty());
            let patched = plan.patched(model, FileId::MAIN).expect("the edits of a plan do not overlap");
            outside_equal(bytes, &edits, &patched);
        }
    });
}

/// Walks input and output side by side, which is not how the output was made.
fn outside_equal(mut input: &[u8], edits: &[Edit], mut output: &[u8]) {
    let mut sorted: Vec<&Edit> = edits.iter().collect();
    sorted.sort_by_key(|edit| edit.span.start);
    let mut at = 0;
    for edit in sorted {
        let (kept, rest) = input.split_at(edit.span.start.checked_sub(at).expect("edits overlap"));
        output = output.strip_prefix(kept).expect("a byte before an edit changed");
        output = output.strip_prefix(edit.text.as_bytes()).expect("an edit is missing");
        input = &rest[edit.span.len()..];
        at = edit.span.end;
    }
    assert_eq!(output, input, "a byte after the last edit changed");
}

/// Reading, limbs, selection, masses and references never panic, whatever the model says.
pub fn inspect(bytes: &[u8]) {
    with_model(bytes, |model| {
        let document = model.document();
        assert!(document.included_files().iter().all(|(_, file)| !file.is_empty()));
        let every = model.force_ids();
        let loaded = model.loaded_spheres(&every);
        match model.limbs(&every) {
            Limbs::Known(limbs) => {
                let spheres: Vec<SphereId> = limbs.iter().flat_map(|limb| limb.spheres.clone()).collect();
                assert_eq!(spheres.len(), loaded.len());
                assert!(spheres.iter().all(|&sphere| model.sphere(sphere).is_some()));
            }
            Limbs::Unknown(why) => assert!(!why.to_string().is_empty()),
        }
        for value in values(model).iter().map(|(_, value)| value) {
            assert!(value.offset <= bytes.len());
            assert!(value.span.as_ref().is_none_or(|span| span.end <= bytes.len()));
            value.checked().map_or_else(|fault| accept(&fault), drop);
        }
        for warning in osim_inspect::model_findings(model) {
            assert!(!warning.message.to_string().is_empty());
        }
        let mass = MassRequest::default().model_mass(model);
        mass.as_ref().map_or_else(accept, drop);
        let selected = match Selection::default().apply(model) {
            Ok(selected) => selected,
            Err(fault) => return accept(&fault),
        };
        assert!(selected.forces.iter().all(|&force| model.force(force).is_some()));
        let Ok(mass) = mass else { return };
        let own = reference_of_model(model, &selected, mass.clone(), 6.0);
        let preset = contact_scaling::preset("falisse2022").map(|preset| Reference::from(&preset));
        for reference in own.into_iter().chain(preset) {
            match transfer(model, &selected, &Transfer::new(reference, mass.clone(), 5.0)) {
                Ok(plan) => {
                    drop(plan.patched(model, FileId::MAIN).expect("the edits of a plan do not overlap"))
                }
                Err(fault) => accept(&fault),
            }
        }
    });
}

/// The output reads back: planned values bit for bit, all others as they were; then the note lets a second run work.
pub fn roundtrip(bytes: &[u8]) {
    with_plan(bytes, |model, request, plan| {
        let patched = plan.patched(model, FileId::MAIN).expect("the edits of a plan do not overlap");
        let again = Model::parse(patched).expect("the output is a model");
        values_as_planned(model, &plan, &again);
        if plan.is_empty() {
            return;
        }
        let note = again.note.as_ref().expect("a changed model has a note");
        assert_eq!(Some(note), plan.note().map(with_written_weights).as_ref(), "the note reads back differently");
        second_run(&again, request, note.scope);
    });
}

/// A note with weights and sizes as it writes them for readers: exact where that is short, else in eight significant digits.
fn with_written_weights(note: &Note) -> Note {
    let written = |value: f64| readable(value).parse().expect("a number reads back");
    let mut note = note.clone();
    note.weighed_kg = note.weighed_kg.map(written);
    for step in &mut note.steps {
        step.from_mass_kg = step.from_mass_kg.map(written);
    }
    for size in &mut note.sizes {
        size.factors = size.factors.map(written);
    }
    note
}

/// Where a number of a model stands, by which it is found again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// Among the values of a parameter set.
    OfSet(ForceId, SetId, usize),
    /// The force's own.
    OfForce(ForceId),
    OfSphere(SphereId),
}

fn values(model: &Model) -> Vec<(Place, Value)> {
    let mut values = Vec::new();
    for force in model.forces() {
        for set in &force.sets {
            let of_set = set.values.iter().cloned().enumerate();
            values.extend(of_set.map(|(number, value)| (Place::OfSet(force.id, set.id, number), value)));
        }
        values.push((Place::OfForce(force.id), force.transition_velocity.clone()));
    }
    let spheres = model.spheres().iter();
    values.extend(spheres.map(|sphere| (Place::OfSphere(sphere.id), sphere.radius.clone())));
    values
}

/// Every number of the output is either a planned one, exactly, or what it was.
fn values_as_planned(before: &Model, plan: &Plan, after: &Model) {
    let mut planned: HashMap<_, Vec<(u64, u64)>> = HashMap::new();
    for change in &plan.changes {
        let bits = (change.from.to_bits(), change.to.to_bits());
        planned.entry((change.line, change.property)).or_default().push(bits);
    }
    let (old, new) = (values(before), values(after));
    assert_eq!(old.len(), new.len(), "a force, a set or a sphere came or went");
    let mut changed = 0;
    for ((old_place, old), (new_place, new)) in old.iter().zip(&new) {
        assert_eq!((old_place, old.property), (new_place, new.property));
        let bits = (old.number.to_bits(), new.number.to_bits());
        let line = before.document().position(old.offset).line;
        let is_planned = planned.get(&(line, old.property)).is_some_and(|pairs| pairs.contains(&bits));
        changed += usize::from(is_planned);
        assert!(
            is_planned || bits.0 == bits.1 || (old.number.is_nan() && new.number.is_nan()),
            "{} went from {} to {}, which nobody planned",
            old.property.as_str(),
            old.number,
            new.number
        );
    }
    assert!(changed >= plan.changes.len(), "{} changes, {changed} of them made", plan.changes.len());
}

/// What the note says is where the next run starts.
fn second_run(again: &Model, request: &Request, scope: Scope) {
    let told = MassRequest::default().contacts_mass(again);
    if scope == Scope::Partial {
        return accept(&told.expect_err("a partial note must be asked about"));
    }
    let (contacts_mass, _warnings) = told.expect("a complete note is trusted");
    assert_eq!(contacts_mass.source, MassSource::Note);
    // The note has 15 digits of it.
    let said = contacts_mass.kg / request.wanted.target_mass_kg;
    assert!((said - 1.0).abs() < 1e-14, "{} kg", contacts_mass.kg);
    // Another factor would change the radii again.
    let radius = match request.wanted.radius {
        RadiusRule::Factor(_) => RadiusRule::Isometric,
        other => other,
    };
    let mut same = request.wanted.clone();
    same.target_mass_kg = contacts_mass.kg;
    same.contacts_mass = contacts_mass;
    same.radius = radius;
    same.target_gravity_m_s2 = None;
    let plan = rescale(again, &request.selected, &same).expect("nothing to do is always possible");
    assert!(plan.is_empty(), "running twice changes something");
    let mut back = same;
    back.target_mass_kg = back.contacts_mass.kg / 3.0;
    match rescale(again, &request.selected, &back) {
        Ok(plan) => {
            let patched = plan.patched(again, FileId::MAIN).expect("the edits of a plan do not overlap");
            outside_equal(again.document().bytes(), &plan.edits(again, FileId::MAIN).expect("every number can be written"), &patched);
            let third = Model::parse(patched).expect("the second output is a model");
            values_as_planned(again, &plan, &third);
            if !plan.is_empty() {
                // A step has the old mass as people read it, with seven digits.
                assert_eq!(third.note.as_ref().map(Note::text), plan.note().map(Note::text));
                let gravity = |model: &Model| model.note.as_ref().and_then(|note| note.gravity_m_s2);
                assert_eq!(gravity(&third), gravity(again), "nobody asked for another gravity");
                assert_eq!(comments(again), comments(&third), "the second run left a second note");
            }
        }
        Err(fault) => accept(&fault),
    }
}

fn comments(model: &Model) -> usize {
    let pieces = model.document().tree().pieces();
    pieces.filter(|piece| piece.kind == PieceKind::Comment).count()
}

fn with_model(bytes: &[u8], check: impl FnOnce(&Model)) {
    match Model::parse(bytes) {
        Ok(model) => check(&model),
        Err(fault) => accept(&fault),
    }
}

fn with_plan(bytes: &[u8], check: impl FnOnce(&Model, &Request, Plan)) {
    with_model(bytes, |model| {
        let request = match Request::of(bytes, model) {
            Ok(request) => request,
            Err(fault) => return accept(&fault),
        };
        match request.plan(model) {
            Ok(plan) => check(model, &request, plan),
            Err(fault) => accept(&fault),
        }
    });
}
