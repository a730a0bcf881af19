//! `--report`: the page is complete, loads no other files, and shows the results of the run.

use sha2::{Digest, Sha256};

use crate::html::Html;
use crate::support::{HUMAN, TestDir, assert_snapshot};

/// A folder with a model that fails, a model without contacts, and models that can be changed.
fn folder_of_models() -> TestDir {
    TestDir::with(&[
        (HUMAN.0, "lib/a_human.osim"),
        ("bad/number_decimal_comma.osim", "lib/b_comma.osim"),
        ("bad/no_contacts.osim", "lib/c_no_contacts.osim"),
        ("check/sunk_in.osim", "lib/d_sunk_in.osim"),
    ])
}

#[track_caller]
fn read_page(dir: &TestDir, name: &str) -> Html {
    Html::parse_and_check(&dir.text(name))
}

/// Compares a page with `tests/snapshots/NAME.snap`, but for digests, which change with the version in the note.
#[track_caller]
fn assert_page_snapshot(name: &str, text: &str) {
    let is_digest = |word: &str| word.len() == 64 && word.chars().all(|c| c.is_ascii_hexdigit());
    let digests: Vec<&str> = text.split_whitespace().filter(|word| is_digest(word)).collect();
    let text = digests.iter().fold(text.to_owned(), |text, digest| text.replace(digest, "[SHA-256]"));
    assert_snapshot(name, &text.replace(env!("CARGO_PKG_VERSION"), "[VERSION]"));
}

#[test]
fn the_page_of_a_rescaled_model_matches_its_snapshot() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --report page.html")
        .succeeded()
        .wrote(&["human.scaled.osim", "page.html"]);
    let page = read_page(&dir, "page.html");
    assert_page_snapshot("page_rescale", &page.text);
    assert_eq!(page.plots, 4);
    // The paper's Table 1: R and E1* of the giraffe-heavy human follow M^(1/3), 19.19^(1/3) = 2.677; and Falisse (2022):
    // x/R 0.353 by Hertz, 0.3396 by the file's law, k R n/F 4.246, 7.5 N just touching.
    for number in ["0.3533", "0.3396", "4.246", "7.498", "2.6774318"] {
        assert!(page.text.contains(number), "{number} is missing");
    }
}

/// The page shows the reference beside the model before and after: x/R changes from 0.17 to 0.35, the value of the reference.
#[test]
fn the_page_of_a_transfer_shows_the_reference() {
    let dir =
        TestDir::with(&[("table1/emu_10_spheres_smooth_sphere.osim", "emu.osim"), (HUMAN.0, "human.osim")]);
    // The paper's Table 1: on 10 spheres of 15 mm the emu has the human's contact; the transfer corrects a stiffer one.
    dir.run("set emu.osim stiffness=x3 -o stiff.osim").succeeded();
    dir.run("transfer stiff.osim --from human.osim -o new.osim --report page.html").succeeded();
    let page_of_transfer = read_page(&dir, "page.html");
    assert_page_snapshot("page_transfer", &page_of_transfer.text);
    assert_eq!(page_of_transfer.plots, 4);
    let verdict = "The contact is now as that of human.osim: all dimensionless numbers are equal.";
    assert!(page_of_transfer.text.contains(verdict), "{}", page_of_transfer.text);
    // x/R 0.3533 by (11) in the reference and after; a third of it to the power 2/3 before, 0.3533 / 3^(2/3) = 0.1698.
    assert!(
        page_of_transfer.text.contains("0.3533") && page_of_transfer.text.contains("0.1698"),
        "{}",
        page_of_transfer.text
    );
    assert!(page_of_transfer.text.contains("lie on each other where the dimensionless contact is the same"));
    // A preset has no figures of spheres, but a contact; and another rule gives another contact.
    dir.run("transfer stiff.osim --from falisse2022 -o b.osim --report preset.html").succeeded();
    assert!(read_page(&dir, "preset.html").text.contains("The contact is now as that of falisse2022"));
    let call =
        "transfer stiff.osim --from falisse2022 --rule predsim --height-ratio 0.9 -o c.osim --report c.html";
    dir.run(call).succeeded();
    assert!(
        read_page(&dir, "c.html").text.contains("The contact is now not that of falisse2022 in all numbers")
    );
}

#[test]
fn the_page_of_a_checked_folder_matches_its_snapshot() {
    let dir = folder_of_models();
    dir.run("check lib --report page.html").failed().wrote(&["page.html"]);
    let page = read_page(&dir, "page.html");
    assert_page_snapshot("page_check_folder", &page.text);
    // A number that cannot be read is a finding; a model without contacts is skipped.
    assert_eq!(page.details, 3);
}

#[test]
fn every_verb_writes_a_valid_page() {
    let dir = folder_of_models();
    dir.write("table.csv", "model,target_mass\nlib/a_human.osim,100\nlib/d_sunk_in.osim,50\n");
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
        let run = dir.run(&format!("{call} --report page.html{force}"));
        assert_eq!(run.status, Some(status), "{call}: {}", run.err());
        let page = read_page(&dir, "page.html");
        assert_eq!(page.details, details, "{call}");
        assert!(page.text.contains(&format!("osim-contact-scale {call}")), "{call} is not told");
        std::fs::remove_file(dir.path("page.html")).unwrap();
    }
}

