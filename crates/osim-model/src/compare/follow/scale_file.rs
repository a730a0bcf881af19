//! Reads the file in which the Scale Tool writes its factors.

use std::collections::BTreeMap;

use glam::DVec3;

use super::body_factors::SharedOffset;
use super::scaled_copy::SharedJoints;
use crate::model::{Anatomy, Document, Fault, FaultKind, MissingFact, Result, UnknownFactors};

/// If a joint is farther than this part of its distance from the place that the file's factors give, the file was applied to another model.
const LARGEST_JOINT_ERROR: f64 = 0.01;
/// Offsets may differ by this length, m, because numbers are rounded when they are written.
const ROUNDING_OF_OFFSETS_M: f64 = 1e-6;

/// The factors in the ScaleSet file that the Scale Tool wrote, by body name: see [`Factors`](crate::compare::follow::Factors) for an
/// example.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScaleFile(BTreeMap<String, [f64; 3]>);

impl ScaleFile {
    /// The factors along x, y and z of each body from other data than a file.
    pub fn from_factors(factors: BTreeMap<String, [f64; 3]>) -> Self {
        Self(factors)
    }

    /// Reads the factors from `<ScaleSet>`: `<Scale><scales>sx sy sz</scales><segment>body</segment><apply>true</apply></Scale>`.
    ///
    /// # Errors
    /// The document is not a ScaleSet, a body's factors are not three numbers above 0, or two entries of one body differ.
    pub fn read(document: &Document) -> Result<Self> {
        Self::read_unlocated(document).map_err(|fault| fault.located(document.bytes()))
    }

    /// The scale factors of `body` along x, y and z.
    ///
    /// # Errors
    /// The file has no factors of this body.
    pub fn required_factors(&self, body: &str) -> Result<[f64; 3]> {
        self.factors(body).ok_or_else(|| {
            Fault::refused(format!(
                "no factors of {body} are known, expected some for each body with spheres"
            ))
        })
    }

    fn read_unlocated(document: &Document) -> Result<Self> {
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ScaleSet" {
            let text = format!(
                "the document holds a <{}>, expected the <ScaleSet> that the Scale Tool writes (its output_scale_file)",
                tree.name(root)
            );
            return Err(Fault::at_span(FaultKind::Refused(text), tree.open_span(root)));
        }
        let mut factors: BTreeMap<String, [f64; 3]> = BTreeMap::new();
        let scales = tree.child(root, "objects").into_iter().flat_map(|objects| tree.children(objects));
        for scale in scales.filter(|&scale| tree.name(scale) == "Scale") {
            let Some(segment) = tree.child(scale, "segment") else { continue };
            let segment = tree.text_of(segment).into_owned();
            let applied = document.flag(scale, "apply")?.unwrap_or(true);
            let values = if applied { document.triple(scale, "scales") } else { Some([1.0; 3]) };
            let is_factor = |value: &f64| *value > 0.0 && value.is_finite();
            let Some(values) = values.filter(|values| values.iter().all(is_factor)) else {
                let text = format!("the scales of segment {segment} are not three numbers above 0");
                return Err(Fault::at_span(FaultKind::Refused(text), tree.span(scale)));
            };
            if factors.insert(segment.clone(), values).is_some_and(|other| other != values) {
                let text = format!("segment {segment} appears twice with different scales");
                return Err(Fault::at_span(FaultKind::Refused(text), tree.span(scale)));
            }
        }
        Ok(Self(factors))
    }

    pub(super) fn factors(&self, body: &str) -> Option<[f64; 3]> {
        self.0.get(body).copied()
    }

    /// Checks that the file's factors take the joints of `reference` to their places in `scaled`, on all bodies with spheres.
    ///
    /// # Errors
    /// A joint is somewhere else: the file belongs to another generic model.
    pub(super) fn refuse_other_reference(
        &self,
        scaled: &Anatomy,
        reference: &Anatomy,
        bodies: &[&str],
    ) -> Result<()> {
        let joints = SharedJoints::of(scaled, reference);
        for &body in bodies {
            let Some(factors) = self.factors(body) else { continue };
            for &SharedOffset { joint, reference_m: old, scaled_m: new } in joints.on(body) {
                let expected = old * DVec3::from(factors);
                let apart_m = new.distance(expected);
                if apart_m > ROUNDING_OF_OFFSETS_M + LARGEST_JOINT_ERROR * expected.length() {
                    let (body, joint) = (body.to_owned(), joint.to_owned());
                    let doubt = UnknownFactors::OtherReference { body, joint, apart_m };
                    return Err(Fault::new(MissingFact::Factors(doubt)));
                }
            }
        }
        Ok(())
    }
}
