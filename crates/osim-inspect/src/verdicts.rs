//! Six questions about every model, and one about a recording, each answered in one line: what was found decides, else what is right about it.

use std::cmp::Reverse;

use osim_model::feet::{ContactPlane, DefaultPose};
use osim_model::messages::{Phrase, counted, four_significant, phrase, readable, shown, three_significant};
use osim_model::{FindingCode, MassSource, Model, Severity, VerdictOn};
use osim_requests::spell::Speller;
#[cfg(feature = "schemas")]
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use crate::figures::{Figure, SphereFigures};
use crate::findings::Found;
use crate::inspection::{Inspection, StandingBody, step_in_words};

/// The answer to one of the six questions, or to that of a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schemas", derive(JsonSchema), schemars(deny_unknown_fields))]
pub struct Verdict {
    /// What it is on: `floor`, `standing`, `mass`, `sides`, `sizes` or `solver`; with a recording `motion`, too.
    #[serde(serialize_with = "name")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub on: VerdictOn,
    /// How it is: `good`, `remark`, `warning`, `error` or `unknown`.
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub sign: Sign,
    /// The answer in words, with the number that decides.
    #[serde(serialize_with = "text")]
    #[cfg_attr(feature = "schemas", schemars(with = "String"))]
    pub text: Phrase,
    /// Component path of the force, sphere or body that decides, where there is one.
    pub place: Option<String>,
    /// Codes of the findings that are about it, the worst first; empty if it is right or not known.
    #[serde(serialize_with = "codes")]
    #[cfg_attr(feature = "schemas", schemars(with = "Vec<String>"))]
    pub codes: Vec<FindingCode>,
}

/// How a question is answered: right, as bad as the worst finding, or not at all.
///
/// Exhaustive: the JSON of a verdict promises these five.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Sign {
    /// Nothing was found.
    Good,
    Remark,
    Warning,
    Error,
    /// Something that decides is not known.
    Unknown,
}

impl Sign {
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Remark => "remark",
            Self::Warning => "warning",
            Self::Error => "error",
            Self::Unknown => "unknown",
        }
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
    /// The answer to the question whether contacts fit a recording.
    pub fn on_recording(sign: Sign, text: Phrase) -> Self {
        Self { on: VerdictOn::Recording, sign, text, place: None, codes: Vec::new() }
    }

    /// The worst finding decides; the codes of `others` are named.
    fn of_findings(on: VerdictOn, worst: &Found, others: &[&Found]) -> Self {
        let mut codes = vec![worst.code()];
        for code in others.iter().map(|found| found.code()) {
            if !codes.contains(&code) {
                codes.push(code);
            }
        }
        let (sign, text) = (worst.severity.into(), worst.message.clone());
        Self { on, sign, text, place: worst.place.clone(), codes }
    }

    fn and(mut self, more: Option<Phrase>) -> Self {
        if let Some(more) = more {
            self.text.push("; ");
            self.text.push(&more);
        }
        self
    }

    /// What is right, or why that is not known.
    fn without_findings(on: VerdictOn, right: Result<Phrase, Phrase>) -> Self {
        let (sign, text) = match right {
            Ok(text) => (Sign::Good, text),
            Err(why) => (Sign::Unknown, why),
        };
        Self { on, sign, text, place: None, codes: Vec::new() }
    }

    /// Spells what it says in the words of a front end.
    pub(crate) fn spell(&mut self, speller: &dyn Speller) {
        self.text.spell(speller);
    }
}

fn name<S: Serializer>(on: &VerdictOn, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(on.as_str())
}

fn text<S: Serializer>(text: &Phrase, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(text)
}

fn codes<S: Serializer>(codes: &[FindingCode], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(codes.iter().map(|code| code.as_str()))
}

/// A model and what its inspection shows.
struct Known<'k> {
    model: &'k Model,
    inspected: &'k Inspection,
}

