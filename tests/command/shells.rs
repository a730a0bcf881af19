//! Tests completions in real shells, and manual pages in groff.

use std::process::{Command, Stdio};

use crate::support::{TestDir, report_skip};

const SHELLS: [&str; 5] = ["bash", "zsh", "fish", "powershell", "elvish"];

/// Runs another program on files of `dir`; reports a skipped test and returns `None` if the program is missing.
fn run_program(dir: &TestDir, test: &str, program: &str, arguments: &[&str]) -> Option<(String, String)> {
    if cfg!(windows) && program == "bash" {
        // On Windows, bash may start another system, which has other paths.
        report_skip(test, "not on Windows");
        return None;
    }
    let output = Command::new(program)
        .args(arguments)
        .current_dir(dir.path(""))
        .env("LC_ALL", "C.UTF-8")
        .stdin(Stdio::null())
        .output();
    let output = match output {
        Ok(output) => output,
        Err(error) => {
            report_skip(test, &format!("{program}: {error}"));
            return None;
        }
    };
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    let (out, err) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{program} {arguments:?}\n{out}{err}");
    Some((out, err))
}

/// A folder with the script `completions.SHELL` for each shell.
fn completion_scripts() -> TestDir {
    let dir = TestDir::new();
    for shell in SHELLS {
        let script = dir.run(&format!("completions {shell}")).succeeded().wrote_nothing().stdout;
        dir.write(&format!("completions.{shell}"), script);
    }
    dir
}

#[test]
fn bash_completes_verbs_options_and_values() {
    let dir = completion_scripts();
    let complete = |line: &[&str]| {
        let script = format!(
            "source completions.bash; COMP_WORDS=({}); COMP_CWORD={}; COMPREPLY=(); {}; echo \"${{COMPREPLY[@]}}\"",
            line.join(" "),
            line.len() - 1,
            // What `complete -p` says bash would call, with the command, the word and the word before it.
            "f=$(complete -p osim-contact-scale | sed 's/.*-F \\([^ ]*\\).*/\\1/'); \
             $f osim-contact-scale \"${COMP_WORDS[COMP_CWORD]}\" \"${COMP_WORDS[COMP_CWORD-1]}\"",
        );
        run_program(&dir, "bash's completion", "bash", &["-c", &script]).map(|(out, _)| out.trim().to_owned())
    };
    if run_program(&dir, "bash's completion", "bash", &["-n", "completions.bash"]).is_none() {
        return;
    }
    assert_eq!(complete(&["osim-contact-scale", "tran"]).unwrap(), "transfer");
    assert_eq!(complete(&["osim-contact-scale", "rescale", "--target-m"]).unwrap(), "--target-mass");
    assert_eq!(complete(&["osim-contact-scale", "inspect", "--format", "j"]).unwrap(), "json");
    assert_eq!(complete(&["osim-contact-scale", "drop-test", "--compare-s"]).unwrap(), "--compare-spheres");
    assert_eq!(complete(&["osim-contact-scale", "completions", "z"]).unwrap(), "zsh");
    // Without a word, bash completes the files of the folder.
    for verb in ["check", "set", "rescale", "transfer"] {
        assert_eq!(complete(&["osim-contact-scale", verb, "''"]).unwrap(), "", "{verb}");
    }
    assert_eq!(complete(&["osim-contact-scale", "presets", "fal"]).unwrap(), "falisse2022");
    assert_eq!(
        complete(&["osim-contact-scale", "add", "m.osim", "--from", "moco-2"]).unwrap(),
        "moco-2d-gait"
    );
    // After an option, bash completes folders and names with blanks by itself, where nothing else is known.
    for option in ["--from", "-o", "-d", "--target-mass"] {
        assert_eq!(complete(&["osim-contact-scale", "transfer", option, "''"]).unwrap(), "", "{option}");
    }
    assert_eq!(complete(&["osim-contact-scale", "drop-test", "--compare", "osim-"]).unwrap(), "osim-rl");
    assert_eq!(complete(&["osim-contact-scale", "rescale", "--only", "stif"]).unwrap(), "stiffness");
    assert_eq!(complete(&["osim-contact-scale", "add", "--yes", "poor"]).unwrap(), "poor-fit");
    assert_eq!(complete(&["osim-contact-scale", "sweep", "--grid", "stif"]).unwrap(), "stiffness=");
    assert_eq!(complete(&["osim-contact-scale", "explain", "sunk"]).unwrap(), "sunk-in");
    assert_eq!(complete(&["osim-contact-scale", "set", "m.osim", "stif"]).unwrap(), "stiffness=");
}

