//! Parts of docs/ are made from the registers of the program: findings, errors, limits, figures of all verbs. Such a part is between
//! `<!-- begin NAME -->` and `<!-- end NAME -->`. To write them again: `UPDATE_DOCS=1 cargo test --test generated`.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "a test fails by panicking")]

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use contact_scaling::limits;
use osim_inspect::{CheckResult, Figure, Quantity};
use osim_messages::{Call, Dialect, Example, Input, Phrase, Verb};
use osim_model::files::{Beside, InMemory, ModelFiles};
use osim_model::{FindingCode, Repair, Rule, Seen, Severity};
use osim_planning::{DesignQuantity, DropColumn, DropFigure, DropRow, Inspector, rules};
use osim_report::ExitStatus;
use osim_report::explain::ErrorGroup;
use osim_requests::options::InspectionOptions;
use osim_requests::spell::{CommandLine, Speller};
use osim_requests::{Request, schema_of};

/// The words of the command line, marked as code.
struct Markdown;

impl Dialect for Markdown {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        format!("`{}`", CommandLine.input(input, example))
    }

    fn call(&self, call: &Call) -> String {
        format!("`{}`", CommandLine.call(call))
    }
}

/// In Markdown outside of code, with what would be read as marks kept as it is.
fn spelled(phrase: &Phrase) -> String {
    marked(&phrase.spelled(&Markdown))
}

