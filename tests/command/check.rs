//! `check`: a test case triggers each code of a finding, and every command that `check` proposes works.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use serde_json::Value;

use crate::json_types::Finding;
use crate::support::{TestDir, fixture, root};

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Report {
    schema_version: u32,
    model: String,
    counts: BTreeMap<String, usize>,
    verdicts: Vec<Value>,
    pub(crate) findings: Vec<Finding>,
    pub(crate) commands: Vec<String>,
    similarity: Option<Value>,
    consistency: Option<Value>,
}

/// The report of `check` about one model, with any exit status.
#[track_caller]
pub(crate) fn check_report(dir: &TestDir, arguments: &str) -> Report {
    let run = dir.run(&format!("check {arguments} --format json")).wrote_nothing();
    let report: Report = serde_json::from_str(&run.out())
        .unwrap_or_else(|error| panic!("{error}: {}{}", run.out(), run.err()));
    let on: Vec<&str> = report.verdicts.iter().filter_map(|verdict| verdict["on"].as_str()).collect();
    let recorded = if arguments.contains("--motion") { &["motion"][..] } else { &[] };
    assert_eq!(on, [&["floor", "standing", "mass", "sides", "sizes", "solver"], recorded].concat());
    assert_eq!(report.similarity.is_some(), arguments.contains("--from"), "{arguments}");
    assert!(report.consistency.is_none() || arguments.contains("--motion"), "{arguments}");
    report
}

fn codes_of(report: &Report) -> BTreeSet<&str> {
    report.findings.iter().map(|finding| finding.code.as_str()).collect()
}

/// A case that triggers one code: fixtures, a command that runs before `check`, and the arguments of `check`.
struct Case {
    code: &'static str,
    fixtures: &'static [(&'static str, &'static str)],
    before: &'static str,
    check: &'static str,
}

const fn case(code: &'static str, fixture: &'static [(&'static str, &'static str)]) -> Case {
    Case { code, fixtures: fixture, before: "", check: "model.osim" }
}

macro_rules! triggers {
    ($($code:literal: $fixture:literal),+ $(,)?) => { &[$(case($code, &[($fixture, "model.osim")])),+] };
}

