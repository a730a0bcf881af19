//! A change is judged by the model that it would write.

use crate::support::{Bench, HUMAN};

#[test]
fn a_change_after_which_the_model_is_wrong_is_refused_until_it_is_meant() {
    let bench = Bench::human();
    // On the spheres of a mouse the smoothing of a human holds the body in the air.
    let call = "human.osim --target-mass 0.02 --keep constant_contact_force,hertz_smoothing";
    let refused = bench.run(call).failed().wrote_nothing().err();
    let asked = "the model would be wrong afterwards [floats]: body weight is carried ";
    assert!(
        refused.contains(asked) && refused.contains("if it is meant, say --yes wrong-afterwards"),
        "{refused}"
    );
    let out = bench.run(&format!("{call} --yes wrong-afterwards")).done().wrote(&["human.scaled.osim"]).out();
    assert!(out.contains("error: in the new model: body weight is carried "), "{out}");
    let found = bench.run("check human.scaled.osim --mass 0.02 --yes implausible-mass").out();
    assert!(found.contains("error floats"), "{found}");
}

#[test]
fn numbers_that_were_given_are_said_to_be_wrong_and_written() {
    let bench = Bench::human();
    // (11): x/R follows E*^(-2/3), 0.3533 becomes 1.64.
    let out = bench.run("set human.osim stiffness=x0.1").done().out();
    let wrong =
        "error: in the new model: too soft: at body weight on one limb spheres sink 1.64 R into the floor";
    assert!(out.contains(wrong), "{out}");
}

#[test]
fn what_is_as_bad_as_before_is_not_said_again() {
    let bench = Bench::with(&[HUMAN, ("check/sunk_in.osim", "deep.osim")]);
    for model in ["human.osim", "deep.osim"] {
        let out = bench.run(&format!("{model} --target-mass 200 --dry-run")).done().out();
        assert!(!out.contains("in the new model"), "{out}");
    }
}