/// Types a line after the other in a terminal of zsh, each with the key Tab, and writes what stands there then.
const TYPED_IN_ZSH: &str = r#"
zmodload zsh/zpty zsh/zselect
zpty shell zsh -f -i
drain() { while zpty -r -t shell shown; do :; done; zselect -t 2 }
zpty -w shell 'autoload -Uz compinit && compinit -D -u; source completions.zsh
keep() { print -r -- "$BUFFER" >> lines; BUFFER= }; zle -N keep; bindkey "^X" keep; bindkey "^I" complete-word; : > lines'
until [[ -e lines ]]; do drain; done
typeset -i typed=0
for line; do
    typed+=1
    zpty -w -n shell "osim-contact-scale $line"$'\t\x18'
    until (( $(wc -l < lines) >= typed )); do drain; done
done
zpty -d shell
cat lines
"#;

#[test]
fn zsh_completes_verbs_options_values_and_files() {
    let dir = completion_scripts();
    dir.write("model.osim", "");
    dir.write("library/other.osim", "");
    let lines = [
        ("tran", "transfer "),
        ("mod", "model.osim "),
        ("model.osim --dry", "model.osim --dry-run "),
        ("model.osim library --dry", "model.osim library --dry-run "),
        ("check mod", "check model.osim "),
        ("check lib", "check library/"),
        ("rescale model.osim --target-m", "rescale model.osim --target-mass="),
        ("transfer model.osim -o lib", "transfer model.osim -o library/"),
        ("transfer model.osim --from mod", "transfer model.osim --from model.osim "),
        ("transfer model.osim --from fal", "transfer model.osim --from falisse2022 "),
        ("drop-test --compare osim-", "drop-test --compare osim-rl "),
        ("presets fal", "presets falisse2022 "),
        ("explain stiffness sunk", "explain stiffness sunk-in "),
        ("model.osim --only stif", "model.osim --only stiffness "),
        ("add --yes poor", "add --yes poor-fit "),
    ];
    let typed = lines.map(|(typed, _)| typed);
    let arguments = [&["-f", "-c", TYPED_IN_ZSH, "zsh"][..], &typed].concat();
    let Some((out, _)) = run_program(&dir, "zsh's completion", "zsh", &arguments) else { return };
    let expected = lines.map(|(_, completed)| format!("osim-contact-scale {completed}"));
    assert_eq!(out.lines().collect::<Vec<_>>(), expected);
}

#[test]
fn zsh_fish_powershell_and_elvish_read_their_scripts() {
    let dir = completion_scripts();
    run_program(&dir, "zsh's completion", "zsh", &["-n", "completions.zsh"]);
    run_program(&dir, "fish's completion", "fish", &["--no-execute", "completions.fish"]);
    let powershell = "$e=$null; [void][System.Management.Automation.Language.Parser]::ParseFile(\
                      (Resolve-Path completions.powershell), [ref]$null, [ref]$e); exit $e.Count";
    run_program(&dir, "PowerShell's completion", "pwsh", &["-NoProfile", "-Command", powershell]);
    // elvish has this module only while somebody types, and it filters the words by itself.
    let elvish = "var edit: = (ns [&completion:=(ns [&arg-completer=[&]]) &complex-candidate~={|word &display=''| put $word }])
                  eval &ns=(ns [&edit:=$edit:]) (slurp < completions.elvish)
                  $edit:completion:arg-completer[osim-contact-scale] osim-contact-scale tran | each $echo~";
    if let Some((out, _)) = run_program(&dir, "elvish's completion", "elvish", &["-norc", "-c", elvish]) {
        let words: Vec<&str> = out.lines().collect();
        assert!(words.contains(&"transfer") && words.contains(&"--target-mass"), "{out}");
    }
}

