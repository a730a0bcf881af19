//! Chooses the special models of a library, such as the lightest: the numbers by which a model is special, and the models that a page
//! draws.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

use contact_scaling::limits;
use osim_inspect::series::ContactBody;
use osim_inspect::{CheckResult, Counts, Figure, Figures};
use osim_model::messages::{four_significant, readable};
use osim_model::{FindingCode, Severity};
use osim_planning::ModelFeet;

/// The numbers of one model by which it may be special.
#[derive(Debug, Clone, Default)]
pub(crate) struct ModelFacts {
    /// Mass of the model, kg; after a change, the mass that the new contacts carry.
    pub(crate) mass_kg: Option<f64>,
    pub(crate) indentation: Indentation,
    /// Numbers of findings about the model; after a change, about the new model.
    pub(crate) counts: Counts,
    /// Each code of a finding, with the worst severity that it has in the model.
    pub(crate) codes: BTreeMap<FindingCode, Severity>,
    /// The dimensionless contact of the model as text. Models with equal texts have the same contact.
    pub(crate) contact: Option<String>,
    /// The model or preset that the contacts come from, in words.
    pub(crate) reference: Option<String>,
}

/// x̂ = x/R in equilibrium, by the Hertz law, of the sphere that sinks in most.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Indentation {
    pub(crate) before: Option<f64>,
    /// x̂ of the old contacts under the new weight, if the weight changes.
    pub(crate) not_scaled: Option<f64>,
    /// x̂ of the new model; x̂ of the model itself if nothing was changed.
    pub(crate) now: Option<f64>,
}

impl ModelFacts {
    /// The numbers of an inspected and checked model.
    pub(crate) fn new(figures: &Figures, found: &CheckResult, body: Option<&ContactBody>) -> Self {
        Self {
            mass_kg: figures.mass_kg,
            indentation: Indentation { now: largest_indentation(figures), ..Indentation::default() },
            counts: found.counts,
            codes: worst_severities(found),
            contact: body.and_then(contact_text),
            reference: None,
        }
    }
}

fn worst_severities(found: &CheckResult) -> BTreeMap<FindingCode, Severity> {
    let mut codes: BTreeMap<FindingCode, Severity> = BTreeMap::new();
    for finding in &found.findings {
        let worst = codes.entry(finding.code()).or_insert(finding.severity);
        *worst = finding.severity.max(*worst);
    }
    codes
}

/// x̂ of the sphere that sinks in most under the body weight on one limb.
pub(crate) fn largest_indentation(figures: &Figures) -> Option<f64> {
    figures.spheres().filter_map(|sphere| sphere.value(Figure::Indentation)).reduce(f64::max)
}

/// Whether x̂ is outside the limit of the Hertz law.
pub(crate) fn is_too_deep(indentation: f64) -> bool {
    !limits::INDENTATION.admits(indentation)
}

/// x/R and damping of each kind of sphere as one text, rounded as on a page.
fn contact_text(body: &ContactBody) -> Option<String> {
    let contacts = body.dimensionless().ok()?;
    let shown = contacts.iter().map(|(_, contact)| {
        let (depth, damping) = (contact.relative_indentation(), contact.dissipation());
        format!("x/R = {}, α √(gR) = {}", four_significant(depth), four_significant(damping))
    });
    // Spheres of several kinds in any order are one contact.
    let distinct: BTreeSet<String> = shown.collect();
    Some(distinct.into_iter().collect::<Vec<_>>().join("; "))
}

// Which models of a library are special, and why: those that a page draws.

/// The largest number of models of a library that get plots.
pub(crate) const MOST_DRAWN_MODELS: usize = 10;
/// The largest number of different dimensionless contacts that are counted. If there are more, the page names no most common contact.
const MOST_COUNTED_CONTACTS: usize = 256;

