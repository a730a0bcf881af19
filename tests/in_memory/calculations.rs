//! Verbs that compute but change no model: drops, fits, designs without a model, presets, explanations.

use osim_planning::{design_sheet, find_presets, run_drop_test, run_fit};
use osim_requests::RequestError;
use osim_requests::spell::CommandLine;
use osim_view::report::explain::{Alphabet, answer};
use osim_view::report::json::{FailureRecord, line};
use osim_view::report::layout::WIDTH;
use osim_view::report::messages::mass_mismatch;
use osim_view::report::reproduce::{ReproductionRecord, fig1_text, reproduction_text};
use osim_view::report::results::{
    DropRecord, FitRecord, PresetRecord, design_sheet_text, drop_csv, drop_text, fit_text, preset_text,
};
use serde_json::json;

use crate::front_end::{files_in_memory, request};
use crate::support::{HUMAN, TestDir};

#[test]
fn a_compared_drop_test_equals_the_command() {
    let dir = TestDir::with(&[HUMAN, ("check/contacts_of_another_mass.osim", "heavier.osim")]);
    let request = request!(DropTest, {
        "verb": "drop-test",
        "subject": "human.osim",
        "compare": "heavier.osim",
        "height": "x0.25",
        "samples": 21,
    });
    let drop = run_drop_test(&request, &files_in_memory(&dir)).unwrap();
    let words = "drop-test human.osim --compare heavier.osim --height x0.25 --samples 21";
    let run = dir.run(words).succeeded();
    assert_eq!(drop_text(&drop, None), run.out());
    let remarks = drop.mismatches.iter().map(|(name, mismatch)| mass_mismatch(name, mismatch, &CommandLine));
    assert_eq!(remarks.collect::<String>(), run.err());
    assert_eq!(line(&DropRecord(&drop)), dir.run(&format!("{words} --format json")).succeeded().out());
    assert_eq!(drop_csv(&drop).unwrap(), dir.run(&format!("{words} --format csv")).succeeded().out());
}

#[test]
fn a_drop_test_of_a_user_preset_equals_the_command() {
    let dir = TestDir::with(&[("presets/lab.toml", "lab.toml")]);
    let request = request!(DropTest, {"verb": "drop-test", "subject": "heel_pad", "presets": "lab.toml"});
    let drop = run_drop_test(&request, &files_in_memory(&dir)).unwrap();
    assert_eq!(drop_text(&drop, None), dir.run("drop-test heel_pad --presets lab.toml").succeeded().out());
}

#[test]
fn fit_in_memory_equals_the_command() {
    let dir =
        TestDir::with(&[("measured/heel_pad_european.csv", "pad.csv"), ("measured/bad_cell.csv", "bad.csv")]);
    let files = files_in_memory(&dir);
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
    let fit_in_memory_equals_the_command = run_fit(&request, &files).unwrap();
    assert_eq!(
        fit_text(&fit_in_memory_equals_the_command, &CommandLine, None),
        dir.run(words).succeeded().out()
    );
    assert_eq!(
        line(&FitRecord::from(&fit_in_memory_equals_the_command)),
        dir.run(&format!("{words} --format json")).succeeded().out()
    );

    let request = request!(Fit, {"verb": "fit", "file": "bad.csv", "radius": 0.01});
    let Err(RequestError::Failure(failure)) = run_fit(&request, &files) else { panic!() };
    let run = dir.run("fit bad.csv --radius 0.01 --format json").failed();
    assert_eq!(line(&FailureRecord::new(&failure, &CommandLine)), run.out());
}

#[test]
fn a_design_sheet_equals_the_command() {
    let dir = TestDir::new();
    let request =
        request!(Design, {"verb": "design", "mass": 62, "spheres": 6, "radius": 0.032, "indentation": 0.16});
    let sheet = design_sheet(&request).unwrap();
    let words = "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16";
    assert_eq!(design_sheet_text(&sheet, None), dir.run(words).succeeded().out());
    assert_eq!(line(&sheet), dir.run(&format!("{words} --format json")).succeeded().out());

    let request = request!(Design, {"verb": "design", "mass": 62});
    let fault = design_sheet(&request).unwrap_err().spelled(&CommandLine);
    assert_eq!(format!("error: {fault}\n"), dir.run("design --mass 62").usage_error().err());
}

#[test]
fn presets_in_memory_equal_the_command() {
    let dir = TestDir::with(&[("presets/lab.toml", "lab.toml")]);
    let presets_in_memory_equal_the_command =
        find_presets(&request!(Presets, {"verb": "presets", "presets": "lab.toml"}), &files_in_memory(&dir))
            .unwrap();
    let texts: Vec<String> =
        presets_in_memory_equal_the_command.iter().map(|preset| preset_text(preset, None)).collect();
    // The command names the presets of unlike spheres, too.
    let out = dir.run("presets --presets lab.toml").succeeded().out();
    assert_eq!(Some(texts.join("\n").as_str()), out.split("\ndhondt2024\n").next());
    let lines: String =
        presets_in_memory_equal_the_command.iter().map(|preset| line(&PresetRecord::from(preset))).collect();
    assert_eq!(lines, dir.run("presets --presets lab.toml --format json").succeeded().out());
}

#[test]
fn reproduce_in_memory_equals_the_command() {
    let dir = TestDir::new();
    let _ = request!(Reproduce, {"verb": "reproduce"});
    let record = ReproductionRecord::new(&CommandLine).unwrap();
    let text = format!("{}\n{}", reproduction_text(&record, None), fig1_text(&record, None));
    assert_eq!(text, dir.run("reproduce").succeeded().out());
    assert_eq!(line(&record), dir.run("reproduce --format json").succeeded().out());
}

#[test]
fn explain_in_memory_equals_the_command() {
    let dir = TestDir::new();
    for (words, json) in [
        ("explain --ascii", json!({"verb": "explain", "ascii": true})),
        (
            "explain C.5 floats --ascii",
            json!({"verb": "explain", "topics": ["C.5", "floats"], "ascii": true}),
        ),
        ("explain 10 --format json", json!({"verb": "explain", "topics": "10", "format": "json"})),
    ] {
        let request = request!(Explain, json);
        let text = answer(&request, Alphabet::Unicode, &CommandLine, WIDTH).unwrap();
        assert_eq!(text, dir.run(words).succeeded().out(), "{words}");
    }
    let unknown = answer(
        &request!(Explain, {"verb": "explain", "topics": "flots"}),
        Alphabet::Unicode,
        &CommandLine,
        WIDTH,
    );
    let message = unknown.unwrap_err().message(&CommandLine);
    assert_eq!(format!("error: {message}\n"), dir.run("explain flots").usage_error().err());
}