/// Cases that consist of one unchanged fixture.
const CASES_OF_ONE_FILE: &[Case] = triggers! {
    "bare-model": "bad/no_contacts.osim",
    "beyond-hertz": "check/beyond_hertz.osim",
    "beyond-hertz-at-two": "check/beyond_hertz_at_two.osim",
    "sunk-in": "check/sunk_in.osim",
    "beyond-hunt-crossley": "check/beyond_hunt_crossley.osim",
    "large-constant-indentation": "check/large_constant_indentation.osim",
    "wide-transition": "check/wide_transition.osim",
    "force-before-contact": "check/force_before_contact.osim",
    "floats": "check/floats.osim",
    "contacts-of-another-mass": "check/contacts_of_another_mass.osim",
    "uneven-bottoms": "check/uneven_bottoms.osim",
    "unlevel-foot": "format/mixed_radii.osim",
    "not-on-floor": "format/no_sides.osim",
    "spheres-misplaced": "check/spheres_misplaced.osim",
    "spheres-not-compared": "check/spheres_not_compared.osim",
    "known-contacts": "check/known_contacts.osim",
    "stale-note": "check/stale_note.osim",
    "sphere-count-unknown": "format/no_sides.osim",
    "no-gravity": "format/no_gravity.osim",
    "angle-in-degrees": "check/angle_in_degrees.osim",
    "gravity-too-large": "check/gravity_in_millimetres.osim",
    "gravity-not-down": "check/gravity_up.osim",
    "floor-upside-down": "check/floor_upside_down.osim",
    "floor-upright": "check/floor_upright.osim",
    "floor-on-limb": "check/floor_on_limb.osim",
    "floor-slopes": "check/floor_slopes.osim",
    "floor-step": "check/floor_step.osim",
    "connectee-by-name": "format/connectee_bare.osim",
    "socket-nowhere": "bad/socket_of_joint.osim",
    "body-without-joint": "bad/body_without_joint.osim",
    "other-version": "bad/version_of_bodies_with_joints.osim",
    "misplaced-object": "bad/sphere_in_force_set.osim",
    "ignored-contacts": "bad/forceset_no_objects.osim",
    "unknown-name": "bad/class_misspelt.osim",
    "loop-of-joints": "format/loop_of_joints.osim",
    "misnamed-parameter-set": "format/parameters_misnamed.osim",
    "default-stiffness": "format/left_out_stiffness.osim",
    "zero-constant-contact-force": "format/zero_dissipation.osim",
    "dead-derivative-smoothing": "format/dead_derivative_smoothing.osim",
    "several-spheres-one-force": "format/one_force_for_all.osim",
    "sphere-in-two-forces": "format/shared_sphere.osim",
    "left-right-differ": "format/unequal_stiffness.osim",
    "left-right-places": "check/left_right_places.osim",
    "left-right-missing": "check/left_right_missing.osim",
    "left-right-off": "check/left_right_off.osim",
    "left-right-close": "check/left_right_close.osim",
    "odd-parent": "check/odd_parent.osim",
    "left-right-bones": "check/left_right_bones.osim",
    "foot-sphere-on-ground": "check/foot_sphere_on_ground.osim",
    "root-held": "check/root_held.osim",
    "one-side-only": "check/one_side_only.osim",
    "doubled-spheres": "check/doubled_spheres.osim",
    "odd-radius": "check/odd_radius.osim",
    "odd-place": "check/odd_place.osim",
    "crowded-spheres": "check/crowded_spheres.osim",
    "left-right-swapped": "check/left_right_swapped.osim",
    "large-friction": "check/large_friction.osim",
    "dynamic-above-static": "check/dynamic_above_static.osim",
    "odd-transition-velocity": "check/odd_transition_velocity.osim",
    "too-stiff": "check/too_stiff.osim",
    "surface-named-twice": "check/surface_named_twice.osim",
    "no-surfaces-meet": "check/no_surfaces_meet.osim",
    "sphere-of-other-side": "check/sphere_of_other_side.osim",
    "shape-presses-nothing": "shapes/torus_and_cylinder.osim",
    "heavy-foot": "check/heavy_foot.osim",
    "default-outside-range": "check/default_outside_range.osim",
    "contact-defaults": "format/defaults_smooth.osim",
    "not-hertz": "format/not_hertz.osim",
    "ellipsoid": "shapes/ellipsoid.osim",
    "mixed-radii": "format/mixed_radii.osim",
    "several-parameter-sets": "format/three_materials.osim",
    "terrain": "format/terrain_welded.osim",
    "not-finite": "bad/number_inf.osim",
    "odd-number": "bad/number_decimal_comma.osim",
    "moco-dialect": "format/moco_sphere_in_force.osim",
    "disabled-force": "format/applies_force_false.osim",
    "unknown-class": "format/components_unknown_class.osim",
    "duplicate-names": "format/same_force_name_twice.osim",
    "refused-name": "bad/name_with_blank.osim",
    "massless-body": "check/massless_body.osim",
    "odd-gravity": "check/odd_gravity.osim",
    "no-friction": "check/no_friction.osim",
    "no-dissipation": "format/zero_dissipation.osim",
    "out-of-domain": "bad/dissipation_negative.osim",
};

