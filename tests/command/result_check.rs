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
fn what_the_caller_says_about_masses_was_not_in_the_file() {
    let dir = TestDir::with(&[("check/known_contacts.osim", "falisse.osim")]);
    let out = dir.run("note falisse.osim --contacts-mass 1 -o noted.osim").succeeded().out();
    assert!(
        out.contains(
            "warning: in the new model: contacts are taken as made for 1 kg (note in the file), but the sum of"
        ),
        "{out}"
    );
    // The masses of the result are said once, with its own numbers.
    dir.run("falisse.osim --target-mass 52 -o m52.osim").succeeded();
    let out = dir.run("transfer m52.osim --from falisse.osim --mass 30 -o m30.osim").succeeded().out();
    assert_eq!(out.matches("mass-sources-disagree").count(), 1, "{out}");
    let remark =
        "remark: in the new model: the bodies weigh 62 kg, and the contacts are for 30 kg: scale the bodies";
    assert!(out.contains(remark), "{out}");
}

#[test]
fn a_preset_brings_no_faults_of_bones_that_it_lacks() {
    let dir = TestDir::with_human();
    let call = "transfer human.osim --from dhondt2024 --reference-sphere heel_r --radius x0.05 -o out.osim";
    let out = dir.run(call).succeeded().out();
    assert!(out.contains("warning: in the new model: radius of ") && out.contains("[odd-radius]"), "{out}");
}

#[test]
fn forces_that_were_not_chosen_are_judged_too_and_need_no_answer() {
    let dir = TestDir::with(&[("scale_tool/generic_smooth.osim", "human.osim")]);
    let out = dir.run("human.osim --target-mass 300 --select *_r -o right.osim").succeeded().out();
    let finding = "error: in the new model: too soft: at body weight on one limb spheres sink 1.011 R into the \
                   floor (x/R by Hertz) (3 of 6 spheres, most in heel_l) [sunk-in]";
    assert!(out.contains(finding), "{out}");
    let check = dir.run("check right.osim --mass 300").out();
    assert!(check.contains("(3 of 6 spheres, most in heel_l)"), "{check}");
    // The second half of the change.
    let out = dir
        .run("right.osim --target-mass 300 --contacts-mass 62 --select *_l -o both.osim")
        .succeeded()
        .out();
    assert!(!out.contains("error: "), "{out}");
}
