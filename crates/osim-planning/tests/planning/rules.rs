//! Tests of all rules: each code has one rule, and the example of the rule has the finding.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::checks::rule;
use osim_model::files::{CompanionPaths, InMemory};
use osim_model::messages::{Call, Dialect, Input};
use osim_model::{Example, Finding, FindingCode, Repair};
use osim_planning::{Inspector, open_with, prepare, rules};
use osim_requests::spell::CommandLine;
use osim_requests::{CheckRequest, Request};
use serde_json::json;

#[test]
fn each_code_has_one_rule() {
    let codes: Vec<FindingCode> = rules::all().iter().map(|rule| rule.code).collect();
    assert_eq!(codes, FindingCode::ALL);
}

#[test]
fn texts_are_spelled_as_the_command_says_it() {
    for (code, why, advice) in [
        (
            FindingCode::AlreadyAtTarget,
            "else --mass, else the sum of the bodies.",
            "Give the mass that the contacts were made for with --contacts-mass KG, or take those of a known model with \
             transfer --from MODEL",
        ),
        (
            FindingCode::ZeroConstantContactForce,
            "even without friction.",
            "Give it a small value, for example for a constant indentation of 0.05 of the radius",
        ),
        (FindingCode::DisabledForce, "", "Nothing, if this is intended; else --skip-disabled"),
        (
            FindingCode::FactorsDisagree,
            "",
            "Look at inspect --from, and give --body-scale BODY=x,y,z where another source is right",
        ),
        (
            FindingCode::BeyondHertzAtTwo,
            "",
            "Nothing, if the model only walks; else make the spheres stiffer, larger or more, for a relative indentation of 0.16 at two body weights",
        ),
        (
            FindingCode::SunkIn,
            "",
            "If the contacts were made for another body, scale them to this one; else make them stiffer, for a relative \
             indentation of 0.16",
        ),
    ] {
        let rule = rule(code);
        assert!(rule.why().spelled(&CommandLine).contains(why), "{code}");
        assert_eq!(rule.advice().spelled(&CommandLine), advice);
    }
}

#[test]
fn no_advice_about_a_model_names_a_command_that_changes_it() {
    // What changes a model is tried first: it is the remedy of a finding.
    struct Changing;
    impl Dialect for Changing {
        fn input(&self, _: Input, _: Option<&osim_model::messages::Example>) -> String {
            String::new()
        }
        fn call(&self, call: &Call) -> String {
            format!("<{}>", call.verb.name())
        }
    }
    // Without contacts there is nothing else to do.
    let of_models = rules::with_code(|code| code != FindingCode::BareModel)
        .filter(|rule| !matches!(rule.repair, Repair::OnlyInChange(_)));
    for rule in of_models {
        let advice = rule.advice().spelled(&Changing);
        for verb in ["rescale", "transfer", "set", "design", "convert", "note", "add", "remove"] {
            assert!(!advice.contains(&format!("<{verb}>")), "{}: {advice}", rule.code);
        }
    }
}

#[test]
fn where_the_forms_of_14_part_the_check_of_a_scaled_model_has_all() {
    // From the human of 62 kg on 32 mm with 2 s/m (mpmath). The horse of Table 1: 545 kg on 15 mm. The child of 20 kg, on 32 mm:
    // the distances between its joints, from its file, are together 0.64296940 of the human's; 1/0.64296940 is 1.555.
    let human = "table1/human_62kg_smooth_sphere.osim";
    let mut files = fixtures();
    files.add(Path::new("walks/moved.osim"), child_on_moved_spheres().into_bytes());
    for (model, original, parts) in [
        (
            "table1/horse_smooth_sphere.osim",
            human,
            &["2.921 s/m by radius", "1.392 s/m by mass", "has 2.921"][..],
        ),
        (
            "walks/moved.osim",
            "scale_tool/generic_smooth.osim",
            &["2 s/m by radius", "2.415 s/m by mass", "2.494 s/m by length of bones", "has 2;", "1.56 times"]
                [..],
        ),
    ] {
        let request = json!({"verb": "check", "models": [model], "from": original});
        let Ok(Request::Check(request)) = Request::from_json(request.to_string().as_bytes()) else {
            panic!()
        };
        let inspector = Inspector::for_check(&request, &files);
        let opened = open_with(&request.models[0], CompanionPaths::default(), &files).unwrap();
        let result = inspector.check(&opened.model, &inspector.inspect(&opened).unwrap(), None, &files);
        let found = result.findings.iter().find(|found| found.code() == FindingCode::DissipationForms);
        let message = found.unwrap().message.to_string();
        for part in parts {
            assert!(message.contains(part), "{message}");
        }
    }
}

