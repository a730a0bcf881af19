//! No file is overwritten by mistake, and no factor is applied twice.

use crate::support::{HUMAN, TestDir, fixture};

const STANDALONE_SETS: [(&str, &str); 3] = [
    ("format/standalone_ForceSet.xml", "forces.xml"),
    ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ("format/standalone_model_without_contacts.osim", "bones.osim"),
];

#[test]
fn no_output_is_an_input_of_the_same_run() {
    let dir = TestDir::with(&[(HUMAN.0, "human.osim"), (HUMAN.0, "human.scaled.osim")]);
    // The same file through a folder that does not exist.
    dir.run("human.osim --target-mass 500 -o new/../human.osim --force").usage_error().wrote_nothing();
    // The default output of one is another of the models.
    dir.run("human.osim human.scaled.osim --target-mass 500 --force").usage_error().wrote_nothing();
    // The reference of a transfer.
    dir.run("transfer human.osim --from human.scaled.osim -o human.scaled.osim --force")
        .usage_error()
        .wrote_nothing();
    assert!(!dir.has("new"));
}

#[test]
fn the_files_of_a_standalone_pair_do_not_overwrite_each_other() {
    let dir = TestDir::with(&STANDALONE_SETS);
    let pair = "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500";
    dir.run(&format!("{pair} -o x.xml --geometry-output x.xml --force")).usage_error().wrote_nothing();
    dir.run(&format!("{pair} -o geometry.xml --force")).usage_error().wrote_nothing();
    // Two force sets would scale the one geometry twice.
    dir.run(&format!("human.osim {pair} --in-place")).usage_error().wrote_nothing();
}

#[test]
fn a_geometry_that_was_scaled_without_its_forces_is_not_scaled_again() {
    let dir = TestDir::with(&STANDALONE_SETS);
    let pair = "forces.xml --geometry geometry.xml --model bones.osim";
    dir.run(&format!("{pair} --target-mass 500 -o forces2.xml --geometry-output geometry2.xml")).succeeded();
    let mixed = "forces.xml --geometry geometry2.xml --model bones.osim --target-mass 300 -d out";
    dir.run(mixed).failed().wrote_nothing().says(&["different runs", "--contacts-mass"]);
}

#[test]
fn several_models_cannot_go_to_standard_output() {
    let dir = TestDir::with_human();
    dir.run_with_stdin("- human.osim --target-mass 500", &fixture(HUMAN.0)).usage_error().wrote_nothing();
}

#[cfg(unix)]
#[test]
fn only_ordinary_files_are_replaced() {
    use std::os::unix::fs::symlink;
    let dir = TestDir::with_human();
    symlink("nowhere.osim", dir.path("link.osim")).unwrap();
    dir.run("human.osim --target-mass 500 -o link.osim --force").failed().says(&["leads nowhere"]);
    dir.run("human.osim --target-mass 500 -o /dev/null --force").failed().says(&["not an ordinary file"]);
}

#[cfg(unix)]
#[test]
fn permissions_are_kept_to_the_bit() {
    use std::os::unix::fs::PermissionsExt;
    let dir = TestDir::with_human();
    let mode = |name: &str| std::fs::metadata(dir.path(name)).unwrap().permissions().mode() & 0o777;
    let set = |bits| {
        let permissions = std::fs::Permissions::from_mode(bits);
        std::fs::set_permissions(dir.path("human.osim"), permissions).unwrap();
    };
    set(0o666);
    dir.run("human.osim --target-mass 500 --in-place").succeeded();
    assert_eq!((mode("human.osim"), mode("human.osim.bak")), (0o666, 0o666));
    set(0o444);
    dir.run("human.osim --target-mass 300 --in-place").failed().wrote_nothing().says(&["write-protected"]);
    dir.run("human.osim --target-mass 300 --in-place --force").succeeded();
    assert_eq!(mode("human.osim"), 0o444);
}

#[test]
fn a_damaged_note_makes_the_run_ask_for_the_mass() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 500 -o noted.osim").succeeded();
    dir.write("noted.osim", dir.text("noted.osim").replace("made for 500 kg", "made for 500,0 kg"));
    dir.run("noted.osim --target-mass 600").failed().wrote_nothing().says(&["is damaged", "--contacts-mass"]);
    dir.run("noted.osim --target-mass 600 --contacts-mass 500").succeeded();
}

