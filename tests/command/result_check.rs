//! The program judges a change by the model that it would write.

use crate::support::{HUMAN, TestDir};

#[test]
fn a_change_that_makes_the_model_wrong_needs_the_answer_yes() {
    let dir = TestDir::with_human();
    // On the spheres of a mouse the smoothing of a human holds the body in the air.
    let call = "human.osim --target-mass 0.02 --keep constant_contact_force,hertz_smoothing";
    let refused = dir.run(call).failed().wrote_nothing().err();
    let question = "the model would be wrong afterwards [floats]: body weight is carried ";
    assert!(
        refused.contains(question)
            && refused.contains("if it is correct, confirm it with --yes wrong-afterwards"),
        "{refused}"
    );
    let out =
        dir.run(&format!("{call} --yes wrong-afterwards")).succeeded().wrote(&["human.scaled.osim"]).out();
    assert!(out.contains("error: in the new model: body weight is carried "), "{out}");
    let check = dir.run("check human.scaled.osim --mass 0.02 --yes implausible-mass").out();
    assert!(check.contains("[floats"), "{check}");
}

#[test]
fn wrong_numbers_of_the_user_are_reported_and_written() {
    let dir = TestDir::with_human();
    // (11): x/R follows E*^(-2/3), 0.3533 becomes 1.64.
    let out = dir.run("set human.osim stiffness=x0.1").succeeded().out();
    let finding =
        "error: in the new model: too soft: at body weight on one limb spheres sink 1.64 R into the floor";
    assert!(out.contains(finding), "{out}");
}

#[test]
fn a_fault_that_the_model_already_had_is_not_repeated() {
    let dir = TestDir::with(&[HUMAN, ("check/sunk_in.osim", "deep.osim")]);
    for model in ["human.osim", "deep.osim"] {
        let out = dir.run(&format!("{model} --target-mass 200 --dry-run")).succeeded().out();
        assert!(
            !out.contains("error: in the new model") && !out.contains("warning: in the new model"),
            "{out}"
        );
        assert!(out.contains("as before: "), "{out}");
    }
}

#[test]
fn with_deny_the_exit_status_follows_from_the_worst_finding_in_the_result() {
    let dir = TestDir::with_human();
    let call = "set human.osim constant_contact_force=x100 hertz_smoothing=x0.1";
    dir.run(&format!("{call} -o a.osim")).succeeded().wrote(&["a.osim"]);
    dir.run(&format!("{call} -o b.osim --deny warning")).failed().wrote(&["b.osim"]);
    dir.run("human.osim --target-mass 80 -o c.osim --deny warning").succeeded().wrote(&["c.osim"]);
}

#[test]
fn a_preset_brings_no_faults_of_bones_that_it_lacks() {
    let dir = TestDir::with(&[("check/known_contacts.osim", "falisse.osim")]);
    let call = "transfer falisse.osim --from dhondt2024 --reference-sphere heel_r --radius x0.05 -o out.osim";
    let out = dir.run(call).succeeded().out();
    assert!(out.contains("warning: in the new model: radius of ") && out.contains("[odd-radius]"), "{out}");
}
