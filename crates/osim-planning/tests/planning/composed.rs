//! Every command that is proposed works: for every finding, under every option that changes what is found, the remedy is run,
//! and the finding is gone. The register says the same of every code as what is proposed.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use osim_inspect::{CheckResult, Found, InspectOptions};
use osim_model::files::InMemory;
use osim_model::{FileId, FindingCode, Model, Repair};
use osim_planning::{Inspector, check_with_trials, open_with, prepare, rules};
use osim_requests::Request;
use serde_json::{Value, json};

const NAME: &str = "model.osim";

/// The project's models that hold one whole model each: those made for `check`, animals of Table 1, and the quirks of the
/// format.
fn models() -> Vec<(String, String)> {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut found = Vec::new();
    for folder in ["check", "table1", "format", "scale_tool"] {
        let mut paths: Vec<PathBuf> = std::fs::read_dir(fixtures.join(folder))
            .expect("the project's fixtures")
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|end| end == "osim"))
            .filter(|path| !path.to_string_lossy().ends_with(".scaled.osim"))
            .collect();
        paths.sort();
        for path in paths {
            let name = format!("{folder}/{}", path.file_name().unwrap().to_string_lossy());
            // Some fixtures are no UTF-8; what those show, others show, too.
            if let Ok(text) = std::fs::read_to_string(&path) {
                found.push((name, text));
            }
        }
    }
    assert!(found.len() > 100, "{}", found.len());
    found
}

/// Options that change what is found, for this model.
fn options(model: &Model) -> Vec<Value> {
    let names: Vec<&str> = model.forces().iter().map(|force| force.name.as_str()).collect();
    let mass = json!({"mass": 40.0});
    let mut all = vec![
        json!({}),
        json!({"spheres": 3}),
        json!({"stance_limbs": 2}),
        mass,
        json!({"gravity": 1.62}),
        json!({"mass": 900.0, "stance_limbs": 4, "gravity": 20.0}),
        json!({"impact_speed": 1.5}),
    ];
    if let Some(body) = model.bodies().last() {
        all.push(json!({"exclude_body": [body.name]}));
    }
    if let Some(first) = names.first() {
        all.push(json!({"select": [first]}));
        all.push(json!({"select": [first], "stance_limbs": 2, "mass": 100.0}));
        all.push(json!({"exclude": [first]}));
        all.push(json!({"exclude": [first], "spheres": 2, "gravity": 5.0}));
    }
    all
}

fn inspect_options(options: &Value) -> Option<InspectOptions> {
    let mut request = json!({"verb": "check", "models": [NAME]});
    request.as_object_mut()?.extend(options.as_object()?.clone());
    match Request::from_json(request.to_string().as_bytes()) {
        Ok(Request::Check(check)) => {
            Some(Inspector::of_check(&check, &InMemory::default()).options().clone())
        }
        Ok(_) => None,
        Err(error) => panic!("{options}: {error:?}"),
    }
}

fn check(options: &InspectOptions, model: &Model) -> CheckResult {
    check_with_trials(options, model, &options.inspect(NAME, model, None), None)
}

/// Findings that say the same: about spheres it is one for all, else one for each place.
fn same(a: &Found, b: &Found) -> bool {
    let about_spheres = !a.spheres.is_empty() && !b.spheres.is_empty();
    a.code() == b.code() && (about_spheres || a.place == b.place)
}

/// Runs the remedy as a request that was written down and read again.
fn put_right(finding: &Found, text: &str) -> Result<Model, String> {
    let request = finding.remedy.as_ref().unwrap();
    let request = Request::from_json(request.to_json().as_bytes()).map_err(|fault| format!("{fault:?}"))?;
    let mut files = InMemory::default();
    files.add(NAME, text.as_bytes().to_vec());
    let change = prepare(request, &files).map_err(|error| format!("{error:?}"))?;
    let model = Model::parse(text).map_err(|fault| fault.to_string())?;
    let plan = change.planner.plan(&model).map_err(|fault| fault.to_string())?;
    let bytes = plan.patched(&model, FileId::MAIN).map_err(|fault| fault.to_string())?;
    Model::parse(bytes).map_err(|fault| fault.to_string())
}