/// The states of a model that the page draws: before and after a change, and the reference.
#[derive(Debug, Default)]
pub(crate) struct DrawnStates {
    pub(crate) bodies: Vec<ContactBody>,
    /// Whether the last of the states is the reference.
    pub(crate) has_reference: bool,
    /// The feet of the states; empty if the page draws no feet.
    pub(crate) feet: Vec<ModelFeet>,
}

/// A model that the page draws if it is chosen as special.
pub(crate) struct Candidate {
    number: usize,
    pub(crate) model: String,
    facts: ModelFacts,
    pub(crate) drawn: DrawnStates,
}

/// The model with the largest or smallest value so far, and the value.
type BestModel = Option<(f64, Rc<Candidate>)>;

/// Models that may be drawn, at most one for each reason. So memory for few models is enough for a page of any size.
#[derive(Default)]
pub(crate) struct ChosenModels {
    pub(crate) models: usize,
    most_found: Option<((usize, usize), Rc<Candidate>)>,
    deepest: BestModel,
    shallowest: BestModel,
    heaviest: BestModel,
    lightest: BestModel,
    contacts: HashMap<String, (usize, Rc<Candidate>)>,
    findings: BTreeMap<(FindingCode, Severity), (usize, Rc<Candidate>)>,
}

impl ChosenModels {
    /// Compares the next model, in the order of the page, with the models chosen so far.
    pub(crate) fn consider(&mut self, number: usize, model: &str, facts: &ModelFacts, drawn: DrawnStates) {
        if drawn.bodies.is_empty() && drawn.feet.is_empty() {
            return;
        }
        self.models += 1;
        let one = Rc::new(Candidate { number, model: model.to_owned(), facts: facts.clone(), drawn });
        let found = (facts.counts.error, facts.counts.warning);
        if found > self.most_found.as_ref().map_or((0, 0), |(most, _)| *most) {
            self.most_found = Some((found, Rc::clone(&one)));
        }
        keep_better(&mut self.deepest, facts.indentation.now, &one, |new, old| new > old);
        keep_better(&mut self.shallowest, facts.indentation.now, &one, |new, old| new < old);
        keep_better(&mut self.heaviest, facts.mass_kg, &one, |new, old| new > old);
        keep_better(&mut self.lightest, facts.mass_kg, &one, |new, old| new < old);
        if let Some(contact) = &facts.contact {
            let room = self.contacts.len() < MOST_COUNTED_CONTACTS;
            match self.contacts.get_mut(contact) {
                Some((count, _)) => *count += 1,
                None if room => drop(self.contacts.insert(contact.clone(), (1, Rc::clone(&one)))),
                None => {}
            }
        }
        for (code, severity) in &facts.codes {
            self.findings.entry((*code, *severity)).or_insert_with(|| (0, Rc::clone(&one))).0 += 1;
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.models == 0
    }

    /// The models to draw, each with the reasons for its choice.
    pub(crate) fn models_to_draw(&self) -> Vec<(&Candidate, Vec<String>)> {
        let mut chosen: Vec<(&Candidate, Vec<String>)> = Vec::new();
        for (one, why) in self.models_at_extremes() {
            let room = chosen.len() < MOST_DRAWN_MODELS;
            match chosen.iter_mut().find(|(other, _)| other.number == one.number) {
                Some((_, reasons)) => reasons.push(why),
                None if room => chosen.push((one, vec![why])),
                None => {}
            }
        }
        // A finding that no model has yet that is drawn.
        for severity in [Severity::Error, Severity::Warning, Severity::Remark] {
            let of_severity = self.findings.iter().filter(|((_, how_bad), _)| *how_bad == severity);
            for ((code, _), (count, one)) in of_severity {
                let shown = chosen.iter().any(|(other, _)| other.facts.codes.contains_key(code));
                if !shown && chosen.len() < MOST_DRAWN_MODELS {
                    let why = match count {
                        1 => format!("the only one with the finding {}", code.as_str()),
                        count => format!("the first of {count} with the finding {}", code.as_str()),
                    };
                    chosen.push((one, vec![why]));
                }
            }
        }
        chosen
    }

    fn models_at_extremes(&self) -> Vec<(&Candidate, String)> {
        let mut reasons: Vec<(&Candidate, String)> = Vec::new();
        if let Some((_, one)) = &self.most_found {
            reasons.push((one, format!("most errors and warnings ({})", one.facts.counts.describe("none"))));
        }
        add_both_extremes(&mut reasons, (&self.deepest, &self.shallowest), |indentation, is_deepest| {
            let limit = if is_too_deep(indentation) { "beyond the limit" } else { "within the limit" };
            let which = if is_deepest { "deepest" } else { "least deep" };
            format!("{which} at rest (x̂ = {}, {limit})", four_significant(indentation))
        });
        add_both_extremes(&mut reasons, (&self.heaviest, &self.lightest), |mass_kg, is_heaviest| {
            format!("{} ({} kg)", if is_heaviest { "heaviest" } else { "lightest" }, readable(mass_kg))
        });
        let common = self.contacts.iter().filter(|(_, (count, _))| *count > 1);
        let common = common.max_by_key(|(_, (count, one))| (*count, std::cmp::Reverse(one.number)));
        if let Some((contact, (count, one))) = common {
            reasons.push((
                one,
                format!("the first of {count} with the most common dimensionless contact ({contact})"),
            ));
        }
        reasons
    }
}

fn keep_better(best: &mut BestModel, value: Option<f64>, one: &Rc<Candidate>, better: fn(f64, f64) -> bool) {
    if let Some(value) = value
        && best.as_ref().is_none_or(|(old, _)| better(value, *old))
    {
        *best = Some((value, Rc::clone(one)));
    }
}

/// Adds the models with the least and the largest value as chosen, if the two values differ.
fn add_both_extremes<'c>(
    reasons: &mut Vec<(&'c Candidate, String)>,
    (highest, lowest): (&'c BestModel, &'c BestModel),
    why: impl Fn(f64, bool) -> String,
) {
    if let (Some((high, first)), Some((low, last))) = (highest, lowest)
        && four_significant(*high) != four_significant(*low)
    {
        reasons.push((first, why(*high, true)));
        reasons.push((last, why(*low, false)));
    }
}

#[cfg(test)]
mod tests {
    use osim_model::files::Failure;