/// In Markdown: code stays as it is, and a page of docs/ is a link.
fn marked(text: &str) -> String {
    let pieces = text.split('`').enumerate().map(|(index, piece)| match index % 2 {
        0 => piece.replace('*', "\\*").replace('<', "\\<").replace('|', "\\|"),
        _ => format!("`{}`", piece.replace('|', "\\|")),
    });
    let words = pieces.collect::<String>();
    let words = words.split(' ').map(|word| {
        match word.split_once("docs/").and_then(|(before, page)| Some((before, page.split_once(".md")?))) {
            Some((before, (page, after))) => format!("{before}[docs/{page}.md]({page}.md){after}"),
            None => word.to_owned(),
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

fn table(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut text = format!("| {} |\n|{}\n", header.join(" | "), "---|".repeat(header.len()));
    for row in rows {
        text.push_str(&format!("| {} |\n", row.join(" | ")));
    }
    text
}

/// Rules with the worst first, as `check` sorts findings.
fn by_severity() -> Vec<&'static Rule> {
    let mut all = rules::all().to_vec();
    all.sort_by_key(|rule| Reverse(rule.severity));
    all
}

/// docs/warnings.md: a list, then a section for each code.
fn findings() -> String {
    let mut text: String = rules::all().iter().map(|rule| format!("- [`{0}`](#{0})\n", rule.code)).collect();
    for rule in rules::all() {
        let severity = match rule.severity {
            Severity::Error => "error",
            Severity::Warn => "warning",
            Severity::Info => "remark",
        };
        let seen = match rule.seen {
            Seen::Change => ", not looked for by check",
            _ => "",
        };
        text.push_str(&format!(
            "\n## {code}\n\n{what} ({severity}{seen})\n\n*Why:* {why}\n\n*What to do:* {advice}.\n\n*Fix:* {repair}.\n\n*Example:* {example}.\n",
            code = rule.code,
            what = spelled(&rule.what()),
            why = spelled(&rule.why()),
            advice = spelled(&rule.advice()),
            repair = marked(&rule.repair.sentence()),
            example = example(rule.example),
        ));
    }
    text
}

/// What raises a finding, and what does not.
fn example(example: osim_model::Example) -> String {
    use osim_model::Example;
    // As it runs in the project's own folder.
    let call = |json: &str| {
        let here = json.replace(r#""models": [""#, r#""models": ["fixtures/"#);
        let here = here.replace(r#""from": ""#, r#""from": "fixtures/"#);
        let request = Request::from_json(here.as_bytes()).unwrap();
        format!("`{}`", CommandLine.request(&request))
    };
    match example {
        Example::Piece { model, good, bad } => {
            format!("`{bad}` has it, `{good}` does not (in `fixtures/{model}`)")
        }
        Example::Models { good, bad } => format!("`fixtures/{bad}` has it, `fixtures/{good}` does not"),
        Example::Request { good, bad } => format!("{} says it, {} does not", call(bad), call(good)),
        Example::InWords { good, bad } => format!("{bad}. Without it: {good}"),
        _ => panic!("an example of another kind"),
    }
}

/// docs/check.md: what it looks for.
fn looked_for() -> String {
    let checked = by_severity().into_iter().filter(|rule| rule.seen == Seen::Model);
    let rows = checked.map(|rule| {
        let what = spelled(&rule.what());
        vec![
            format!("`{}`", rule.code),
            rule.severity.as_str().to_owned(),
            what.trim_end_matches('.').to_owned(),
        ]
    });
    table(&["code", "severity", "what it is"], rows)
}

/// docs/check.md: the command of each code, or why there is none.
fn repairs() -> String {
    let checked = by_severity().into_iter().filter(|rule| rule.seen == Seen::Model);
    let rows = checked.map(|rule| {
        let (command, why) = match rule.repair {
            Repair::Command(what) => (what, ""),
            Repair::NotPossible(why) => ("", why),
        };
        vec![format!("`{}`", rule.code), marked(command), marked(why)]
    });
    table(&["code", "the proposed command", "why there is none"], rows)
}

/// docs/check.md: on how many published models each rule fires; `None` without them.
fn published() -> Option<String> {
    let Some(folder) = std::env::var_os("OSIM_CORPUS").map(PathBuf::from) else {
        // Straight to the terminal: what a passing test prints is kept.
        let line = "skipped: how often each rule fires: OSIM_CORPUS is not set\n";
        let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
        return None;
    };
    let mut names: Vec<PathBuf> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.retain(|path| path.extension().is_some_and(|extension| extension == "osim"));
    names.sort();
    let mut counted: BTreeMap<(Reverse<Severity>, FindingCode), Vec<String>> = BTreeMap::new();
    let checked: Vec<CheckResult> = names.iter().filter_map(|path| checked(path)).collect();
    for found in &checked {
        let name = found.model.trim_end_matches(".osim").to_owned();
        let kinds: BTreeSet<_> =
            found.findings.iter().map(|one| (Reverse(one.severity), one.code())).collect();
        kinds.into_iter().for_each(|kind| counted.entry(kind).or_default().push(name.clone()));
    }
    let rows = counted.into_iter().map(|((severity, code), models)| {
        let named = if models.len() <= NAMED { models.join(", ") } else { String::new() };
        vec![format!("`{code}`"), severity.0.as_str().to_owned(), models.len().to_string(), named]
    });
    let warned = checked.iter().filter(|found| found.counts.error + found.counts.warn > 0).count();
    let all = checked.len();
    let table = table(&["code", "severity", "models", "which, where they are few"], rows);
    Some(format!("Of {all} published models with contacts {warned} have an error or a warning.\n\n{table}"))
}

/// Models that a row names at most.
const NAMED: usize = 3;

/// What is found in a published model; `None` if it has no contacts.
fn checked(path: &Path) -> Option<CheckResult> {
    let name = Path::new(path.file_name().unwrap());
    let bytes = std::fs::read(path).unwrap();
    let files = ModelFiles::read(name, bytes, Beside::default(), &InMemory::default()).ok()?;
    let opened = files.open().ok()?;
    let inspector = Inspector::new(&InspectionOptions::default());
    let inspected = inspector.inspect(&opened).ok()?;
    inspector.refuse_without_contacts(&opened, &inspected).ok()?;
    Some(inspector.check(&opened.model, &inspected, None, &InMemory::default()))
}

fn limits() -> String {
    let rows =
        limits::ALL.iter().map(|limit| vec![marked(limit.what), limit.in_words(), marked(limit.source)]);
    table(&["figure", "limit", "source"], rows)
}

/// docs/json.md: the figures of a sphere.
fn figures() -> String {
    let rows = Figure::ALL.iter().map(|figure| {
        let info = figure.info();
        let [unit, equation, limit] = unit_equation_limit(info);
        vec![
            format!("`….{}`", info.name),
            format!("`{}`", info.column()),
            meaning(info),
            unit,
            equation,
            limit,
        ]
    });
    table(&["field", "column in CSV", "meaning", "unit", "equation", "limit"], rows)
}

fn meaning(info: &Quantity) -> String {
    spelled(&info.meaning()).trim_end_matches('.').to_owned()
}

fn unit_equation_limit(info: &Quantity) -> [String; 3] {
    let limit = info.limit.map(limits::Limit::in_words).unwrap_or_default();
    [info.unit.to_owned(), info.equation.to_owned(), limit]
}

/// docs/json.md: what a design without a model finds.
fn design_figures() -> String {
    let rows = DesignQuantity::ALL.iter().map(|quantity| {
        let info = quantity.info();
        let [unit, equation, limit] = unit_equation_limit(info);
        vec![format!("`{}`", info.name), meaning(info), unit, equation, limit]
    });
    table(&["name", "meaning", "unit", "equation", "limit"], rows)
}

/// docs/json.md: the figures of a drop.
fn drop_figures() -> String {
    let rows = DropFigure::ALL.iter().map(|figure| {
        let info = figure.info();
        let of_type = if figure.is_always_known() { "number" } else { "number or null" };
        vec![format!("`{}`", info.name), of_type.to_owned(), meaning(info), info.unit.to_owned()]
    });
    table(&["field", "type", "meaning", "unit"], rows)
}

/// docs/json.md: the series of a drop.
fn drop_series() -> String {
    let rows = DropColumn::ALL.iter().map(|column| {
        let info = column.info();
        vec![format!("`series.{}`", info.name), meaning(info), info.unit.to_owned()]
    });
    table(&["field", "meaning", "unit"], rows)
}

/// docs/drop-test.md: the rows of the table, in their order.
fn drop_rows() -> String {
    let rows = [DropRow::Here, DropRow::Last].into_iter().flat_map(|place| {
        DropFigure::ALL.iter().filter(move |figure| figure.row() == place).map(|figure| {
            let info = figure.info();
            let [unit, _, limit] = unit_equation_limit(info);
            vec![marked(info.heading_without_unit().trim()), meaning(info), unit, limit]
        })
    });
    table(&["figure", "is", "unit", "limit"], rows)
}

fn errors(group: ErrorGroup) -> String {
    let header = match group {
        ErrorGroup::Question => ["code", "question", "answer"],
        _ => ["code", "means", "way out"],
    };
    let rows = group
        .errors()
        .iter()
        .map(|error| vec![format!("`{}`", error.code), spelled(&error.means()), spelled(&error.way_out())]);
    table(&header, rows)
}

/// docs/errors.md: what the exit status says.
fn exit_statuses() -> String {
    let row = |status: &ExitStatus| vec![status.code().to_string(), status.meaning().to_owned()];
    table(&["status", "means"], ExitStatus::ALL.iter().map(row))
}

/// docs/requests.md: the verbs that take a request, each with its schema.
fn verbs() -> String {
    let asked = Verb::ALL.iter().filter(|verb| schema_of(**verb).is_some()).map(|verb| verb.name());
    asked.map(|name| format!("- [`{name}`](../schemas/requests/{name}.schema.json)\n")).collect()
}

/// Each part: its page, its name, its text.
fn parts() -> Vec<(&'static str, &'static str, String)> {
    let published = published().map(|text| ("check.md", "published", text));
    let others = vec![
        ("warnings.md", "findings", findings()),
        ("check.md", "looked-for", looked_for()),
        ("check.md", "repairs", repairs()),
        ("check.md", "limits", limits()),
        ("json.md", "figures", figures()),
        ("json.md", "design-figures", design_figures()),
        ("json.md", "drop-figures", drop_figures()),
        ("json.md", "drop-series", drop_series()),
        ("drop-test.md", "drop-test-figures", drop_rows()),
        ("requests.md", "verbs", verbs()),
        ("errors.md", "exit-statuses", exit_statuses()),
        ("errors.md", "errors-file", errors(ErrorGroup::File)),
        ("errors.md", "errors-model", errors(ErrorGroup::Model)),
        ("errors.md", "errors-question", errors(ErrorGroup::Question)),
        ("errors.md", "errors-request", errors(ErrorGroup::Request)),
    ];
    others.into_iter().chain(published).collect()
}

fn page(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name)
}

/// The page with `text` between the marks of the part.
fn replaced(page: &str, name: &str, text: &str) -> Option<String> {
    let (begin, end) = (format!("<!-- begin {name} -->\n"), format!("<!-- end {name} -->"));
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}\n{text}\n{end}{after}"))
}

#[test]
fn the_documents_say_what_the_registers_say() {
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut differ = Vec::new();
    for (name, part, text) in parts() {
        let path = page(name);
        let now = std::fs::read_to_string(&path).unwrap();
        let new = replaced(&now, part, &text).unwrap_or_else(|| panic!("{name} has no marks of {part}"));
        if update && new != now {
            std::fs::write(&path, new).unwrap();
        } else if new != now {
            differ.push(format!("docs/{name}, part {part}"));
        }
    }
    assert!(
        differ.is_empty(),
        "not what the registers say (UPDATE_DOCS=1 cargo test --test generated writes them): {}",
        differ.join("; ")
    );
}

#[test]
fn a_changed_text_is_noticed() {
    let page = "before\n<!-- begin x -->\n\nold\n<!-- end x -->\nafter\n";
    assert_eq!(
        replaced(page, "x", "old").as_deref(),
        Some("before\n<!-- begin x -->\n\nold\n<!-- end x -->\nafter\n")
    );
    assert_ne!(replaced(page, "x", "new").as_deref(), Some(page));
    assert_eq!(replaced(page, "y", "new"), None);
}
