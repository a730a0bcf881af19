//! Numbers that look like slips: a run asks, and goes on where its code is the answer.

use crate::support::{Bench, Ran};

/// A run that asks: one line on standard error, nothing written, exit status 1.
#[track_caller]
fn asks(ran: Ran, name: &str) {
    let ran = ran.failed().wrote_nothing();
    assert_eq!(ran.err().lines().filter(|line| line.starts_with("error: ")).count(), 1, "{}", ran.err());
    ran.looks_like(&format!("slip_{name}"));
}

#[test]
fn a_radius_that_was_meant_in_mm_is_asked_about() {
    // The longest of calcn_r and tibia_r is the tibia, 0.4278 m from knee to ankle; toes_r has calcn_r, 0.1488 m.
    let bench = Bench::human();
    asks(bench.run("human.osim --target-mass 62 --radius 32"), "radius_mm");
    asks(bench.run("human.osim --target-mass 62 --radius 3.2"), "radius_cm");
    asks(bench.run("set human.osim radius=32"), "radius_set");
    bench.run("human.osim --target-mass 62 --radius 0.1487 --dry-run").done();
    bench
        .run("human.osim --target-mass 62 --radius 0.1489 --dry-run")
        .failed()
        .says(&["at most 0.1488 m apart"]);
    bench
        .run("human.osim --target-mass 62 --radius 32 --yes implausible-radius")
        .done()
        .wrote(&["human.scaled.osim"]);
    // What is that large in the file already and stays so is no question.
    bench.run("set human.scaled.osim stiffness=x2 --dry-run").done();
}

#[test]
fn a_radius_that_follows_from_a_mass_is_asked_about_too() {
    // 62 kg to 62 kg x 125 is 5 times the length: 0.032 m to 0.16 m, above the 0.1488 m of the foot.
    let bench = Bench::human();
    asks(bench.run("human.osim --target-mass 7750"), "radius_isometric");
    // 62 kg x 64 is 4 times the length: 0.128 m.
    bench.run("human.osim --target-mass 3968 --dry-run").done();
}

#[test]
fn masses_in_other_units_are_asked_about() {
    let bench = Bench::human();
    asks(bench.run("human.osim --target-mass 62000"), "mass_g");
    asks(bench.run("human.osim --target-mass 0.062"), "mass_t");
    // 62 kg are 136.69 lb.
    asks(bench.run("human.osim --target-mass 137"), "mass_lb");
    // 62 lb are 28.12 kg.
    asks(bench.run("human.osim --target-mass 28"), "mass_bodies_lb");
    asks(bench.run("human.osim --target-mass 200001"), "mass_whale");
    asks(bench.run("human.osim --target-mass 9e-7"), "mass_mite");
    asks(bench.run("human.osim --target-mass 50 --contacts-mass 62000"), "mass_contacts");
    asks(bench.run("transfer human.osim --from falisse2022 --mass 62000"), "mass_of_model");
    asks(bench.run("transfer human.osim --from falisse2022 --reference-mass 300000"), "mass_of_preset");
    asks(bench.run("transfer human.osim --from human.osim --reference-mass 62000"), "mass_of_reference");
    bench.run("human.osim --target-mass 137 --yes mass-in-pounds").done().wrote(&["human.scaled.osim"]);
}

#[test]
fn pounds_are_asked_about_where_the_body_weighs_that_and_said_where_it_may() {
    let bench = Bench::human();
    let pounds = "if it is in lb";
    // 62 kg are 136.69 lb: 1 % to both sides is 135.3 to 138.1; what is further away is most often meant.
    for (kg, is_asked, is_said) in [
        (135.0, false, true),
        (135.5, true, true),
        (138.0, true, true),
        (138.5, false, true),
        (117.0, false, true),
        (157.0, false, true),
        (115.0, false, false),
        (158.0, false, false),
    ] {
        let ran = bench.run(&format!("human.osim --target-mass {kg} --dry-run"));
        assert_eq!(ran.status, Some(i32::from(is_asked)), "{kg}");
        let said = ran.out() + &ran.err();
        assert_eq!(said.contains(pounds), is_said, "{kg}: {said}");
    }
    // Children: 62 lb are 28.12 kg.
    for kg in [24, 26, 30, 32] {
        let ran = bench.run(&format!("human.osim --target-mass {kg} --dry-run")).done();
        assert!(!(ran.out() + &ran.err()).contains("that the bodies weigh"), "{}", ran.err());
    }
    bench.run("human.osim --target-mass 28.1 --dry-run").failed().says(&["say --yes mass-in-pounds"]);
}

