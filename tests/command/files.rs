//! Where results go, and what is never lost.

use std::process::Stdio;

use crate::support::{Bench, HUMAN, fixture};

#[test]
fn the_input_is_never_touched_unless_asked() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190").done().wrote(&["human.scaled.osim"]);
    bench.run("human.osim --target-mass 1190").failed().wrote_nothing().says(&["exists already", "--force"]);
    bench.run("human.osim --target-mass 500 --force").done().wrote(&["human.scaled.osim"]);
    bench.run("human.osim --target-mass 500 --dry-run --force").done().wrote_nothing();
    assert_eq!(bench.read("human.osim"), fixture(HUMAN.0));
}

#[test]
fn in_place_keeps_a_backup_and_never_loses_an_older_one() {
    let bench = Bench::human();
    bench.write("human.osim.bak", "precious");
    bench.run("human.osim --target-mass 1190 --in-place").done().wrote(&["human.osim", "human.osim.bak2"]);
    assert_eq!(bench.read("human.osim.bak"), b"precious");
    assert_eq!(bench.read("human.osim.bak2"), fixture(HUMAN.0));
    let first = bench.read("human.osim");
    bench.run("human.osim --target-mass 500 --in-place").done().wrote(&["human.osim", "human.osim.bak3"]);
    assert_eq!(bench.read("human.osim.bak3"), first);
    bench.run("human.osim --target-mass 100 --in-place --no-backup").done().wrote(&["human.osim"]);
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --in-place").done().wrote(&["human.osim", "human.osim.bak"]);
    assert_eq!(bench.read("human.osim.bak"), fixture(HUMAN.0));
}

#[cfg(unix)]
#[test]
fn a_symlink_stays_one() {
    use std::os::unix::fs::symlink;
    let bench = Bench::with(&[(HUMAN.0, "store/real.osim")]);
    symlink("store/real.osim", bench.path("human.osim")).unwrap();
    bench.run("human.osim --target-mass 1190 --in-place").done();
    assert!(bench.path("human.osim").symlink_metadata().unwrap().is_symlink());
    assert_eq!(bench.read("human.osim"), bench.read("store/real.osim"));
    assert_ne!(bench.read("store/real.osim"), fixture(HUMAN.0));
    assert_eq!(bench.read("store/real.osim.bak"), fixture(HUMAN.0));
    // An output that is a link to the input is the input.
    let bench = Bench::human();
    symlink("human.osim", bench.path("link.osim")).unwrap();
    bench
        .run("human.osim --target-mass 1190 -o link.osim --force")
        .usage()
        .wrote_nothing()
        .says(&["is an input of this run"]);
    // A link that leads nowhere is not written through unasked.
    symlink("nowhere.osim", bench.path("dangling.osim")).unwrap();
    bench.run("human.osim --target-mass 1190 -o dangling.osim");
    assert!(
        bench.path("dangling.osim").symlink_metadata().unwrap().is_symlink(),
        "the link was replaced by a file"
    );
}

/// Of a folder whose new files get another group.
#[cfg(unix)]
#[test]
fn owner_and_group_are_kept() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let bench = Bench::human();
    let given = |name: &str, group| chown(bench.path(name), None, Some(group)).is_ok();
    if !given("human.osim", 54321) || !given(".", 12345) {
        crate::support::skipped("owner_and_group_are_kept", "this user may not give files to groups");
        return;
    }
    std::fs::set_permissions(bench.path("."), PermissionsExt::from_mode(0o2775)).unwrap();
    std::fs::set_permissions(bench.path("human.osim"), PermissionsExt::from_mode(0o2664)).unwrap();
    bench.run("human.osim --target-mass 1190 --in-place").done();
    let seen = bench.path("human.osim").metadata().unwrap();
    assert_eq!((seen.gid(), seen.mode() & 0o7777), (54321, 0o2664));
}

#[cfg(unix)]
#[test]
fn permissions_are_kept() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt};
    let bench = Bench::human();
    let mode = |name: &str| bench.path(name).metadata().unwrap().mode() & 0o7777;
    for bits in [0o640, 0o600, 0o444] {
        std::fs::set_permissions(bench.path("human.osim"), PermissionsExt::from_mode(bits)).unwrap();
        bench.run(&format!("human.osim --target-mass 1190 -o {bits:o}.osim")).done();
        assert_eq!(mode(&format!("{bits:o}.osim")), bits, "{bits:o}");
    }
    std::fs::set_permissions(bench.path("human.osim"), PermissionsExt::from_mode(0o640)).unwrap();
    bench.run("human.osim --target-mass 1190 --in-place").done();
    assert_eq!((mode("human.osim"), mode("human.osim.bak")), (0o640, 0o640));
    for (kg, bits) in [(1500, 0o2664), (1600, 0o2660)] {
        std::fs::set_permissions(bench.path("human.osim"), PermissionsExt::from_mode(bits)).unwrap();
        bench.run(&format!("human.osim --target-mass {kg} --in-place")).done();
        assert_eq!(mode("human.osim"), bits);
        // A copy is another file: its group got no right from anybody.
        bench.run(&format!("human.osim --target-mass 70 -o {kg}.osim")).done();
        assert_eq!(mode(&format!("{kg}.osim")), bits & 0o777);
    }
    // Replacing a file keeps that file's permissions.
    bench.write("out.osim", "old");
    std::fs::set_permissions(bench.path("out.osim"), PermissionsExt::from_mode(0o604)).unwrap();
    bench.run("human.osim --target-mass 2000 -o out.osim --force").done();
    assert_eq!(mode("out.osim"), 0o604);
}

