//! Runs every command that `check` proposes, as it is printed, on every model and on each model with every damage. The command succeeds,
//! its finding is gone, no warning is new, and every verb runs on the result as it did before. After all commands of a model, none is left.

mod cases;
mod damage;
mod damage_findings;
mod folder_in_memory;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use osim_inspect::{CheckResult, FindingWithRemedy};
use osim_model::messages::{Call, Dialect, Example, Input};
use osim_model::{FindingCode, MassRequest, Model, Repair, Severity};
use osim_planning::rules;
use osim_requests::Request;
use serde_json::{Value, json};

use cases::{NAME, models, options};
use damage::damages;
use folder_in_memory::{CommandResult, FindingAndPlace, FolderInMemory, warnings_and_errors};

/// Numbers of commands that were run, and of commands that had the right effect.
#[derive(Default)]
struct Counts {
    models: usize,
    remedies: (usize, usize),
    chains: (usize, usize),
    prose: (usize, usize),
    /// Number of findings that are at least warnings, and number of such findings without a command.
    findings: (usize, usize),
    /// Codes of findings for which a command was proposed at least once.
    proposed: BTreeSet<FindingCode>,
    causes: BTreeMap<String, usize>,
    failures: Vec<String>,
    without: Vec<String>,
}

impl Counts {
    fn add(&mut self, other: Self) {
        let pairs = [
            (&mut self.remedies, other.remedies),
            (&mut self.chains, other.chains),
            (&mut self.prose, other.prose),
            (&mut self.findings, other.findings),
        ];
        for (own, more) in pairs {
            *own = (own.0 + more.0, own.1 + more.1);
        }
        self.models += other.models;
        self.proposed.extend(other.proposed);
        for (cause, count) in other.causes {
            *self.causes.entry(cause).or_default() += count;
        }
        self.failures.extend(other.failures);
        self.without.extend(other.without);
    }

    fn add_failure(&mut self, name: &str, cause: &str, what: &str) {
        *self.causes.entry(cause.to_owned()).or_default() += 1;
        self.failures.push(format!("{name}: {cause}: {what}"));
    }
}

/// The commands in the result of a check, in the order in which they have to be run.
fn commands(found: &CheckResult) -> Vec<Request> {
    found.steps.clone()
}

/// Runs a command, compares the model before and after it, and returns the name of the new file.
fn run_command(
    folder: &mut FolderInMemory,
    request: &Request,
    name: &str,
    counts: &mut Counts,
    verbs: Option<f64>,
) -> Option<String> {
    counts.remedies.0 += 1;
    let said = Value::Object(request.to_map()).to_string();
    let model = request.to_map()["models"][0].as_str().unwrap().to_owned();
    let before = folder.check(Path::new(&model));
    let ran = match folder.run(request) {
        Err(why) => {
            counts.add_failure(name, "refused", &format!("{said}: {why}"));
            return None;
        }
        Ok(ran) => ran,
    };
    let different = differs_from_check(folder, request, &ran);
    let made = ran.output;
    let (Some(before), Some(after)) = (before, folder.check(Path::new(&made))) else {
        counts.add_failure(name, "cannot be checked", &said);
        return Some(made);
    };
    let its = before.findings.iter().filter(|one| one.remedy.as_ref() == Some(request));
    let its: BTreeSet<_> =
        its.map(|one| (one.code(), one.place.clone().filter(|_| one.spheres.is_empty()))).collect();
    let (was, is) = (warnings_and_errors(&before), warnings_and_errors(&after));
    let codes = |set: &BTreeSet<(FindingCode, Option<String>)>| -> BTreeSet<_> {
        set.iter().map(|(code, _)| *code).collect()
    };
    let mut held = different.is_none();
    if let Some(different) = different {
        counts.add_failure(name, "not what check says of the result", &format!("{said}: {different}"));
    }
    // What is only a remark afterwards, as in the published model, is put right.
    let was_worse = |now: &FindingWithRemedy| {
        let mut all = before.findings.iter().filter(|one| one.code() == now.code());
        all.any(|one| one.severity > now.severity && now.severity == Severity::Remark)
    };
    let all_after: BTreeSet<_> = after
        .findings
        .iter()
        .filter(|one| !was_worse(one))
        .map(|one| (one.code(), one.place.clone().filter(|_| one.spheres.is_empty())))
        .collect();
    if let Some(left) = its.iter().find(|one| all_after.contains(one)) {
        counts.add_failure(name, "finding stays", &format!("{said}: {left:?}"));
        held = false;
    }
    // What followed from a fault that is gone now may have been left out before.
    let (old, new) = (&codes(&was) | &before.left_out, codes(&is));
    if let Some(new) = new.difference(&old).next() {
        counts.add_failure(name, "new warning", &format!("{said}: {new}"));
        held = false;
    }
    let pairs = verbs
        .into_iter()
        .flat_map(|kg| folder.run_each_verb(&model, kg).into_iter().zip(folder.run_each_verb(&made, kg)));
    for ((call, then), (_, now)) in pairs {
        let worse = match (&then, &now) {
            (_, Err(why)) if why == "nothing to change" => None,
            // Contacts that are known again, under another body: so they were published, and so it asks.
            (_, Err(why)) if why.starts_with("the contacts are those of ") => None,
            (Ok(_), Err(why)) => Some(format!("refused: {why}")),
            (Ok(then), Ok(now)) => now
                .difference(then)
                // What is found in the result as it was in the model is not new.
                .find(|code| !is.iter().any(|(found, _)| found.as_str() == **code))
                .map(|code| format!("warned: {code}")),
            _ => None,
        };
        if let Some(worse) = worse {
            counts.add_failure(name, "a verb afterwards", &format!("{said}, then {call}: {worse}"));
            held = false;
        }
    }
    counts.remedies.1 += usize::from(held);
    Some(made)
}

