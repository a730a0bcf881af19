//! Ways in which a file or a factor could get lost between two files or two runs, each closed.

use crate::support::{Bench, HUMAN, fixture};

const PAIR: [(&str, &str); 3] = [
    ("format/standalone_ForceSet.xml", "forces.xml"),
    ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
    ("format/standalone_model_without_contacts.osim", "bones.osim"),
];

#[test]
fn no_output_is_an_input_of_the_same_run() {
    let bench = Bench::with(&[(HUMAN.0, "human.osim"), (HUMAN.0, "human.scaled.osim")]);
    // By another way, through a folder that is not there.
    bench.run("human.osim --target-mass 500 -o new/../human.osim --force").usage().wrote_nothing();
    // The default output of one is another of the models.
    bench.run("human.osim human.scaled.osim --target-mass 500 --force").usage().wrote_nothing();
    // The reference of a transfer.
    bench
        .run("transfer human.osim --from human.scaled.osim -o human.scaled.osim --force")
        .usage()
        .wrote_nothing();
    assert!(!bench.has("new"));
}

#[test]
fn a_model_that_is_named_twice_is_changed_once() {
    let bench = Bench::human();
    bench.run("set human.osim ./human.osim stiffness=x2 --in-place --no-backup").done();
    assert!(bench.text("human.osim").contains("<stiffness>2000000</stiffness>"));
}

#[test]
fn the_files_of_a_standalone_pair_do_not_overwrite_each_other() {
    let bench = Bench::with(&PAIR);
    let pair = "forces.xml --geometry geometry.xml --model bones.osim --target-mass 500";
    bench.run(&format!("{pair} -o x.xml --geometry-output x.xml --force")).usage().wrote_nothing();
    bench.run(&format!("{pair} -o geometry.xml --force")).usage().wrote_nothing();
    // Two force sets would scale the one geometry twice.
    bench.run(&format!("human.osim {pair} --in-place")).usage().wrote_nothing();
}

#[test]
fn a_geometry_that_was_scaled_without_its_forces_is_not_scaled_again() {
    let bench = Bench::with(&PAIR);
    let pair = "forces.xml --geometry geometry.xml --model bones.osim";
    bench.run(&format!("{pair} --target-mass 500 -o forces2.xml --geometry-output geometry2.xml")).done();
    let mixed = "forces.xml --geometry geometry2.xml --model bones.osim --target-mass 300 -d out";
    bench.run(mixed).failed().wrote_nothing().says(&["different runs", "--contacts-mass"]);
}

#[test]
fn one_model_at_most_goes_to_standard_output() {
    let bench = Bench::human();
    bench.run_with("- human.osim --target-mass 500", &fixture(HUMAN.0)).usage().wrote_nothing();
}

#[cfg(unix)]
#[test]
fn what_is_no_ordinary_file_is_not_replaced() {
    use std::os::unix::fs::symlink;
    let bench = Bench::human();
    symlink("nowhere.osim", bench.path("link.osim")).unwrap();
    bench.run("human.osim --target-mass 500 -o link.osim --force").failed().says(&["leads nowhere"]);
    bench.run("human.osim --target-mass 500 -o /dev/null --force").failed().says(&["not an ordinary file"]);
}

#[cfg(unix)]
#[test]
fn permissions_are_kept_to_the_bit() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::human();
    let mode = |name: &str| std::fs::metadata(bench.path(name)).unwrap().permissions().mode() & 0o777;
    let set = |bits| {
        let permissions = std::fs::Permissions::from_mode(bits);
        std::fs::set_permissions(bench.path("human.osim"), permissions).unwrap();
    };
    set(0o666);
    bench.run("human.osim --target-mass 500 --in-place").done();
    assert_eq!((mode("human.osim"), mode("human.osim.bak")), (0o666, 0o666));
    set(0o444);
    bench.run("human.osim --target-mass 300 --in-place").failed().wrote_nothing().says(&["write-protected"]);
    bench.run("human.osim --target-mass 300 --in-place --force").done();
    assert_eq!(mode("human.osim"), 0o444);
}

#[test]
fn a_note_that_cannot_be_read_is_asked_about() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 500 -o noted.osim").done();
    bench.write("noted.osim", bench.text("noted.osim").replace("made for 500 kg", "made for 500,0 kg"));
    bench
        .run("noted.osim --target-mass 600")
        .failed()
        .wrote_nothing()
        .says(&["is damaged", "--contacts-mass"]);
    bench.run("noted.osim --target-mass 600 --contacts-mass 500").done();
}

