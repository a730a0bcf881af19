//! Scale factors of each body, axis by axis, from the sources in their order.

use std::collections::BTreeMap;

use foldhash::HashSet;

use super::body_factors::{AXIS_NAMES, AxisFactor, BodyFactors, BodyIndex, ComparedJoints};
use super::scaled_copy::{self, CopyDifference, ScaleFile};
use super::sources::{self, Sources};
use crate::messages::Phrase;
use crate::model::{Anatomy, Fault, FaultKind, Finding, Needed, rules};

/// Factors of all bodies of a model against those of a reference: new lengths over old ones.
///
/// Where the model is a scaled copy of the reference, so that there is no [`difference`](Self::difference), each axis comes from
/// the first source that has it, exactly: what the caller gives, the Scale Tool's file, meshes, joint offsets. Between different
/// models, offsets are not factors: then a body's factors are the ratio of the mesh factors of the same bone, else one ratio of
/// distances to a joint below it; a body at the end of a limb takes those of its parent body. Left and right take the
/// same source.
///
/// ```
/// use std::collections::BTreeMap;
/// use osim_model::{Anatomy, Document, Model};
/// use osim_model::compare::{FactorSource, Factors, ScaleFile};
///
/// # let bytes: &[u8] = include_bytes!("../../../tests/data/one_foot.osim");
/// // The file in which the Scale Tool says what it did: foot_r is 1.2 times as long.
/// let text = r#"<OpenSimDocument Version="40000"><ScaleSet><objects><Scale>
///     <scales>1.2 1.1 1</scales><segment>foot_r</segment><apply>true</apply>
/// </Scale></objects></ScaleSet></OpenSimDocument>"#;
/// let file = ScaleFile::read(&Document::parse(text)?)?;
///
/// // The model here has no meshes and no joints, which would say the same.
/// let anatomy = Anatomy::of(&Model::parse(bytes)?)?;
/// let factors = Factors::find(&anatomy, &anatomy, Some(&file), &BTreeMap::new())?;
/// assert_eq!(factors.body_factors("foot_r")?, [1.2, 1.1, 1.0]);
/// assert_eq!(factors.bodies[0].axes[0].map(|axis| axis.source), Some(FactorSource::ScaleFile));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    /// In file order of the scaled model.
    pub bodies: Vec<BodyFactors>,
    /// Where sources disagree on bodies that carry spheres: by more than 1 % in a scaled copy, 5 % between different models; and
    /// that the models are different.
    pub findings: Vec<Finding>,
    /// Other decisions, such as factors that a body takes from its parent.
    pub remarks: Vec<Phrase>,
    /// What shows that the model is not a scaled copy of the reference; `None` where it is one.
    pub difference: Option<CopyDifference>,
    by_name: BodyIndex,
}

impl Factors {
    /// Compares `scaled` with the `reference` it came from, or with any other model. `given` has factors along x, y and z by body
    /// name, which count more than any other source.
    ///
    /// # Errors
    /// Factors given for a body that is not there, or a file that was applied to another model than the reference.
    pub fn find(
        scaled: &Anatomy,
        reference: &Anatomy,
        file: Option<&ScaleFile>,
        given: &BTreeMap<String, [f64; 3]>,
    ) -> Result<Self, Fault> {
        if let Some(name) = given.keys().find(|name| !scaled.has_body(name)) {
            return Err(Fault::new(FaultKind::UnknownBody { body: name.clone() }));
        }
        let carriers = carriers(scaled, reference);
        if let Some(file) = file {
            file.refuse_other_reference(scaled, reference, &carriers)?;
        }
        let difference = scaled_copy::difference(scaled, reference);
        let distances = difference.as_ref().map(|_| ComparedJoints::of(scaled, reference));
        let all_sources: Vec<Sources> = scaled
            .bodies
            .iter()
            .map(|body| Sources::of(scaled, reference, body, file, given.get(body), distances.as_ref()))
            .collect();
        let mut factors = Self {
            bodies: Vec::new(),
            findings: Vec::new(),
            remarks: Vec::new(),
            difference,
            by_name: BodyIndex::default(),
        };
        let taken = sources::choose_factors(&all_sources);
        for (sources, axes) in all_sources.iter().zip(taken) {
            factors.bodies.push(BodyFactors {
                body: sources.body.to_owned(),
                axes,
                sources: sources.by_source.clone(),
                question: None,
            });
        }
        factors.by_name = BodyIndex::of(&factors.bodies);
        if let Some(difference) = &factors.difference {
            factors.findings.push(rules::not_a_scaled_copy(difference.phrase()));
            factors.remarks =
                sources::inherit_from_body_above(&mut factors.bodies, &factors.by_name, scaled, &carriers);
            sources::add_questions(&mut factors.bodies, &factors.by_name, &all_sources, scaled);
        }
        factors.question_impossible_factors();
        let carrying: HashSet<&str> = carriers.into_iter().collect();
        for sources in all_sources.iter().filter(|sources| carrying.contains(&sources.body)) {
            let messages = sources.disagreements(&factors.by_name.axes(&factors.bodies, sources.body));
            factors.findings.extend(messages.into_iter().map(rules::factors_disagree));
        }
        Ok(factors)
    }

    /// Replaces factors that no length can have, such as 0, by questions.
    fn question_impossible_factors(&mut self) {
        for body in &mut self.bodies {
            let bad = AXIS_NAMES.iter().zip(body.axes).find_map(|(name, axis)| {
                let AxisFactor { factor, source } = axis?;
                (!(factor.is_finite() && factor > 0.0)).then_some((name, factor, source))
            });
            let Some((name, factor, source)) = bad else { continue };
            body.question = Some(Fault::refused(format!(
                "the {name} factor of body {} is {factor} ({}), expected a finite number above 0",
                body.body,
                source.as_str()
            )));
            body.axes = [None; 3];
        }
    }

    /// The factors of `body` along x, y and z.
    ///
    /// # Errors
    /// - An axis that no source determines ([`Needed::BodyFactors`]): the body and axis are named.
    /// - Between different models, a question about the body ([`Needed::Factors`]).
    /// - A factor that is zero, negative or not finite.
    pub fn body_factors(&self, body: &str) -> Result<[f64; 3], Fault> {
        let found = self.by_name.place(body).and_then(|at| self.bodies.get(at));
        if let Some(question) = found.and_then(|found| found.question.clone()) {
            return Err(question);
        }
        let axes = self.by_name.axes(&self.bodies, body);
        let missing: Vec<&str> =
            AXIS_NAMES.iter().zip(&axes).filter(|(_, axis)| axis.is_none()).map(|(name, _)| *name).collect();
        match axes {
            [Some(x), Some(y), Some(z)] => Ok([x.factor, y.factor, z.factor]),
            _ => Err(Fault::new(Needed::BodyFactors { body: body.to_owned(), axes: missing })),
        }
    }
}

/// Bodies of `scaled` that carry spheres, there or in the reference: only their factors matter.
fn carriers<'a>(scaled: &'a Anatomy, reference: &'a Anatomy) -> Vec<&'a str> {
    let spheres = scaled.spheres.iter().chain(&reference.spheres);
    let carrying: HashSet<&str> = spheres.filter_map(|sphere| sphere.body.as_deref()).collect();
    scaled.bodies.iter().map(String::as_str).filter(|body| carrying.contains(body)).collect()
}