/// A finding about the new model that only the run has, or only `check RESULT --mass M`, where M is the mass that the run scaled to. A run
/// for some forces, and a check with options of its own, are not compared: each judges something else.
fn differs_from_check(folder: &FolderInMemory, request: &Request, ran: &CommandResult) -> Option<String> {
    let said =
        ran.said.as_ref().filter(|_| !folder.has_options() && !request.to_map().contains_key("select"))?;
    let found = folder.check_at_mass(Path::new(&ran.output), ran.target_kg)?;
    let found: BTreeSet<FindingAndPlace> =
        found.findings.iter().map(|one| (one.code(), one.severity, one.place.clone())).collect();
    let of_models = |code: FindingCode| {
        rules::with_code(|one| one == code).all(|rule| !matches!(rule.repair, Repair::OnlyInChange(_)))
    };
    let by_run = said.difference(&found).find(|(code, ..)| of_models(*code));
    let by_check = found.difference(said).next();
    by_run
        .map(|one| format!("only the run: {one:?}"))
        .or_else(|| by_check.map(|one| format!("only check: {one:?}")))
}

/// Runs every command of a model, each alone and then all one after the other.
fn try_model(name: &str, text: &str, given: &Value, with_verbs: bool, counts: &mut Counts) {
    let Ok(model) = Model::parse(text) else { return };
    let kg = MassRequest::default().model_mass(&model).map_or(60.0, |mass| mass.kg);
    let mut folder = FolderInMemory::of(text, given);
    let Some(found) = folder.check(Path::new(NAME)) else { return };
    counts.models += 1;
    let bad = found.findings.iter().filter(|one| one.severity >= Severity::Warning);
    counts.findings.0 += bad.clone().count();
    counts.findings.1 += bad.clone().filter(|one| one.remedy.is_none()).count();
    for one in bad.filter(|one| one.remedy.is_none() && matches!(one.rule.repair, Repair::Command(_))) {
        *counts.causes.entry(format!("without a command: {}", one.code())).or_default() += 1;
        if std::env::var_os("COMPOSE_FAILURES").is_some() {
            counts.without.push(format!("{name}: {}: {}", one.code(), one.message));
        }
    }
    counts.proposed.extend(found.findings.iter().filter(|one| one.remedy.is_some()).map(|one| one.code()));
    let all = commands(&found);
    try_commands_in_texts(name, &found, &folder, kg, counts);
    if all.is_empty() {
        return;
    }
    counts.chains.0 += 1;
    let failures = counts.failures.len();
    let mut last = None;
    let mut names = BTreeSet::new();
    for request in &all {
        if let Some(made) = run_command(&mut folder, request, name, counts, with_verbs.then_some(kg)) {
            names.insert(made.clone());
            last = Some(made);
        }
    }
    if names.len() < all.len() {
        *counts.causes.entry("chain: a step is missing".to_owned()).or_default() += 1;
    }
    let left = last.and_then(|last| folder.check(Path::new(&last)));
    let settled = left.as_ref().is_some_and(|left| commands(left).is_empty());
    if !settled {
        counts.add_failure(
            name,
            "chain: advice again",
            &format!(
                "{:?}",
                left.map(|left| commands(&left).iter().map(Request::to_json).collect::<Vec<_>>())
            ),
        );
    }
    counts.chains.1 += usize::from(counts.failures.len() == failures && names.len() == all.len());
}

/// The commands that a text names, collected while the text is spelled.
#[derive(Default)]
struct Calls(std::cell::RefCell<Vec<Call>>);

impl Dialect for Calls {
    fn input(&self, _: Input, _: Option<&Example>) -> String {
        String::new()
    }

    fn call(&self, call: &Call) -> String {
        self.0.borrow_mut().push(call.clone());
        String::new()
    }
}