#[test]
fn standard_input_goes_to_standard_output() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 -o file.osim").done();
    let piped = bench.run_with("- --target-mass 1190", &fixture(HUMAN.0)).done().wrote_nothing();
    assert_eq!(piped.stdout, bench.read("file.osim"));
    assert!(
        piped.err().contains("contacts taken as made for 62 kg"),
        "the table goes to standard error: {}",
        piped.err()
    );
    let to_stdout = bench.run("human.osim --target-mass 1190 -o -").done().wrote_nothing();
    assert_eq!(to_stdout.stdout, bench.read("file.osim"));
    let quiet = bench.run("human.osim --target-mass 1190 -o - --quiet").done();
    assert!(quiet.stderr.is_empty(), "{}", quiet.err());
    bench.run_with("- --target-mass 1190 -o other.osim", &fixture(HUMAN.0)).done().wrote(&["other.osim"]);
    assert_eq!(bench.read("other.osim"), bench.read("file.osim"));
    let seen = bench.run_with("inspect - --format json", &fixture(HUMAN.0)).done();
    assert!(seen.out().contains("\"contacts_mass_kg\":{\"value\":62"), "{}", seen.out());
    bench.run_with("- --target-mass 1190", b"").failed();
}

#[test]
fn json_is_not_mixed_into_the_model_on_standard_output() {
    // Standard input defaults to standard output, so JSON there is a usage error as with -o -.
    let bench = Bench::new();
    let ran = bench.run_with("- --target-mass 1190 --format json", &fixture(HUMAN.0));
    let models = ran.out().matches("<OpenSimDocument").count();
    assert!(models == 0 || !ran.out().starts_with('{'), "JSON and a model on one stream");
    let ran = bench.run_with("- --target-mass 1190 --diff", &fixture(HUMAN.0));
    assert!(
        !(ran.out().contains("<OpenSimDocument") && ran.out().contains("@@")),
        "a diff and a model on one stream"
    );
}

fn library() -> Bench {
    Bench::with(&[
        ("format/v40000.osim", "lib/right/foot.osim"),
        ("format/v30000.osim", "lib/left/foot.osim"),
        ("format/v20001.osim", "lib/UPPER.OSIM"),
        ("bad/no_contacts.osim", "lib/none.osim"),
        ("format/v40000.osim", "lib/before.scaled.osim"),
        ("bad/not_xml.osim", "lib/notes.txt"),
    ])
}

#[test]
fn a_folder_keeps_its_shape_and_passes_over_its_own_outputs_aloud() {
    let bench = library();
    bench
        .run("lib --target-mass 492 -d out")
        .done()
        .wrote(&["out/UPPER.OSIM", "out/left/foot.osim", "out/right/foot.osim"])
        .says(&["outputs of this tool (*.scaled.osim) skipped: 1", "1 skipped (no contacts)"]);
    // The output folder inside the walked one is not walked.
    let bench = library();
    bench.run("lib --target-mass 492 -d lib/out").done();
    bench.run("lib --target-mass 492 -d lib/out --force").done();
    assert!(!bench.has("lib/out/out"));
    // Beside the models, run twice: no copies of copies.
    let bench = library();
    bench.run("lib --target-mass 492").done();
    bench.run("lib --target-mass 492 --force").done();
    assert!(bench.files().keys().all(|name| !name.contains("scaled.scaled")));
}

#[test]
fn two_equal_outputs_are_found_before_anything_is_written() {
    let bench = Bench::with(&[
        ("format/v40000.osim", "a/foot.osim"),
        ("format/v30000.osim", "b/FOOT.osim"),
        ("format/v30000.osim", "c/foot.osim"),
        ("format/v20001.osim", "a/other.osim"),
    ]);
    bench
        .run("a/other.osim a/foot.osim c/foot.osim --target-mass 5 -d out")
        .usage()
        .wrote_nothing()
        .says(&["a/foot.osim", "c/foot.osim"]);
    bench
        .run("a/other.osim a/foot.osim b/FOOT.osim --target-mass 5 -d out")
        .usage()
        .wrote_nothing()
        .says(&["b/FOOT.osim"]);
    assert!(!bench.has("out"));
}

