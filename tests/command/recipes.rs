//! The files of `docs/recipes` in the programs they are written for.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::support::{Bench, root, skipped};

/// From 62 to 1190 kg the stiffness grows as M^(1/3), by (10) with isometric radii.
const MASSES: (f64, f64) = (62.0, 1190.0);

/// A folder with the recipes, a model under a name that needs quotation marks, one without contacts, and a table.
fn bench() -> Bench {
    let bench = Bench::with(&[
        ("table1/human_62kg_smooth_sphere.osim", "it's a folder/human.osim"),
        ("bad/no_contacts.osim", "no_contacts.osim"),
    ]);
    for recipe in std::fs::read_dir(root().join("docs/recipes")).unwrap() {
        let recipe = recipe.unwrap();
        if recipe.path().is_file() {
            bench.write(recipe.file_name().to_str().unwrap(), std::fs::read(recipe.path()).unwrap());
        }
    }
    bench.write(
        "masses.csv",
        "model,contacts_mass,target_mass\n\
         it's a folder/human.osim,62,1190\n\
         no_contacts.osim,62,500\n\
         it's a folder/human.osim,62,0\n\
         it's a folder/human.osim,62,62\n",
    );
    bench
}

/// A program in the folder, with the command on its path; `None`, said aloud, where it is not installed.
fn run(bench: &Bench, program: &str, arguments: &[&str]) -> Option<(Option<i32>, String)> {
    let command = Path::new(env!("CARGO_BIN_EXE_osim-contact-scale")).parent().unwrap().to_owned();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path: OsString =
        std::env::join_paths([command].into_iter().chain(std::env::split_paths(&path))).unwrap();
    let output = Command::new(program)
        .args(arguments)
        .current_dir(bench.path(""))
        .env("PATH", path)
        .env_remove("DISPLAY")
        .stdin(Stdio::null())
        .output();
    match output {
        Ok(output) => {
            let text =
                [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
            Some((output.status.code(), text.concat()))
        }
        Err(error) => {
            skipped(&format!("the recipes in {program}"), &error.to_string());
            None
        }
    }
}

/// The number behind `name = ` in what a program printed.
#[track_caller]
fn number(text: &str, name: &str) -> f64 {
    let line = text.lines().find_map(|line| line.strip_prefix(&format!("{name} = ")));
    line.unwrap_or_else(|| panic!("no '{name}' in\n{text}")).trim().parse().unwrap()
}

#[test]
fn octave_runs_the_recipes() {
    let bench = bench();
    let script = "\
        stiffness = look_and_rescale('it''s a folder/human.osim', 62, 1190, 'it''s a folder/big one.osim');\n\
        fprintf('stiffness = %.17g\\n', stiffness);\n\
        rows = table_of_masses('masses.csv', 'scaled models');\n\
        fprintf('rows = %d\\n', numel(rows));\n\
        fprintf('factor = %.17g\\n', rows(1).factor);\n\
        fprintf('same = %d\\n', isnan(rows(4).factor) && isempty(rows(4).problem));\n\
        for i = 1:numel(rows), fprintf('problem %d: %s\\n', i, rows(i).problem); end\n\
        try, contact_scale('inspect'), catch problem, fprintf('caught %s\\n', problem.identifier); end\n\
        try, look_and_rescale('no_contacts.osim', 62, 500, 'x.osim'), catch problem, fprintf('%s\\n', problem.message); end\n\
        gone = contact_scale('inspect', 'gone.osim'); fprintf('code: %s\\n', gone{1}.error.code);\n\
        setenv('PATH', '/nowhere');\n\
        try, contact_scale('inspect', 'gone.osim'), catch problem, fprintf('caught %s\\n', problem.identifier); end\n";
    bench.write("all_recipes.m", script);
    // --traditional: as near to MATLAB as Octave can be.
    let options = ["--traditional", "--no-gui", "--norc", "--no-history", "--eval", "all_recipes"];
    let Some((status, text)) = run(&bench, "octave", &options) else { return };
    assert_eq!(status, Some(0), "{text}");
    let factor = (MASSES.1 / MASSES.0).cbrt();
    assert!((number(&text, "stiffness") / (1e6 * factor) - 1.0).abs() < 1e-14, "{text}");
    assert!((number(&text, "factor") / factor - 1.0).abs() < 1e-14, "{text}");
    assert_eq!((number(&text, "rows"), number(&text, "same")), (4.0, 1.0), "{text}");
    for words in [
        "human_62kg weighs 62 kg and has 12 contact forces",
        "by equation (10)",
        "problem 1: \n",
        "problem 2: there are no contacts to work on",
        "problem 3: error: --target-mass '0'",
        "caught contact_scale:usage",
        "no_contacts.osim: there are no contacts to work on",
        "code: unreadable",
        "caught contact_scale:missing",
    ] {
        assert!(text.contains(words), "'{words}' is not in:\n{text}");
    }
    assert!(bench.has("it's a folder/big one.osim") && bench.has("scaled models/human_1190kg.osim"));
}

/// The first block of a language on a page of docs/.
fn block(page: &str, language: &str) -> String {
    let text = std::fs::read_to_string(root().join("docs").join(page)).unwrap();
    let opening = format!("\n```{language}\n");
    let after = text.split_once(&opening).unwrap_or_else(|| panic!("{page} has no {language}")).1;
    after.split_once("\n```").unwrap().0.to_owned()
}

/// A folder with the CSV of the seven smoothed animals of Table 1, as docs/libraries.md has it made.
fn bench_with_table() -> Bench {
    let bench = bench();
    for animal in
        ["human_62kg", "human_500kg", "mouse", "emu_10_spheres", "emu_2_spheres", "horse", "giraffe"]
    {
        let name = format!("{animal}_smooth_sphere.osim");
        bench.write(&format!("my_models/{name}"), crate::support::fixture(&format!("table1/{name}")));
    }
    let table = bench.run("inspect my_models --format csv").done().out();
    bench.write("models.csv", table);
    bench
}

#[test]
fn octave_reads_the_table_of_a_folder() {
    let bench = bench_with_table();
    // Octave without a screen draws nothing: what would be drawn is counted.
    bench.write(
        "loglog.m",
        "function loglog(x, y, varargin)\nfprintf('points = %d\\n', sum(x > 0 & y > 0));\nend\n",
    );
    for name in ["xlabel", "ylabel"] {
        bench.write(&format!("{name}.m"), format!("function {name}(varargin)\nend\n"));
    }
    let more = "fprintf('mass = %.17g\\n', max(models.mass_kg));\nfprintf('models = %d\\n', numel(unique(models.model_file)));\n\
                fprintf('deep = %d\\n', numel(unique(models.model_file(deep))));\n";
    bench.write("look.m", format!("{}\n{more}", block("libraries.md", "matlab")));
    let options = ["--traditional", "--no-gui", "--norc", "--no-history", "--eval", "look"];
    let Some((status, text)) = run(&bench, "octave", &options) else { return };
    assert_eq!(status, Some(0), "{text}");
    // Table 1: seven models up to 1190 kg. Spheres: 6 and 6 of each human foot, 10 and 2 of each emu's, and on all four limbs of
    // the quadrupeds 1, 5 and 4 each.
    let spheres = 2 * (6 + 6 + 10 + 2) + 4 * (1 + 5 + 4);
    let numbers = ["mass", "models", "deep", "points"].map(|name| number(&text, name));
    assert_eq!(numbers, [1190.0, 7.0, 7.0, f64::from(spheres)], "{text}");
}

/// `--data` of a figure, as docs/plots.md reads it.
#[test]
fn octave_reads_the_numbers_of_a_figure() {
    let bench = bench();
    bench.run("plot force falisse2022 --target-mass 1190 --label Human --label Giraffe -o a.svg --data print.csv").done();
    bench.write(
        "plot.m",
        "function plot(x, y)\nfprintf('from = %.17g\\nto = %.17g\\n', min(x), max(x));\nend\n",
    );
    bench.write("look.m", block("plots.md", "matlab"));
    let options = ["--traditional", "--no-gui", "--norc", "--no-history", "--eval", "look"];
    let Some((status, text)) = run(&bench, "octave", &options) else { return };
    assert_eq!(status, Some(0), "{text}");
    // From half a radius above the ground to half a radius in it: it rests at 0.339, and 1.25 times that is less.
    for (end, expected) in [("from", -0.5), ("to", 0.5)] {
        assert!((number(&text, end) - expected).abs() < 1e-12, "{text}");
    }
}

#[test]
fn the_recipes_are_matlab_too() {
    for recipe in std::fs::read_dir(root().join("docs/recipes")).unwrap() {
        let path = recipe.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "m") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let name = path.file_stem().unwrap().to_str().unwrap();
        assert!(text.starts_with("function ") && text.lines().next().unwrap().contains(name), "{name}");
        for (number, line) in text.lines().enumerate() {
            let code = line.split('%').next().unwrap();
            // Words and signs that Octave knows and MATLAB does not; texts in double quotes are another type there.
            let words = [
                "endif",
                "endfor",
                "endfunction",
                "endwhile",
                "end_try_catch",
                "printf (",
                "puts(",
                "unwind_protect",
            ];
            let signs = ["#", "!=", "+=", "++", "||="];
            let foreign = words.iter().chain(&signs).find(|sign| code.contains(**sign));
            assert!(foreign.is_none(), "{name}:{}: {foreign:?}", number + 1);
            let texts = code.replace("''''", "").replace("''", "");
            let outside: String = texts.split('\'').step_by(2).collect();
            assert!(!outside.contains('"'), "{name}:{}: {line}", number + 1);
        }
    }
}

