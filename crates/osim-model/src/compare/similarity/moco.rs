//! The bounds in an optimisation problem of OpenSim Moco whose units contain length or time.

use std::collections::HashMap;

use crate::model::opensim_text;
use crate::model::{Document, ElementId, Fault, Model, NotRead, SizedKind, SizedValue, SizedValues};

/// Reads the bounds in a setup file of Moco (`.omoco`): of time, and of the values and speeds of coordinates. `model` says which
/// coordinates are angles. Activations, controls and normalised tendon forces have no unit and are left out.
pub fn moco_bounds(setup: &Document, model: &Model) -> SizedValues {
    let tree = setup.tree();
    let angles = model.coordinates_are_angles();
    let (mut found, mut phases) = (SizedValues::default(), 0_usize);
    let mut patterns = 0_usize;
    tree.walk(setup.data_root(), |id| {
        match tree.name(id) {
            "MocoPhase" => phases += 1,
            // The problem has its model in it.
            "ModelProcessor" => return false,
            "MocoInitialBounds" | "MocoFinalBounds" => {
                let name = tree.attribute(id, "name").unwrap_or_default();
                if let Some(part) =
                    ["time_initial_bounds", "time_final_bounds"].into_iter().find(|one| *one == name)
                {
                    let owner = format!("phase {phases}");
                    push_bounds(&mut found, setup, id, ("bounds", part), SizedKind::MocoTime, &owner);
                }
            }
            "MocoVariableInfo" => {
                let list = tree.parent(id).map(|list| tree.name(list)).unwrap_or_default();
                let name = tree.attribute(id, "name").unwrap_or_default();
                match list {
                    "state_infos" => {
                        if let Some(kind) = state_kind(&name, &angles) {
                            let owner = format!("phase {phases} {name}");
                            for part in ["bounds", "initial_bounds", "final_bounds"] {
                                push_bounds(&mut found, setup, id, (part, part), kind, &owner);
                            }
                        }
                    }
                    "state_infos_pattern" => patterns += 1,
                    _ => {}
                }
            }
            _ => {}
        }
        true
    });
    if patterns > 0 {
        found.not_read.push(NotRead::new("state_infos_pattern", patterns, "states of several dimensions"));
    }
    found
}

pub fn refuse_without_moco_phase(setup: &Document) -> Result<(), Fault> {
    let tree = setup.tree();
    if tree.elements().any(|id| tree.name(id) == "MocoPhase") {
        return Ok(());
    }
    let tag = tree.name(setup.data_root());
    Err(Fault::refused(format!("the document holds a {tag}, expected a MocoStudy with a MocoPhase")))
}

/// The kind of number that a bound of a state has: the state's path names the value or the speed of a coordinate.
fn state_kind(path: &str, angles: &HashMap<&str, Option<bool>>) -> Option<SizedKind> {
    let mut segments = path.rsplit('/');
    let (what, coordinate) = (segments.next()?, segments.next()?);
    let is_angle = angles.get(coordinate).copied().flatten()?;
    match (what, is_angle) {
        ("value", false) => Some(SizedKind::MocoTranslation),
        ("speed", false) => Some(SizedKind::MocoSpeed),
        ("speed", true) => Some(SizedKind::MocoAngularSpeed),
        _ => None,
    }
}

fn push_bounds(
    found: &mut SizedValues,
    setup: &Document,
    owner: ElementId,
    (tag, part): (&str, &'static str),
    kind: SizedKind,
    name: &str,
) {
    let tree = setup.tree();
    let text = tree.child(owner, tag).map(|element| tree.text_of(element)).unwrap_or_default();
    let numbers = opensim_text::numbers(&text).unwrap_or_default();
    // One number is both bounds.
    for (place, value) in numbers.into_iter().take(2).enumerate().filter(|(_, value)| value.is_finite()) {
        found.values.push(SizedValue { kind, owner: name.to_owned(), part: (part, place), value });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = r#"<OpenSimDocument Version="40000"><Model><BodySet><objects><Body name="b"><mass>1</mass></Body></objects></BodySet>
        <JointSet><objects><PlanarJoint name="j"><socket_parent_frame>/ground</socket_parent_frame>
        <socket_child_frame>/bodyset/b</socket_child_frame><coordinates><Coordinate name="turn"/><Coordinate name="x"/>
        <Coordinate name="y"/></coordinates></PlanarJoint></objects></JointSet></Model></OpenSimDocument>"#;
    // The elements are those that `MocoStudy.printToXML` of OpenSim 4.6 writes; the model in it has a state of its own name.
    const SETUP: &str = r#"<OpenSimDocument Version="40600"><MocoStudy><MocoProblem name="problem"><MocoPhase name="phases">
        <ModelProcessor name="model"><model><MocoVariableInfo name="/jointset/j/y/value"><bounds>9 9</bounds></MocoVariableInfo></model></ModelProcessor>
        <MocoInitialBounds name="time_initial_bounds"><bounds>0</bounds></MocoInitialBounds>
        <MocoFinalBounds name="time_final_bounds"><bounds>0.4 0.6</bounds></MocoFinalBounds>
        <state_infos>
            <MocoVariableInfo name="/jointset/j/turn/value"><bounds>-1 1</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/turn/speed"><bounds>-20 20</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/y/value"><bounds>0.8 1.1</bounds><initial_bounds>0.9</initial_bounds></MocoVariableInfo>
            <MocoVariableInfo name="/jointset/j/x/speed"><bounds>0 2</bounds></MocoVariableInfo>
            <MocoVariableInfo name="/forceset/vasti/activation"><bounds>0 1</bounds></MocoVariableInfo>
        </state_infos>
        <state_infos_pattern><MocoVariableInfo name="/jointset/.*/speed"><bounds>-30 30</bounds></MocoVariableInfo></state_infos_pattern>
        <control_infos><MocoVariableInfo name="/y/value"><bounds>-50 50</bounds></MocoVariableInfo></control_infos>
        </MocoPhase></MocoProblem></MocoStudy></OpenSimDocument>"#;

    #[test]
    fn bounds_with_a_length_or_a_time_are_read() {
        let setup = Document::parse(SETUP).unwrap();
        let found = moco_bounds(&setup, &Model::parse(MODEL).unwrap());
        let of = |kind| -> Vec<f64> {
            found.values.iter().filter(|one| one.kind == kind).map(|one| one.value).collect()
        };
        assert_eq!(of(SizedKind::MocoTime), [0.0, 0.4, 0.6]);
        assert_eq!(of(SizedKind::MocoTranslation), [0.8, 1.1, 0.9]);
        assert_eq!(of(SizedKind::MocoSpeed), [0.0, 2.0]);
        assert_eq!(of(SizedKind::MocoAngularSpeed), [-20.0, 20.0]);
        assert_eq!(found.values.len(), 10);
        assert_eq!(found.not_read, [NotRead::new("state_infos_pattern", 1, "states of several dimensions")]);
    }

    #[test]
    fn a_document_without_a_problem_is_refused() {
        let model = Document::parse(MODEL).unwrap();
        assert!(refuse_without_moco_phase(&model).unwrap_err().to_string().contains("holds a Model"));
        assert!(refuse_without_moco_phase(&Document::parse(SETUP).unwrap()).is_ok());
    }
}