/// A table in which these masses are the targets of copies of the human of 62 kg; gives the rows that are asked about.
fn rows_asked(bench: &Bench, masses: &[f64]) -> Vec<(usize, String)> {
    let row = |(at, kg): (usize, &f64)| format!("human.osim,{kg},keep,{at}.osim\n");
    let rows: String = masses.iter().enumerate().map(row).collect();
    bench.write("masses.csv", format!("model,target-mass,radius,output\n{rows}"));
    let said = bench.run("batch masses.csv --dry-run").err();
    let row = |line: &str| line.rsplit_once("(row ")?.1.trim_end_matches(')').parse::<usize>().ok();
    said.lines().filter_map(|line| Some((row(line)? - 2, line.to_owned()))).collect()
}

#[test]
fn a_table_is_judged_as_a_table() {
    let bench = Bench::human();
    // Thirty children, among them some who weigh what 62 lb are.
    let children: Vec<f64> = (0..30).map(|at| 22.0 + 0.4 * f64::from(at)).collect();
    assert_eq!(rows_asked(&bench, &children), []);
    let adults: Vec<f64> = (0..30).map(|at| 50.0 + f64::from(at)).collect();
    for (kg, code, meant) in [
        // 154 lb are 69.85 kg.
        (154.0, "mass-in-pounds", "if it is in lb, write 69.853225"),
        (640.0, "implausible-mass", "about 10 times the 51 to 78 kg of the other rows"),
        (6.4, "implausible-mass", "about 1/10 of the 51 to 78 kg of the other rows"),
        (64_000.0, "implausible-mass", "if it is in g, write 64;"),
        (28.0, "mass-in-pounds", "masses are in kg, in all rows"),
    ] {
        let mut masses = adults.clone();
        masses[14] = kg;
        let asked = rows_asked(&bench, &masses);
        assert_eq!(asked.len(), 1, "{kg}: {asked:?}");
        assert!(asked[0].0 == 14 && asked[0].1.contains(code) && asked[0].1.contains(meant), "{asked:?}");
    }
    // Heavy, and nothing else.
    let heavy = [adults.as_slice(), &[96.0, 40.0]].concat();
    assert_eq!(rows_asked(&bench, &heavy), []);
    // Bodies of several kinds say nothing of each other.
    assert_eq!(rows_asked(&bench, &[3.0, 60.0, 62.0, 70.0, 545.0, 700.0]), []);
    // Where all other rows are too few to say what is usual, the model does.
    let few = rows_asked(&bench, &[60.0, 62.5, 137.0]);
    assert!(few.len() == 1 && few[0].1.contains("that the bodies weigh together"), "{few:?}");
    // What the row's own model weighs is meant, however the others are.
    assert_eq!(rows_asked(&bench, &[25.0, 27.0, 28.1, 26.0, 62.0]), []);
}

#[test]
fn fifteen_per_cent_are_near() {
    let bench = Bench::human();
    let asked = |kg: f64| {
        bench.run(&format!("human.osim --target-mass {kg} --radius keep --dry-run")).status == Some(1)
    };
    // 62 kg times 1/1000, with 14 % and 16 % to both sides.
    for (share, expected) in [(0.84, false), (0.86, true), (1.14, true), (1.16, false)] {
        let kg = 62.0 * 1e-3 * share;
        assert_eq!(asked(kg), expected, "{kg}");
    }
    // Grams: also of an animal that weighs a fifth or five times as much as the model.
    for (factor, expected) in [(199.0, false), (201.0, true), (1000.0, true), (3200.0, true)] {
        assert_eq!(asked(62.0 * factor), expected, "{factor}");
    }
}