impl Known<'_> {
    /// The largest value of a figure among the chosen spheres.
    fn most(&self, figure: Figure) -> Option<f64> {
        self.values(figure).reduce(f64::max)
    }

    /// The least value of a figure among the chosen spheres.
    fn least(&self, figure: Figure) -> Option<f64> {
        self.values(figure).reduce(f64::min)
    }

    fn values(&self, figure: Figure) -> impl Iterator<Item = f64> {
        let spheres = self.inspected.figures.spheres();
        spheres.filter_map(move |sphere: &SphereFigures| sphere.value(figure))
    }

    /// Why figures under body weight are absent.
    fn why_no_figures(&self) -> Phrase {
        let why = self.inspected.figures.why_no_body_weight.clone();
        why.unwrap_or_else(|| "no sphere of the chosen forces carries weight".into())
    }
}

/// Two numbers as a range, or as one number if they look the same.
fn range(least: &str, most: &str) -> String {
    if least == most { least.to_owned() } else { format!("{least} to {most}") }
}

/// The verdicts on a model, in their order. `findings` come the worst first.
pub(crate) fn of(model: &Model, inspected: &Inspection, findings: &[Found]) -> Vec<Verdict> {
    let known = Known { model, inspected };
    VerdictOn::ALL.into_iter().map(|on| of_one(on, &known, findings)).collect()
}

fn of_one(on: VerdictOn, known: &Known<'_>, findings: &[Found]) -> Verdict {
    let mut deciding: Vec<&Found> = findings.iter().filter(|found| found.rule.verdict == Some(on)).collect();
    // Of two that are equally bad, the mass is the reason and the depth what follows.
    deciding
        .sort_by_key(|found| (Reverse(found.severity), found.code() != FindingCode::ContactsOfAnotherMass));
    if let Some((worst, others)) = deciding.split_first() {
        let story = (on == VerdictOn::Mass).then(|| describe_origin(known, worst.code())).flatten();
        return Verdict::of_findings(on, worst, others).and(story);
    }
    if findings.iter().any(|found| found.code() == FindingCode::BareModel) {
        return Verdict::without_findings(on, Err("there are no contacts".into()));
    }
    let right = match on {
        VerdictOn::Floor => describe_floor(known),
        VerdictOn::Standing => describe_standing(known),
        VerdictOn::Mass => describe_mass(known),
        VerdictOn::Sides => describe_sides(known),
        VerdictOn::Sizes => describe_sizes(known),
        VerdictOn::Solver => describe_solver(known),
        VerdictOn::Recording => Err("no recording is given".into()),
    };
    Verdict::without_findings(on, right)
}

/// The plane that most spheres press on: how it lies, and what carries it.
fn describe_floor(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let model = known.model;
    let planes = ContactPlane::all(model, &model.force_ids(), &DefaultPose::of(model));
    // The first of those that equally many press on.
    let most = planes.iter().reduce(|a, b| if b.spheres.len() > a.spheres.len() { b } else { a });
    let plane = most.ok_or_else(|| Phrase::from("no moving sphere meets a half-space"))?;
    let name = shown(&plane.plane.name).to_string();
    let Some(surface) = plane.surface else {
        return Err(format!("how {name} lies is not known").into());
    };
    let carrier =
        plane.plane.body.as_deref().map_or_else(|| "ground".to_owned(), |body| shown(body).to_string());
    let others = match planes.len() {
        1 => String::new(),
        2 => "; one more plane".to_owned(),
        count => format!("; {} more planes", count - 1),
    };
    let degrees = readable((surface.tilt_rad.to_degrees() * 100.0).round() / 100.0);
    Ok(format!("{name} leans by {degrees} degrees, on {carrier}{others}").into())
}

/// Where the lowest sphere starts, and what puts the body on its feet.
fn describe_standing(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let of_body = |body: &StandingBody| Some(format!("it starts {}; {}", body.place()?, body.way_to_stand()));
    let first = known.inspected.standing.iter().find_map(of_body);
    first.map(Phrase::from).ok_or_else(|| "where its spheres are over a floor is not known".into())
}

