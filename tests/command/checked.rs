//! `check`: every code has a case that triggers it and one that does not, and every command it proposes works.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use serde_json::Value;

use crate::contract::Finding;
use crate::support::{Bench, HUMAN, corpus, root};

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
}

/// The report of one model, whatever the exit status.
#[track_caller]
pub(crate) fn report(bench: &Bench, arguments: &str) -> Report {
    let ran = bench.run(&format!("check {arguments} --format json")).wrote_nothing();
    let report: Report = serde_json::from_str(&ran.out())
        .unwrap_or_else(|error| panic!("{error}: {}{}", ran.out(), ran.err()));
    let on: Vec<&str> = report.verdicts.iter().filter_map(|verdict| verdict["on"].as_str()).collect();
    assert_eq!(on, ["floor", "standing", "mass", "sides", "sizes", "solver"]);
    assert_eq!(report.similarity.is_some(), arguments.contains("--from"), "{arguments}");
    report
}

fn codes(report: &Report) -> BTreeSet<&str> {
    report.findings.iter().map(|finding| finding.code.as_str()).collect()
}

/// What is needed to see a code: fixtures, commands that go before, and what is checked.
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

/// Codes that one fixture shows as it is.
const PLAIN: &[Case] = triggers! {
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
    "connectee-by-name": "format/connectee_bare.osim",
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
    "one-side-only": "check/one_side_only.osim",
    "doubled-spheres": "check/doubled_spheres.osim",
    "odd-radius": "check/odd_radius.osim",
    "odd-place": "check/odd_place.osim",
    "crowded-spheres": "check/crowded_spheres.osim",
    "left-right-swapped": "check/left_right_swapped.osim",
    "large-friction": "check/large_friction.osim",
    "contact-defaults": "format/defaults_smooth.osim",
    "not-hertz": "format/not_hertz.osim",
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
    "mass-unknown": "bad/mass_missing.osim",
    "out-of-domain": "bad/dissipation_negative.osim",
};

/// Codes that need more than one file.
const COMPOSED: &[Case] = &[
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
        code: "unmatched-pattern",
        fixtures: &[("check/within_limits.osim", "model.osim")],
        before: "",
        check: "model.osim --exclude ball_*",
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
    PLAIN.iter().chain(COMPOSED)
}

fn bench(case: &Case) -> Bench {
    let bench = Bench::with(case.fixtures);
    if !case.before.is_empty() {
        bench.run(case.before).done();
    }
    bench
}

/// The register, as `explain` knows it: code, and whether `check` looks for it.
fn register() -> Vec<Value> {
    let out = Bench::new().run("explain --format json").done().out();
    let topics = out.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    topics.filter(|topic| topic["kind"] == "finding").collect()
}

#[test]
fn every_code_has_a_case_that_triggers_it_and_one_that_does_not() {
    let clean = report(&Bench::with(&[("check/within_limits.osim", "model.osim")]), "model.osim");
    assert!(clean.findings.is_empty(), "{:?}", clean.findings);
    let checked: BTreeSet<String> = register()
        .iter()
        .filter(|topic| topic["checked"] == true)
        .map(|topic| topic["code"].as_str().unwrap().to_owned())
        .collect();
    let here: BTreeSet<String> = cases().map(|case| case.code.to_owned()).collect();
    assert_eq!(here, checked, "codes with a case, and codes of the register that check looks for");
    for case in cases() {
        let report = report(&bench(case), case.check);
        assert!(codes(&report).contains(case.code), "{}: {:?}", case.code, report.findings);
    }
}

