//! The rows of `check`: judges six topics of every model, and one topic of a recording, in one line each. The line has the worst finding,
//! or says that all is right.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use contact_scaling::limits;
use osim_model::feet::{ContactPlane, DefaultPose};
use osim_model::messages::{Phrase, counted, four_significant, named, phrase, shown, three_significant};
use osim_model::{FindingCode, MassSource, Model, Severity, Side, VerdictTopic};
use serde::{Serialize, Serializer};

use crate::inspection::{Inspection, StandingBody, step_in_words};
use crate::rules::floors;
use crate::{Figure, FindingWithRemedy, SphereFigures};

/// What is right or wrong with a model in one topic.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(deny_unknown_fields))]
pub struct Verdict {
    /// The topic: `floor`, `standing`, `mass`, `sides`, `sizes` or `solver`; with a recording `motion`, too.
    #[serde(serialize_with = "name")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub on: VerdictTopic,
    /// The result: `good`, `remark`, `warning`, `error` or `unknown`.
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub sign: Sign,
    /// The result in words, with the number that decides.
    #[serde(serialize_with = "text")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub text: Phrase,
    /// Component path of the force, sphere or body that decides, if there is one.
    pub place: Option<String>,
    /// Codes of the findings about the topic, the worst first; empty if all is right or not known.
    #[serde(serialize_with = "codes")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub codes: Vec<FindingCode>,
}

named! {
    /// The result of a topic: good, the severity of the worst finding, or unknown. The JSON of a verdict has exactly these five.
    #[derive(Serialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Sign {
        /// No finding is about the topic.
        Good = "good",
        Remark = "remark",
        Warning = "warning",
        Error = "error",
        /// Something that decides is not known.
        Unknown = "unknown",
    }
}

impl From<Severity> for Sign {
    fn from(severity: Severity) -> Self {
        match severity {
            Severity::Remark => Self::Remark,
            Severity::Warning => Self::Warning,
            Severity::Error => Self::Error,
        }
    }
}

impl Verdict {
    /// A verdict with the text of the worst finding and the codes of all findings.
    pub(crate) fn from_findings(
        on: VerdictTopic,
        worst: &FindingWithRemedy,
        others: &[&FindingWithRemedy],
    ) -> Self {
        let mut codes = vec![worst.code()];
        for code in others.iter().map(|found| found.code()) {
            if !codes.contains(&code) {
                codes.push(code);
            }
        }
        let (sign, text) = (worst.severity.into(), worst.message.clone());
        Self { on, sign, text, place: worst.place.clone(), codes }
    }

    /// The verdict on a topic without findings: the text says what is right, or why this is not known.
    pub(crate) fn without_findings(on: VerdictTopic, right: Result<Phrase, Phrase>) -> Self {
        let (sign, text) = match right {
            Ok(text) => (Sign::Good, text),
            Err(why) => (Sign::Unknown, why),
        };
        Self { on, sign, text, place: None, codes: Vec::new() }
    }
}

fn name<S: Serializer>(on: &VerdictTopic, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(on.as_str())
}

fn text<S: Serializer>(text: &Phrase, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(text)
}

fn codes<S: Serializer>(codes: &[FindingCode], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(codes.iter().map(|code| code.as_str()))
}

/// A model with its inspection, from which its verdicts follow.
struct InspectedModel<'k> {
    model: &'k Model,
    inspection: &'k Inspection,
}

impl InspectedModel<'_> {
    /// The largest value of a figure among the chosen spheres.
    fn largest(&self, figure: Figure) -> Option<f64> {
        self.values_of_figure(figure).reduce(f64::max)
    }

    /// The smallest value of a figure among the chosen spheres.
    fn smallest(&self, figure: Figure) -> Option<f64> {
        self.values_of_figure(figure).reduce(f64::min)
    }

    /// The known values of a figure among the chosen spheres.
    fn values_of_figure(&self, figure: Figure) -> impl Iterator<Item = f64> {
        let spheres = self.inspection.figures.spheres();
        spheres.filter_map(move |sphere: &SphereFigures| sphere.value(figure))
    }

    /// The reason why figures under body weight are absent.
    fn why_no_figures(&self) -> Phrase {
        let why = self.inspection.figures.why_no_body_weight.clone();
        why.unwrap_or_else(|| "no sphere of the chosen forces carries weight".into())
    }
}

/// The verdicts on all topics of a model. `findings` must be sorted, the worst first; those `left_out` follow from them, and have topics.
pub(crate) fn answer_all(
    model: &Model,
    inspected: &Inspection,
    (findings, left_out): (&[FindingWithRemedy], &BTreeMap<FindingCode, Option<VerdictTopic>>),
) -> Vec<Verdict> {
    let inspected = InspectedModel { model, inspection: inspected };
    let all = VerdictTopic::OF_EVERY_MODEL.into_iter();
    all.map(|on| judge_topic(on, &inspected, (findings, left_out))).collect()
}

