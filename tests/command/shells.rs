//! Completions and manual pages, read by the programs they are for.

use std::process::{Command, Stdio};

use crate::support::{Bench, skipped};

const SHELLS: [&str; 5] = ["bash", "zsh", "fish", "powershell", "elvish"];

/// A run of another program on files of `bench`; `None`, said aloud, where the program is not there.
fn run(bench: &Bench, test: &str, program: &str, arguments: &[&str]) -> Option<(String, String)> {
    if cfg!(windows) && program == "bash" {
        // There it may be the door to another system, which sees other paths.
        skipped(test, "not on Windows");
        return None;
    }
    let output = Command::new(program)
        .args(arguments)
        .current_dir(bench.path(""))
        .env("LC_ALL", "C.UTF-8")
        .stdin(Stdio::null())
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            skipped(test, &format!("{program}: {error}"));
            return None;
        }
    };
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{program} {arguments:?}\n{out}{err}");
    Some((out, err))
}

/// A folder with `completions.SHELL` for each shell.
fn scripts() -> Bench {
    let bench = Bench::new();
    for shell in SHELLS {
        let script = bench.run(&format!("completions {shell}")).done().wrote_nothing().stdout;
        bench.write(&format!("completions.{shell}"), script);
    }
    bench
}

#[test]
fn bash_completes_verbs_options_and_values() {
    let bench = scripts();
    let complete = |line: &[&str]| {
        let script = format!(
            "source completions.bash; COMP_WORDS=({}); COMP_CWORD={}; COMPREPLY=(); {}; echo \"${{COMPREPLY[@]}}\"",
            line.join(" "),
            line.len() - 1,
            // What `complete -p` says bash would call, with the command, the word and the word before it.
            "f=$(complete -p osim-contact-scale | sed 's/.*-F \\([^ ]*\\).*/\\1/'); \
             $f osim-contact-scale \"${COMP_WORDS[COMP_CWORD]}\" \"${COMP_WORDS[COMP_CWORD-1]}\"",
        );
        run(&bench, "bash's completion", "bash", &["-c", &script]).map(|(out, _)| out.trim().to_owned())
    };
    if run(&bench, "bash's completion", "bash", &["-n", "completions.bash"]).is_none() {
        return;
    }
    assert_eq!(complete(&["osim-contact-scale", "tran"]).unwrap(), "transfer");
    assert_eq!(complete(&["osim-contact-scale", "rescale", "--target-m"]).unwrap(), "--target-mass");
    assert_eq!(complete(&["osim-contact-scale", "inspect", "--format", "j"]).unwrap(), "json");
    assert_eq!(complete(&["osim-contact-scale", "drop-test", "--compare-s"]).unwrap(), "--compare-spheres");
    assert_eq!(complete(&["osim-contact-scale", "completions", "z"]).unwrap(), "zsh");
}

#[test]
fn other_shells_can_read_theirs() {
    let bench = scripts();
    run(&bench, "zsh's completion", "zsh", &["-n", "completions.zsh"]);
    run(&bench, "fish's completion", "fish", &["--no-execute", "completions.fish"]);
    let powershell = "$e=$null; [void][System.Management.Automation.Language.Parser]::ParseFile(\
                      (Resolve-Path completions.powershell), [ref]$null, [ref]$e); exit $e.Count";
    run(&bench, "PowerShell's completion", "pwsh", &["-NoProfile", "-Command", powershell]);
    // What elvish has only while somebody types; it chooses among the words by itself.
    let elvish = "var edit: = (ns [&completion:=(ns [&arg-completer=[&]]) &complex-candidate~={|word &display=''| put $word }])
                  eval &ns=(ns [&edit:=$edit:]) (slurp < completions.elvish)
                  $edit:completion:arg-completer[osim-contact-scale] osim-contact-scale tran | each $echo~";
    if let Some((out, _)) = run(&bench, "elvish's completion", "elvish", &["-norc", "-c", elvish]) {
        let words: Vec<&str> = out.lines().collect();
        assert!(words.contains(&"transfer") && words.contains(&"--target-mass"), "{out}");
    }
}