#[test]
fn a_report_is_what_the_register_says_of_it() {
    let register = register();
    for case in cases() {
        let report = report(&bench(case), case.check);
        assert_eq!(report.schema_version, 1);
        assert!(report.model.ends_with(case.check.split(' ').next().unwrap()));
        let mut counts = BTreeMap::from([("error".into(), 0), ("warning".into(), 0), ("remark".into(), 0)]);
        let mut worst = 0;
        let published = codes(&report).contains("known-contacts");
        for finding in &report.findings {
            let known = register.iter().find(|topic| topic["code"] == finding.code.as_str()).unwrap();
            // What was published so with known contacts is a remark.
            let as_published = published && finding.severity == "remark";
            assert!(as_published || known["severity"] == finding.severity.as_str(), "{finding:?}");
            assert_eq!(
                (&known["why"], &known["advice"]),
                (&finding.why.as_str().into(), &finding.advice.as_str().into())
            );
            assert!(!finding.message.is_empty() && finding.line != Some(0));
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

/// Every model among the fixtures that can be read.
fn fixtures() -> Vec<String> {
    let mut found = Vec::new();
    for folder in ["check", "format", "table1"] {
        for entry in std::fs::read_dir(root().join("fixtures").join(folder)).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            if name.ends_with(".osim") && !name.ends_with(".scaled.osim") {
                found.push(format!("{folder}/{name}"));
            }
        }
    }
    found.sort();
    found
}

#[test]
fn every_command_that_is_proposed_mends_what_it_is_proposed_for() {
    let mut fixed: BTreeMap<String, usize> = BTreeMap::new();
    for fixture in fixtures() {
        let bench = Bench::with(&[(fixture.as_str(), "model.osim")]);
        let ran = bench.run("check model.osim --format json");
        let Ok(report) = serde_json::from_str::<Report>(&ran.out()) else { continue };
        // As they are printed, one after the other in one folder.
        let mut last = None;
        for command in &report.commands {
            let arguments = command.strip_prefix("osim-contact-scale ").unwrap();
            bench.run(arguments).done();
            let named = arguments.split_once(" --output ").map(|(_, name)| name.split(' ').next().unwrap());
            last = Some(named.unwrap_or("model.scaled.osim").to_owned());
        }
        let Some(last) = last else { continue };
        let after = self::report(&bench, &last);
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
fn commands_wait_until_the_mass_is_settled() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 0.0209").done();
    let of = |model: &str| report(&bench, model);
    let commands = |report: &Report| report.findings.iter().filter_map(|one| one.command.clone()).count();
    // The note and the bodies tell different masses: a design for the body would undo the scaling.
    let scaled = of("human.scaled.osim");
    assert!(codes(&scaled).contains("mass-sources-disagree") && codes(&scaled).contains("sunk-in"));
    assert_eq!(commands(&scaled), 0);
    assert!(scaled.findings.iter().any(|one| one.message.ends_with("for the others say --mass 0.0209")));
    let settled = of("human.scaled.osim --mass 0.0209");
    assert!(!codes(&settled).contains("sunk-in"));
    // A preset under another body is scaled first, alone.
    bench.write("other.osim", crate::support::fixture("check/contacts_of_another_mass.osim"));
    let other = of("other.osim");
    let with: Vec<_> =
        other.findings.iter().filter(|one| one.command.is_some()).map(|one| one.code.as_str()).collect();
    assert_eq!(with, ["contacts-of-another-mass"]);
}

#[test]
fn drops_and_plots_say_whose_weight_the_contacts_carry() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 0.0209").done();
    let warned = ["made for 0.0209 kg", "62 kg", "say --mass 0.0209"];
    for call in ["drop-test human.scaled.osim", "plot force human.scaled.osim -o figure.svg --force"] {
        bench.run(call).done().says(&warned);
        let ran = bench.run(&format!("{call} --mass 0.0209")).done();
        assert!(!ran.err().contains("mass-sources-disagree"), "{}", ran.err());
    }
}

#[test]
fn it_says_why_figures_are_absent() {
    for (fixture, option, why) in [
        ("format/player_and_ball.osim", "--select contact_* --spheres 2", "--select GLOB"),
        ("format/no_sides.osim", "--spheres 2", "left or right cannot be determined"),
    ] {
        let bench = Bench::with(&[(fixture, "model.osim")]);
        let before = report(&bench, "model.osim");
        let told = before.findings.iter().find(|finding| finding.code == "sphere-count-unknown").unwrap();
        assert!(told.message.contains(why), "{}", told.message);
        let after = report(&bench, &format!("model.osim {option}"));
        assert!(!codes(&after).contains("sphere-count-unknown"), "{:?}", after.findings);
        assert!(
            codes(&after).contains("beyond-hertz") || codes(&after).contains("sunk-in"),
            "{:?}",
            after.findings
        );
    }
}

#[test]
fn the_exit_status_is_that_of_the_worst_finding() {
    let of = |fixture: &str| Bench::with(&[(fixture, "model.osim")]);
    let (remark, warning, error) =
        (of("check/beyond_hertz_at_two.osim"), of("check/wide_transition.osim"), of("check/floats.osim"));
    of("check/within_limits.osim").run("check model.osim --deny warning").done();
    remark.run("check model.osim --deny warning").done();
    warning.run("check model.osim").done();
    warning.run("check model.osim --deny warning").failed();
    error.run("check model.osim").failed();
    error.run("check model.osim --deny sometimes").usage();
}

#[test]
fn what_is_said_of_the_model_is_said_in_the_commands() {
    let bench = Bench::with(&[("format/no_sides.osim", "my model.osim")]);
    let set = ["set", "my model.osim", "stiffness=x0.01", "--in-place", "--no-backup", "--no-note"];
    assert!(bench.run_words(&set).status.success());
    let ran = bench.run_words(&[
        "check",
        "my model.osim",
        "--spheres",
        "2",
        "--mass",
        "80",
        "--exclude",
        "contact_toe_*",
        "--format",
        "json",
    ]);
    let report: Report = serde_json::from_slice(&ran.stdout).unwrap();
    let sunk = report.findings.iter().find(|finding| finding.code == "sunk-in").unwrap();
    let command = sunk.command.as_deref().unwrap();
    assert!(command.starts_with("osim-contact-scale design \"my model.osim\" "), "{command}");
    for said in ["--indentation 0.16", "--mass 80", "--spheres 2", "--exclude"] {
        assert!(command.contains(said), "{command}");
    }
    let from_stdin = bench.run_with("check - --spheres 2 --format json", &bench.read("my model.osim"));
    let report: Report = serde_json::from_str(&from_stdin.out()).unwrap();
    assert!(
        report.findings.iter().all(|finding| finding.command.is_none()),
        "standard input is gone by then"
    );
}

#[test]
fn checking() {
    let bench = Bench::with(&[
        HUMAN,
        ("check/within_limits.osim", "lib/good.osim"),
        ("check/floats.osim", "lib/floats.osim"),
        ("check/wide_transition.osim", "lib/wide.osim"),
        ("bad/no_contacts.osim", "lib/bones.osim"),
        ("bad/not_xml.osim", "lib/broken.osim"),
    ]);
    bench.run("check human.osim").done().wrote_nothing().looks_like("check");
    bench.run("check human.osim --format json").done().looks_like("check_json");
    bench.run("check lib").failed().wrote_nothing().looks_like("check_folder");
    bench.run("check lib --format csv").failed().looks_like("check_csv");
    bench.run("check lib --format json").failed().looks_like("check_folder_json");
    bench.run("check lib/good.osim --deny warning").done().looks_like("check_good");
    bench.run("check lib/bones.osim").done().looks_like("check_no_contacts");
}

#[test]
fn tables_fit_80_columns() {
    for fixture in ["check/floats.osim", "format/mixed_radii.osim", "format/terrain_welded.osim"] {
        let bench = Bench::with(&[(fixture, "model.osim"), ("check/within_limits.osim", "other.osim")]);
        for arguments in ["check model.osim", "check model.osim other.osim"] {
            let text = bench.run(arguments).out();
            assert!(!text.contains('\u{1b}'));
            for line in text.lines().filter(|line| !line.trim_start().starts_with("$ ")) {
                assert!(line.chars().count() <= 80, "{line}");
            }
        }
    }
}

#[test]
fn published_models_and_what_is_known_of_them() {
    let Some(folder) = corpus("published_models_and_what_is_known_of_them") else { return };
    let of = |model: &str| {
        let bench = Bench::new();
        bench.write("model.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        report(&bench, "model.osim").findings.into_iter().map(|finding| finding.code).collect::<BTreeSet<_>>()
    };
    // Falisse's smoothing "does not have the issue" of the paper's Fig. C.5; its indentation and damping are beyond both laws.
    assert_eq!(
        of("v40000_falisse_2022_human"),
        BTreeSet::from(
            ["beyond-hertz", "beyond-hunt-crossley", "known-contacts", "not-on-floor"].map(String::from)
        )
    );
    // The same contacts under 78 kg.
    assert!(of("v40000_opencap_lai_arnold_crlf").contains("contacts-of-another-mass"));
    let dhondt = of("v40000_dhondt_2024_3seg_human");
    assert!(dhondt.contains("force-before-contact") && dhondt.contains("large-constant-indentation"));
    assert!(of("v40000_moco_2d_gait").contains("dead-derivative-smoothing"));
    // Each of them is clean, and says so in one line.
    for model in [
        "v40000_falisse_2022_human",
        "v40000_dhondt_2024_3seg_human",
        "v40000_human_12_hunt_crossley",
        "v40000_opencap_lai_arnold_crlf",
        "v40000_moco_2d_gait",
        "v30000_osim_rl_gait9dof18musc_crlf",
        "v30000_scone_h0914m",
        "v40000_scone_h0914m",
        "v40000_toy_landing",
        "v20302_dynamic_jumper",
        "v40000_dynamic_jumper",
        "v20001_bouncing_ball_hunt_crossley",
        "v40000_bouncing_ball_smooth",
        "v30000_bouncing_block",
        "v20303_bouncing_block",
    ] {
        let bench = Bench::new();
        bench.write("m.osim", std::fs::read(folder.join(format!("{model}.osim"))).unwrap());
        let out = bench.run("check m.osim --deny warning").done().out();
        // Those that may be for another mass are not called right.
        let certain = if model.contains("opencap") { " for certain" } else { "" };
        let says = format!("m.osim: nothing is wrong{certain}; the contact parameters are those of");
        let start = out.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(start.starts_with(&says), "{model}: {out}");
    }
    let landing = of("v40000_toy_landing");
    assert!(landing.contains("mixed-radii") && !landing.contains("beyond-hertz"));
}
