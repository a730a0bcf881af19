//! Text from outside (names in a model, file names, cells, options) is printed in a harmless form.

use osim_model::messages::is_visible;

use crate::support::{CommandRun, HUMAN, TestDir, fixture};

/// A name that clears the screen, changes its colour and the direction of writing, and begins as a formula.
const NASTY_NAME: &str = "=1+1\u{1b}[2J\u{9b}31m\u{202e}";
/// A model's name that also begins a new line, and may contain blanks.
const NASTY_LINE: &str = "=1+1\u{1b}[2J\u{9b}31m\u{202e}&#10;error: fake ";
/// Beginnings of lines in [`NASTY_LINE`] that no output may contain.
const FAKE_LINES: [&str; 2] = ["\nerror: fake", "\nwarning: fake"];

/// The human with `name` put before the names of its spheres, forces and feet, and `line` put before the model's name.
fn human_with_names(name: &str, line: &str) -> String {
    let mut text = String::from_utf8(fixture(HUMAN.0)).unwrap();
    text = text.replace("human_62kg", &format!("{line}human"));
    let spheres = (1..=6).flat_map(|n| ["r", "l"].map(|side| format!("s{n}_{side}")));
    let old_names: Vec<String> = spheres.flat_map(|sphere| [format!("contact_{sphere}"), sphere]).collect();
    for old in old_names.iter().map(String::as_str).chain(["calcn_r", "calcn_l", "toes_r", "toes_l"]) {
        let mut pieces = text.split(old);
        let mut out = pieces.next().unwrap().to_owned();
        for piece in pieces {
            let part_of_a_word = |c: char| c == '_' || c.is_alphanumeric();
            let whole = !out.ends_with(part_of_a_word) && !piece.starts_with(part_of_a_word);
            out.extend([if whole { name } else { "" }, old, piece]);
        }
        text = out;
    }
    text
}

/// Asserts that all printed characters are visible, and that no name begins a new line.
#[track_caller]
fn assert_terminal_safe(run: &CommandRun, call: &str) {
    for (stream, text) in [("output", run.out()), ("error", run.err())] {
        let control_characters: Vec<char> =
            text.chars().filter(|&letter| !matches!(letter, '\n' | '\t') && !is_visible(letter)).collect();
        assert!(
            control_characters.is_empty(),
            "{call}: standard {stream} has {control_characters:?}:\n{text}"
        );
        assert!(FAKE_LINES.iter().all(|fake| !text.contains(fake)), "{call}: standard {stream}:\n{text}");
    }
}

/// Asserts that no cell of a CSV table begins like a formula, except numbers.
#[track_caller]
fn assert_no_formula(table: &[u8], call: &str) {
    for record in csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(table).records() {
        for cell in &record.unwrap() {
            let formula = cell.starts_with(['=', '+', '-', '@', '\t', '\r']) && cell.parse::<f64>().is_err();
            assert!(!formula, "{call}: the cell {cell:?}");
        }
    }
}

/// Calls of every verb that reads a model, in every form.
const CALLS_THAT_PRINT_NAMES: [&str; 27] = [
    "inspect MODEL",
    "inspect MODEL --format json",
    "inspect MODEL --format csv",
    "inspect MODEL --from human.osim",
    "check MODEL",
    "check MODEL --format json",
    "check MODEL --format csv",
    "check MODEL human.osim",
    "check MODEL --from human.osim",
    "MODEL --target-mass 100 -o a.osim",
    "MODEL --target-mass 100 -o b.osim --format json",
    "MODEL --target-mass 100 --dry-run --diff --format json",
    "MODEL human.osim --target-mass 100 -d many --summary many.csv --report many.html",
    "transfer MODEL --from human.osim --dry-run",
    "transfer human.osim --from MODEL --dry-run",
    "transfer human.osim --from MODEL --reference-sphere nobody --dry-run",
    "set MODEL stiffness=1e6 --dry-run",
    "set MODEL stiffness=1e6 --select none* --dry-run",
    "note MODEL --contacts-mass 62 --dry-run",
    "sweep MODEL --grid stiffness=x1,x2 -d swept",
    "drop-test MODEL",
    "drop-test MODEL --format json",
    "plot force MODEL -o -",
    "plot state MODEL -o f.svg",
    "design MODEL --indentation 0.1",
    "transfer MODEL --from human.osim --follow-bodies --body-scale nobody=1,1,1 --dry-run",
    "explain MODEL",
];

