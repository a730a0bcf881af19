//! What messages advise can be said to the verb that gave them, or to the verb that they name.

use std::collections::{BTreeMap, BTreeSet};

use crate::support::{Bench, root};

const FOLDERS: [&str; 6] = ["bad", "check", "drawn_feet", "follows_size", "format", "scale_tool"];
const GENERIC: &str = "scale_tool/generic_smooth.osim";

/// Verbs that take many models, each with what it cannot do without.
const CHANGING: [(&str, &str); 13] = [
    ("rescale", "--target-mass 80"),
    ("rescale", "--target-mass 80 --follow-bodies"),
    ("transfer", "--from falisse2022"),
    ("transfer", "--from GENERIC --follow-bodies"),
    ("add", "--from falisse2022"),
    ("add", "--from GENERIC --replace"),
    ("add", "--from GENERIC --replace --radius follow"),
    ("remove", ""),
    ("convert", "--to smooth"),
    ("design", "--indentation 0.1"),
    ("set", "stiffness=x2"),
    ("note", "--contacts-mass 62"),
    ("note", "--stance-limbs 2"),
];
const OTHERS: [&str; 8] = ["check", "inspect", "sweep", "batch", "drop-test", "motion", "fit", "explain"];

/// The options of each verb, by its help.
fn options(bench: &Bench) -> BTreeMap<String, BTreeSet<String>> {
    let verbs: BTreeSet<&str> = CHANGING.iter().map(|(verb, _)| *verb).chain(OTHERS).collect();
    let words = |help: String| {
        help.split(|c: char| c != '-' && !c.is_ascii_lowercase()).map(str::to_owned).collect::<Vec<_>>()
    };
    let own = |verb: &str| {
        let help = bench.run(&format!("{verb} --help")).done().out();
        words(help).into_iter().filter(|word| word.starts_with("--")).collect::<BTreeSet<String>>()
    };
    verbs.into_iter().map(|verb| (verb.to_owned(), own(verb))).collect()
}

/// Options in `text` that neither `verb` has nor the verb that the sentence names, each with its line.
fn foreign(text: &str, verb: &str, options: &BTreeMap<String, BTreeSet<String>>) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let takes = |verb: &str, option: &str| options.get(verb).is_some_and(|own| own.contains(option));
    let mut named = "";
    for line in text.lines() {
        // Excerpts of files have what is in the files.
        if line.trim_start().trim_start_matches(|c: char| c.is_ascii_digit()).trim_start().starts_with('|') {
            continue;
        }
        for word in line.split_whitespace() {
            let bare = word.trim_matches(|c: char| !c.is_ascii_alphanumeric() && c != '-');
            if options.contains_key(bare) {
                named = bare;
            }
            if bare.starts_with("--") && bare.len() > 2 && !takes(verb, bare) && !takes(named, bare) {
                found.push((bare.to_owned(), line.trim().to_owned()));
            }
            if word.ends_with([',', ';', '.', ':', ')']) {
                named = "";
            }
        }
    }
    found
}

#[test]
fn no_change_advises_what_its_verb_does_not_take() {
    let bench = Bench::new();
    let options = options(&bench);
    let fixtures = root().join("fixtures");
    let folders: Vec<String> = FOLDERS.iter().map(|name| fixtures.join(name).display().to_string()).collect();
    let sets = fixtures.join("format/standalone_ContactGeometrySet.xml").display().to_string();
    let forces = fixtures.join("format/standalone_ForceSet.xml").display().to_string();
    let generic = fixtures.join(GENERIC).display().to_string();
    for (verb, with) in CHANGING {
        let with = with.replace("GENERIC", &generic);
        let mut words = vec![verb];
        words.extend(folders.iter().map(String::as_str).chain([sets.as_str(), forces.as_str()]));
        words.extend(with.split_whitespace());
        words.extend(["--dry-run", "--format", "table"]);
        let output = bench.run_words(&words);
        let text = [output.stderr, output.stdout].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
        assert!(text.len() > 10_000, "{verb}: {text}");
        assert_eq!(foreign(&text, verb, &options), [], "{verb} {with}");
    }
    for set in [&sets, &forces] {
        let ran = bench.run(&format!("sweep {set} --indentation 0.1,0.2 -d out --dry-run"));
        assert_eq!(foreign(&ran.err(), "sweep", &options), []);
    }
}

#[test]
fn no_check_advises_what_it_does_not_take() {
    let bench = Bench::new();
    let options = options(&bench);
    let fixtures = root().join("fixtures");
    let generic = fixtures.join(GENERIC).display().to_string();
    for folder in ["check", "scale_tool", "follows_size", "feet"] {
        for entry in std::fs::read_dir(fixtures.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|ending| ending != "osim") {
                continue;
            }
            let path = path.display().to_string();
            for with in [vec![], vec!["--from", &generic]] {
                let words: Vec<&str> = ["check", &path].into_iter().chain(with).collect();
                let output = bench.run_words(&words);
                let text = String::from_utf8(output.stdout).unwrap();
                assert_eq!(foreign(&text, "check", &options), [], "{words:?}");
            }
        }
    }
}

/// Only a model can be changed itself: a report needs a name of its own.
#[test]
fn a_report_over_a_model_is_not_advised_to_change_it() {
    let bench = Bench::human();
    bench.write("page.html", bench.read("human.osim"));
    let ran = bench.run("check page.html --report page.html --force");
    assert!(!ran.err().contains("--in-place") && ran.err().contains("choose another name"), "{}", ran.err());
    let ran = bench.run("human.osim --target-mass 80 -o human.osim --force");
    assert!(ran.err().contains("--in-place"), "{}", ran.err());
}