#[test]
fn every_remedy_puts_its_finding_right() {
    let mut proposed: BTreeMap<FindingCode, usize> = BTreeMap::new();
    let mut seen: BTreeSet<FindingCode> = BTreeSet::new();
    let mut wrong = Vec::new();
    for (name, text) in models() {
        let Ok(model) = Model::parse(text.as_str()) else { continue };
        for given in options(&model) {
            let options = inspect_options(&given).unwrap();
            for finding in check(&options, &model).findings {
                seen.insert(finding.code());
                if finding.remedy.is_none() {
                    continue;
                }
                *proposed.entry(finding.code()).or_default() += 1;
                match put_right(&finding, &text) {
                    Err(why) => wrong.push(format!("{name} {given} {}: {why}", finding.code())),
                    Ok(changed) => {
                        let left = check(&options, &changed).findings;
                        if let Some(left) = left.iter().find(|left| same(left, &finding)) {
                            let (before, after) = (&finding.message, &left.message);
                            wrong.push(format!("{name} {given} {}: {before} -> {after}", finding.code()));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} remedies leave their finding:\n{}", wrong.len(), wrong.join("\n"));
    // Its command needs the model that was scaled: see below.
    let alone = |code: &FindingCode| *code != FindingCode::SpheresLeftBehind;
    let with_command = rules::all()
        .iter()
        .filter(|rule| matches!(rule.repair, Repair::Command(_)))
        .map(|rule| rule.code)
        .filter(alone);
    assert_eq!(proposed.keys().copied().collect::<BTreeSet<_>>(), with_command.collect());
    assert!(seen.len() > 25, "{seen:?}");
}

#[test]
fn spheres_that_were_left_behind_follow_by_the_command() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scale_tool");
    let read = |name: &str| std::fs::read_to_string(fixtures.join(name)).unwrap();
    for kind in ["smooth", "hunt_crossley"] {
        let (generic, scaled) = (read(&format!("generic_{kind}.osim")), read(&format!("scaled_{kind}.osim")));
        let scale_set = read("applied_scale_set.xml");
        let mut files = InMemory::default();
        files.add("generic.osim", generic.into_bytes());
        files.add("set.xml", scale_set.into_bytes());
        for more in
            [json!({}), json!({"body_scale_file": "set.xml"}), json!({"stance_limbs": 2, "mass": 60.0})]
        {
            let mut request = json!({"verb": "check", "models": [NAME], "from": "generic.osim"});
            request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
            let Ok(Request::Check(request)) = Request::from_json(request.to_string().as_bytes()) else {
                panic!()
            };
            let check = |text: &[u8]| {
                let mut files = files.clone();
                files.add(NAME, text.to_vec());
                let inspector = Inspector::of_check(&request, &files);
                let opened = open_with(NAME.as_ref(), inspector.set_files().beside(), &files).unwrap();
                let inspected = inspector.inspect(&opened).unwrap();
                inspector.check(&opened.model, &inspected, None)
            };
            let found = check(scaled.as_bytes());
            let behind =
                found.findings.iter().find(|one| one.code() == FindingCode::SpheresLeftBehind).unwrap();
            let request = behind.remedy.as_ref().unwrap();
            let request = Request::from_json(request.to_json().as_bytes()).unwrap();
            let change = prepare(request, &files).unwrap();
            let model = Model::parse(scaled.as_str()).unwrap();
            let changed = change.planner.plan(&model).unwrap().patched(&model, FileId::MAIN).unwrap();
            let left = check(&changed);
            assert!(
                left.findings.iter().all(|one| one.code() != FindingCode::SpheresLeftBehind),
                "{more}: {left:?}"
            );
        }
    }
}
