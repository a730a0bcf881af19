//! Wrong input causes one line on standard error with the fault and its place, the right exit status, and no files.

use crate::support::{CommandRun, TestDir};

/// Asserts that the run writes nothing and prints one line of error (an excerpt of the file may follow).
#[track_caller]
fn assert_refused(run: CommandRun, name: &str) -> CommandRun {
    let run = run.wrote_nothing();
    let errors = run.err().lines().filter(|line| line.starts_with("error: ")).count();
    assert_eq!(errors, 1, "{}", run.err());
    assert!(run.stdout.is_empty(), "{}", run.out());
    run.matches_snapshot(&format!("bad_{name}"))
}

/// Asserts that `rescale` refuses a model from `fixtures/bad` or `fixtures/format`.
#[track_caller]
fn assert_model_refused(fixture: &str) {
    let (_, name) = fixture.split_once('/').unwrap();
    let dir = TestDir::with(&[(&format!("{fixture}.osim"), "model.osim")]);
    assert_refused(dir.run("model.osim --target-mass 1190"), name).failed();
}

/// Asserts that these arguments are a usage error, whatever the model.
#[track_caller]
fn assert_usage_error(arguments: &str, name: &str) {
    let dir = TestDir::with(&[("format/v40000.osim", "model.osim"), ("format/v30000.osim", "other.osim")]);
    assert_refused(dir.run(arguments), name).usage_error();
}

#[test]
fn files_that_are_not_models_are_refused() {
    for fixture in [
        "bad/not_xml",
        "bad/truncated",
        "bad/truncated_between_tags",
        "bad/two_roots",
        "bad/utf16",
        "bad/doctype_subset",
    ] {
        assert_model_refused(fixture);
    }
    for fixture in
        ["bad/empty", "bad/html", "bad/not_opensim", "bad/tags_crossed", "bad/second_bom", "bad/no_version"]
    {
        assert_model_refused(fixture);
    }
}

#[test]
fn models_without_contacts_are_refused() {
    for fixture in ["bad/no_contacts", "bad/no_forces", "format/sphere_on_sphere_only"] {
        assert_model_refused(fixture);
    }
}

#[test]
fn models_with_numbers_that_cannot_be_scaled_are_refused() {
    for fixture in
        ["bad/radius_zero", "bad/radius_missing", "bad/stiffness_zero", "bad/hunt_crossley_stiffness_zero"]
    {
        assert_model_refused(fixture);
    }
    for fixture in [
        "bad/number_nan",
        "bad/number_decimal_comma",
        "bad/number_unit",
        "bad/number_empty",
        "bad/number_overflow",
    ] {
        assert_model_refused(fixture);
    }
    for fixture in ["bad/number_comment_inside", "bad/mass_missing", "bad/mass_nan", "bad/mass_negative"] {
        assert_model_refused(fixture);
    }
}

#[test]
fn models_with_broken_connections_are_refused() {
    for fixture in
        ["bad/sphere_unknown", "bad/frame_unknown", "format/geometry_unknown", "format/file_missing"]
    {
        assert_model_refused(fixture);
    }
}

#[test]
fn models_that_need_an_answer_are_refused() {
    assert_model_refused("format/player_and_ball");
    let dir = TestDir::with(&[("format/shared_sphere.osim", "model.osim")]);
    assert_refused(dir.run("model.osim --target-mass 100 --select contact_1"), "shared_sphere").failed();
    let dir = TestDir::with(&[
        ("format/no_sides.osim", "model.osim"),
        ("format/unequal_counts.osim", "unequal.osim"),
    ]);
    assert_refused(dir.run("transfer model.osim --from falisse2022"), "no_sides").failed();
    assert_refused(dir.run("transfer unequal.osim --from falisse2022"), "unequal_counts").failed();
}

#[test]
fn standalone_sets_without_their_geometry_or_forces_are_refused() {
    let dir = TestDir::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    assert_refused(dir.run("forces.xml --target-mass 100"), "set_alone").failed();
    assert_refused(dir.run("geometry.xml --target-mass 100"), "geometry_alone").failed();
    assert_refused(dir.run("forces.xml --geometry geometry.xml --target-mass 100"), "set_without_mass")
        .failed();
    assert_refused(dir.run("forces.xml --geometry nowhere.xml --target-mass 100"), "set_geometry_missing")
        .failed();
}

#[test]
fn a_model_whose_contacts_are_in_an_included_file_is_refused() {
    let dir = TestDir::with(&[
        ("format/file_forceset.osim", "model.osim"),
        ("format/standalone_ForceSet.xml", "standalone_ForceSet.xml"),
    ]);
    assert_refused(dir.run("model.osim --target-mass 100"), "included_file").failed();
}

#[test]
fn missing_files_and_empty_folders_are_refused() {
    let dir = TestDir::new();
    assert_refused(dir.run("nowhere.osim --target-mass 100"), "missing_file").failed();
    std::fs::create_dir(dir.path("empty")).unwrap();
    assert_refused(dir.run("empty --target-mass 100"), "empty_folder").failed();
    assert_refused(dir.run("inspect empty"), "empty_folder_inspect").failed();
    assert_refused(dir.run("inspect nowhere.osim"), "missing_file_inspect").failed();
}

