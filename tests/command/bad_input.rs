//! Wrong input: one line on standard error that says what and where, the right exit status, and nothing written.

use crate::support::{Bench, Ran};

/// A run that must write nothing and say it in one line (a snippet may follow).
#[track_caller]
fn refused(ran: Ran, name: &str) -> Ran {
    let ran = ran.wrote_nothing();
    let errors = ran.err().lines().filter(|line| line.starts_with("error: ")).count();
    assert_eq!(errors, 1, "{}", ran.err());
    assert!(ran.stdout.is_empty(), "{}", ran.out());
    ran.looks_like(&format!("bad_{name}"))
}

/// A model from `fixtures/bad` or `fixtures/format` that cannot be rescaled.
#[track_caller]
fn bad_model(fixture: &str) {
    let (_, name) = fixture.split_once('/').unwrap();
    let bench = Bench::with(&[(&format!("{fixture}.osim"), "model.osim")]);
    refused(bench.run("model.osim --target-mass 1190"), name).failed();
}

/// A call that is wrong whatever the model.
#[track_caller]
fn bad_call(arguments: &str, name: &str) {
    let bench = Bench::with(&[("format/v40000.osim", "model.osim"), ("format/v30000.osim", "other.osim")]);
    refused(bench.run(arguments), name).usage();
}

#[test]
fn files_that_are_no_model() {
    for fixture in [
        "bad/not_xml",
        "bad/truncated",
        "bad/truncated_between_tags",
        "bad/two_roots",
        "bad/utf16",
        "bad/doctype_subset",
    ] {
        bad_model(fixture);
    }
    for fixture in
        ["bad/empty", "bad/html", "bad/not_opensim", "bad/tags_crossed", "bad/second_bom", "bad/no_version"]
    {
        bad_model(fixture);
    }
}

#[test]
fn models_without_contacts() {
    for fixture in ["bad/no_contacts", "bad/no_forces", "format/sphere_on_sphere_only"] {
        bad_model(fixture);
    }
}

#[test]
fn numbers_that_cannot_be_scaled() {
    for fixture in
        ["bad/radius_zero", "bad/radius_missing", "bad/stiffness_zero", "bad/hunt_crossley_stiffness_zero"]
    {
        bad_model(fixture);
    }
    for fixture in [
        "bad/number_nan",
        "bad/number_decimal_comma",
        "bad/number_unit",
        "bad/number_empty",
        "bad/number_overflow",
    ] {
        bad_model(fixture);
    }
    for fixture in ["bad/number_comment_inside", "bad/mass_missing", "bad/mass_nan", "bad/mass_negative"] {
        bad_model(fixture);
    }
}

#[test]
fn connections_that_lead_nowhere() {
    for fixture in
        ["bad/sphere_unknown", "bad/frame_unknown", "format/geometry_unknown", "format/file_missing"]
    {
        bad_model(fixture);
    }
}

#[test]
fn models_that_need_an_answer() {
    bad_model("format/player_and_ball");
    let bench = Bench::with(&[("format/shared_sphere.osim", "model.osim")]);
    refused(bench.run("model.osim --target-mass 100 --select contact_1"), "shared_sphere").failed();
    let bench = Bench::with(&[
        ("format/no_sides.osim", "model.osim"),
        ("format/unequal_counts.osim", "unequal.osim"),
    ]);
    refused(bench.run("transfer model.osim --from falisse2022"), "no_sides").failed();
    refused(bench.run("transfer unequal.osim --from falisse2022"), "unequal_counts").failed();
}

#[test]
fn standalone_sets_without_their_other_half() {
    let bench = Bench::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ]);
    refused(bench.run("forces.xml --target-mass 100"), "set_alone").failed();
    refused(bench.run("geometry.xml --target-mass 100"), "geometry_alone").failed();
    refused(bench.run("forces.xml --geometry geometry.xml --target-mass 100"), "set_without_mass").failed();
    refused(bench.run("forces.xml --geometry nowhere.xml --target-mass 100"), "set_geometry_missing")
        .failed();
}