#[test]
fn a_factor_is_not_applied_twice_in_place_unasked() {
    let bench = Bench::human();
    let run = "human.osim --target-mass 500 --radius x2 --in-place --no-backup";
    bench.run(run).done();
    bench.run(run).failed().wrote_nothing().says(&["was done already", "--force"]);
    bench.run("set human.osim dissipation=x2 --in-place --no-backup").done();
    bench.run("set human.osim stiffness=x2 --in-place --no-backup").done();
    bench
        .run("set human.osim dissipation=x2 --in-place")
        .failed()
        .wrote_nothing()
        .says(&["was done already"]);
    // The mass the contacts stood for is still known.
    assert!(bench.text("human.osim").contains("contacts made for 500 kg"));
}

#[test]
fn choosing_forces_does_not_change_how_many_spheres_stand() {
    let bench = Bench::human();
    let transfer = "transfer human.osim --from falisse2022 --dry-run --select contact_s1_r";
    bench.run(transfer).done().says(&["n = 6) for 62 kg", "nothing to change"]);
}

#[test]
fn isometric_radii_follow_their_namesakes() {
    let bench = Bench::with(&[("format/mixed_radii.osim", "mixed.osim")]);
    let transfer = "transfer mixed.osim --from mixed.osim --radius isometric --dry-run --spheres 2";
    bench.run(&format!("{transfer} --reference-spheres 2")).done().says(&["nothing to change"]);
}

#[test]
fn a_shared_sphere_is_not_resized_for_one_of_its_forces() {
    let bench = Bench::with(&[("format/shared_sphere.osim", "shared.osim")]);
    bench
        .run("set shared.osim radius=x2 --select contact_1")
        .failed()
        .wrote_nothing()
        .says(&["is used by", "--select"]);
}

#[test]
fn options_that_leave_nothing_are_refused() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 500 --only stiffness --keep stiffness").usage().wrote_nothing();
    bench.run("human.osim --target-mass 500 --only static_friction").usage().wrote_nothing();
    bench
        .run("design --mass 62 --spheres 6 --radius 0.03 --indentation 0.1 -o x.osim")
        .usage()
        .wrote_nothing();
}

#[cfg(unix)]
#[test]
fn other_names_of_a_model_keep_the_old_one() {
    let bench = Bench::human();
    std::fs::hard_link(bench.path("human.osim"), bench.path("other.osim")).unwrap();
    let call = "human.osim --target-mass 500 --in-place";
    bench.run(&format!("{call} --dry-run")).done().says(&["one more name", "hard-linked"]);
    bench.run(call).done().wrote(&["human.osim", "human.osim.bak"]).says(&["one more name"]);
    // The backup is a file of its own: who changes the other name does not change it.
    bench.write("other.osim", "changed");
    assert_eq!(bench.read("human.osim.bak"), fixture(HUMAN.0));
    let ran = bench.run("human.osim --target-mass 400 --in-place").done();
    assert!(!ran.err().contains("hard-linked"), "{}", ran.err());
}

/// The owner and the group of a model that is changed by somebody else, who may: root.
#[cfg(unix)]
#[test]
fn a_model_changed_in_place_keeps_its_owner_or_is_left_alone() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let bench = Bench::human();
    if chown(bench.path("human.osim"), Some(12_345), Some(54_321)).is_err() {
        crate::support::skipped("the owner of a model stays", "only root can give files away");
        return;
    }
    let owner = |name: &str| {
        let metadata = std::fs::metadata(bench.path(name)).unwrap();
        (metadata.uid(), metadata.gid())
    };
    bench.run("human.osim --target-mass 500 --in-place").done();
    assert_eq!((owner("human.osim"), owner("human.osim.bak")), ((12_345, 54_321), (12_345, 54_321)));
    // Who may write into the folder but not give files away.
    std::fs::set_permissions(bench.path("."), PermissionsExt::from_mode(0o777)).unwrap();
    std::fs::set_permissions(bench.path("human.osim"), PermissionsExt::from_mode(0o666)).unwrap();
    let before = bench.files();
    let program = env!("CARGO_BIN_EXE_osim-contact-scale");
    let mut command = std::process::Command::new("setpriv");
    command.args(["--reuid=65534", "--regid=65534", "--clear-groups", "--", program]);
    let call = ["human.osim", "--target-mass", "400", "--in-place"];
    let output = command.args(call).current_dir(bench.path(".")).output().unwrap();
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("belongs to another user") && text.contains("another name with -o"), "{text}");
    assert!(bench.files() == before, "nothing is written");
}
