//! Each kind of damage, in published models: `check` gives a warning, a remark or nothing, as `kinds.md` in the folder OSIM_CASES says.
//! Edits that do no harm give no warning.

mod damages;
mod published;
mod skeleton;
mod unread;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use osim_inspect::InspectOptions;
use osim_model::{FindingCode, Model, Severity};
use osim_planning::check_with_remedies;

use damages::{DAMAGES, HARMLESS};
use published::Published;
use skeleton::SKELETON_DAMAGES;
use unread::DAMAGES_OF_UNREAD_PARTS;

const MODELS: [&str; 9] = [
    "v40000_falisse_2022_human",
    "v40000_human_12_hunt_crossley",
    "v40000_dhondt_2024_3seg_human",
    "v40000_opencap_lai_arnold_crlf",
    "v40000_scone_h0914m",
    "v30000_osim_rl_gait9dof18musc_crlf",
    "v40000_moco_2d_gait",
    "v40000_dynamic_jumper",
    "v30000_scone_h0914m",
];
/// The largest number of models in which each damage is tried.
const MOST_MODELS: usize = 6;

type Findings = BTreeSet<(Severity, FindingCode, String)>;

/// The findings about the model `text`; `None` if it cannot be read. Such a model is refused, which counts as a warning.
fn findings(text: &str) -> Option<Findings> {
    let model = Model::parse(text).ok()?;
    let options = InspectOptions::default();
    let inspected = options.inspect_for_rules("model.osim", &model);
    let result = check_with_remedies(&options, &model, &inspected, &[]);
    let found = result.findings.iter();
    Some(found.map(|found| (found.severity, found.code(), found.message.to_string())).collect())
}

/// The worst finding about a damage. Findings that the model had before the damage do not count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum WorstFinding {
    Nothing,
    Remark,
    Accused,
}

fn worst_finding_of(before: &Findings, after: Option<&Findings>, codes: &str) -> WorstFinding {
    let Some(after) = after else { return WorstFinding::Accused };
    let about = |code: &FindingCode| codes.split(' ').any(|one| one == code.as_str());
    // A remark that all contacts are published ones disappears.
    let known = |findings: &Findings| findings.iter().any(|(_, code, _)| *code == FindingCode::KnownContacts);
    let new = after.difference(before).filter(|(_, code, _)| about(code)).map(|(severity, _, _)| *severity);
    match new.max() {
        Some(Severity::Error | Severity::Warning) => WorstFinding::Accused,
        Some(Severity::Remark) => WorstFinding::Remark,
        None if about(&FindingCode::KnownContacts) && known(before) && !known(after) => WorstFinding::Remark,
        None => WorstFinding::Nothing,
    }
}

fn folder_of_models(name: &str, variable: &str, what: &str) -> Option<PathBuf> {
    let folder = std::env::var_os(variable).map(PathBuf::from).filter(|folder| folder.is_dir());
    if folder.is_none() {
        // Straight to the terminal: the test harness does not show what a passing test prints.
        let line = format!("skipped: {name}: {variable} is not set to the folder of {what}\n");
        let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
    }
    folder
}

fn published_models(folder: &Path) -> Vec<(Published, Findings)> {
    let read = |name| {
        let model = Published::read(folder, name);
        let found = findings(&model.text).unwrap();
        (model, found)
    };
    MODELS.into_iter().map(read).collect()
}

/// The rows of the list: for each damage, the severity that `check` has to give.
fn rows_of_list(list: &str) -> BTreeMap<&str, &str> {
    let cells = |line: &'_ str| -> Option<[usize; 4]> {
        let mut bars = line.match_indices(" | ").map(|(at, _)| at);
        Some([2, bars.next()?, bars.next()?, bars.next()?])
    };
    let lines = list.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| damage"));
    lines
        .filter_map(|line| {
            cells(line).map(|[start, first, second, _]| (&line[start..first], &line[first + 3..second]))
        })
        .collect()
}