#[test]
fn included_files_are_not_changed() {
    let bench = Bench::with(&[
        ("format/file_forceset.osim", "model.osim"),
        ("format/standalone_ForceSet.xml", "standalone_ForceSet.xml"),
    ]);
    refused(bench.run("model.osim --target-mass 100"), "included_file").failed();
}

#[test]
fn missing_files_and_empty_folders() {
    let bench = Bench::new();
    refused(bench.run("nowhere.osim --target-mass 100"), "missing_file").failed();
    std::fs::create_dir(bench.path("empty")).unwrap();
    refused(bench.run("empty --target-mass 100"), "empty_folder").failed();
    refused(bench.run("inspect empty"), "empty_folder_inspect").failed();
    refused(bench.run("inspect nowhere.osim"), "missing_file_inspect").failed();
}

#[test]
fn masses_that_are_none() {
    for (value, name) in [
        ("-3", "minus"),
        ("0", "zero"),
        ("1190kg", "kg"),
        ("0,0209", "comma"),
        ("20.9g", "g"),
        ("nan", "nan"),
        ("heavy", "word"),
    ] {
        bad_call(&format!("model.osim --target-mass {value}"), &format!("target_mass_{name}"));
    }
    bad_call("model.osim --target-mass 5 --contacts-mass 62kg", "contacts_mass_kg");
    bad_call("model.osim --target-mass", "target_mass_without_value");
}

#[test]
fn options_that_make_no_sense() {
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
        bad_call(arguments, name);
    }
}

#[test]
fn outputs_that_cannot_be() {
    let bench = Bench::with(&[("format/v40000.osim", "model.osim")]);
    std::fs::create_dir(bench.path("folder.osim")).unwrap();
    bench.write("taken.osim", "precious");
    refused(bench.run("model.osim --target-mass 5 -o folder.osim"), "output_is_folder").failed();
    refused(bench.run("model.osim --target-mass 5 -o model.osim"), "output_is_input").usage();
    refused(bench.run("model.osim --target-mass 5 -o ./model.osim --force"), "output_is_input_forced")
        .usage();
    refused(bench.run("model.osim --target-mass 5 -o taken.osim"), "output_exists").failed();
    refused(bench.run("model.osim --target-mass 5 -d taken.osim"), "output_folder_is_file").failed();
    bench.write("model.scaled.osim", "precious");
    refused(bench.run("model.osim --target-mass 5"), "default_output_exists").failed();
    assert_eq!(bench.read("taken.osim"), b"precious");
}

#[cfg(unix)]
#[test]
fn a_folder_that_must_not_be_written() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::with(&[("format/v40000.osim", "locked/model.osim")]);
    let locked =
        |mode| std::fs::set_permissions(bench.path("locked"), PermissionsExt::from_mode(mode)).unwrap();
    locked(0o555);
    let may_write = std::fs::write(bench.path("locked/probe"), "").is_ok();
    let ran = bench.run("locked/model.osim --target-mass 5");
    let in_place = bench.run("locked/model.osim --target-mass 5 --in-place");
    locked(0o755);
    if may_write {
        crate::support::skipped("a folder that must not be written", "root may write everywhere");
        return;
    }
    refused(ran, "output_not_permitted").failed();
    in_place.wrote_nothing().failed();
}

#[test]
fn failures_as_json() {
    let bench = Bench::with(&[
        ("bad/number_decimal_comma.osim", "comma.osim"),
        ("bad/truncated.osim", "truncated.osim"),
        ("format/v40000.osim", "good.osim"),
    ]);
    bench
        .run("comma.osim truncated.osim nowhere.osim good.osim --target-mass 123 --format json")
        .failed()
        .wrote(&["good.scaled.osim"])
        .looks_like("failures_json");
}

#[test]
fn a_batch_goes_on_after_a_failure() {
    let bench = Bench::with(&[
        ("bad/stiffness_zero.osim", "lib/a.osim"),
        ("format/v40000.osim", "lib/b.osim"),
        ("bad/not_xml.osim", "lib/c.osim"),
    ]);
    let ran = bench.run("lib --target-mass 123").failed().wrote(&["lib/b.scaled.osim"]);
    assert_eq!(ran.err().lines().filter(|line| line.starts_with("error: ")).count(), 2, "{}", ran.err());
    bench.run("nowhere.osim --target-mass 123").failed();
}