/// The verdict on one topic: its worst finding, or what is right.
fn judge_topic(
    on: VerdictTopic,
    inspected: &InspectedModel<'_>,
    (findings, left_out): (&[FindingWithRemedy], &BTreeMap<FindingCode, Option<VerdictTopic>>),
) -> Verdict {
    let mut deciding: Vec<&FindingWithRemedy> =
        findings.iter().filter(|found| found.rule.verdict == Some(on)).collect();
    // Of two that are equally bad, masses of bodies come first, because the others follow from them.
    let rank = |code| match code {
        FindingCode::MasslessBody | FindingCode::HeavyFoot => 0,
        FindingCode::ContactsOfAnotherMass => 1,
        _ => 2,
    };
    deciding.sort_by_key(|found| (Reverse(found.severity), rank(found.code())));
    if let Some((worst, others)) = deciding.split_first() {
        let mut verdict = Verdict::from_findings(on, worst, others);
        // A finding about depth does not have the mass that the contacts are made for.
        let depth_codes = [FindingCode::SunkIn, FindingCode::BeyondHertz, FindingCode::BeyondHertzAtTwo];
        let is_about_depth = on == VerdictTopic::Mass && depth_codes.contains(&worst.code());
        if let Some(made_for) = made_for(inspected).filter(|_| is_about_depth) {
            verdict.text.push("; ");
            verdict.text.push(&made_for);
        }
        return verdict;
    }
    let has_finding = |code| findings.iter().any(|found| found.code() == code);
    let (model, inspection) = (inspected.model, inspected.inspection);
    let is_of_other_class = model.forces().is_empty() && !model.carriers_of_other_classes().is_empty();
    let all = findings.iter().map(|found| &found.finding);
    let in_other_units = floors::are_figures_in_other_units(inspection, all);
    let follows_weight = matches!(on, VerdictTopic::Standing | VerdictTopic::Mass | VerdictTopic::Solver);
    let is_on_contacts =
        matches!(on, VerdictTopic::Mass | VerdictTopic::Sides | VerdictTopic::Sizes | VerdictTopic::Solver);
    let is_on_sides = on == VerdictTopic::Sides;
    let is_left_out = left_out.values().any(|topic| *topic == Some(on));
    let is_one_side_misplaced = || is_on_sides && findings.iter().any(is_about_places_on_one_side);
    let reasons = [
        (has_finding(FindingCode::BareModel), "there are no contacts"),
        (is_of_other_class, "contacts of this class are not judged"),
        (follows_weight && in_other_units, "gravity has to be corrected first"),
        (is_on_sides && has_finding(FindingCode::OddNumber), "OpenSim reads another number than is written"),
        (is_on_contacts && has_finding(FindingCode::UnknownName), "OpenSim does not know a name in the file"),
        (is_left_out || is_one_side_misplaced(), "another finding has to be corrected first"),
    ];
    if let Some((_, why)) = reasons.into_iter().find(|(applies, _)| *applies) {
        return Verdict::without_findings(on, Err(why.into()));
    }
    let right = match on {
        VerdictTopic::Floor => describe_floor(inspected),
        VerdictTopic::Standing => describe_standing(inspected),
        VerdictTopic::Mass => describe_mass(inspected),
        VerdictTopic::Sides => describe_sides(inspected),
        VerdictTopic::Sizes => describe_sizes(inspected),
        VerdictTopic::Solver => describe_solver(inspected),
        VerdictTopic::Recording => Err("no recording is given".into()),
    };
    Verdict::without_findings(on, right)
}

/// Whether a warning is about places of spheres of one side alone, so that nothing else says that the sides differ.
fn is_about_places_on_one_side(found: &FindingWithRemedy) -> bool {
    let is_about_places = matches!(found.code(), FindingCode::OddPlace | FindingCode::SpheresMisplaced);
    let has_sphere_on = |side| found.spheres.iter().any(|name| Side::of_name(name) == Some(side));
    is_about_places
        && found.severity > Severity::Remark
        && has_sphere_on(Side::Left) != has_sphere_on(Side::Right)
}

/// Describes the plane that most spheres press on: its tilt and the body that carries it.
fn describe_floor(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let model = inspected.model;
    let planes = ContactPlane::all(model, &model.force_ids(), &DefaultPose::of(model));
    // The first of several with equally many spheres.
    let main = planes.iter().reduce(|a, b| if b.spheres.len() > a.spheres.len() { b } else { a });
    let plane = main.ok_or_else(|| Phrase::from("no moving sphere meets a half-space"))?;
    let name = shown(&plane.plane.name).to_string();
    let Some(surface) = plane.surface else {
        return Err(format!("the orientation of {name} is not known").into());
    };
    let carrier =
        plane.plane.body.as_deref().map_or_else(|| "ground".to_owned(), |body| shown(body).to_string());
    let others = match planes.len() {
        1 => String::new(),
        2 => "; one more plane".to_owned(),
        count => format!("; {} more planes", count - 1),
    };
    let degrees = (surface.tilt_rad.to_degrees() * 100.0).round() / 100.0;
    let floor = floors::floor_in_words(&plane.plane.name);
    let lies = if degrees == 0.0 { "is level".to_owned() } else { format!("is tilted by {degrees} degrees") };
    Ok(format!("{floor} {lies} and is fixed to {carrier}{others}").into())
}

