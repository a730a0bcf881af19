//! Options in messages belong to the verb that printed the message, or to the verb that it names.

use std::collections::{BTreeMap, BTreeSet};

use crate::support::{TestDir, root};

const FOLDERS_OF_FIXTURES: [&str; 6] = ["bad", "check", "drawn_feet", "follows_size", "format", "scale_tool"];
const GENERIC: &str = "scale_tool/generic_smooth.osim";

/// Verbs that take many models, each with the options that it needs.
const CHANGING_VERBS_WITH_OPTIONS: [(&str, &str); 13] = [
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
const VERBS_WITHOUT_CHANGES: [&str; 8] =
    ["check", "inspect", "sweep", "batch", "drop-test", "motion", "fit", "explain"];

/// The options of each verb, read from the help of the verb.
fn options_by_verb(dir: &TestDir) -> BTreeMap<String, BTreeSet<String>> {
    let verbs: BTreeSet<&str> =
        CHANGING_VERBS_WITH_OPTIONS.iter().map(|(verb, _)| *verb).chain(VERBS_WITHOUT_CHANGES).collect();
    let words = |help: String| {
        help.split(|c: char| c != '-' && !c.is_ascii_lowercase()).map(str::to_owned).collect::<Vec<_>>()
    };
    let own_options = |verb: &str| {
        let help = dir.run(&format!("{verb} --help")).succeeded().out();
        words(help).into_iter().filter(|word| word.starts_with("--")).collect::<BTreeSet<String>>()
    };
    verbs.into_iter().map(|verb| (verb.to_owned(), own_options(verb))).collect()
}

/// Options in `text` that belong neither to `verb` nor to the verb that the sentence names, each with its line.
fn foreign_options(
    text: &str,
    verb: &str,
    options: &BTreeMap<String, BTreeSet<String>>,
) -> Vec<(String, String)> {
    let mut foreign = Vec::new();
    let has_option =
        |verb: &str, option: &str| options.get(verb).is_some_and(|own_options| own_options.contains(option));
    let mut named_verb = "";
    for line in text.lines() {
        // Excerpts of files have what is in the files.
        if line.trim_start().trim_start_matches(|c: char| c.is_ascii_digit()).trim_start().starts_with('|') {
            continue;
        }
        for word in line.split_whitespace() {
            let bare = word.trim_matches(|c: char| !c.is_ascii_alphanumeric() && c != '-');
            if options.contains_key(bare) {
                named_verb = bare;
            }
            if bare.starts_with("--")
                && bare.len() > 2
                && !has_option(verb, bare)
                && !has_option(named_verb, bare)
            {
                foreign.push((bare.to_owned(), line.trim().to_owned()));
            }
            if word.ends_with([',', ';', '.', ':', ')']) {
                named_verb = "";
            }
        }
    }
    foreign
}

#[test]
fn no_change_advises_an_option_that_its_verb_lacks() {
    let dir = TestDir::new();
    let options = options_by_verb(&dir);
    let fixtures = root().join("fixtures");
    let folders: Vec<String> =
        FOLDERS_OF_FIXTURES.iter().map(|name| fixtures.join(name).display().to_string()).collect();
    let sets = fixtures.join("format/standalone_ContactGeometrySet.xml").display().to_string();
    let forces = fixtures.join("format/standalone_ForceSet.xml").display().to_string();
    let generic = fixtures.join(GENERIC).display().to_string();
    for (verb, options_given) in CHANGING_VERBS_WITH_OPTIONS {
        let options_given = options_given.replace("GENERIC", &generic);
        let mut words = vec![verb];
        words.extend(folders.iter().map(String::as_str).chain([sets.as_str(), forces.as_str()]));
        words.extend(options_given.split_whitespace());
        words.extend(["--dry-run", "--format", "table"]);
        let output = dir.run_words(&words);
        let text = [output.stderr, output.stdout].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
        assert!(text.len() > 10_000, "{verb}: {text}");
        assert_eq!(foreign_options(&text, verb, &options), [], "{verb} {options_given}");
    }
    for set in [&sets, &forces] {
        let run = dir.run(&format!("sweep {set} --indentation 0.1,0.2 -d out --dry-run"));
        assert_eq!(foreign_options(&run.err(), "sweep", &options), []);
    }
}

#[test]
fn check_advises_no_option_that_it_lacks() {
    let dir = TestDir::new();
    let options = options_by_verb(&dir);
    let fixtures = root().join("fixtures");
    let generic = fixtures.join(GENERIC).display().to_string();
    for folder in ["check", "scale_tool", "follows_size", "feet"] {
        for entry in std::fs::read_dir(fixtures.join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_none_or(|ending| ending != "osim") {
                continue;
            }
            let path = path.display().to_string();
            for options_given in [vec![], vec!["--from", &generic]] {
                let words: Vec<&str> = ["check", &path].into_iter().chain(options_given).collect();
                let output = dir.run_words(&words);
                let text = String::from_utf8(output.stdout).unwrap();
                assert_eq!(foreign_options(&text, "check", &options), [], "{words:?}");
            }
        }
    }
}

/// Advice to change the model in place would not help here: the report needs another name.
#[test]
fn a_report_named_like_a_model_is_not_advised_to_change_in_place() {
    let dir = TestDir::with_human();
    dir.write("page.html", dir.read("human.osim"));
    let run = dir.run("check page.html --report page.html --force");
    assert!(!run.err().contains("--in-place") && run.err().contains("choose another name"), "{}", run.err());
    let run = dir.run("human.osim --target-mass 80 -o human.osim --force");
    assert!(run.err().contains("--in-place"), "{}", run.err());
}