/// Cases that need more than one file.
const CASES_OF_SEVERAL_FILES: &[Case] = &[
    Case {
        code: "spheres-left-behind",
        fixtures: &[
            ("scale_tool/generic_smooth.osim", "generic.osim"),
            ("scale_tool/scaled_smooth.osim", "model.osim"),
        ],
        before: "",
        check: "model.osim --from generic.osim",
    },
    Case {
        code: "mass-against-length",
        fixtures: &[
            ("check/known_contacts.osim", "original.osim"),
            ("check/mass_against_length.osim", "model.osim"),
        ],
        before: "",
        check: "model.osim --from original.osim",
    },
    Case {
        code: "dissipation-forms",
        fixtures: &[
            ("check/known_contacts.osim", "original.osim"),
            ("check/mass_against_length.osim", "model.osim"),
        ],
        before: "",
        check: "model.osim --from original.osim",
    },
    Case {
        code: "unlike-recording",
        fixtures: &[
            ("motion/walker.osim", "model.osim"),
            ("motion/walk.mot", "walk.mot"),
            ("motion/kilonewtons.sto", "plates.sto"),
        ],
        before: "",
        check: "model.osim --motion walk.mot --plates plates.sto",
    },
    Case {
        code: "large-correction",
        fixtures: &[
            ("motion/walker.osim", "model.osim"),
            ("motion/pitched.mot", "walk.mot"),
            ("motion/plates.sto", "plates.sto"),
        ],
        before: "",
        check: "model.osim --motion walk.mot --plates plates.sto",
    },
    Case {
        code: "horizontal-error",
        fixtures: &[
            ("motion/walker.osim", "ice.osim"),
            ("motion/walk.mot", "walk.mot"),
            ("motion/plates.sto", "plates.sto"),
        ],
        before: "set ice.osim static_friction=0.8 dynamic_friction=0.8 -o model.osim",
        check: "model.osim --motion walk.mot --plates plates.sto",
    },
    Case {
        code: "unmatched-pattern",
        fixtures: &[("check/within_limits.osim", "model.osim")],
        before: "",
        check: "model.osim --exclude ball_*",
    },
    Case {
        code: "mass-unknown",
        fixtures: &[("check/within_limits.osim", "model.osim")],
        before: "",
        check: "model.osim --exclude-body calcn_r",
    },
    Case {
        code: "mass-sources-disagree",
        fixtures: &[("check/within_limits.osim", "model.osim")],
        before: "",
        check: "model.osim --contacts-mass 70",
    },
    Case {
        code: "gravity-sources-disagree",
        fixtures: &[("check/within_limits.osim", "made.osim")],
        before: "made.osim --target-mass 70 --target-gravity 1.62 -o model.osim",
        check: "model.osim --mass 70",
    },
    Case {
        code: "compiled-model-beside",
        // Only its name counts.
        fixtures: &[("check/within_limits.osim", "model.osim"), ("bad/empty.osim", "F_model.so")],
        before: "",
        check: "model.osim",
    },
    Case {
        code: "weak-at-rest",
        fixtures: &[("check/within_limits.osim", "model.osim")],
        before: "set model.osim hunt_crossley_smoothing=0.1 -o weak.osim",
        check: "weak.osim",
    },
    Case {
        code: "odd-mesh",
        fixtures: &[
            ("feet/human_in_millimetres.osim", "model.osim"),
            ("feet/Geometry/r_human_foot.vtp", "r_human_foot.vtp"),
        ],
        before: "",
        check: "model.osim",
    },
    Case {
        code: "included-file",
        fixtures: &[
            ("format/file_forceset.osim", "model.osim"),
            ("format/standalone_ForceSet.xml", "standalone_ForceSet.xml"),
        ],
        before: "",
        check: "model.osim",
    },
    Case {
        code: "mixed-pair",
        fixtures: &[
            ("format/standalone_ForceSet.xml", "forces.xml"),
            ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
            ("format/standalone_model_without_contacts.osim", "body.osim"),
        ],
        before: "forces.xml --geometry geometry.xml --model body.osim --target-mass 200 -d out",
        check: "out/forces.xml --geometry geometry.xml --model body.osim",
    },
];

fn cases() -> impl Iterator<Item = &'static Case> {
    CASES_OF_ONE_FILE.iter().chain(CASES_OF_SEVERAL_FILES)
}

fn dir_of_case(case: &Case) -> TestDir {
    let dir = TestDir::with(case.fixtures);
    if !case.before.is_empty() {
        dir.run(case.before).succeeded();
    }
    dir
}

/// The topics about findings in `explain`: each with its code, and whether `check` searches for the finding.
fn finding_topics() -> Vec<Value> {
    let out = TestDir::new().run("explain --format json").succeeded().out();
    let topics = out.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    topics.filter(|topic| topic["kind"] == "finding").collect()
}

#[test]
fn every_finding_that_check_looks_for_has_a_case_that_triggers_it() {
    let clean = check_report(&TestDir::with(&[("check/within_limits.osim", "model.osim")]), "model.osim");
    assert!(clean.findings.is_empty(), "{:?}", clean.findings);
    let checked: BTreeSet<String> = finding_topics()
        .iter()
        .filter(|topic| topic["checked"] == true)
        .map(|topic| topic["code"].as_str().unwrap().to_owned())
        .collect();
    let tried: BTreeSet<String> = cases().map(|case| case.code.to_owned()).collect();
    assert_eq!(tried, checked, "codes with a case, and codes of the register that check looks for");
    for case in cases() {
        let report = check_report(&dir_of_case(case), case.check);
        assert!(codes_of(&report).contains(case.code), "{}: {:?}", case.code, report.findings);
    }
}

