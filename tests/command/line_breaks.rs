//! The program wraps sentences at the width of the terminal, and never wraps lines for programs.

use crate::support::{HUMAN, TestDir};
use crate::terminal::terminal_output;

/// The texts that a run prints on both streams, in terminals of this number of columns.
fn output_in_terminal(dir: &TestDir, columns: u16, arguments: &str) -> (String, String) {
    terminal_output(dir.command(arguments), columns)
}

/// The texts that a run prints into pipes. `COLUMNS` is set, as by an interactive Python that starts the program, but has no effect.
fn output_in_pipes(dir: &TestDir, arguments: &str) -> (String, String) {
    let output = dir.command(arguments).env("COLUMNS", "40").output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr))
}

fn longest_line(text: &str) -> usize {
    text.lines().map(|line| line.chars().count()).max().unwrap_or_default()
}

fn words_of_text(text: &str) -> Vec<&str> {
    text.split_whitespace().collect()
}

#[test]
fn sentences_wrap_at_the_terminal_width() {
    let dir = TestDir::with(&[
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
    ] {
        let (whole, narrow) = (output_in_pipes(&dir, arguments), output_in_terminal(&dir, 60, arguments));
        for (whole, narrow) in [(whole.0, narrow.0), (whole.1, narrow.1)] {
            assert_eq!(words_of_text(&whole), words_of_text(&narrow), "{arguments}");
            let is_text = |line: &&str| !line.starts_with("$ ") && !line.trim_start().contains("   ");
            let text: String = narrow.lines().filter(is_text).map(|line| format!("{line}\n")).collect();
            assert!(longest_line(&text) <= 60, "{arguments}:\n{text}");
        }
    }
}

#[test]
fn a_faulty_line_of_a_file_is_cut_around_the_fault() {
    let dir = TestDir::with(&[("bad/tags_crossed.osim", "crossed.osim")]);
    let line = "<stiffness>1234567.8</dissipation>";
    let comment = " force".repeat(10);
    let long = dir.text("crossed.osim").replace(line, &format!("<!--{comment} -->{line}"));
    dir.write("long.osim", long);
    for columns in [60, 80] {
        let (_, message) = output_in_terminal(&dir, columns, "long.osim --target-mass 80");
        assert!(longest_line(&message) <= usize::from(columns), "{message}");
        let lines: Vec<&str> = message.lines().collect();
        let [.., source, mark] = lines.as_slice() else { panic!("{message}") };
        let at = mark.find('^').unwrap();
        assert!(source[at..].starts_with("</dissipation>"), "{message}");
    }
    let (_, message) = output_in_pipes(&dir, "long.osim --target-mass 80");
    assert!(message.contains(&format!("<!--{comment} -->{line}")), "{message}");
}

#[test]
fn a_proposed_command_stays_on_one_line() {
    let dir = TestDir::with(&[("check/sunk_in.osim", "soft.osim")]);
    let (out, _) = output_in_terminal(&dir, 40, "check soft.osim");
    let command = out.lines().find(|line| line.starts_with("$ osim-contact-scale design ")).unwrap();
    assert!(command.ends_with("--constant-indentation 0.054"), "{command}");
}

#[test]
fn lines_for_programs_are_not_wrapped() {
    let dir = TestDir::with(&[(HUMAN.0, "human.osim"), ("bad/no_contacts.osim", "bare.osim")]);
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
        let (whole, narrow) = (output_in_pipes(&dir, arguments), output_in_terminal(&dir, 40, arguments));
        assert!(!whole.0.is_empty(), "{arguments}: {}", whole.1);
        assert_eq!(whole.0, narrow.0, "{arguments}");
    }
}

#[test]
fn messages_about_a_request_are_not_wrapped() {
    let dir = TestDir::with(&[("bad/no_contacts.osim", "bare.osim")]);
    dir.write("request.json", r#"{"verb": "rescale", "models": ["bare.osim"], "target_mass": 80}"#);
    for (_, message) in
        [output_in_pipes(&dir, "request request.json"), output_in_terminal(&dir, 40, "request request.json")]
    {
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}

#[test]
fn help_fits_narrow_terminals() {
    let dir = TestDir::new();
    for columns in [60, 80, 100] {
        for arguments in ["-h", "--help"] {
            let (help, _) = output_in_terminal(&dir, columns, arguments);
            // Usage is code.
            let text: Vec<&str> = help.lines().filter(|line| !line.contains("osim-contact-scale")).collect();
            assert!(longest_line(&text.join("\n")) <= usize::from(columns), "{columns}: {help}");
        }
    }
}

#[test]
fn messages_in_a_pipe_are_not_wrapped() {
    let dir = TestDir::with(&[("bad/no_contacts.osim", "bare.osim")]);
    let (_, message) = output_in_pipes(&dir, "bare.osim --target-mass 80");
    assert!(message.lines().count() == 1 && longest_line(&message) > 80, "{message}");
}