#[test]
fn each_kind_of_damage_is_judged() {
    let name = "each_kind_of_damage_is_judged";
    let Some(cases) = folder_of_models(name, "OSIM_CASES", "cases") else { return };
    let Some(corpus) = folder_of_models(name, "OSIM_CORPUS", "real models") else { return };
    let list = std::fs::read_to_string(cases.join("kinds.md")).unwrap();
    let expected = rows_of_list(&list);
    let models = published_models(&corpus);
    let mut wrong = Vec::new();
    for (damage, codes, make) in DAMAGES.iter().chain(DAMAGES_OF_UNREAD_PARTS) {
        let Some(expected) = expected.get(damage) else {
            wrong.push(format!("{damage}: not in the list"));
            continue;
        };
        let enough = if *expected == "accuse" { WorstFinding::Accused } else { WorstFinding::Remark };
        let mut counts: BTreeMap<WorstFinding, usize> = BTreeMap::new();
        let damaged = models.iter().filter_map(|(model, before)| Some((model.name, before, make(model)?)));
        for (model, before, text) in damaged.take(MOST_MODELS) {
            let after = findings(&text);
            let said = worst_finding_of(before, after.as_ref(), codes);
            *counts.entry(said).or_default() += 1;
            if said < enough {
                let after = after.unwrap_or_default();
                let new = after
                    .difference(before)
                    .map(|(severity, code, _)| format!("{} {code}", severity.as_str()));
                wrong.push(format!(
                    "{damage}: {model}: expected to {expected}: {:?}",
                    new.collect::<Vec<_>>()
                ));
            }
        }
        println!("{damage}: {expected}: {counts:?}");
        if counts.is_empty() {
            wrong.push(format!("{damage}: fits no model"));
        }
    }
    let others = expected
        .keys()
        .filter(|damage| DAMAGES.iter().chain(DAMAGES_OF_UNREAD_PARTS).all(|(name, _, _)| name != *damage));
    others.for_each(|damage| println!("27: {damage}"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn damaged_skeletons_have_findings() {
    let Some(corpus) = folder_of_models("damaged_skeletons_have_findings", "OSIM_CORPUS", "real models")
    else {
        return;
    };
    let mut wrong = Vec::new();
    for (model, before) in published_models(&corpus) {
        for (damage, code, make) in SKELETON_DAMAGES {
            let Some(text) = make(&model) else { continue };
            let after = findings(&text).unwrap_or_else(|| panic!("{}: {damage}", model.name));
            let said = worst_finding_of(&before, Some(&after), code);
            let enough = if *code == "root-held" { WorstFinding::Remark } else { WorstFinding::Accused };
            println!("{}: {damage}: {said:?}", model.name);
            if said < enough {
                let new = after.difference(&before).map(|(_, code, message)| format!("{code}: {message}"));
                wrong.push(format!("{}: {damage}: {:?}", model.name, new.collect::<Vec<_>>()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn published_skeletons_have_no_findings() {
    let name = "published_skeletons_have_no_findings";
    let Some(corpus) = folder_of_models(name, "OSIM_CORPUS", "real models") else { return };
    let paths = std::fs::read_dir(corpus).unwrap().map(|entry| entry.unwrap().path());
    let mut wrong = Vec::new();
    for path in paths.filter(|path| path.extension().is_some_and(|end| end == "osim")) {
        let found = findings(&String::from_utf8_lossy(&std::fs::read(&path).unwrap())).unwrap_or_default();
        let about = found
            .iter()
            .filter(|(_, code, _)| SKELETON_DAMAGES.iter().any(|(_, one, _)| *one == code.as_str()));
        wrong.extend(about.map(|(_, code, message)| format!("{}: {code}: {message}", path.display())));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn edits_that_do_no_harm_raise_no_warning() {
    let Some(corpus) =
        folder_of_models("edits_that_do_no_harm_raise_no_warning", "OSIM_CORPUS", "real models")
    else {
        return;
    };
    let mut wrong = Vec::new();
    for (model, before) in published_models(&corpus) {
        for (edit, make) in HARMLESS {
            let Some(text) = make(&model) else { continue };
            let after = findings(&text).unwrap_or_else(|| panic!("{}: {edit}", model.name));
            let codes: BTreeSet<FindingCode> =
                before.iter().filter(|one| one.0 >= Severity::Warning).map(|one| one.1).collect();
            let new = after.iter().filter(|one| one.0 >= Severity::Warning && !codes.contains(&one.1));
            wrong.extend(new.map(|(_, code, message)| format!("{}: {edit}: {code}: {message}", model.name)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
