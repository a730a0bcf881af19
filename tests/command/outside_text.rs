//! Text from outside (names in a model, file names, cells, options) is printed so that it can do no harm.

use osim_model::messages::is_visible;

use crate::support::{Bench, HUMAN, Ran, fixture};

/// Clears the screen, recolours it, turns the direction of writing, and is a formula.
const NASTY: &str = "=1+1\u{1b}[2J\u{9b}31m\u{202e}";
/// The same for the name of a model, which may hold blanks: it begins a line of its own.
const NASTY_LINE: &str = "=1+1\u{1b}[2J\u{9b}31m\u{202e}&#10;error: fake ";
/// What of it must not be seen in any output.
const FAKE: [&str; 2] = ["\nerror: fake", "\nwarning: fake"];

/// The human with these words before the names of its spheres, forces and feet, and `line` before its own.
fn renamed(name: &str, line: &str) -> String {
    let mut text = String::from_utf8(fixture(HUMAN.0)).unwrap();
    text = text.replace("human_62kg", &format!("{line}human"));
    let spheres = (1..=6).flat_map(|n| ["r", "l"].map(|side| format!("s{n}_{side}")));
    let olds: Vec<String> = spheres.flat_map(|sphere| [format!("contact_{sphere}"), sphere]).collect();
    for old in olds.iter().map(String::as_str).chain(["calcn_r", "calcn_l", "toes_r", "toes_l"]) {
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

/// Everything that is printed is seen, and begins no line.
#[track_caller]
fn terminal_safe(ran: &Ran, call: &str) {
    for (stream, text) in [("output", ran.out()), ("error", ran.err())] {
        let bad: Vec<char> =
            text.chars().filter(|&letter| !matches!(letter, '\n' | '\t') && !is_visible(letter)).collect();
        assert!(bad.is_empty(), "{call}: standard {stream} has {bad:?}:\n{text}");
        assert!(FAKE.iter().all(|fake| !text.contains(fake)), "{call}: standard {stream}:\n{text}");
    }
}

/// Cells of CSV do not begin like formulas, except numbers.
#[track_caller]
fn no_formula(table: &[u8], call: &str) {
    for record in csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(table).records() {
        for cell in &record.unwrap() {
            let formula = cell.starts_with(['=', '+', '-', '@', '\t', '\r']) && cell.parse::<f64>().is_err();
            assert!(!formula, "{call}: the cell {cell:?}");
        }
    }
}

/// Calls of every verb that reads a model, in every form.
const CALLS: [&str; 27] = [
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
fn names_in_a_model_cannot_steer_a_terminal_or_a_spreadsheet() {
    let bench = Bench::human();
    bench.write("nasty.osim", renamed(NASTY, NASTY_LINE));
    for call in CALLS {
        let call = call.replace("MODEL", "nasty.osim");
        let ran = bench.run(&call);
        // A check says that OpenSim refuses such names.
        let meant_to_fail = ["explain", "nobody", "none*", "check"].iter().any(|word| call.contains(word));
        assert_eq!(ran.status != Some(0), meant_to_fail, "{call}: {}", ran.err());
        terminal_safe(&ran, &call);
        if call.contains("csv") {
            no_formula(&ran.stdout, &call);
        }
        // A call that writes nothing shows nothing.
        let writes = [" -o ", " -d "].iter().any(|option| call.contains(option)) && !call.ends_with(" -o -");
        assert!(!writes || !ran.changed.is_empty(), "{call}: {}", ran.err());
        for file in &ran.changed {
            if file.ends_with(".csv") {
                no_formula(&bench.read(file), file);
            } else if !file.ends_with(".osim") && !file.ends_with(".png") {
                let text = bench.text(file);
                assert!(!text.contains(['\u{1b}', '\u{9b}', '\u{202e}']), "{call}: {file}");
            }
        }
    }
}

/// A diff may be for a program, which needs line ends, umlauts and blanks as they are; nothing in it moves a cursor.
#[test]
fn a_diff_into_a_pipe_does_not_steer_a_terminal() {
    let bench = Bench::human();
    bench.write("nasty.osim", renamed("F\u{fc}\u{df}e\u{a0}\u{1b}[2J\u{9b}31m\u{7f}", ""));
    let ran = bench.run("remove nasty.osim --dry-run --diff").done();
    let text = ran.out();
    assert!(text.lines().any(|line| line.starts_with("-\t")), "{text}");
    assert!(!text.contains(|letter: char| letter.is_control() && !"\t\r\n".contains(letter)), "{text}");
    assert!(text.contains("F\u{fc}\u{df}e\u{a0}\\u{1b}[2J\\u{9b}31m\\u{7f}"), "{text}");
    // Carriage returns stay, so that it can be applied.
    bench.write("crlf.osim", bench.text("human.osim").replace('\n', "\r\n"));
    let out = bench.run("crlf.osim --target-mass 100 --dry-run --diff").done().out();
    assert!(out.contains("</radius>\r\n") && !out.contains("\\u{d}"), "{out}");
}

#[test]
fn a_name_of_many_letters_is_shown_short() {
    let bench = Bench::human();
    bench.write("long.osim", renamed(&"n".repeat(100_000), ""));
    for call in CALLS {
        let call = call.replace("MODEL", "long.osim");
        let ran = bench.run(&call);
        assert!(ran.stderr.len() < 20_000, "{call}: {} bytes on standard error", ran.stderr.len());
        let for_programs = ["json", "csv", "diff"].iter().any(|word| call.contains(word));
        assert!(for_programs || ran.stdout.len() < 60_000, "{call}: {} bytes", ran.stdout.len());
    }
}

#[cfg(unix)]
#[test]
fn names_of_files_cannot_steer_a_terminal_or_a_spreadsheet() {
    const NAMES: [&str; 2] = ["=a\u{1b}[2J\nerror: fake\u{202e}.osim", "@b\twarning: fake\u{9b}.osim"];
    let bench = Bench::human();
    for name in NAMES {
        bench.write(name, fixture(HUMAN.0));
        bench.write(&format!("broken{name}"), "<OpenSimDocument Version=\"40000\"><Model");
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
        let ran = bench.run(call);
        terminal_safe(&ran, call);
        if call.contains("csv") && !call.contains("summary") {
            no_formula(&ran.stdout, call);
        }
        for file in ran.changed.iter().filter(|file| file.ends_with(".csv")) {
            no_formula(&bench.read(file), file);
            let table = bench.text(file);
            let steers = |letter: char| letter != '\n' && (letter.is_control() || letter == '\u{202e}');
            assert!(!table.contains(steers), "{table}");
            // The header, and one line for each record.
            let models = csv::Reader::from_reader(table.as_bytes()).records().count();
            assert_eq!(table.lines().count(), 1 + models, "{table}");
        }
        if call.contains("--resume") {
            // What a summary says is found again, although its cells are marked.
            assert!(ran.changed.is_empty(), "{:?}", ran.changed);
        }
    }
}

#[cfg(unix)]
#[test]
fn a_table_finds_the_files_that_a_summary_names() {
    let bench = Bench::human();
    let (name, output) = ("a\u{1b}[2J\n.osim", "out/a\u{1b}[2J\n.osim");
    bench.write(name, fixture(HUMAN.0));
    bench.run_words(&[name, "--target-mass", "100", "-d", "out", "--summary", "done.csv"]);
    let summary = bench.text("done.csv");
    let model = r"a\u{1b}[2J\u{a}.osim";
    assert!(
        summary.lines().nth(1).is_some_and(|line| line.starts_with(&format!(",{model},out/{model},"))),
        "{summary}"
    );
    bench.write("rows.csv", format!("model,target-mass\n{model},90\n"));
    bench.run("batch rows.csv -d out --force").done().wrote(&[output]);
    bench.run_words(&["sweep", name, "--grid", "stiffness=x2", "-d", "swept"]);
    let table = bench.files().into_keys().find(|file| file.starts_with("swept/") && file.ends_with(".csv"));
    let table = bench.text(&table.unwrap());
    assert_eq!(table.lines().count(), 2, "{table}");
    assert!(table.contains(r"a\u{1b}[2J\u{a}_1_stiffness-x2.osim,"), "{table}");
}

#[test]
fn the_path_of_a_model_is_shown_whole_by_check() {
    let bench = Bench::human();
    let folders = "a_folder_of_twenty_8/".repeat(11);
    bench.write(&format!("{folders}m.osim"), fixture(HUMAN.0));
    let shown = bench.run(&format!("check {folders}m.osim")).out().replace("\n  ", "");
    assert!(shown.starts_with(&format!("{folders}m.osim:")), "{shown}");
}

#[test]
fn options_and_cells_are_shown_short_and_on_one_line() {
    let bench = Bench::human();
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
        let output = bench.run_words(&words);
        for stream in [output.stdout, output.stderr] {
            let text = String::from_utf8(stream).unwrap();
            assert!(!text.contains('\u{1b}') && !text.contains("\nerror: fake"), "{words:?}: {text}");
        }
    }
    let cell = "x ".repeat(2_500_000);
    bench.write("long.csv", format!("model,target-mass\nhuman.osim,{cell}\n{cell},31\n"));
    for call in [
        "batch long.csv -d out",
        "batch long.csv -d out --format json",
        "fit long.csv",
        "human.osim --target-mass 100 --presets long.csv",
    ] {
        let ran = bench.run(call);
        assert!(
            ran.stdout.len() + ran.stderr.len() < 20_000,
            "{call}: {}",
            ran.stdout.len() + ran.stderr.len()
        );
    }
}