#[test]
fn python_runs_the_recipes() {
    let bench = bench();
    let script = "\
from contact_scale import ModelError, UsageError, contact_scale
(done,) = contact_scale(\"it's a folder/human.osim\", '--target-mass', 1190, '-o', \"it's a folder/big one.osim\")
print('stiffness =', repr(next(c['to'] for c in done['changes'] if c['property'] == 'stiffness')))
for call in [('no_contacts.osim', '--target-mass', 500), ('--target-mas', 3)]:
    try:
        contact_scale(*call)
    except ModelError as problem:
        print('caught', problem.code, problem.model)
    except UsageError as problem:
        print('caught usage:', problem)
results = contact_scale('inspect', 'gone.osim', \"it's a folder/human.osim\", check=False)
print('kept', ['error' in result for result in results])
";
    bench.write("try_it.py", script);
    let Some((status, text)) = run(&bench, "python3", &["try_it.py"]) else { return };
    assert_eq!(status, Some(0), "{text}");
    let factor = (MASSES.1 / MASSES.0).cbrt();
    assert!((number(&text, "stiffness") / (1e6 * factor) - 1.0).abs() < 1e-14, "{text}");
    for words in [
        "caught no-contacts no_contacts.osim",
        "caught usage: error: unexpected argument",
        "kept [True, False]",
    ] {
        assert!(text.contains(words), "'{words}' is not in:\n{text}");
    }

    let (status, text) = run(&bench, "python3", &["table_of_masses.py", "masses.csv", "scaled"]).unwrap();
    assert_eq!(status, Some(1), "{text}");
    // Windows writes paths its own way.
    let summary = bench.text("scaled/summary.csv").replace('\\', "/");
    let rows: Vec<&str> = summary.lines().collect();
    assert_eq!(rows.len(), 5, "{summary}");
    assert!(rows[1].starts_with("it's a folder/human.osim,scaled") && rows[1].contains(",10,"), "{summary}");
    assert!(rows[2].contains("no contacts") && rows[3].contains("--target-mass '0'"), "{summary}");
    assert!(rows[4].contains("already-at-target"), "{summary}");
    assert!(bench.has("scaled/human_1190kg.osim"));
}
