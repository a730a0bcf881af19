//! The file in which the Scale Tool says what it did.

use std::collections::BTreeMap;

use crate::model::{Anatomy, Document, FactorQuestion, Fault, FaultKind, Needed};

use super::body_factors::length;
use super::copy::{SharedJoints, SharedOffset};

/// A joint that is further than this from where the file puts it, relative to its distance from the body's origin, says that
/// the file was applied to another model.
const OTHER_REFERENCE: f64 = 0.01;
/// Below this, a difference is one of spelling, m.
const SPELLING_M: f64 = 1e-6;

/// Factors from the Scale Tool's applied ScaleSet file, by body name: see [`Factors`](crate::compare::follow::Factors) for an example.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScaleFile(BTreeMap<String, [f64; 3]>);

impl ScaleFile {
    /// Factors along x, y and z by body, where they are known without a file.
    #[must_use]
    pub fn of_factors(factors: BTreeMap<String, [f64; 3]>) -> Self {
        Self(factors)
    }

    /// Reads `<ScaleSet>`: `<Scale><scales>sx sy sz</scales><segment>body</segment><apply>true</apply></Scale>`.
    ///
    /// # Errors
    /// Another document, factors that are not three numbers above 0, or two that contradict each other.
    pub fn read(document: &Document) -> Result<Self, Fault> {
        Self::read_unlocated(document).map_err(|fault| fault.located(document.bytes()))
    }

    /// The factors of `body` along x, y and z.
    ///
    /// # Errors
    /// The file does not have it.
    pub fn of(&self, body: &str) -> Result<[f64; 3], Fault> {
        self.factors(body).ok_or_else(|| {
            Fault::refused(format!(
                "no factors of {body} are known, expected some for each body with spheres"
            ))
        })
    }

    fn read_unlocated(document: &Document) -> Result<Self, Fault> {
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ScaleSet" {
            let text = format!(
                "the document holds a <{}>, expected the <ScaleSet> that the Scale Tool writes (its output_scale_file)",
                tree.name(root)
            );
            return Err(Fault::over(FaultKind::Refused(text), tree.open_span(root)));
        }
        let mut factors: BTreeMap<String, [f64; 3]> = BTreeMap::new();
        let scales = tree.child(root, "objects").into_iter().flat_map(|objects| tree.children(objects));
        for scale in scales.filter(|&scale| tree.name(scale) == "Scale") {
            let Some(segment) =
                tree.child(scale, "segment").map(|segment| tree.text_of(segment).into_owned())
            else {
                continue;
            };
            let applied = document.flag(scale, "apply")?.unwrap_or(true);
            let values = if applied { document.triple(scale, "scales") } else { Some([1.0; 3]) };
            let Some(values) =
                values.filter(|values| values.iter().all(|value| *value > 0.0 && value.is_finite()))
            else {
                let text = format!("the scales of segment {segment} are not three numbers above 0");
                return Err(Fault::over(FaultKind::Refused(text), tree.span(scale)));
            };
            if factors.insert(segment.clone(), values).is_some_and(|other| other != values) {
                let text = format!("segment {segment} appears twice with different scales");
                return Err(Fault::over(FaultKind::Refused(text), tree.span(scale)));
            }
        }
        Ok(Self(factors))
    }

    pub(super) fn factors(&self, body: &str) -> Option<[f64; 3]> {
        self.0.get(body).copied()
    }

    /// Checks that the file's factors lead from `reference` to `scaled`, by the joints on bodies that carry spheres.
    ///
    /// # Errors
    /// They do not: the file belongs to another generic model.
    pub(super) fn refuse_other_reference(
        &self,
        scaled: &Anatomy,
        reference: &Anatomy,
        bodies: &[&str],
    ) -> Result<(), Fault> {
        let joints = SharedJoints::of(scaled, reference);
        for &body in bodies {
            let Some(factors) = self.factors(body) else { continue };
            for &SharedOffset { joint, old_m: old, new_m: new } in joints.on(body) {
                let expected: [f64; 3] = std::array::from_fn(|axis| old[axis] * factors[axis]);
                let apart: [f64; 3] = std::array::from_fn(|axis| new[axis] - expected[axis]);
                if length(apart) > SPELLING_M + OTHER_REFERENCE * length(expected) {
                    let (body, joint) = (body.to_owned(), joint.to_owned());
                    let question = FactorQuestion::OtherReference { body, joint, apart_m: length(apart) };
                    return Err(Fault::new(Needed::Factors(question)));
                }
            }
        }
        Ok(())
    }
}