#[test]
fn the_page_shows_the_result_of_each_model() {
    let dir = folder_of_models();
    dir.run("lib --target-mass 100 -d out --report page.html").failed();
    let page = read_page(&dir, "page.html");
    let row = |name: &str| page.text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(row("lib/a_human.osim").contains("| written | 62 → 100 |"), "{}", row("lib/a_human.osim"));
    assert!(row("lib/b_comma.osim").contains("failed: "), "{}", row("lib/b_comma.osim"));
    assert!(row("lib/c_no_contacts.osim").contains("skipped"), "{}", row("lib/c_no_contacts.osim"));
}

#[test]
fn the_page_shows_digests_of_the_files() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --report page.html").succeeded();
    let page = read_page(&dir, "page.html");
    for file in ["human.osim", "human.scaled.osim"] {
        let digest: String =
            Sha256::digest(dir.read(file)).iter().map(|byte| format!("{byte:02x}")).collect();
        assert!(page.text.contains(&digest), "{file}");
    }
}

#[test]
fn every_file_of_a_standalone_set_has_its_digest() {
    let dir = TestDir::with(&[
        ("format/standalone_ForceSet.xml", "forces.xml"),
        ("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
        ("format/standalone_model_without_contacts.osim", "body.osim"),
    ]);
    let sets = "forces.xml --geometry geometry.xml --model body.osim";
    dir.run(&format!("{sets} --target-mass 200 -d out --report page.html")).succeeded();
    dir.run(&format!("inspect {sets} --report look.html")).succeeded();
    let sources = ["forces.xml", "geometry.xml", "body.osim"];
    for (name, files) in [
        ("page.html", &["forces.xml", "geometry.xml", "body.osim", "out/forces.xml", "out/geometry.xml"][..]),
        ("look.html", &sources),
    ] {
        let page = read_page(&dir, name);
        for file in files {
            let digest: String =
                Sha256::digest(dir.read(file)).iter().map(|byte| format!("{byte:02x}")).collect();
            assert!(page.text.contains(&digest), "{name}: {file}");
        }
    }
}

#[test]
fn contacts_for_another_gravity_are_judged_at_that_gravity() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --target-gravity 1.62 --report page.html").succeeded();
    let page = read_page(&dir, "page.html");
    // Scaling keeps x/R (Falisse 2022: 0.3533), whatever the weight.
    let row = page.text.lines().find(|line| line.contains("x/R at 1 BW, Hertz")).unwrap().to_owned();
    assert_eq!(row.matches("0.353").count(), 2, "{row}");
    assert!(page.text.contains("after, under 1190 kg at 1.62 m/s²"), "{}", page.text);
    assert!(page.text.contains("set it in OpenSim"), "{}", page.text);
    assert!(!page.text.contains("sunk-in"), "{}", page.text);
}

#[test]
fn several_rows_for_one_model_have_different_headings() {
    let dir = TestDir::with_human();
    dir.write("t.csv", "model,target-mass,output\nhuman.osim,100,a.osim\nhuman.osim,200,b.osim\n");
    dir.run("batch t.csv --report page.html").succeeded();
    let page = read_page(&dir, "page.html");
    for name in ["row 2: human.osim → a.osim", "row 3: human.osim → b.osim"] {
        assert!(page.text.contains(name), "{}", page.text);
    }
}

#[test]
fn a_failed_model_has_its_line_and_an_explained_code() {
    let dir = folder_of_models();
    dir.run("lib --target-mass 100 -d out --report page.html").failed();
    let page = read_page(&dir, "page.html");
    let row = page.text.lines().find(|line| line.starts_with("lib/b_comma.osim")).unwrap().to_owned();
    assert!(row.contains("line ") && row.contains("| not-a-number"), "{row}");
    assert!(page.text.contains("write the number plainly") || page.text.contains("Write the number plainly"));
}

#[test]
fn the_text_about_failed_models_fits_the_verb() {
    let dir = TestDir::with(&[HUMAN]);
    dir.write("broken.osim", "<OpenSimDocument>");
    let assert_page_has = |words: &str, what: &str| {
        dir.run(&format!("{words} human.osim broken.osim --report page.html --force")).failed();
        let text = read_page(&dir, "page.html").text;
        assert!(text.contains("Failed models") && text.contains(what), "{words}: {text}");
    };
    assert_page_has("rescale --target-mass 100 -d out", "Nothing was written for these models.");
    assert_page_has("check", "These models could not be read or checked.");
}