#[test]
fn a_model_that_is_named_twice_is_changed_once() {
    for again in ["foot.osim", "./foot.osim", "."] {
        let bench = Bench::with(&[("format/v40000.osim", "foot.osim")]);
        let ran = bench.run(&format!("foot.osim {again} --target-mass 424 --in-place"));
        if ran.status == Some(0) {
            ran.wrote(&["foot.osim", "foot.osim.bak"]);
            assert_eq!(bench.read("foot.osim.bak"), fixture("format/v40000.osim"), "{again}");
        } else {
            ran.usage().wrote_nothing();
        }
    }
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let bench = Bench::human();
    for arguments in
        ["human.osim --target-mass 1190 -o -", "inspect human.osim --format json", "--help", "explain"]
    {
        let mut child =
            bench.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // Closed before anything is written: the first write meets a broken pipe.
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{arguments}: {stderr}");
        assert!(!stderr.contains("error") && !stderr.contains("panicked"), "{arguments}: {stderr}");
    }
}

#[test]
fn a_standalone_pair_is_written_together() {
    let pair = [
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "model.osim"),
    ];
    let bench = Bench::with(&pair);
    bench
        .run("forces.xml --geometry geometry.xml --model model.osim --target-mass 492")
        .done()
        .wrote(&["forces.scaled.xml", "geometry.scaled.xml"])
        .says(&["contacts taken as made for 61.5 kg"]);
    assert!(bench.text("forces.scaled.xml").contains("<stiffness>2469135.6</stiffness>"));
    assert!(bench.text("geometry.scaled.xml").contains("<radius>0.065</radius>"));
    bench.run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 -o f.xml --geometry-output g.xml").done().wrote(&["f.xml", "g.xml"]);
    // The pair goes on together from its note, and a mixed pair is noticed.
    bench
        .run("f.xml --geometry g.xml --target-mass 61.5 -d back")
        .done()
        .says(&["contacts made for 492 kg (note"]);
    bench.run("f.xml --geometry geometry.xml --target-mass 100 -d mixed").failed().wrote_nothing();
    // Where one of the two cannot be written, neither is.
    let bench = Bench::with(&pair);
    bench.write("geometry.scaled.xml", "precious");
    bench
        .run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492")
        .failed()
        .wrote_nothing();
    let bench = Bench::with(&pair);
    bench
        .run("forces.xml --geometry geometry.xml --contacts-mass 61.5 --target-mass 492 --in-place")
        .done()
        .wrote(&["forces.xml", "forces.xml.bak", "geometry.xml", "geometry.xml.bak"]);
}

#[test]
fn a_compiled_model_beside_the_output_is_warned_about() {
    let bench = Bench::human();
    bench.write("F_human.scaled.so", "compiled");
    bench.run("human.osim --target-mass 1190").done().says(&["F_human.scaled.so", "compiled-model-beside"]);
    let bench = Bench::human();
    bench.write("F_human.dll", "compiled");
    bench.run("human.osim --target-mass 1190 --in-place").done().says(&["F_human.dll"]);
    let bench = Bench::human();
    bench.write("F_human2.dll", "compiled");
    let ran = bench.run("human.osim --target-mass 1190 --in-place").done();
    assert!(!ran.out().contains("compiled-model-beside"));
}

#[test]
fn no_temporary_file_is_left_behind() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --in-place").done();
    bench.run("human.osim --target-mass 5 -o out/deep/er.osim").done().wrote(&["out/deep/er.osim"]);
    bench.run("human.osim --target-mass 7 -o out/deep/er.osim").failed();
    assert!(
        bench.files().keys().all(|name| !name.contains(".osim-contact-scale-")),
        "{:?}",
        bench.files().keys()
    );
}

/// The set of forces of a model beside that model: its contacts count once.
#[test]
fn a_set_beside_its_whole_model_counts_once() {
    let bench = Bench::with(&[("format/v40000.osim", "model.osim")]);
    let text = bench.text("model.osim");
    let (start, end) = (text.find("<ForceSet").unwrap(), text.find("</ForceSet>").unwrap());
    let set =
        format!("<OpenSimDocument Version=\"40000\">{}</ForceSet></OpenSimDocument>", &text[start..end]);
    bench.write("forces.xml", set);
    let seen = |call: &str| -> serde_json::Value {
        serde_json::from_str(&bench.run(&format!("inspect {call} --format json")).done().out()).unwrap()
    };
    let alone = seen("model.osim");
    for beside in ["--model model.osim", "--geometry model.osim", "--geometry model.osim --model model.osim"]
    {
        let with = seen(&format!("forces.xml {beside}"));
        for field in ["mass_kg", "spheres_per_limb", "standing", "figures"] {
            assert_eq!(with[field], alone[field], "{beside}: {field}");
        }
        assert_eq!(with["spheres"].as_array().unwrap().len(), 4, "{beside}");
    }
}