#[test]
fn fish_completes_verbs_options_values_and_files() {
    let bench = scripts();
    bench.write("model.osim", "");
    bench.write("library/other.osim", "");
    let complete = |line: &str| {
        let script = format!("source completions.fish; complete -C 'osim-contact-scale {line}'");
        let (out, _) = run(&bench, "fish's completion", "fish", &["--no-config", "-c", &script])?;
        // A tab, and what it is, come after each word.
        Some(
            out.lines()
                .map(|line| line.split('\t').next().unwrap_or_default().to_owned())
                .collect::<Vec<_>>(),
        )
    };
    if complete("").is_none() {
        return;
    }
    let complete = |line: &str| complete(line).unwrap();
    assert_eq!(complete("tran"), ["transfer"]);
    // Verbs and files are both possible.
    assert_eq!(complete("mo"), ["model.osim", "motion"]);
    assert_eq!(complete("lib"), ["library/"]);
    for verb in ["check ", "check --deny warning ", "transfer ", "plot force ", "rescale model.osim "] {
        assert_eq!(complete(&format!("{verb}mod")), ["model.osim"], "{verb}");
    }
    assert_eq!(complete("transfer model.osim --from mod"), ["model.osim"]);
    assert_eq!(complete("check library/"), ["library/other.osim"]);
    // Options, of a call without a verb, too, before and after its model.
    assert_eq!(complete("--target-m"), ["--target-mass"]);
    assert_eq!(complete("model.osim --target-m"), ["--target-mass"]);
    assert_eq!(complete("model.osim --target-mass 80 --dry"), ["--dry-run"]);
    assert_eq!(complete("drop-test --compare-s"), ["--compare-spheres"]);
    // What a verb does not take.
    assert!(complete("inspect model.osim --target-g").is_empty());
    assert_eq!(complete("inspect --format j"), ["json"]);
    assert_eq!(complete("help drop"), ["drop-test"]);
    assert_eq!(complete("completions z"), ["zsh"]);
    assert_eq!(complete("plot fig-"), ["fig-c5"]);
}

#[test]
fn every_verb_has_a_page_that_groff_can_set() {
    let bench = Bench::new();
    bench.run("man -d pages").done();
    let pages: Vec<String> = bench.files().into_keys().collect();
    let help = bench.run("-h").done().out();
    let (groups, _) = help.split_once("\nArguments:").unwrap();
    let (_, groups) = groups.split_once("\nChange models:\n").unwrap();
    let verbs: Vec<&str> = groups
        .lines()
        // A long description goes on in the next line, further in; groups have headings.
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .map(|line| line.split_whitespace().next().unwrap())
        .collect();
    assert!(verbs.contains(&"rescale") && verbs.contains(&"version"), "{verbs:?}");
    let mut expected: Vec<String> =
        verbs.iter().map(|verb| format!("pages/osim-contact-scale-{verb}.1")).collect();
    expected.push("pages/osim-contact-scale.1".to_owned());
    expected.sort();
    assert_eq!(pages, expected);
    for page in &pages {
        let groff = ["-man", "-Tutf8", "-Kutf8", "-ww", "-P-cbou", page.as_str()];
        let Some((text, warnings)) = run(&bench, "the manual", "groff", &groff) else { return };
        assert!(warnings.is_empty(), "{page}: {warnings}");
        assert!(text.contains("NAME") && text.contains("SYNOPSIS"), "{page}\n{text}");
    }
    let rescale = ["-man", "-Tascii", "-P-cbou", "pages/osim-contact-scale-rescale.1"];
    let (text, _) = run(&bench, "the manual", "groff", &rescale).unwrap();
    // Also what the short help leaves out.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in ["Mass the contacts should be made for, kg", "Leave these bodies out of the sum"] {
        assert!(text.contains(words), "{words}\n{text}");
    }
}

#[test]
fn one_page_is_printed_and_nothing_is_replaced() {
    let bench = Bench::new();
    let page = bench.run("man transfer").done().wrote_nothing().out();
    assert!(page.contains("osim\\-contact\\-scale\\-transfer"), "{page}");
    assert!(bench.run("man").done().out().contains("SUBCOMMANDS"));
    bench.run("man xyzzy").usage().says(&["invalid value 'xyzzy'", "transfer"]);
    bench.run("man tranfer").usage().says(&["'tranfer': did you mean 'transfer'?"]);
    bench.run("man -d pages").done();
    bench.run("man -d pages").failed().wrote_nothing().says(&["--force"]);
    bench.run("man -d pages --force").done();
}
