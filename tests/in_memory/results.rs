//! Verbs that compute and change nothing: drops, fits, designs without a model, presets, explanations.

use osim_planning::{design_sheet, find_presets, run_drop_test, run_fit};
use osim_requests::RequestError;
use osim_requests::spell::CommandLine;
use osim_view::report::explain::{Letters, answer};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::messages::mass_mismatch;
use osim_view::report::reproduce::{ReproductionRecord, fig1_text, reproduction_text};
use osim_view::report::results::{
    DropRecord, FitRecord, PresetRecord, design_sheet_text, drop_csv, drop_text, fit_text, preset_text,
};
use serde_json::json;

use crate::front_end::{files_of, request};
use crate::support::{Bench, HUMAN};

#[test]
fn drop_test_compared_with_another() {
    let bench = Bench::with(&[HUMAN, ("check/contacts_of_another_mass.osim", "heavier.osim")]);
    let request = request!(DropTest, {
        "verb": "drop-test",
        "subject": "human.osim",
        "compare": "heavier.osim",
        "height": "x0.25",
        "samples": 21,
    });
    let drop = run_drop_test(&request, &files_of(&bench)).unwrap();
    let words = "drop-test human.osim --compare heavier.osim --height x0.25 --samples 21";
    let ran = bench.run(words).done();
    assert_eq!(drop_text(&drop), ran.out());
    let beside = drop.mismatches.iter().map(|(name, mismatch)| mass_mismatch(name, mismatch, &CommandLine));
    assert_eq!(beside.collect::<String>(), ran.err());
    assert_eq!(line(&DropRecord::from(&drop)), bench.run(&format!("{words} --format json")).done().out());
    assert_eq!(drop_csv(&drop).unwrap(), bench.run(&format!("{words} --format csv")).done().out());
}

#[test]
fn drop_test_of_a_preset_of_ones_own() {
    let bench = Bench::with(&[("presets/lab.toml", "lab.toml")]);
    let request = request!(DropTest, {"verb": "drop-test", "subject": "heel_pad", "presets": "lab.toml"});
    let drop = run_drop_test(&request, &files_of(&bench)).unwrap();
    assert_eq!(drop_text(&drop), bench.run("drop-test heel_pad --presets lab.toml").done().out());
}

#[test]
fn fit() {
    let bench =
        Bench::with(&[("measured/heel_pad_european.csv", "pad.csv"), ("measured/bad_cell.csv", "bad.csv")]);
    let files = files_of(&bench);
    let request = request!(Fit, {
        "verb": "fit",
        "file": "pad.csv",
        "radius": 0.01,
        "indentation_column": "Eindringtiefe",
        "indentation_unit": "mm",
        "force_column": "Kraft",
        "force_unit": "kN",
        "time_column": "Zeit",
    });
    let words = "fit pad.csv --radius 0.01 --indentation-column Eindringtiefe --indentation-unit mm \
                 --force-column Kraft --force-unit kN --time-column Zeit";
    let fit = run_fit(&request, &files).unwrap();
    assert_eq!(fit_text(&fit, &CommandLine), bench.run(words).done().out());
    assert_eq!(line(&FitRecord::from(&fit)), bench.run(&format!("{words} --format json")).done().out());

    let request = request!(Fit, {"verb": "fit", "file": "bad.csv", "radius": 0.01});
    let Err(RequestError::Failure(failure)) = run_fit(&request, &files) else { panic!() };
    let ran = bench.run("fit bad.csv --radius 0.01 --format json").failed();
    assert_eq!(line(&FailureRecord::new(&failure, &CommandLine)), ran.out());
}

#[test]
fn design_without_a_model() {
    let bench = Bench::new();
    let request =
        request!(Design, {"verb": "design", "mass": 62, "spheres": 6, "radius": 0.032, "indentation": 0.16});
    let sheet = design_sheet(&request).unwrap();
    let words = "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16";
    assert_eq!(design_sheet_text(&sheet), bench.run(words).done().out());
    assert_eq!(line(&sheet), bench.run(&format!("{words} --format json")).done().out());

    let request = request!(Design, {"verb": "design", "mass": 62});
    let fault = design_sheet(&request).unwrap_err().spelled(&CommandLine);
    assert_eq!(format!("error: {fault}\n"), bench.run("design --mass 62").usage().err());
}

#[test]
fn presets() {
    let bench = Bench::with(&[("presets/lab.toml", "lab.toml")]);
    let presets =
        find_presets(&request!(Presets, {"verb": "presets", "presets": "lab.toml"}), &files_of(&bench))
            .unwrap();
    let texts: Vec<String> = presets.iter().map(preset_text).collect();
    assert_eq!(texts.join("\n"), bench.run("presets --presets lab.toml").done().out());
    let lines: String = presets.iter().map(|preset| line(&PresetRecord::from(preset))).collect();
    assert_eq!(lines, bench.run("presets --presets lab.toml --format json").done().out());
}

#[test]
fn reproduce() {
    let bench = Bench::new();
    let _ = request!(Reproduce, {"verb": "reproduce"});
    let record = ReproductionRecord::new(&CommandLine).unwrap();
    let text = format!("{}\n{}", reproduction_text(&record), fig1_text(&record));
    assert_eq!(text, bench.run("reproduce").done().out());
    assert_eq!(line(&record), bench.run("reproduce --format json").done().out());
}

#[test]
fn explain() {
    let bench = Bench::new();
    for (words, json) in [
        ("explain --ascii", json!({"verb": "explain", "ascii": true})),
        (
            "explain C.5 floats --ascii",
            json!({"verb": "explain", "topics": ["C.5", "floats"], "ascii": true}),
        ),
        ("explain 10 --format json", json!({"verb": "explain", "topics": "10", "format": "json"})),
    ] {
        let request = request!(Explain, json);
        let text = answer(&request, Letters::Unicode, &CommandLine).unwrap();
        assert_eq!(text, bench.run(words).done().out(), "{words}");
    }
    let unknown =
        answer(&request!(Explain, {"verb": "explain", "topics": "flots"}), Letters::Unicode, &CommandLine);
    let message = unknown.unwrap_err().message(&CommandLine);
    assert_eq!(format!("error: {message}\n"), bench.run("explain flots").usage().err());
}