#[test]
fn names_in_a_model_cannot_control_a_terminal_or_spreadsheet() {
    let dir = TestDir::with_human();
    dir.write("nasty.osim", human_with_names(NASTY_NAME, NASTY_LINE));
    for call in CALLS_THAT_PRINT_NAMES {
        let call = call.replace("MODEL", "nasty.osim");
        let run = dir.run(&call);
        // A check says that OpenSim refuses such names.
        let fails = ["explain", "nobody", "none*", "check"].iter().any(|word| call.contains(word));
        assert_eq!(run.status != Some(0), fails, "{call}: {}", run.err());
        assert_terminal_safe(&run, &call);
        if call.contains("csv") {
            assert_no_formula(&run.stdout, &call);
        }
        // Without a written file, the loop below would test nothing.
        let writes = [" -o ", " -d "].iter().any(|option| call.contains(option)) && !call.ends_with(" -o -");
        assert!(!writes || !run.changed.is_empty(), "{call}: {}", run.err());
        for file in &run.changed {
            if file.ends_with(".csv") {
                assert_no_formula(&dir.read(file), file);
            } else if !file.ends_with(".osim") && !file.ends_with(".png") {
                let text = dir.text(file);
                assert!(!text.contains(['\u{1b}', '\u{9b}', '\u{202e}']), "{call}: {file}");
            }
        }
    }
}

/// Programs that read a diff need unchanged line ends, umlauts and blanks. No character of a diff may move the cursor of a terminal.
#[test]
fn a_diff_in_a_pipe_cannot_control_a_terminal() {
    let dir = TestDir::with_human();
    dir.write("nasty.osim", human_with_names("F\u{fc}\u{df}e\u{a0}\u{1b}[2J\u{9b}31m\u{7f}", ""));
    let run = dir.run("remove nasty.osim --dry-run --diff").succeeded();
    let text = run.out();
    assert!(text.lines().any(|line| line.starts_with("-\t")), "{text}");
    assert!(!text.contains(|letter: char| letter.is_control() && !"\t\r\n".contains(letter)), "{text}");
    assert!(text.contains("F\u{fc}\u{df}e\u{a0}\\u{1b}[2J\\u{9b}31m\\u{7f}"), "{text}");
    // Carriage returns stay, so that it can be applied.
    dir.write("crlf.osim", dir.text("human.osim").replace('\n', "\r\n"));
    let out = dir.run("crlf.osim --target-mass 100 --dry-run --diff").succeeded().out();
    assert!(out.contains("</radius>\r\n") && !out.contains("\\u{d}"), "{out}");
}

#[test]
fn a_very_long_name_is_shortened() {
    let dir = TestDir::with_human();
    dir.write("long.osim", human_with_names(&"n".repeat(100_000), ""));
    for call in CALLS_THAT_PRINT_NAMES {
        let call = call.replace("MODEL", "long.osim");
        let run = dir.run(&call);
        assert!(run.stderr.len() < 20_000, "{call}: {} bytes on standard error", run.stderr.len());
        let for_programs = ["json", "csv", "diff"].iter().any(|word| call.contains(word));
        assert!(for_programs || run.stdout.len() < 60_000, "{call}: {} bytes", run.stdout.len());
    }
}