#[test]
fn a_resumed_run_shows_results_of_earlier_runs() {
    let dir = folder_of_models();
    let call = "lib --target-mass 100 -d out --summary done.csv --report page.html";
    dir.run(call).failed();
    let before = read_page(&dir, "page.html");
    dir.run(&format!("{call} --resume")).failed();
    let after = read_page(&dir, "page.html");
    assert_eq!(after.details, before.details);
    let row = after.text.lines().find(|line| line.starts_with("lib/a_human.osim")).unwrap().to_owned();
    assert!(row.contains("| written † | 62 → 100 |"), "{row}");
    // Without --force only a resumed run replaces a file, and only if that is a page.
    dir.write("mine.html", "mine");
    dir.run("lib --target-mass 100 -d out --summary done.csv --resume --report mine.html").usage_error();
    dir.run("lib --target-mass 100 -d new --summary new.csv --resume --report page.html").usage_error();
    assert_eq!(dir.text("mine.html"), "mine");
}

#[test]
fn models_changed_in_place_by_an_earlier_run_are_rows() {
    let dir = TestDir::with(&[(HUMAN.0, "lib/a.osim"), (HUMAN.0, "lib/b.osim")]);
    let call = "lib --target-mass 100 --in-place --summary done.csv --report page.html";
    dir.run(call).succeeded();
    dir.run(&format!("{call} --resume")).succeeded();
    let page = read_page(&dir, "page.html");
    assert_eq!(page.details, 0);
    assert!(page.text.contains("lib/a.osim | written † | 62 → 100 | 72 |"), "{}", page.text);
}

#[test]
fn the_same_call_gives_the_same_page() {
    let dir = folder_of_models();
    let call = "lib --target-mass 100 -d out --jobs 4 --force --report page.html";
    dir.run(call).failed();
    let first = dir.read("page.html");
    dir.run(call).failed();
    assert_eq!(dir.read("page.html"), first);
}

#[test]
fn a_dry_run_shows_the_planned_changes() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 --dry-run --report page.html").succeeded().wrote(&["page.html"]);
    let page = read_page(&dir, "page.html");
    assert!(
        page.text.contains("dry run: nothing written") && page.text.contains("×2.6774318"),
        "{}",
        page.text
    );
}

#[test]
fn an_existing_page_is_replaced_only_with_force() {
    let dir = TestDir::with_human();
    dir.write("page.html", "mine");
    for call in ["human.osim --target-mass 1190", "inspect human.osim", "check human.osim", "human.osim"] {
        let run = dir.run(&format!("{call} --report page.html")).usage_error().wrote(&[]);
        assert!(run.err().contains("--force"), "{}", run.err());
    }
    dir.run("inspect human.osim --report page.html --force").succeeded().wrote(&["page.html"]);
}

#[test]
fn a_report_never_replaces_a_model() {
    let dir = TestDir::with_human();
    let run = dir.run("check human.osim --report page.txt").usage_error().wrote(&[]);
    assert!(run.err().contains("such as report.html"), "{}", run.err());
    dir.run("human.osim --target-mass 90 --force --report human.osim").usage_error().wrote(&[]);
    dir.write("model.html", dir.read("human.osim"));
    for call in [
        "inspect model.html --force --report model.html",
        "model.html --target-mass 90 --force --report model.html",
        "human.osim --target-mass 90 -o out.html --report out.html",
        "inspect human.osim --from model.html --force --report model.html",
        "inspect human.osim --geometry model.html --force --report model.html",
        "check human.osim --model model.html --force --report model.html",
    ] {
        dir.run(call).usage_error().wrote(&[]);
    }
}

#[test]
fn names_with_markup_are_shown_as_text() {
    let dir = TestDir::with_human();
    let text = dir.text("human.osim").replacen(
        "<Model name=\"",
        "<Model name=\"&lt;script&gt;alert(1)&lt;/script&gt;",
        1,
    );
    dir.write("a&b.osim", text);
    dir.run("inspect a&b.osim --report page.html").succeeded();
    let page = read_page(&dir, "page.html");
    assert!(
        page.text.contains("<script>alert(1)</script>") && page.text.contains("a&b.osim"),
        "{}",
        page.text
    );
}

#[test]
fn the_page_of_many_models_names_what_it_leaves_out() {
    let dir = TestDir::new();
    let human = crate::support::fixture(HUMAN.0);
    for number in 0..12 {
        dir.write(&format!("lib/{number:02}.osim"), &human);
    }
    dir.run("check lib --report page.html").succeeded();
    let page = read_page(&dir, "page.html");
    // All models are equal, so the page draws one of them (its feet and three plots), and the chart of all.
    assert_eq!((page.details, page.plots), (12, 5));
    assert!(page.text.contains("At most 10 models have plots"), "{}", page.text);
}

#[test]
fn a_design_for_another_gravity_is_judged_at_that_gravity() {
    let dir = TestDir::with_human();
    dir.run("design human.osim --indentation 0.16 --constant-indentation 0.05 --gravity 1.62 --report page.html -o new.osim").succeeded();
    // Under the model's own 9.81 m/s2 the design would sink in by more than three times as much, and a further one be proposed.
    let page = dir.text("page.html");
    assert!(!page.contains("new.osim --indentation 0.16 --"), "{page}");
    let check = dir.run("check new.osim --gravity 1.62").out();
    assert!(!check.contains("warning beyond-hertz\n"), "{check}");
}