#[test]
fn a_factor_is_not_applied_twice_in_place_without_force() {
    let dir = TestDir::with_human();
    let run = "human.osim --target-mass 500 --radius x2 --in-place --no-backup";
    dir.run(run).succeeded();
    dir.run(run).failed().wrote_nothing().says(&["was done already", "--force"]);
    dir.run("set human.osim dissipation=x2 --in-place --no-backup").succeeded();
    dir.run("set human.osim stiffness=x2 --in-place --no-backup").succeeded();
    dir.run("set human.osim dissipation=x2 --in-place").failed().wrote_nothing().says(&["was done already"]);
    // The note still has the mass that the contacts are made for.
    assert!(dir.text("human.osim").contains("contacts made for 500 kg"));
}

#[test]
fn selecting_forces_does_not_change_the_sphere_count() {
    let dir = TestDir::with_human();
    let transfer = "transfer human.osim --from falisse2022 --dry-run --select contact_s1_r";
    dir.run(transfer).succeeded().says(&["n = 6) for 62 kg", "nothing to change"]);
}

#[test]
fn isometric_radii_follow_the_sphere_of_the_same_name() {
    let dir = TestDir::with(&[("format/mixed_radii.osim", "mixed.osim")]);
    let transfer = "transfer mixed.osim --from mixed.osim --radius isometric --dry-run --spheres 2";
    dir.run(&format!("{transfer} --reference-spheres 2")).succeeded().says(&["nothing to change"]);
}

#[test]
fn a_shared_sphere_is_not_resized_for_one_of_its_forces() {
    let dir = TestDir::with(&[("format/shared_sphere.osim", "shared.osim")]);
    dir.run("set shared.osim radius=x2 --select contact_1")
        .failed()
        .wrote_nothing()
        .says(&["is used by", "--select"]);
}

#[test]
fn options_that_leave_nothing_to_change_are_refused() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 500 --only stiffness --keep stiffness").usage_error().wrote_nothing();
    dir.run("human.osim --target-mass 500 --only static_friction").usage_error().wrote_nothing();
    dir.run("design --mass 62 --spheres 6 --radius 0.03 --indentation 0.1 -o x.osim")
        .usage_error()
        .wrote_nothing();
}

#[cfg(unix)]
#[test]
fn hard_links_of_a_model_keep_the_old_file() {
    let dir = TestDir::with_human();
    std::fs::hard_link(dir.path("human.osim"), dir.path("other.osim")).unwrap();
    let call = "human.osim --target-mass 500 --in-place";
    dir.run(&format!("{call} --dry-run")).succeeded().says(&["one more name", "hard-linked"]);
    dir.run(call).succeeded().wrote(&["human.osim", "human.osim.bak"]).says(&["one more name"]);
    // The backup is a copy: changing the other name does not change it.
    dir.write("other.osim", "changed");
    assert_eq!(dir.read("human.osim.bak"), fixture(HUMAN.0));
    let run = dir.run("human.osim --target-mass 400 --in-place").succeeded();
    assert!(!run.err().contains("hard-linked"), "{}", run.err());
}

/// If root changes a model of another user, the model keeps its owner and group.
#[cfg(unix)]
#[test]
fn a_model_changed_in_place_keeps_its_owner_or_is_refused() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let dir = TestDir::with_human();
    if chown(dir.path("human.osim"), Some(12_345), Some(54_321)).is_err() {
        crate::support::report_skip("the owner of a model stays", "only root can give files away");
        return;
    }
    let owner = |name: &str| {
        let metadata = std::fs::metadata(dir.path(name)).unwrap();
        (metadata.uid(), metadata.gid())
    };
    dir.run("human.osim --target-mass 500 --in-place").succeeded();
    assert_eq!((owner("human.osim"), owner("human.osim.bak")), ((12_345, 54_321), (12_345, 54_321)));
    // Who may write into the folder but not give files away.
    std::fs::set_permissions(dir.path("."), PermissionsExt::from_mode(0o777)).unwrap();
    std::fs::set_permissions(dir.path("human.osim"), PermissionsExt::from_mode(0o666)).unwrap();
    let before = dir.files();
    let program = env!("CARGO_BIN_EXE_osim-contact-scale");
    let mut command = std::process::Command::new("setpriv");
    command.args(["--reuid=65534", "--regid=65534", "--clear-groups", "--", program]);
    let call = ["human.osim", "--target-mass", "400", "--in-place"];
    let output = command.args(call).current_dir(dir.path(".")).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("belongs to another user") && text.contains("another name with -o"), "{text}");
    assert!(dir.files() == before, "nothing is written");
}
