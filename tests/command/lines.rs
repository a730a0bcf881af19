//! Lines of text end where the terminal ends; those for programs do not.

use crate::screen::shown;
use crate::support::{Bench, HUMAN};

/// What a run prints on both streams, on terminals of so many columns.
fn in_columns(bench: &Bench, columns: u16, arguments: &str) -> (String, String) {
    shown(bench.command(arguments), columns)
}

/// What it prints into pipes. Readline puts `COLUMNS` into the process of an interactive Python, which hands it on: it changes nothing.
fn in_pipes(bench: &Bench, arguments: &str) -> (String, String) {
    let output = bench.command(arguments).env("COLUMNS", "40").output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr))
}

fn longest(text: &str) -> usize {
    text.lines().map(|line| line.chars().count()).max().unwrap_or_default()
}

fn words(text: &str) -> Vec<&str> {
    text.split_whitespace().collect()
}

#[test]
fn sentences_end_where_the_terminal_ends() {
    let bench = Bench::with(&[
        (HUMAN.0, "human.osim"),
        ("bad/no_contacts.osim", "bare.osim"),
        ("check/stale_note.osim", "noted.osim"),
        ("check/sunk_in.osim", "soft.osim"),
    ]);
    for arguments in [
        "bare.osim --target-mass 80",
        "noted.osim --target-mass 80",
        "plot fig1 -o f.svg",
        "human.osim --target-mass",
        "human.osim --only stifness --target-mass 80",
        "explain sunk-in",
        "check noted.osim",
        "check soft.osim",
        "reproduce",
    ] {
        let (whole, narrow) = (in_pipes(&bench, arguments), in_columns(&bench, 60, arguments));
        for (whole, narrow) in [(whole.0, narrow.0), (whole.1, narrow.1)] {
            assert_eq!(words(&whole), words(&narrow), "{arguments}");
            let is_text = |line: &&str| !line.contains(" $ ") && !line.trim_start().contains("   ");
            let text: String = narrow.lines().filter(is_text).map(|line| format!("{line}\n")).collect();
            assert!(longest(&text) <= 60, "{arguments}:\n{text}");
        }
    }
}

#[test]
fn the_command_that_corrects_something_stays_one_line() {
    let bench = Bench::with(&[("check/sunk_in.osim", "soft.osim")]);
    let (out, _) = in_columns(&bench, 40, "check soft.osim");
    let command = out.lines().find(|line| line.starts_with("  $ osim-contact-scale design ")).unwrap();
    assert!(command.ends_with("--constant-indentation 0.054"), "{command}");
}

#[test]
fn lines_for_programs_have_no_end() {
    let bench = Bench::with(&[(HUMAN.0, "human.osim"), ("bad/no_contacts.osim", "bare.osim")]);
    for arguments in [
        "inspect human.osim --format json",
        "inspect human.osim --format csv",
        "check human.osim bare.osim --format json",
        "check human.osim --format csv",
        "human.osim --target-mass 80 --dry-run --format json",
        "human.osim --target-mass 80 --diff --dry-run --quiet",
        "bare.osim --target-mass 80 --format json",
        "explain 11 --format json",
        "presets --format json",
        "drop-test human.osim --format csv",
        "reproduce --format json",
        "design --mass 62 --spheres 6 --radius 0.032 --indentation 0.16 --format json",
        "completions zsh",
        "man check",
    ] {
        let (whole, narrow) = (in_pipes(&bench, arguments), in_columns(&bench, 40, arguments));
        assert!(!whole.0.is_empty(), "{arguments}: {}", whole.1);
        assert_eq!(whole.0, narrow.0, "{arguments}");
    }
}

#[test]
fn a_program_that_sends_a_request_gets_whole_lines() {
    let bench = Bench::with(&[("bad/no_contacts.osim", "bare.osim")]);
    bench.write("request.json", r#"{"verb": "rescale", "models": ["bare.osim"], "target_mass": 80}"#);
    for (_, said) in
        [in_pipes(&bench, "request request.json"), in_columns(&bench, 40, "request request.json")]
    {
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}

#[test]
fn help_fits_narrow_terminals() {
    let bench = Bench::new();
    for columns in [60, 80, 100] {
        for arguments in ["-h", "--help"] {
            let (help, _) = in_columns(&bench, columns, arguments);
            // Usage is code.
            let text: Vec<&str> = help.lines().filter(|line| !line.contains("osim-contact-scale")).collect();
            assert!(longest(&text.join("\n")) <= usize::from(columns), "{columns}: {help}");
        }
    }
}

#[test]
fn lines_in_a_pipe_have_no_end() {
    let bench = Bench::with(&[("bad/no_contacts.osim", "bare.osim")]);
    let (_, said) = in_pipes(&bench, "bare.osim --target-mass 80");
    assert!(said.lines().count() == 1 && longest(&said) > 80, "{said}");
}