#[cfg(unix)]
#[test]
fn names_of_files_cannot_control_a_terminal_or_spreadsheet() {
    const NASTY_FILE_NAMES: [&str; 2] =
        ["=a\u{1b}[2J\nerror: fake\u{202e}.osim", "@b\twarning: fake\u{9b}.osim"];
    let dir = TestDir::with_human();
    for name in NASTY_FILE_NAMES {
        dir.write(name, fixture(HUMAN.0));
        dir.write(&format!("broken{name}"), "<OpenSimDocument Version=\"40000\"><Model");
    }
    for call in [
        "inspect .",
        "inspect . --format csv",
        "check .",
        "check . --format csv",
        "check . --format json",
        ". --target-mass 100 -d many --summary many.csv --report many.html",
        ". --target-mass 100 -d many --summary many.csv --resume",
        ". --target-mass 100 --in-place --summary places.csv",
    ] {
        let run = dir.run(call);
        assert_terminal_safe(&run, call);
        if call.contains("csv") && !call.contains("summary") {
            assert_no_formula(&run.stdout, call);
        }
        for file in run.changed.iter().filter(|file| file.ends_with(".csv")) {
            assert_no_formula(&dir.read(file), file);
            let table = dir.text(file);
            let steers = |letter: char| letter != '\n' && (letter.is_control() || letter == '\u{202e}');
            assert!(!table.contains(steers), "{table}");
            // The header, and one line for each record.
            let models = csv::Reader::from_reader(table.as_bytes()).records().count();
            assert_eq!(table.lines().count(), 1 + models, "{table}");
        }
        if call.contains("--resume") {
            // The program recognises the names in its summary although it has escaped them.
            assert!(run.changed.is_empty(), "{:?}", run.changed);
        }
    }
}

#[cfg(unix)]
#[test]
fn names_from_a_summary_work_in_a_table() {
    let dir = TestDir::with_human();
    let (name, output) = ("a\u{1b}[2J\n.osim", "out/a\u{1b}[2J\n.osim");
    dir.write(name, fixture(HUMAN.0));
    dir.run_words(&[name, "--target-mass", "100", "-d", "out", "--summary", "done.csv"]);
    let summary = dir.text("done.csv");
    let model = r"a\u{1b}[2J\u{a}.osim";
    assert!(
        summary.lines().nth(1).is_some_and(|line| line.starts_with(&format!(",{model},out/{model},"))),
        "{summary}"
    );
    dir.write("rows.csv", format!("model,target-mass\n{model},90\n"));
    dir.run("batch rows.csv -d out --force").succeeded().wrote(&[output]);
    dir.run_words(&["sweep", name, "--grid", "stiffness=x2", "-d", "swept"]);
    let table = dir.files().into_keys().find(|file| file.starts_with("swept/") && file.ends_with(".csv"));
    let table = dir.text(&table.unwrap());
    assert_eq!(table.lines().count(), 2, "{table}");
    assert!(table.contains(r"a\u{1b}[2J\u{a}_1_stiffness-x2.osim,"), "{table}");
}

#[test]
fn check_prints_the_whole_path_of_a_model() {
    let dir = TestDir::with_human();
    let folders = "a_folder_of_twenty_8/".repeat(11);
    dir.write(&format!("{folders}m.osim"), fixture(HUMAN.0));
    let output = dir.run(&format!("check {folders}m.osim")).out().replace("\n  ", "");
    assert!(output.starts_with(&format!("{folders}m.osim:")), "{output}");
}

#[test]
fn options_and_cells_are_shortened_to_one_line() {
    let dir = TestDir::with_human();
    let nasty = "1\u{1b}[2J\nerror: fake";
    for words in [
        ["human.osim", "--target-mass", nasty],
        ["human.osim", "--select", nasty],
        ["inspect", nasty, "human.osim"],
        [nasty, "human.osim", "--dry-run"],
        ["explain", nasty, "1"],
        ["presets", nasty, "--quiet"],
        ["plot", nasty, "human.osim"],
        ["human.osim", nasty, "--nonsense"],
    ] {
        let output = dir.run_words(&words);
        for stream in [output.stdout, output.stderr] {
            let text = String::from_utf8(stream).unwrap();
            assert!(!text.contains('\u{1b}') && !text.contains("\nerror: fake"), "{words:?}: {text}");
        }
    }
    let cell = "x ".repeat(2_500_000);
    dir.write("long.csv", format!("model,target-mass\nhuman.osim,{cell}\n{cell},31\n"));
    for call in [
        "batch long.csv -d out",
        "batch long.csv -d out --format json",
        "fit long.csv",
        "human.osim --target-mass 100 --presets long.csv",
    ] {
        let run = dir.run(call);
        assert!(
            run.stdout.len() + run.stderr.len() < 20_000,
            "{call}: {}",
            run.stdout.len() + run.stderr.len()
        );
    }
}