#[test]
fn fish_completes_verbs_options_values_and_files() {
    let dir = completion_scripts();
    dir.write("model.osim", "");
    dir.write("library/other.osim", "");
    let complete = |line: &str| {
        let script = format!("source completions.fish; complete -C 'osim-contact-scale {line}'");
        let (out, _) = run_program(&dir, "fish's completion", "fish", &["--no-config", "-c", &script])?;
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
    assert_eq!(complete("transfer model.osim --from fal"), ["falisse2022"]);
    assert_eq!(complete("drop-test --compare osim-"), ["osim-rl"]);
    assert_eq!(complete("rescale --only stif"), ["stiffness"]);
    assert_eq!(complete("add --yes poor"), ["poor-fit"]);
    assert_eq!(complete("explain sunk"), ["sunk-in"]);
    // Options, of a call without a verb, too, before and after its model.
    assert_eq!(complete("--target-m"), ["--target-mass"]);
    assert_eq!(complete("model.osim --target-m"), ["--target-mass"]);
    assert_eq!(complete("model.osim --target-mass 80 --dry"), ["--dry-run"]);
    assert_eq!(complete("drop-test --compare-s"), ["--compare-spheres"]);
    // An option that the verb does not have.
    assert!(complete("inspect model.osim --target-g").is_empty());
    assert_eq!(complete("inspect --format j"), ["json"]);
    assert_eq!(complete("help drop"), ["drop-test"]);
    assert_eq!(complete("completions z"), ["zsh"]);
    assert_eq!(complete("plot fig-"), ["fig-c5"]);
}

#[test]
fn groff_formats_the_manual_page_of_every_verb() {
    let dir = TestDir::new();
    dir.run("man -d pages").succeeded();
    let pages: Vec<String> = dir.files().into_keys().collect();
    let help = dir.run("-h").succeeded().out();
    let (groups, _) = help.split_once("\nArguments:").unwrap();
    let (_, groups) = groups.split_once("\nChange models:\n").unwrap();
    let verbs: Vec<&str> = groups
        .lines()
        // A long description continues in the next line, indented further; groups have headings.
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
        let Some((text, warnings)) = run_program(&dir, "the manual", "groff", &groff) else { return };
        assert!(warnings.is_empty(), "{page}: {warnings}");
        assert!(text.contains("NAME") && text.contains("SYNOPSIS"), "{page}\n{text}");
    }
    let rescale = ["-man", "-Tascii", "-P-cbou", "pages/osim-contact-scale-rescale.1"];
    let (text, _) = run_program(&dir, "the manual", "groff", &rescale).unwrap();
    // Also options that the short help leaves out.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in ["Mass the contacts should be made for, kg", "Leave these bodies out of the sum"] {
        assert!(text.contains(words), "{words}\n{text}");
    }
}

#[test]
fn man_prints_one_page_and_replaces_files_only_with_force() {
    let dir = TestDir::new();
    let page = dir.run("man transfer").succeeded().wrote_nothing().out();
    assert!(page.contains("osim\\-contact\\-scale\\-transfer"), "{page}");
    assert!(dir.run("man").succeeded().out().contains("SUBCOMMANDS"));
    dir.run("man xyzzy").usage_error().says(&["invalid value 'xyzzy'", "transfer"]);
    dir.run("man tranfer").usage_error().says(&["'tranfer': did you mean 'transfer'?"]);
    dir.run("man -d pages").succeeded();
    dir.run("man -d pages").usage_error().wrote_nothing().says(&["another folder with -d", "--force"]);
    dir.run("man -d pages --force").succeeded();
}
