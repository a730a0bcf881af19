//! Parts of docs/ are made from the registers of the program and from `schemas/`: findings, errors, limits, figures and records of all verbs.
//! Such a part is between `<!-- begin NAME -->` and `<!-- end NAME -->`. To write them again: `UPDATE_DOCS=1 cargo test --test generated`.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use contact_scaling::limits;
use osim_inspect::{CheckResult, Figure};
use osim_model::files::{CompanionPaths, InMemory, ModelFiles};
use osim_model::messages::{Call, Dialect, Example, Input, Phrase};
use osim_model::{FindingCode, Repair, Severity};
use osim_planning::{DesignQuantity, Inspector, rules};
use osim_requests::options::InspectionOptions;
use osim_requests::spell::CommandLine;
use osim_view::report::ExitStatus;
use osim_view::report::explain::ErrorGroup;

#[path = "generated/records.rs"]
mod records;

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

/// In Markdown: code stays as it is, and a page of docs/ is a link, from the project's top.
fn marked(text: &str) -> String {
    let pieces = text.split('`').enumerate().map(|(index, piece)| match index % 2 {
        0 => piece.replace('*', "\\*").replace('<', "\\<").replace('|', "\\|"),
        _ => format!("`{}`", piece.replace('|', "\\|")),
    });
    let words = pieces.collect::<String>();
    let words = words.split(' ').map(|word| {
        match word.split_once("docs/").and_then(|(before, page)| Some((before, page.split_once(".md")?))) {
            Some((before, (page, after))) => format!("{before}[{page}]({DOCS}{page}.md){after}"),
            None => word.to_owned(),
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// How links to other pages begin until it is known which page has them.
const DOCS: &str = "docs:";

/// No blanks beside the bars: they would count as words.
fn table(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut text = format!("|{}|\n|{}\n", header.join("|"), "---|".repeat(header.len()));
    for row in rows {
        text.push_str(&format!("|{}|\n", row.join("|")));
    }
    text
}

/// Up to its first full stop, semicolon, colon, remark in brackets or clause after it: `explain` has the rest.
fn short(text: &str) -> String {
    let is_number = |at: usize| text[at..].starts_with(|c: char| !c.is_ascii_lowercase());
    let bracket = text.match_indices(" (").map(|(at, _)| at).find(|at| !is_number(at + 2));
    let ends =
        [". ", "; ", ": ", ", which ", ", such as ", ", so "].into_iter().filter_map(|end| text.find(end));
    text[..ends.chain(bracket).min().unwrap_or(text.len())].trim_end_matches('.').to_owned()
}

/// Where it is nothing, what to do otherwise comes in the next one.
fn first_sentence(text: &str) -> String {
    let end = text.find(". ").filter(|_| !text.starts_with("Nothing"));
    text[..end.unwrap_or(text.len())].to_owned()
}

/// docs/reference/findings.md: the codes of a severity, in the order in which they are looked for.
fn findings(severity: Severity) -> String {
    let rows = rules::all().iter().filter(|rule| rule.severity == severity).map(|rule| {
        let check = match rule.repair {
            Repair::OnlyInChange(_) => "no",
            Repair::Command(_) => "command",
            Repair::NotPossible(_) => "yes",
        };
        let [what, advice] = [rule.what(), rule.advice()].map(|text| spelled(&text));
        vec![format!("`{}`", rule.code), short(&what), first_sentence(&advice), check.to_owned()]
    });
    table(&["code", "what it is", "what to do", "`check`"], rows)
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
    let warned = checked.iter().filter(|found| found.counts.error + found.counts.warning > 0).count();
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
    let files = ModelFiles::read(name, bytes, CompanionPaths::default(), &InMemory::default()).ok()?;
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

/// docs/reference/json.md: the figures of a sphere.
fn figures() -> String {
    let rows = Figure::ALL.iter().map(|figure| {
        let info = figure.info();
        let limit = info.limit.map(limits::Limit::in_words).unwrap_or_default();
        let [name, column] =
            [info.name.to_owned(), info.column().to_string()].map(|name| format!("`{name}`"));
        vec![name, column, info.equation.to_owned(), limit]
    });
    table(&["field", "column in CSV, which says what it is", "equation", "limit"], rows)
}

/// docs/reference/json.md: what a design without a model finds.
fn design_figures() -> String {
    let rows = DesignQuantity::ALL.iter().map(|quantity| {
        let info = quantity.info();
        vec![format!("`{}`", info.name), info.unit.to_owned(), info.equation.to_owned()]
    });
    table(&["`name`", "unit", "equation"], rows)
}

/// The first of several.
fn way_out(text: &str) -> String {
    text.split(", or ").next().unwrap_or_default().to_owned()
}

fn errors(group: ErrorGroup) -> String {
    let header = match group {
        ErrorGroup::Question => ["code", "question", "answer"],
        _ => ["code", "means", "way out"],
    };
    let rows = group.errors().iter().map(|error| {
        [
            format!("`{}`", error.code),
            short(&spelled(&error.means())),
            way_out(&short(&spelled(&error.way_out()))),
        ]
    });
    table(&header, rows.map(Vec::from))
}

/// docs/reference/errors.md: what the exit status says.
fn exit_statuses() -> String {
    let row = |status: &ExitStatus| vec![status.code().to_string(), status.meaning().to_owned()];
    table(&["status", "means"], ExitStatus::ALL.iter().map(row))
}

/// Each part: its page, its name, its text.
fn parts() -> Vec<(&'static str, &'static str, String)> {
    const FINDINGS: &str = "reference/findings.md";
    const ERRORS: &str = "reference/errors.md";
    const JSON: &str = "reference/json.md";
    let published = published().map(|text| ("check.md", "published", text));
    let others = vec![
        (FINDINGS, "findings-error", findings(Severity::Error)),
        (FINDINGS, "findings-warning", findings(Severity::Warning)),
        (FINDINGS, "findings-remark", findings(Severity::Remark)),
        ("check.md", "limits", limits()),
        (JSON, "figures", figures()),
        (JSON, "design-figures", design_figures()),
        (ERRORS, "exit-statuses", exit_statuses()),
        (ERRORS, "errors-file", errors(ErrorGroup::File)),
        (ERRORS, "errors-model", errors(ErrorGroup::Model)),
        (ERRORS, "errors-question", errors(ErrorGroup::Question)),
        (ERRORS, "errors-request", errors(ErrorGroup::Request)),
    ];
    let records = records::PARTS.iter().map(|(part, schemas)| (JSON, *part, records::table(schemas)));
    others.into_iter().chain(records).chain(published).collect()
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
        let up = "../".repeat(name.matches('/').count());
        let new = replaced(&now, part, &text.replace(&format!("]({DOCS}"), &format!("]({up}")))
            .unwrap_or_else(|| panic!("{name} has no marks of {part}"));
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
