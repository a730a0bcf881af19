//! Numbers that look like mistakes: a run asks, and continues if `--yes` has the code of the question.

use crate::support::{CommandRun, TestDir};

/// Asserts that the run asks: it prints one line on standard error, writes nothing, and ends with exit status 1.
#[track_caller]
fn assert_asks(run: CommandRun, name: &str) {
    let run = run.failed().wrote_nothing();
    assert_eq!(run.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", run.err());
    run.matches_snapshot(&format!("implausible_{name}"));
}

#[test]
fn rescale_asks_about_a_radius_in_another_unit() {
    // The longest of calcn_r and tibia_r is the tibia, 0.4278 m from knee to ankle; toes_r has calcn_r, 0.1488 m.
    let dir = TestDir::with_human();
    assert_asks(dir.run("human.osim --target-mass 62 --radius 32"), "radius_mm");
    assert_asks(dir.run("human.osim --target-mass 62 --radius 3.2"), "radius_cm");
    assert_asks(dir.run("set human.osim radius=32"), "radius_set");
    dir.run("human.osim --target-mass 62 --radius 0.1487 --dry-run").succeeded();
    dir.run("human.osim --target-mass 62 --radius 0.1489 --dry-run")
        .failed()
        .says(&["at most 0.1488 m apart"]);
    dir.run("human.osim --target-mass 62 --radius 32 --yes implausible-radius")
        .succeeded()
        .wrote(&["human.scaled.osim"]);
    // A large radius that the file already has causes no question.
    dir.run("set human.scaled.osim stiffness=x2 --dry-run").succeeded();
}

#[test]
fn a_stiffness_like_a_factor_or_in_mpa_causes_a_question() {
    let dir = TestDir::with_human();
    let question = "a stiffness would be 2 N/m2, and is 1000000 now: write x2 to multiply it, or 2000000 if it is in MPa";
    for call in ["set human.osim stiffness=2", "sweep human.osim --grid stiffness=2,3e6 -d out"] {
        dir.run(call).failed().wrote_nothing().says(&[question, "--yes wrong-afterwards"]);
    }
    // A design takes no factor.
    let designed = dir.run("design human.osim --radius 0.03 --stiffness 2").failed().wrote_nothing();
    designed.says(&["and is 1000000 now: write 2000000 if it is in MPa"]);
    for call in ["stiffness=x2", "stiffness=1001", "stiffness=2 --yes wrong-afterwards"] {
        dir.run(&format!("set human.osim {call} --dry-run")).succeeded();
    }
}

#[test]
fn lengths_in_millimetres_cause_a_question_without_a_model() {
    let dir = TestDir::with(&[("measured/heel_pad.csv", "heel_pad.csv")]);
    let asks = |arguments: &str, name: &str| {
        dir.run(arguments).usage_error().wrote_nothing().matches_snapshot(&format!("implausible_{name}"));
    };
    let design = "design --mass 62 --spheres 6 --indentation 0.1 --radius";
    asks(&format!("{design} 32"), "design_radius_mm");
    dir.run(&format!("{design} 32 --yes implausible-radius")).succeeded();
    dir.run(&format!("{design} 0.99")).succeeded();
    let fit = "fit heel_pad.csv --time-column time --radius";
    asks(&format!("{fit} 30 --indentation-unit mm"), "fit_radius_mm");
    asks(&format!("{fit} 0.03"), "fit_indentation_mm");
    dir.run(&format!("{fit} 0.03 --yes implausible-radius")).succeeded();
    dir.run(&format!("{fit} 0.03 --indentation-unit mm")).succeeded();
}

#[test]
fn rescale_asks_about_an_implausible_scaled_radius() {
    // 62 kg to 62 kg x 125 is 5 times the length: 0.032 m to 0.16 m, above the 0.1488 m of the foot.
    let dir = TestDir::with_human();
    assert_asks(dir.run("human.osim --target-mass 7750"), "radius_isometric");
    // 62 kg x 64 is 4 times the length: 0.128 m.
    dir.run("human.osim --target-mass 3968 --dry-run").succeeded();
}

#[test]
fn masses_in_other_units_cause_a_question() {
    let dir = TestDir::with_human();
    assert_asks(dir.run("human.osim --target-mass 62000"), "mass_g");
    assert_asks(dir.run("human.osim --target-mass 0.062"), "mass_t");
    // 62 kg are 136.69 lb.
    assert_asks(dir.run("human.osim --target-mass 137"), "mass_lb");
    // 62 lb are 28.12 kg.
    assert_asks(dir.run("human.osim --target-mass 28"), "mass_bodies_lb");
    assert_asks(dir.run("human.osim --target-mass 200001"), "mass_whale");
    assert_asks(dir.run("human.osim --target-mass 9e-7"), "mass_mite");
    assert_asks(dir.run("human.osim --target-mass 50 --contacts-mass 62000"), "mass_contacts");
    assert_asks(dir.run("transfer human.osim --from falisse2022 --mass 62000"), "mass_of_model");
    assert_asks(dir.run("transfer human.osim --from falisse2022 --reference-mass 300000"), "mass_of_preset");
    assert_asks(dir.run("transfer human.osim --from human.osim --reference-mass 62000"), "mass_of_reference");
    dir.run("human.osim --target-mass 137 --yes mass-in-pounds").succeeded().wrote(&["human.scaled.osim"]);
}

#[test]
fn a_mass_in_pounds_causes_a_question_or_a_remark() {
    let dir = TestDir::with_human();
    let pounds = "if it is in lb";
    // 62 kg are 136.69 lb, and 1 % to both sides is 135.3 to 138.1: masses further away cause a remark.
    for (kg, is_asked, is_mentioned) in [
        (135.0, false, true),
        (135.5, true, true),
        (138.0, true, true),
        (138.5, false, true),
        (117.0, false, true),
        (157.0, false, true),
        (115.0, false, false),
        (158.0, false, false),
    ] {
        let run = dir.run(&format!("human.osim --target-mass {kg} --dry-run"));
        assert_eq!(run.status, Some(i32::from(is_asked)), "{kg}");
        let output = run.out() + &run.err();
        assert_eq!(output.contains(pounds), is_mentioned, "{kg}: {output}");
    }
    // Children: 62 lb are 28.12 kg.
    for kg in [24, 26, 30, 32] {
        let run = dir.run(&format!("human.osim --target-mass {kg} --dry-run")).succeeded();
        assert!(!(run.out() + &run.err()).contains("that the bodies weigh"), "{}", run.err());
    }
    dir.run("human.osim --target-mass 28.1 --dry-run")
        .failed()
        .says(&["confirm it with --yes mass-in-pounds"]);
}

/// Runs a table in which copies of the 62 kg human have these target masses. Returns the rows about which the run asks.
fn rows_with_questions(dir: &TestDir, masses: &[f64]) -> Vec<(usize, String)> {
    let row = |(at, kg): (usize, &f64)| format!("human.osim,{kg},keep,{at}.osim\n");
    let rows: String = masses.iter().enumerate().map(row).collect();
    dir.write("masses.csv", format!("model,target-mass,radius,output\n{rows}"));
    let output = dir.run("batch masses.csv --dry-run").err();
    let row = |line: &str| line.rsplit_once("(row ")?.1.trim_end_matches(')').parse::<usize>().ok();
    let errors = output.lines().filter(|line| !line.starts_with("remark: "));
    errors.filter_map(|line| Some((row(line)? - 2, line.to_owned()))).collect()
}

#[test]
fn masses_of_a_table_are_compared_with_each_other() {
    let dir = TestDir::with_human();
    // Thirty children, among them some who weigh what 62 lb are.
    let children: Vec<f64> = (0..30).map(|at| 22.0 + 0.4 * f64::from(at)).collect();
    assert_eq!(rows_with_questions(&dir, &children), []);
    let adults: Vec<f64> = (0..30).map(|at| 50.0 + f64::from(at)).collect();
    for (kg, code, expected) in [
        // 154 lb are 69.85 kg.
        (154.0, "mass-in-pounds", "if it is in lb, write 69.853225"),
        (640.0, "implausible-mass", "about 10 times the 51 to 78 kg of the other rows"),
        (6.4, "implausible-mass", "about 1/10 of the 51 to 78 kg of the other rows"),
        (64_000.0, "implausible-mass", "if it is in g, write 64;"),
        (28.0, "mass-in-pounds", "masses are in kg, in all rows"),
    ] {
        let mut masses = adults.clone();
        masses[14] = kg;
        let questions = rows_with_questions(&dir, &masses);
        assert_eq!(questions.len(), 1, "{kg}: {questions:?}");
        assert!(
            questions[0].0 == 14 && questions[0].1.contains(code) && questions[0].1.contains(expected),
            "{questions:?}"
        );
    }
    // Heavy or light people cause no question.
    let heavy = [adults.as_slice(), &[96.0, 40.0]].concat();
    assert_eq!(rows_with_questions(&dir, &heavy), []);
    // Masses of different animals are not compared.
    assert_eq!(rows_with_questions(&dir, &[3.0, 60.0, 62.0, 70.0, 545.0, 700.0]), []);
    // If there are too few other rows, the mass of the model is compared.
    let few = rows_with_questions(&dir, &[60.0, 62.5, 137.0]);
    assert!(few.len() == 1 && few[0].1.contains("that the bodies weigh together"), "{few:?}");
    // A row with the mass of its own model causes no question.
    assert_eq!(rows_with_questions(&dir, &[25.0, 27.0, 28.1, 26.0, 62.0]), []);
}

#[test]
fn a_mass_within_15_percent_of_another_unit_causes_a_question() {
    let dir = TestDir::with_human();
    let is_asked = |kg: f64| {
        dir.run(&format!("human.osim --target-mass {kg} --radius keep --dry-run")).status == Some(1)
    };
    // 62 kg times 1/1000, with 14 % and 16 % to both sides.
    for (share, expected) in [(0.84, false), (0.86, true), (1.14, true), (1.16, false)] {
        let kg = 62.0 * 1e-3 * share;
        assert_eq!(is_asked(kg), expected, "{kg}");
    }
    // Grams: also of an animal that weighs a fifth or five times as much as the model.
    for (factor, expected) in [(199.0, false), (201.0, true), (1000.0, true), (3200.0, true)] {
        assert_eq!(is_asked(62.0 * factor), expected, "{factor}");
    }
}

#[test]
fn verbs_that_only_read_ask_about_implausible_masses() {
    let dir = TestDir::with_human();
    for call in
        ["inspect human.osim", "check human.osim", "drop-test human.osim", "plot force human.osim -o f.svg"]
    {
        dir.run(&format!("{call} --mass 62000"))
            .failed()
            .wrote_nothing()
            .says(&["confirm it with --yes implausible-mass"]);
    }
    dir.run("inspect human.osim --mass 62000 --yes implausible-mass").succeeded();
}

#[test]
fn the_answer_is_a_code_and_is_not_read_from_standard_input() {
    let dir = TestDir::with_human();
    dir.run_with_stdin("human.osim --target-mass 62000", b"yes\ny\n").failed().wrote_nothing();
    dir.run("human.osim --target-mass 62000 --yes implausible-radius").failed().wrote_nothing();
    // A yes to pounds is no answer to the question about grams.
    dir.run("human.osim --target-mass 62000 --yes mass-in-pounds").failed().wrote_nothing();
    let unknown = dir.run("human.osim --target-mass 62000 --yes really");
    unknown.usage_error().wrote_nothing().matches_snapshot("implausible_unknown_code");
    let both = "--yes implausible-mass --yes implausible-radius";
    dir.run(&format!("human.osim --target-mass 62000 {both}")).succeeded().wrote(&["human.scaled.osim"]);
    dir.run("explain implausible-mass").succeeded().matches_snapshot("explain_implausible_mass");
}

#[test]
fn json_has_the_code_and_a_request_has_the_answer() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 62000 --format json").failed().matches_snapshot("implausible_json");
    let request = |yes: &str| {
        format!(r#"{{"verb":"rescale","models":"human.osim","target_mass":62000{yes},"radius":"keep"}}"#)
    };
    dir.run_with_stdin("request -", request("").as_bytes()).failed().wrote_nothing();
    let answered = request(r#","yes":"implausible-mass""#);
    dir.run_with_stdin("request -", answered.as_bytes()).succeeded().wrote(&["human.scaled.osim"]);
}

#[test]
fn a_column_of_a_table_holds_the_answers() {
    let dir = TestDir::with_human();
    dir.write(
        "m.csv",
        "model,target-mass,radius,yes,output\n\
         human.osim,137,keep,,a.osim\n\
         human.osim,137,keep,mass-in-pounds,b.osim\n\
         human.osim,137,32,mass-in-pounds;implausible-radius,c.osim\n",
    );
    dir.run("batch m.csv")
        .failed()
        .wrote(&["b.osim", "c.osim"])
        .says(&["confirm it with --yes mass-in-pounds"]);
    dir.run("batch m.csv --force --yes mass-in-pounds").succeeded().says(&["3 written"]);
}

#[test]
fn sweeps_ask_about_implausible_masses_before_they_write() {
    let dir = TestDir::with_human();
    let call = "sweep human.osim --grid target_mass=50,137";
    assert_asks(dir.run(call), "sweep");
    dir.run(&format!("{call} --yes mass-in-pounds")).succeeded();
}

#[test]
fn a_mass_that_is_proposed_comes_with_its_answer() {
    // Contacts scaled to 137 kg under a body that still weighs 62 kg.
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 137 --yes mass-in-pounds").succeeded();
    let drop_test = dir.run("drop-test human.scaled.osim").succeeded();
    assert!(drop_test.err().contains("give --mass 137 with --yes mass-in-pounds"), "{}", drop_test.err());
    dir.run("drop-test human.scaled.osim --mass 137 --yes mass-in-pounds").succeeded();
}

#[test]
fn the_command_that_check_proposes_runs() {
    // Contacts of the published 62 kg human under a body of 28 kg: the masses are 2.2 apart.
    let dir = TestDir::with(&[("check/contacts_of_another_mass.osim", "heavy.osim")]);
    dir.write("child.osim", dir.text("heavy.osim").replace("<mass>88</mass>", "<mass>26</mass>"));
    let check = dir.run("check child.osim").out();
    let proposed_commands =
        check.lines().filter_map(|line| Some(line.split_once("osim-contact-scale ")?.1.to_owned()));
    let rescale: Vec<String> = proposed_commands.filter(|call| call.contains("--contacts-mass")).collect();
    assert_eq!(rescale.len(), 1, "{check}");
    // The masses of known contacts and of the body cause no question.
    assert!(!rescale[0].contains("--yes"), "{}", rescale[0]);
    dir.run(&rescale[0]).succeeded().wrote(&["child.scaled.osim"]);
}