#[test]
fn values_that_are_not_masses_are_refused() {
    for (value, name) in [
        ("-3", "minus"),
        ("0", "zero"),
        ("1190kg", "kg"),
        ("0,0209", "comma"),
        ("20.9g", "g"),
        ("nan", "nan"),
        ("heavy", "word"),
    ] {
        assert_usage_error(&format!("model.osim --target-mass {value}"), &format!("target_mass_{name}"));
    }
    assert_usage_error("model.osim --target-mass 5 --contacts-mass 62kg", "contacts_mass_kg");
    assert_usage_error("model.osim --target-mass", "target_mass_without_value");
}

#[test]
fn options_that_contradict_are_refused() {
    for (arguments, name) in [
        ("transfer model.osim --from nobody2022", "unknown_preset"),
        ("transfer model.osim", "no_source"),
        ("model.osim --target-mass 5 --only stifness", "unknown_property"),
        ("model.osim --target-mass 5 --radius 32mm", "radius_mm"),
        ("model.osim --target-mass 5 --radius big", "radius_word"),
        ("transfer model.osim --from falisse2022 --spheres 1.5", "half_a_sphere"),
        ("transfer model.osim --from falisse2022 --spheres 0", "no_spheres"),
        ("model.osim --target-mass 5 --select [", "broken_glob"),
        ("model.osim --targetmass 5", "unknown_option"),
        ("model.osim --diff", "no_target"),
        ("--target-mass 5", "no_model"),
        ("rescal model.osim", "unknown_verb"),
        ("model.osim other.osim --target-mass 5 -o out.osim", "output_of_two"),
        ("model.osim --target-mass 5 -o - --diff", "stdout_with_diff"),
        ("model.osim --target-mass 5 -o - --format json", "stdout_with_json"),
        ("model.osim --target-mass 5 -o out.osim --in-place", "output_and_in_place"),
        ("model.osim --target-mass 5 --no-backup", "no_backup_alone"),
        ("- --target-mass 5 --in-place", "stdin_in_place"),
        ("model.osim --target-mass 5 --format yaml", "unknown_format"),
    ] {
        assert_usage_error(arguments, name);
    }
}

#[test]
fn outputs_that_cannot_be_written_are_refused() {
    let dir = TestDir::with(&[("format/v40000.osim", "model.osim")]);
    std::fs::create_dir(dir.path("folder.osim")).unwrap();
    dir.write("taken.osim", "precious");
    assert_refused(dir.run("model.osim --target-mass 5 -o folder.osim"), "output_is_folder").failed();
    assert_refused(dir.run("model.osim --target-mass 5 -o model.osim"), "output_is_input").usage_error();
    assert_refused(dir.run("model.osim --target-mass 5 -o ./model.osim --force"), "output_is_input_forced")
        .usage_error();
    assert_refused(dir.run("model.osim --target-mass 5 -o taken.osim"), "output_exists").failed();
    assert_refused(dir.run("model.osim --target-mass 5 -d taken.osim"), "output_folder_is_file")
        .usage_error();
    dir.write("model.scaled.osim", "precious");
    assert_refused(dir.run("model.osim --target-mass 5"), "default_output_exists").failed();
    // One line for all models, also about a folder that would be below a file.
    dir.write("other.osim", dir.text("model.osim"));
    dir.write("rows.csv", "model,target-mass\nmodel.osim,5\nother.osim,5\n");
    for call in [
        "model.osim other.osim --target-mass 5 -d taken.osim/new",
        "model.osim --target-mass 5 -o taken.osim/new.osim",
        "check model.osim other.osim --fix -d taken.osim",
        "batch rows.csv -d taken.osim",
        "plot force model.osim -o taken.osim/f.svg",
    ] {
        let run = dir.run(call).usage_error().wrote_nothing();
        assert_eq!(run.err(), "error: taken.osim is a file, expected a folder: choose another name\n");
    }
    assert_eq!(dir.read("taken.osim"), b"precious");
}

#[cfg(unix)]
#[test]
fn a_write_protected_folder_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let dir = TestDir::with(&[("format/v40000.osim", "locked/model.osim")]);
    let set_mode =
        |mode| std::fs::set_permissions(dir.path("locked"), PermissionsExt::from_mode(mode)).unwrap();
    set_mode(0o555);
    let may_write = std::fs::write(dir.path("locked/probe"), "").is_ok();
    let run = dir.run("locked/model.osim --target-mass 5");
    let in_place = dir.run("locked/model.osim --target-mass 5 --in-place");
    set_mode(0o755);
    if may_write {
        crate::support::report_skip("a folder that must not be written", "root may write everywhere");
        return;
    }
    assert_refused(run, "output_not_permitted").failed();
    in_place.wrote_nothing().failed();
}

#[test]
fn failures_are_printed_as_json() {
    let dir = TestDir::with(&[
        ("bad/number_decimal_comma.osim", "comma.osim"),
        ("bad/truncated.osim", "truncated.osim"),
        ("format/v40000.osim", "good.osim"),
    ]);
    dir.run("comma.osim truncated.osim nowhere.osim good.osim --target-mass 123 --format json")
        .failed()
        .wrote(&["good.scaled.osim"])
        .matches_snapshot("failures_json");
}

#[test]
fn a_folder_continues_after_a_failed_model() {
    let dir = TestDir::with(&[
        ("bad/stiffness_zero.osim", "lib/a.osim"),
        ("format/v40000.osim", "lib/b.osim"),
        ("bad/not_xml.osim", "lib/c.osim"),
    ]);
    let run = dir.run("lib --target-mass 123").failed().wrote(&["lib/b.scaled.osim"]);
    assert_eq!(run.err().lines().filter(|line| line.starts_with("error: ")).count(), 2, "{}", run.err());
    dir.run("nowhere.osim --target-mass 123").failed();
}