#[test]
fn verbs_that_only_read_ask_too() {
    let bench = Bench::human();
    for call in
        ["inspect human.osim", "check human.osim", "drop-test human.osim", "plot force human.osim -o f.svg"]
    {
        bench
            .run(&format!("{call} --mass 62000"))
            .failed()
            .wrote_nothing()
            .says(&["say --yes implausible-mass"]);
    }
    bench.run("inspect human.osim --mass 62000 --yes implausible-mass").done();
}

#[test]
fn the_answer_is_a_code_and_never_read_from_standard_input() {
    let bench = Bench::human();
    bench.run_with("human.osim --target-mass 62000", b"yes\ny\n").failed().wrote_nothing();
    bench.run("human.osim --target-mass 62000 --yes implausible-radius").failed().wrote_nothing();
    // Pounds that are meant say nothing of grams.
    bench.run("human.osim --target-mass 62000 --yes mass-in-pounds").failed().wrote_nothing();
    let unknown = bench.run("human.osim --target-mass 62000 --yes really");
    unknown.usage().wrote_nothing().looks_like("slip_unknown_code");
    let both = "--yes implausible-mass --yes implausible-radius";
    bench.run(&format!("human.osim --target-mass 62000 {both}")).done().wrote(&["human.scaled.osim"]);
    bench.run("explain implausible-mass").done().looks_like("explain_implausible_mass");
}

#[test]
fn json_has_code_and_key() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 62000 --format json").failed().looks_like("slip_json");
    let request = |yes: &str| {
        format!(r#"{{"verb":"rescale","models":"human.osim","target_mass":62000{yes},"radius":"keep"}}"#)
    };
    bench.run_with("request -", request("").as_bytes()).failed().wrote_nothing();
    let answered = request(r#","yes":"implausible-mass""#);
    bench.run_with("request -", answered.as_bytes()).done().wrote(&["human.scaled.osim"]);
}

#[test]
fn tables_have_a_column_for_answers() {
    let bench = Bench::human();
    bench.write(
        "m.csv",
        "model,target-mass,radius,yes,output\n\
         human.osim,137,keep,,a.osim\n\
         human.osim,137,keep,mass-in-pounds,b.osim\n\
         human.osim,137,32,mass-in-pounds;implausible-radius,c.osim\n",
    );
    bench.run("batch m.csv").failed().wrote(&["b.osim", "c.osim"]).says(&["say --yes mass-in-pounds"]);
    bench.run("batch m.csv --force --yes mass-in-pounds").done().says(&["3 written"]);
}

#[test]
fn sweeps_ask_before_they_write() {
    let bench = Bench::human();
    let call = "sweep human.osim --grid target_mass=50,137";
    asks(bench.run(call), "sweep");
    bench.run(&format!("{call} --yes mass-in-pounds")).done();
}

#[test]
fn a_mass_that_is_proposed_comes_with_its_answer() {
    // Contacts scaled to 137 kg under a body that still weighs 62 kg.
    let bench = Bench::human();
    bench.run("human.osim --target-mass 137 --yes mass-in-pounds").done();
    let noted = bench.run("drop-test human.scaled.osim").done();
    assert!(noted.err().contains("say --mass 137 with --yes mass-in-pounds"), "{}", noted.err());
    bench.run("drop-test human.scaled.osim --mass 137 --yes mass-in-pounds").done();
}

#[test]
fn what_check_proposes_runs_as_it_is_printed() {
    // Contacts of the published 62 kg human under a body of 28 kg: the masses are 2.2 apart.
    let bench = Bench::with(&[("check/contacts_of_another_mass.osim", "heavy.osim")]);
    bench.write("child.osim", bench.text("heavy.osim").replace("<mass>88</mass>", "<mass>26</mass>"));
    let checked = bench.run("check child.osim").out();
    let proposed =
        checked.lines().filter_map(|line| Some(line.split_once("osim-contact-scale ")?.1.to_owned()));
    let rescale: Vec<String> = proposed.filter(|call| call.contains("--contacts-mass")).collect();
    assert_eq!(rescale.len(), 1, "{checked}");
    // The mass of known contacts, and that of the body, are no slips of each other.
    assert!(!rescale[0].contains("--yes"), "{}", rescale[0]);
    bench.run(&rescale[0]).done().wrote(&["child.scaled.osim"]);
}