/// Describes how high the lowest sphere starts, and with which coordinate the body stands.
fn describe_standing(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let describe = |body: &StandingBody| {
        Some(format!(
            "at the default pose the lowest sphere is {}; {}",
            body.pose_in_words()?,
            body.describe_way_to_stand()
        ))
    };
    let first = inspected.inspection.standing.iter().find_map(describe);
    first.map(Phrase::from).ok_or_else(|| "the height of its spheres over a floor is not known".into())
}

/// Describes the mass that the contacts are made for, and how deep the deepest sphere is under the body.
fn describe_mass(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let deepest = inspected.largest(Figure::Indentation).ok_or_else(|| inspected.why_no_figures())?;
    let weighs = inspected.inspection.figures.mass_kg.map(four_significant).unwrap_or_default();
    let made_for = made_for(inspected).unwrap_or_else(|| "no note says for which mass they were made".into());
    let x_hat = four_significant(deepest);
    let on = &inspected.inspection.carriers;
    Ok(phrase![&made_for, format!("; under {weighs} kg on {on} the deepest sphere sinks in {x_hat} R")])
}

/// The recorded mass that the contacts are made for: `made for 500 kg (note in the file, by rescale)`.
fn made_for(inspected: &InspectedModel<'_>) -> Option<Phrase> {
    let mass = inspected.inspection.contacts_mass_kg.as_ref().filter(|mass| mass.from.is_about_contacts())?;
    let note = inspected.model.note.as_ref().filter(|_| mass.source == MassSource::Note.as_str());
    let by = note.and_then(|note| note.steps.last()).map(|step| format!(", by {}", step_in_words(step)));
    let kg = four_significant(mass.value);
    Some(phrase!["made for {kg} kg ({}{})"; &mass.description, by.unwrap_or_default()])
}

/// Describes how many spheres each limb has, and whether left and right agree.
fn describe_sides(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let inspection = inspected.inspection;
    let Some(limbs) = inspection.limbs.as_deref().filter(|limbs| !limbs.is_empty()) else {
        return Err(inspection.limbs_unknown.clone().unwrap_or_else(|| "limbs are not known".into()));
    };
    let count_on = |side: &str| -> usize {
        limbs.iter().filter(|limb| limb.side == side).map(|limb| limb.spheres.len()).sum()
    };
    let spheres = |count| counted(count, "sphere");
    Ok(match (count_on("right"), count_on("left")) {
        (0, some) | (some, 0) => format!("there is one side only ({})", spheres(some)),
        (right, left) if right == left => format!("left and right agree ({} each)", spheres(right)),
        (right, left) => format!(
            "the contacts that both sides have agree ({} on the right, {} on the left)",
            spheres(right),
            spheres(left)
        ),
    }
    .into())
}

/// Describes the radii of the spheres.
fn describe_sizes(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let radii = inspected.smallest(Figure::Radius).zip(inspected.largest(Figure::Radius));
    let (least, most) = radii.ok_or_else(|| inspected.why_no_figures())?;
    let (least, most) = (three_significant(least * 1e3), three_significant(most * 1e3));
    // One number if both look the same.
    let range = if least == most { least } else { format!("{least} to {most}") };
    Ok(format!("radii of {range} mm").into())
}

/// Describes the properties of the contacts that matter for a solver: transition width, restitution and natural frequency.
fn describe_solver(inspected: &InspectedModel<'_>) -> Result<Phrase, Phrase> {
    let least = inspected.smallest(Figure::RestitutionExact).ok_or_else(|| inspected.why_no_figures())?;
    let mut text = match inspected.largest(Figure::TransitionWidth) {
        Some(width) => format!(
            "smoothing switches contact on over {} R (limit {} R)",
            three_significant(width),
            limits::TRANSITION_WIDTH.value
        ),
        None => "contact switches on at once, without smoothing".to_owned(),
    };
    if let Some(speed) = inspected.inspection.figures.impact_speed_m_s {
        let (least, speed) = (three_significant(least), three_significant(speed));
        text.push_str(&format!("; restitution {least} at {speed} m/s"));
    }
    if let Some(frequency) = inspected.largest(Figure::NaturalFrequency) {
        text.push_str(&format!("; a rigid body would bounce on it at {} Hz", three_significant(frequency)));
    }
    Ok(text.into())
}