#[test]
fn findings_agree_with_their_topics_in_explain() {
    let register = finding_topics();
    for case in cases() {
        let report = check_report(&dir_of_case(case), case.check);
        assert_eq!(report.schema_version, 1);
        assert!(report.model.ends_with(case.check.split(' ').next().unwrap()));
        let mut counts = BTreeMap::from([("error".into(), 0), ("warning".into(), 0), ("remark".into(), 0)]);
        let mut worst = 0;
        let published = codes_of(&report).contains("known-contacts");
        for finding in &report.findings {
            let topic = register.iter().find(|topic| topic["code"] == finding.code.as_str()).unwrap();
            // A fault that the published contacts have is only a remark.
            let as_published = published && finding.severity == "remark";
            // Bodies that are still to be scaled to the mass that the caller says are a remark.
            let is_to_do = finding.code == "mass-sources-disagree" && finding.severity == "remark";
            // Spheres without any force are not meant, as a model without contacts may be.
            let is_left = finding.code == "bare-model" && !finding.spheres.is_empty();
            // From these follows that the body floats, or sinks in.
            let is_worse = finding.severity == "error"
                && ["massless-body", "odd-place", "odd-radius"].contains(&finding.code.as_str());
            let is_other = as_published || is_to_do || is_left || is_worse;
            assert!(is_other || topic["severity"] == finding.severity.as_str(), "{finding:?}");
            assert_eq!(topic["why"], finding.why.as_str());
            // About a model, a call in the advice names its file.
            let advice = finding.advice.replace(&report.model, "MODEL");
            // Nobody is asked for the original who named it.
            let is_named = case.check.contains("--from") && topic["advice"].to_string().contains("--from");
            // No contacts are for a body that its bones are not of.
            let is_of_bones =
                finding.advice.starts_with("Correct the masses of the bodies: the bones are those of");
            assert!(is_named || is_of_bones || topic["advice"] == advice.as_str(), "{finding:?}");
            assert!(!finding.message.is_empty() && ![finding.line, finding.column].contains(&Some(0)));
            assert_eq!(finding.line.is_some(), finding.column.is_some());
            assert!(
                finding.details.is_empty()
                    || [finding.spheres.len(), finding.places.len()].contains(&finding.details.len()),
                "{finding:?}"
            );
            let about_spheres = !finding.spheres.is_empty();
            assert!(!about_spheres || finding.place.is_some() && finding.line.is_some(), "{finding:?}");
            assert!(finding.place.as_ref().is_none_or(|place| place.starts_with('/')), "{:?}", finding.place);
            *counts.get_mut(&finding.severity).unwrap() += 1;
            let rank =
                ["error", "warning", "remark"].iter().position(|name| *name == finding.severity).unwrap();
            assert!(rank >= worst, "the worst comes first");
            worst = rank;
        }
        assert_eq!(report.counts, counts);
    }
}

/// The models in three folders of fixtures.
fn readable_fixtures() -> Vec<String> {
    let mut readable = Vec::new();
    for folder in ["check", "format", "table1"] {
        for entry in std::fs::read_dir(root().join("fixtures").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            if name.ends_with(".osim") && !name.ends_with(".scaled.osim") {
                readable.push(format!("{folder}/{name}"));
            }
        }
    }
    readable.sort();
    readable
}

#[test]
fn every_proposed_command_removes_its_finding() {
    let mut fixed: BTreeMap<String, usize> = BTreeMap::new();
    for fixture in readable_fixtures() {
        let dir = TestDir::with(&[(fixture.as_str(), "model.osim")]);
        let run = dir.run("check model.osim --format json");
        let Ok(report) = serde_json::from_str::<Report>(&run.out()) else { continue };
        // All commands in their order, in one folder.
        let mut last_output = None;
        for command in &report.commands {
            let arguments = command.strip_prefix("osim-contact-scale ").unwrap();
            dir.run(arguments).succeeded();
            let output_name = arguments.split_once(" -o ").map(|(_, name)| name.split(' ').next().unwrap());
            last_output = Some(output_name.unwrap_or("model.scaled.osim").to_owned());
        }
        let Some(last_output) = last_output else { continue };
        let after = check_report(&dir, &last_output);
        assert_eq!(after.commands, Vec::<String>::new(), "{fixture}");
        for finding in report.findings.iter().filter(|finding| finding.command.is_some()) {
            let place = |finding: &Finding| (finding.code.clone(), finding.place.clone());
            assert!(
                !after.findings.iter().any(|left| place(left) == place(finding)),
                "{fixture}: {finding:?}"
            );
            *fixed.entry(finding.code.clone()).or_default() += 1;
        }
    }
    for code in [
        "sunk-in",
        "large-constant-indentation",
        "wide-transition",
        "force-before-contact",
        "floats",
        "contacts-of-another-mass",
        "default-stiffness",
        "zero-constant-contact-force",
    ] {
        assert!(fixed.contains_key(code), "nothing that {code} proposes was tried: {fixed:?}");
    }
}

