//! `--report`: the page is whole, needs nothing from elsewhere, and says what the run did.

use sha2::{Digest, Sha256};

use crate::html::Html;
use crate::support::{Bench, HUMAN, looks_like};

/// A model that fails, one without contacts, and good ones.
fn library() -> Bench {
    Bench::with(&[
        (HUMAN.0, "lib/a_human.osim"),
        ("bad/number_decimal_comma.osim", "lib/b_comma.osim"),
        ("bad/no_contacts.osim", "lib/c_no_contacts.osim"),
        ("check/sunk_in.osim", "lib/d_sunk_in.osim"),
    ])
}

#[track_caller]
fn page(bench: &Bench, name: &str) -> Html {
    Html::sound(&bench.text(name))
}

/// Compares with `tests/snapshots/NAME.snap`. Digests follow the version, which the note in the file tells.
#[track_caller]
fn snapshot(name: &str, text: &str) {
    let is_digest = |word: &str| word.len() == 64 && word.chars().all(|c| c.is_ascii_hexdigit());
    let digests: Vec<&str> = text.split_whitespace().filter(|word| is_digest(word)).collect();
    let text = digests.iter().fold(text.to_owned(), |text, digest| text.replace(digest, "[SHA-256]"));
    looks_like(name, &text.replace(env!("CARGO_PKG_VERSION"), "[VERSION]"));
}

#[test]
fn a_rescaled_model() {
    let bench = Bench::human();
    bench
        .run("human.osim --target-mass 1190 --report page.html")
        .done()
        .wrote(&["human.scaled.osim", "page.html"]);
    let page = page(&bench, "page.html");
    snapshot("page_rescale", &page.text);
    assert_eq!(page.plots, 4);
    // The paper's Table 1: R and E1* of the giraffe-heavy human follow M^(1/3), 19.19^(1/3) = 2.677; and Falisse (2022):
    // x/R 0.353 by Hertz, 0.3396 by the file's law, k R n/F 4.246, 7.5 N just touching.
    for number in ["0.3533", "0.3396", "4.246", "7.498", "2.6774318"] {
        assert!(page.text.contains(number), "{number} is missing");
    }
}

/// A transfer shows the reference beside both states: what looks like damage (x/R 0.17 before, 0.35 after) is as it is there.
#[test]
fn a_transferred_model_beside_its_reference() {
    let bench =
        Bench::with(&[("table1/emu_10_spheres_smooth_sphere.osim", "emu.osim"), (HUMAN.0, "human.osim")]);
    // The paper's Table 1: on 10 spheres of 15 mm the emu has the human's contact already; a stiffer one is put right.
    bench.run("set emu.osim stiffness=x3 -o stiff.osim").done();
    bench.run("transfer stiff.osim --from human.osim -o new.osim --report page.html").done();
    let whole = page(&bench, "page.html");
    snapshot("page_transfer", &whole.text);
    assert_eq!(whole.plots, 4);
    let now = "The contact is now as that of human.osim: without dimensions all numbers are equal.";
    assert!(whole.text.contains(now), "{}", whole.text);
    // x/R 0.3533 by (11) in the reference and after; a third of it to the power 2/3 before, 0.3533 / 3^(2/3) = 0.1698.
    assert!(whole.text.contains("0.3533") && whole.text.contains("0.1698"), "{}", whole.text);
    assert!(whole.text.contains("lie on each other where the contact without dimensions is the same"));
    // A preset has no figures of spheres, but a contact; and another rule gives another contact.
    bench.run("transfer stiff.osim --from falisse2022 -o b.osim --report preset.html").done();
    assert!(page(&bench, "preset.html").text.contains("The contact is now as that of falisse2022"));
    let call =
        "transfer stiff.osim --from falisse2022 --rule predsim --height-ratio 0.9 -o c.osim --report c.html";
    bench.run(call).done();
    assert!(
        page(&bench, "c.html").text.contains("The contact is now not that of falisse2022 in all numbers")
    );
}

#[test]
fn a_library_that_is_checked() {
    let bench = library();
    bench.run("check lib --report page.html").failed().wrote(&["page.html"]);
    let page = page(&bench, "page.html");
    snapshot("page_check_folder", &page.text);
    // A number that cannot be read is a finding; a model without contacts is skipped.
    assert_eq!(page.details, 3);
}

#[test]
fn every_verb_writes_a_sound_page() {
    let bench = library();
    bench.write("table.csv", "model,target_mass\nlib/a_human.osim,100\nlib/d_sunk_in.osim,50\n");
    let human = "lib/a_human.osim";
    for (call, status, details) in [
        (format!("{human} --target-mass 1190 -d out"), 0, 0),
        (format!("transfer {human} --from falisse2022 --spheres 4 -d out"), 0, 0),
        (format!("design {human} --indentation 0.1 -d out"), 0, 0),
        (format!("set {human} dissipation=x2 -d out"), 0, 0),
        (format!("inspect {human}"), 0, 0),
        (format!("check {human}"), 0, 0),
        (human.to_owned(), 0, 0),
        ("lib --target-mass 100 -d out".to_owned(), 1, 2),
        ("transfer lib --from falisse2022 --spheres 6 -d out".to_owned(), 1, 2),
        ("batch table.csv -d out".to_owned(), 0, 2),
        ("inspect lib".to_owned(), 0, 4),
        ("inspect nowhere.osim".to_owned(), 1, 0),
    ] {
        let force = if call.contains("-d out") || !call.starts_with("lib/") { " --force" } else { "" };
        let ran = bench.run(&format!("{call} --report page.html{force}"));
        assert_eq!(ran.status, Some(status), "{call}: {}", ran.err());
        let page = page(&bench, "page.html");
        assert_eq!(page.details, details, "{call}");
        assert!(page.text.contains(&format!("osim-contact-scale {call}")), "{call} is not told");
        std::fs::remove_file(bench.path("page.html")).unwrap();
    }
}