    use super::*;

    fn offer_model(chosen: &mut ChosenModels, number: usize, mass_kg: f64, code: Option<FindingCode>) {
        let why = Failure::outside("a", "plot", "not known".to_owned());
        let body = ContactBody::without_weight(format!("model {number}"), Vec::new(), &why);
        let facts = ModelFacts {
            mass_kg: Some(mass_kg),
            codes: code.map(|code| (code, Severity::Error)).into_iter().collect(),
            contact: Some("x/R = 0.1".to_owned()),
            ..ModelFacts::default()
        };
        let drawn = DrawnStates { bodies: vec![body], ..DrawnStates::default() };
        chosen.consider(number, &format!("model {number}"), &facts, drawn);
    }

    #[test]
    fn special_models_are_drawn_and_not_the_first() {
        let mut chosen = ChosenModels::default();
        for number in 1..=40 {
            let code = (number == 30).then_some(FindingCode::Floats);
            offer_model(&mut chosen, number, 100.0 - number as f64, code);
        }
        let drawn: Vec<(usize, String)> =
            chosen.models_to_draw().into_iter().map(|(one, why)| (one.number, why.join("; "))).collect();
        let expected = [
            (1, "heaviest (99 kg); the first of 40 with the most common dimensionless contact (x/R = 0.1)"),
            (40, "lightest (60 kg)"),
            (30, "the only one with the finding floats"),
        ];
        assert_eq!(drawn, expected.map(|(number, why)| (number, why.to_owned())));
    }
}