/// Runs the commands in the texts of the findings of a model. Placeholders get suitable numbers, `kg` for a mass.
fn try_commands_in_texts(
    name: &str,
    found: &CheckResult,
    folder: &FolderInMemory,
    kg: f64,
    counts: &mut Counts,
) {
    for finding in &found.findings {
        let calls = Calls::default();
        for text in [&finding.message, &finding.advice] {
            let _ = text.spelled(&calls);
        }
        for call in calls.0.into_inner() {
            let Some(request) = request_with_mass(&call, kg) else { continue };
            counts.prose.0 += 1;
            let mut folder = folder.clone();
            let ran = folder.run(&request).ok().and_then(|ran| folder.check(Path::new(&ran.output)));
            let gone = ran.is_some_and(|left| left.findings.iter().all(|one| one.code() != finding.code()));
            counts.prose.1 += usize::from(gone);
            if !gone {
                counts.add_failure(name, "prose", &format!("{}: {}", finding.code(), request.to_json()));
            }
        }
    }
}

fn request_with_mass(call: &Call, kg: f64) -> Option<Request> {
    let verb = call.verb.name();
    if !["rescale", "transfer", "set", "design", "convert"].contains(&verb) {
        return None;
    }
    let mut fields = json!({"verb": verb, "models": [NAME], "output": "prose.osim"});
    for (input, example) in &call.inputs {
        let text = example.as_ref().map(ToString::to_string).unwrap_or_default();
        let value = match text.as_str() {
            "" => true.into(),
            "KG" => kg.into(),
            "X" => 0.05.into(),
            other => other.parse::<f64>().map_or_else(|_| Value::from(other), Value::from),
        };
        fields.as_object_mut()?.insert(input.name().to_owned(), value);
    }
    Request::from_json(fields.to_string().as_bytes()).ok()
}

/// Whether everything is tried on every model. It is not by default, because the fixtures of file formats differ in little.
fn tries_every_model() -> bool {
    std::env::var_os("REMEDIES").is_some_and(|which| which == "all")
}

fn try_all(models: &[(usize, (String, String))]) -> Counts {
    let mut counts = Counts::default();
    for (at, (name, text)) in models {
        let Ok(model) = Model::parse(text.as_str()) else { continue };
        let whole = tries_every_model() || !name.starts_with("format/") || at % 8 == 0;
        for given in options(&model) {
            let verbs = tries_every_model() || (whole && given == json!({}));
            try_model(&format!("{name} {given}"), text, &given, verbs, &mut counts);
        }
        for (number, damaged) in damages(text, &model).into_iter().filter(|_| whole).enumerate() {
            // What every verb does afterwards takes most of the time.
            let verbs = tries_every_model() || (at + number) % 3 == 0;
            try_model(&format!("{name} [{}]", damaged.what), &damaged.text, &json!({}), verbs, &mut counts);
        }
    }
    counts
}

#[test]
fn remedies_can_be_run_one_after_the_other() {
    let all: Vec<_> = models().into_iter().enumerate().collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut parts = vec![Vec::new(); threads];
    for (at, model) in all.into_iter().enumerate() {
        parts[at % threads].push(model);
    }
    let mut counts = Counts::default();
    std::thread::scope(|scope| {
        let running: Vec<_> = parts.iter().map(|part| scope.spawn(|| try_all(part))).collect();
        for part in running {
            counts.add(part.join().unwrap());
        }
    });
    let Counts { models, remedies, chains, prose, findings, proposed, causes, failures, without } = counts;
    println!(
        "{models} models: {} remedies run, {} held; {} chains run, {} held; {} commands in prose, {} held; {} findings, {} of them \
         without a command",
        remedies.0, remedies.1, chains.0, chains.1, prose.0, prose.1, findings.0, findings.1
    );
    for (cause, count) in &causes {
        println!("  {cause}: {count}");
    }
    if let Some(path) = std::env::var_os("COMPOSE_FAILURES") {
        std::fs::write(path, [failures.as_slice(), &without].concat().join("\n")).unwrap();
    }
    // The register says the same of every code as what is proposed. Spheres at wrong places follow the model that was scaled.
    let of_places = [FindingCode::SpheresLeftBehind, FindingCode::SpheresMisplaced];
    let alone = |code: &FindingCode| !of_places.contains(code);
    let with_command = rules::all().iter().filter(|rule| matches!(rule.repair, Repair::Command(_)));
    let with_command: BTreeSet<_> = with_command.map(|rule| rule.code).filter(alone).collect();
    assert_eq!(proposed.into_iter().filter(alone).collect::<BTreeSet<_>>(), with_command);
    assert!(
        failures.is_empty(),
        "{} fail; the first:\n{}",
        failures.len(),
        failures[..failures.len().min(20)].join("\n")
    );
}