#[test]
fn what_became_of_each_model_is_told() {
    let bench = library();
    bench.run("lib --target-mass 100 -d out --report page.html").failed();
    let page = page(&bench, "page.html");
    let row = |name: &str| page.text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(row("lib/a_human.osim").contains("| written | 62 → 100 |"), "{}", row("lib/a_human.osim"));
    assert!(row("lib/b_comma.osim").contains("failed: "), "{}", row("lib/b_comma.osim"));
    assert!(row("lib/c_no_contacts.osim").contains("skipped"), "{}", row("lib/c_no_contacts.osim"));
}

#[test]
fn digests_are_those_of_the_files() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --report page.html").done();
    let page = page(&bench, "page.html");
    for file in ["human.osim", "human.scaled.osim"] {
        let digest: String =
            Sha256::digest(bench.read(file)).iter().map(|byte| format!("{byte:02x}")).collect();
        assert!(page.text.contains(&digest), "{file}");
    }
}

#[test]
fn every_file_of_a_standalone_set_has_its_digest() {
    let bench = Bench::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "body.osim"),
    ]);
    let sets = "forces.xml --geometry geometry.xml --model body.osim";
    bench.run(&format!("{sets} --target-mass 200 -d out --report page.html")).done();
    bench.run(&format!("inspect {sets} --report look.html")).done();
    let read = ["forces.xml", "geometry.xml", "body.osim"];
    for (name, files) in [
        ("page.html", &["forces.xml", "geometry.xml", "body.osim", "out/forces.xml", "out/geometry.xml"][..]),
        ("look.html", &read),
    ] {
        let page = page(&bench, name);
        for file in files {
            let digest: String =
                Sha256::digest(bench.read(file)).iter().map(|byte| format!("{byte:02x}")).collect();
            assert!(page.text.contains(&digest), "{name}: {file}");
        }
    }
}

#[test]
fn contacts_for_another_gravity_are_judged_under_it() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --target-gravity 1.62 --report page.html").done();
    let page = page(&bench, "page.html");
    // Scaling keeps x/R (Falisse 2022: 0.3533), whatever the weight.
    let row = page.text.lines().find(|line| line.contains("x/R at 1 BW, Hertz")).unwrap().to_owned();
    assert_eq!(row.matches("0.353").count(), 2, "{row}");
    assert!(page.text.contains("after, under 1190 kg at 1.62 m/s²"), "{}", page.text);
    assert!(page.text.contains("set it in OpenSim"), "{}", page.text);
    assert!(!page.text.contains("sunk-in"), "{}", page.text);
}

#[test]
fn rows_of_one_model_are_told_apart() {
    let bench = Bench::human();
    bench.write("t.csv", "model,target-mass,output\nhuman.osim,100,a.osim\nhuman.osim,200,b.osim\n");
    bench.run("batch t.csv --report page.html").done();
    let page = page(&bench, "page.html");
    for name in ["row 2: human.osim → a.osim", "row 3: human.osim → b.osim"] {
        assert!(page.text.contains(name), "{}", page.text);
    }
}

#[test]
fn a_failed_model_says_where_and_its_code_is_explained() {
    let bench = library();
    bench.run("lib --target-mass 100 -d out --report page.html").failed();
    let page = page(&bench, "page.html");
    let row = page.text.lines().find(|line| line.starts_with("lib/b_comma.osim")).unwrap().to_owned();
    assert!(row.contains("line ") && row.contains("| not-a-number"), "{row}");
    assert!(page.text.contains("write the number plainly") || page.text.contains("Write the number plainly"));
}

#[test]
fn what_is_said_of_failed_models_fits_the_verb() {
    let bench = Bench::with(&[HUMAN]);
    bench.write("broken.osim", "<OpenSimDocument>");
    let says = |words: &str, what: &str| {
        bench.run(&format!("{words} human.osim broken.osim --report page.html --force")).failed();
        let text = page(&bench, "page.html").text;
        assert!(text.contains("Failed models") && text.contains(what), "{words}: {text}");
    };
    says("rescale --target-mass 100 -d out", "Nothing was written for these models.");
    says("check", "These models could not be read or checked.");
}