#[test]
fn no_command_is_proposed_while_masses_disagree() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 0.0209").succeeded();
    let report_of = |model: &str| check_report(&dir, model);
    let commands =
        |report: &Report| report.findings.iter().filter_map(|finding| finding.command.clone()).count();
    // The note and the bodies have different masses: a design for the body would undo the scaling.
    let scaled = report_of("human.scaled.osim");
    assert!(codes_of(&scaled).contains("mass-sources-disagree") && codes_of(&scaled).contains("sunk-in"));
    assert_eq!(commands(&scaled), 0);
    assert!(
        scaled
            .findings
            .iter()
            .any(|finding| { finding.message.ends_with("--mass 0.0209 gives those for 0.0209 kg") })
    );
    let settled = report_of("human.scaled.osim --mass 0.0209");
    assert!(!codes_of(&settled).contains("sunk-in"));
    // For contacts of a preset under another body, only the scaling is proposed.
    dir.write("other.osim", fixture("check/contacts_of_another_mass.osim"));
    let other = report_of("other.osim");
    let codes_with_command: Vec<_> = other
        .findings
        .iter()
        .filter(|finding| finding.command.is_some())
        .map(|finding| finding.code.as_str())
        .collect();
    assert_eq!(codes_with_command, ["contacts-of-another-mass"]);
}

#[test]
fn drop_test_and_plot_report_contacts_for_another_mass() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 0.0209").succeeded();
    let expected = ["made for 0.0209 kg", "62 kg", "give --mass 0.0209"];
    for call in ["drop-test human.scaled.osim", "plot force human.scaled.osim -o figure.svg --force"] {
        dir.run(call).succeeded().says(&expected);
        let run = dir.run(&format!("{call} --mass 0.0209")).succeeded();
        assert!(!run.err().contains("mass-sources-disagree"), "{}", run.err());
    }
}

#[test]
fn check_gives_the_reason_for_absent_figures() {
    for (fixture, option, why) in [
        ("format/player_and_ball.osim", "--select contact_* --spheres 2", "--select GLOB"),
        ("format/no_sides.osim", "--spheres 2", "left or right cannot be determined"),
    ] {
        let dir = TestDir::with(&[(fixture, "model.osim")]);
        let before = check_report(&dir, "model.osim");
        let finding = before.findings.iter().find(|finding| finding.code == "sphere-count-unknown").unwrap();
        assert!(finding.message.contains(why), "{}", finding.message);
        let after = check_report(&dir, &format!("model.osim {option}"));
        assert!(!codes_of(&after).contains("sphere-count-unknown"), "{:?}", after.findings);
        assert!(
            codes_of(&after).contains("beyond-hertz") || codes_of(&after).contains("sunk-in"),
            "{:?}",
            after.findings
        );
    }
}

#[test]
fn options_of_the_call_are_in_the_proposed_commands() {
    let dir = TestDir::with(&[("format/no_sides.osim", "my model.osim")]);
    let set = ["set", "my model.osim", "stiffness=x0.01", "--in-place", "--no-backup", "--no-note"];
    assert!(dir.run_words(&set).status.success());
    let call = r#"check "my model.osim" --spheres 2 --mass 80 --exclude contact_toe_* --format json"#;
    let run = dir.run(call);
    let report: Report = serde_json::from_slice(&run.stdout).unwrap();
    let finding = report.findings.iter().find(|finding| finding.code == "sunk-in").unwrap();
    let command = finding.command.as_deref().unwrap();
    assert!(command.starts_with("osim-contact-scale design \"my model.osim\" "), "{command}");
    for option in ["--indentation 0.16", "--mass 80", "--spheres 2", "--exclude"] {
        assert!(command.contains(option), "{command}");
    }
    let from_stdin = dir.run_with_stdin("check - --spheres 2 --format json", &dir.read("my model.osim"));
    let report: Report = serde_json::from_str(&from_stdin.out()).unwrap();
    assert!(
        report.findings.iter().all(|finding| finding.command.is_none()),
        "standard input is gone by then"
    );
}