/// What the contacts are made for, and how deep the deepest sphere is under the body.
fn describe_mass(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let deepest = known.most(Figure::Indentation).ok_or_else(|| known.why_no_figures())?;
    let weighs = known.inspected.figures.mass_kg.map(readable).unwrap_or_default();
    let made_for = made_for(known).unwrap_or_else(|| "no note says what they were made for".into());
    let x_hat = four_significant(deepest);
    Ok(phrase![&made_for, format!("; under {weighs} kg on one limb the deepest sphere has x/R = {x_hat}")])
}

/// What the contacts are made for, if the worst finding says how deep spheres are, and not that.
fn describe_origin(known: &Known<'_>, worst: FindingCode) -> Option<Phrase> {
    let of_depth = [FindingCode::SunkIn, FindingCode::BeyondHertz, FindingCode::BeyondHertzAtTwo];
    made_for(known).filter(|_| of_depth.contains(&worst))
}

/// What somebody said that the contacts are made for: `made for 500 kg (note in the file, by rescale)`.
fn made_for(known: &Known<'_>) -> Option<Phrase> {
    let mass = known.inspected.contacts_mass_kg.as_ref().filter(|mass| mass.recorded)?;
    let note = known.model.note.as_ref().filter(|_| mass.source == MassSource::Note.as_str());
    let by = note.and_then(|note| note.steps.last()).map(|step| format!(", by {}", step_in_words(step)));
    Some(phrase![
        format!("made for {} kg (", readable(mass.value)),
        &mass.description,
        by.unwrap_or_default(),
        ")"
    ])
}

fn describe_sides(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let inspected = known.inspected;
    let Some(limbs) = inspected.limbs.as_deref().filter(|limbs| !limbs.is_empty()) else {
        return Err(inspected.limbs_unknown.clone().unwrap_or_else(|| "limbs are not known".into()));
    };
    let on = |side: &str| -> usize {
        limbs.iter().filter(|limb| limb.side == side).map(|limb| limb.spheres.len()).sum()
    };
    Ok(match (on("right"), on("left")) {
        (0, some) | (some, 0) => format!("there is one side only, with {}", spheres(some)),
        (right, left) if right == left => {
            format!("they agree: {} on each side", spheres(right))
        }
        (right, left) => {
            format!("what both have agrees: {} on the right, {} on the left", spheres(right), spheres(left))
        }
    }
    .into())
}

fn spheres(count: usize) -> String {
    counted(count, "sphere")
}

/// The radii, and how large they are for the body.
fn describe_sizes(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let radii = known.least(Figure::Radius).zip(known.most(Figure::Radius));
    let (least, most) = radii.ok_or_else(|| known.why_no_figures())?;
    let of = |scale: f64| range(&three_significant(least * scale), &three_significant(most * scale));
    let radii = format!("radii of {} mm", of(1000.0));
    Ok(match known.inspected.figures.mass_kg {
        Some(mass) => format!("{radii}, {} m/kg^(1/3) of the mass", of(mass.cbrt().recip())),
        None => radii,
    }
    .into())
}

/// How fast the contacts change, and what an impact leaves.
fn describe_solver(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let least = known.least(Figure::RestitutionExact).ok_or_else(|| known.why_no_figures())?;
    let mut text = match known.most(Figure::TransitionWidth) {
        Some(width) => format!("contact sets in over {} R", three_significant(width)),
        None => "contact sets in at once, without smoothing".to_owned(),
    };
    if let Some(speed) = known.inspected.figures.impact_speed_m_s {
        let (least, speed) = (three_significant(least), three_significant(speed));
        text.push_str(&format!("; a sphere keeps {least} of an impact speed of {speed} m/s"));
    }
    if let Some(frequency) = known.most(Figure::NaturalFrequency) {
        text.push_str(&format!("; it swings at {} Hz", three_significant(frequency)));
    }
    Ok(text.into())
}