#[test]
fn a_run_that_goes_on_shows_what_was_done_before() {
    let bench = library();
    let call = "lib --target-mass 100 -d out --summary done.csv --report page.html";
    bench.run(call).failed();
    let before = page(&bench, "page.html");
    bench.run(&format!("{call} --resume")).failed();
    let after = page(&bench, "page.html");
    assert_eq!(after.details, before.details);
    let row = after.text.lines().find(|line| line.starts_with("lib/a_human.osim")).unwrap().to_owned();
    assert!(row.contains("| written † | 62 → 100 |"), "{row}");
    // A page is replaced without --force only if it is one, and only by a run that goes on.
    bench.write("mine.html", "mine");
    bench.run("lib --target-mass 100 -d out --summary done.csv --resume --report mine.html").usage();
    bench.run("lib --target-mass 100 -d new --summary new.csv --resume --report page.html").usage();
    assert_eq!(bench.text("mine.html"), "mine");
}

#[test]
fn models_changed_themselves_by_an_earlier_run_are_rows() {
    let bench = Bench::with(&[(HUMAN.0, "lib/a.osim"), (HUMAN.0, "lib/b.osim")]);
    let call = "lib --target-mass 100 --in-place --summary done.csv --report page.html";
    bench.run(call).done();
    bench.run(&format!("{call} --resume")).done();
    let page = page(&bench, "page.html");
    assert_eq!(page.details, 0);
    assert!(page.text.contains("lib/a.osim | written † | 62 → 100 | 72 |"), "{}", page.text);
}

#[test]
fn the_same_call_gives_the_same_page() {
    let bench = library();
    let call = "lib --target-mass 100 -d out --jobs 4 --force --report page.html";
    bench.run(call).failed();
    let first = bench.read("page.html");
    bench.run(call).failed();
    assert_eq!(bench.read("page.html"), first);
}

#[test]
fn a_dry_run_shows_what_would_be() {
    let bench = Bench::human();
    bench.run("human.osim --target-mass 1190 --dry-run --report page.html").done().wrote(&["page.html"]);
    let page = page(&bench, "page.html");
    assert!(
        page.text.contains("dry run: nothing written") && page.text.contains("×2.6774318"),
        "{}",
        page.text
    );
}

#[test]
fn a_page_that_is_there_stays_unless_forced() {
    let bench = Bench::human();
    bench.write("page.html", "mine");
    for call in ["human.osim --target-mass 1190", "inspect human.osim", "check human.osim", "human.osim"] {
        let ran = bench.run(&format!("{call} --report page.html")).usage().wrote(&[]);
        assert!(ran.err().contains("--force"), "{}", ran.err());
    }
    bench.run("inspect human.osim --report page.html --force").done().wrote(&["page.html"]);
}

#[test]
fn nothing_but_a_page_is_written_over() {
    let bench = Bench::human();
    let ran = bench.run("check human.osim --report page.txt").usage().wrote(&[]);
    assert!(ran.err().contains("such as report.html"), "{}", ran.err());
    bench.run("human.osim --target-mass 90 --force --report human.osim").usage().wrote(&[]);
    bench.write("model.html", bench.read("human.osim"));
    for call in [
        "inspect model.html --force --report model.html",
        "model.html --target-mass 90 --force --report model.html",
        "human.osim --target-mass 90 -o out.html --report out.html",
        "inspect human.osim --from model.html --force --report model.html",
        "inspect human.osim --geometry model.html --force --report model.html",
        "check human.osim --model model.html --force --report model.html",
    ] {
        bench.run(call).usage().wrote(&[]);
    }
}

#[test]
fn names_are_text_whatever_they_hold() {
    let bench = Bench::human();
    let text = bench.text("human.osim").replacen(
        "<Model name=\"",
        "<Model name=\"&lt;script&gt;alert(1)&lt;/script&gt;",
        1,
    );
    bench.write("a&b.osim", text);
    bench.run("inspect a&b.osim --report page.html").done();
    let page = page(&bench, "page.html");
    assert!(
        page.text.contains("<script>alert(1)</script>") && page.text.contains("a&b.osim"),
        "{}",
        page.text
    );
}

#[test]
fn a_large_library_says_what_its_page_leaves_out() {
    let bench = Bench::new();
    let human = crate::support::fixture(HUMAN.0);
    for number in 0..12 {
        bench.write(&format!("lib/{number:02}.osim"), &human);
    }
    bench.run("check lib --report page.html").done();
    let page = page(&bench, "page.html");
    // All are the same model, so one is drawn for all: its feet and three plots; and the chart of all.
    assert_eq!((page.details, page.plots), (12, 5));
    assert!(page.text.contains("At most 10 models have plots"), "{}", page.text);
}

#[test]
fn a_design_for_another_gravity_is_judged_under_it_before_and_after() {
    let bench = Bench::human();
    bench.run("design human.osim --indentation 0.16 --constant-indentation 0.05 --gravity 1.62 --report page.html -o new.osim").done();
    // Under the model's own 9.81 m/s2 the design would sink in by more than three times as much, and a further one be proposed.
    let page = bench.text("page.html");
    assert!(!page.contains("new.osim --indentation 0.16 --"), "{page}");
    let check = bench.run("check new.osim --gravity 1.62").out();
    assert!(!check.contains("warning beyond-hertz\n"), "{check}");
}