/// The child of `fixtures/walks/`, whose spheres have moved with its feet by the factors of `make_walks.py`. Their radii are the human's.
fn child_on_moved_spheres() -> String {
    let moved = |line: &str| {
        let place = line.trim().strip_prefix("<location>")?.strip_suffix("</location>")?;
        let factors = [0.68, 0.63, 0.66];
        let scaled = |(old, factor): (&str, f64)| (old.parse::<f64>().unwrap() * factor).to_string();
        let place: Vec<String> = place.split(' ').zip(factors).map(scaled).collect();
        Some(format!("<location>{}</location>", place.join(" ")))
    };
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/walks/child.osim");
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().map(|line| moved(line).unwrap_or_else(|| line.to_owned()) + "\n").collect()
}

/// All models and meshes in `fixtures/`, by their paths in this folder.
pub fn fixtures() -> InMemory {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let mut files = InMemory::default();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path
                .extension()
                .is_some_and(|end| ["osim", "xml", "vtp", "mot", "sto"].iter().any(|known| end == *known))
            {
                files.add(path.strip_prefix(&root).unwrap(), std::fs::read(&path).unwrap());
            }
        }
    }
    files
}

fn finding_codes<'f>(findings: impl IntoIterator<Item = &'f Finding>) -> BTreeSet<FindingCode> {
    findings.into_iter().map(Finding::code).collect()
}

/// Codes of the findings of `check` in a model.
fn codes_found(model: &str, files: &InMemory) -> BTreeSet<FindingCode> {
    codes_of_request(&json!({"verb": "check", "models": [model]}).to_string(), files)
}

fn codes_of_check_request(request: &CheckRequest, model: &Path, files: &InMemory) -> BTreeSet<FindingCode> {
    let inspector = Inspector::for_check(request, files);
    let opened = open_with(model, inspector.set_files.companion_paths(), files).unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    let found = inspector.check(&opened.model, &inspected, None, files);
    finding_codes(found.findings.iter().map(|found| &found.finding))
}

/// Codes of the findings of a request that changes or inspects a model.
fn codes_of_request(request: &str, files: &InMemory) -> BTreeSet<FindingCode> {
    let request = Request::from_json(request.as_bytes()).unwrap();
    let model: PathBuf = request.to_map()["models"][0].as_str().unwrap().into();
    if let Request::Check(request) = &request {
        return codes_of_check_request(request, &model, files);
    }
    let opened = open_with(&model, CompanionPaths::default(), files).unwrap();
    if let Request::Inspect(request) = &request {
        return finding_codes(&Inspector::for_inspect(request, files).inspect(&opened).unwrap().findings);
    }
    let plan = prepare(request, files).unwrap().plan(&opened, files).unwrap();
    finding_codes(&plan.findings)
}

/// Codes of the findings in a model with the text `good`, and with `bad` in its place.
fn codes_with_piece(mut files: InMemory, model: &str, good: &str, bad: &str) -> [BTreeSet<FindingCode>; 2] {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(model);
    let text = std::fs::read_to_string(path).unwrap();
    assert!(text.contains(good), "{model} has no {good}");
    let before = codes_found(model, &files);
    files.add(model, text.replacen(good, bad, 1).into_bytes());
    [before, codes_found(model, &files)]
}

/// Codes of the findings in the good and in the bad example of a rule; `None` if a test in another file makes the example.
fn codes_of_example(example: Example) -> Option<[BTreeSet<FindingCode>; 2]> {
    let files = fixtures();
    match example {
        Example::Piece { model, good, bad } => Some(codes_with_piece(files, model, good, bad)),
        Example::ElementText { tag, good, bad } => {
            let [good, bad] = [good, bad].map(|text| format!("<{tag}>{text}</{tag}>"));
            Some(codes_with_piece(files, "check/within_limits.osim", &good, &bad))
        }
        Example::Models { good, bad } => Some([good, bad].map(|model| codes_found(model, &files))),
        Example::Request { good, bad } => Some([good, bad].map(|request| codes_of_request(request, &files))),
        _ => None,
    }
}

#[test]
fn the_bad_example_raises_its_rule_and_the_good_one_does_not() {
    let mut wrong = Vec::new();
    let mut elsewhere = Vec::new();
    for rule in rules::all() {
        match codes_of_example(rule.example) {
            None => elsewhere.push(rule.code.as_str()),
            Some([good, bad]) if good.contains(&rule.code) || !bad.contains(&rule.code) => {
                wrong.push(format!("{}: good {good:?}, bad {bad:?}", rule.code));
            }
            Some(_) => {}
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Files on a disk, and recordings, which tests/command makes.
    assert_eq!(elsewhere, ["compiled-model-beside", "hard-linked", "mixed-pair", "horizontal-error"]);
}
