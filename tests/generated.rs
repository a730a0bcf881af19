//! Compares parts of docs/ with texts from the registers of the program and from `schemas/`: findings, errors, limits and records; and with
//! the names of all source files.
//! A part is between `<!-- begin NAME -->` and `<!-- end NAME -->`. To write all parts again: `UPDATE_DOCS=1 cargo test --test generated`.

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

/// Spells options and calls as on the command line, marked as code of Markdown.
struct Markdown;

impl Dialect for Markdown {
    fn input(&self, input: Input, example: Option<&Example>) -> String {
        format!("`{}`", CommandLine.input(input, example))
    }

    fn call(&self, call: &Call) -> String {
        format!("`{}`", CommandLine.call(call))
    }
}

/// A phrase as Markdown, with options and calls marked as code.
fn phrase_as_markdown(phrase: &Phrase) -> String {
    as_markdown(&phrase.spelled(&Markdown))
}

/// The text as Markdown: characters outside of code are escaped, and the path of a page in docs/ becomes a link.
fn as_markdown(text: &str) -> String {
    let pieces = text.split('`').enumerate().map(|(index, piece)| match index % 2 {
        0 => piece.replace('*', "\\*").replace('<', "\\<").replace('|', "\\|"),
        _ => format!("`{}`", piece.replace('|', "\\|")),
    });
    let words = pieces.collect::<String>();
    let words = words.split(' ').map(|word| {
        match word.split_once("docs/").and_then(|(before, page)| Some((before, page.split_once(".md")?))) {
            Some((before, (page, after))) => format!("{before}[{page}]({DOCS_MARK}{page}.md){after}"),
            None => word.to_owned(),
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// The start of links to other pages, which `generated_parts_of_the_docs_are_up_to_date` replaces by a relative path.
const DOCS_MARK: &str = "docs:";

/// A table in Markdown. No blanks are beside its bars, because bars between blanks would count as words of the page.
fn markdown_table(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut text = format!("|{}|\n|{}\n", header.join("|"), "---|".repeat(header.len()));
    for row in rows {
        text.push_str(&format!("|{}|\n", row.join("|")));
    }
    text
}

/// The text up to its first full stop, semicolon, colon, remark in brackets or subordinate clause. `explain` prints the whole text.
fn first_clause(text: &str) -> String {
    let is_number = |at: usize| text[at..].starts_with(|c: char| !c.is_ascii_lowercase());
    let bracket = text.match_indices(" (").map(|(at, _)| at).find(|at| !is_number(at + 2));
    let ends =
        [". ", "; ", ": ", ", which ", ", such as ", ", so "].into_iter().filter_map(|end| text.find(end));
    text[..ends.chain(bracket).min().unwrap_or(text.len())].trim_end_matches('.').to_owned()
}

/// The first sentence of the text; the first two sentences if the first begins with "Nothing".
fn first_sentence(text: &str) -> String {
    let end = text.find(". ").filter(|_| !text.starts_with("Nothing"));
    text[..end.unwrap_or(text.len())].to_owned()
}

/// The part of docs/reference/findings.md with the codes of a severity, in the order in which `check` searches for them.
fn findings_table(severity: Severity) -> String {
    let rows = rules::all().iter().filter(|rule| rule.severity == severity).map(|rule| {
        let check = match rule.repair {
            Repair::OnlyInChange(_) => "no",
            Repair::Command(_) => "command",
            Repair::NotPossible(_) => "yes",
        };
        let [what, advice] = [rule.what(), rule.advice()].map(|text| phrase_as_markdown(&text));
        vec![format!("`{}`", rule.code), first_clause(&what), first_sentence(&advice), check.to_owned()]
    });
    markdown_table(&["code", "what it is", "what to do", "`check`"], rows)
}

/// The part of docs/check.md with the number of published models that each rule finds; `None` without published models.
fn published_models_table() -> Option<String> {
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
    let mut models_by_code: BTreeMap<(Reverse<Severity>, FindingCode), Vec<String>> = BTreeMap::new();
    let checked: Vec<CheckResult> = names.iter().filter_map(|path| check_published(path)).collect();
    for result in &checked {
        let name = result.model.trim_end_matches(".osim").to_owned();
        let kinds: BTreeSet<_> =
            result.findings.iter().map(|one| (Reverse(one.severity), one.code())).collect();
        kinds.into_iter().for_each(|kind| models_by_code.entry(kind).or_default().push(name.clone()));
    }
    let rows = models_by_code.into_iter().map(|((severity, code), models)| {
        let names_of_few = if models.len() <= MOST_NAMED_RECORDS { models.join(", ") } else { String::new() };
        vec![format!("`{code}`"), severity.0.as_str().to_owned(), models.len().to_string(), names_of_few]
    });
    let with_warnings =
        checked.iter().filter(|result| result.counts.error + result.counts.warning > 0).count();
    let all = checked.len();
    let table = markdown_table(&["code", "severity", "models", "which, where they are few"], rows);
    Some(format!(
        "Published models with contacts: {all}. With an error or a warning: {with_warnings}.\n\n{table}"
    ))
}

/// Most models that a row of the table names.
const MOST_NAMED_RECORDS: usize = 3;

/// The findings of a published model; `None` if it has no contacts.
fn check_published(path: &Path) -> Option<CheckResult> {
    let name = Path::new(path.file_name().unwrap());
    let bytes = std::fs::read(path).unwrap();
    let files = ModelFiles::read(name, bytes, CompanionPaths::default(), &InMemory::default()).ok()?;
    let opened = files.open().ok()?;
    let inspector = Inspector::new(&InspectionOptions::default());
    let inspected = inspector.inspect(&opened).ok()?;
    inspector.refuse_without_contacts(&opened, &inspected).ok()?;
    Some(inspector.check(&opened.model, &inspected, None, &InMemory::default()))
}

fn limits_table() -> String {
    let rows = limits::ALL
        .iter()
        .map(|limit| vec![as_markdown(limit.what), limit.in_words(), as_markdown(limit.source)]);
    markdown_table(&["figure", "limit", "source"], rows)
}

/// The part of docs/reference/json.md about the computed numbers of a sphere.
fn figures_table() -> String {
    let rows = Figure::ALL.iter().map(|figure| {
        let info = figure.info();
        let limit = info.limit.map(limits::Limit::in_words).unwrap_or_default();
        let [name, column] =
            [info.name.to_owned(), info.column().to_string()].map(|name| format!("`{name}`"));
        vec![name, column, info.equation.to_owned(), limit]
    });
    markdown_table(&["field", "column in CSV", "equation", "limit"], rows)
}

/// The part of docs/reference/json.md about the values that a design without a model computes.
fn design_figures_table() -> String {
    let rows = DesignQuantity::ALL.iter().map(|quantity| {
        let info = quantity.info();
        vec![format!("`{}`", info.name), info.unit.to_owned(), info.equation.to_owned()]
    });
    markdown_table(&["`name`", "unit", "equation"], rows)
}

/// The first of several ways out in the text about an error.
fn first_way_out(text: &str) -> String {
    text.split(", or ").next().unwrap_or_default().to_owned()
}

fn errors_table(group: ErrorGroup) -> String {
    let header = match group {
        ErrorGroup::Question => ["code", "question", "answer"],
        _ => ["code", "means", "way out"],
    };
    let rows = group.errors().iter().map(|error| {
        [
            format!("`{}`", error.code),
            first_clause(&phrase_as_markdown(&error.means())),
            first_way_out(&first_clause(&phrase_as_markdown(&error.way_out()))),
        ]
    });
    markdown_table(&header, rows.map(Vec::from))
}

/// The part of docs/reference/errors.md with the meanings of the exit status.
fn exit_statuses_table() -> String {
    let row = |status: &ExitStatus| vec![status.code().to_string(), status.meaning().to_owned()];
    markdown_table(&["status", "means"], ExitStatus::ALL.iter().map(row))
}

/// Names of files that the list of source files omits, because every crate, package or folder has them.
const OMITTED_NAMES: [&str; 5] = ["lib", "main", "mod", "__init__", "__main__"];
/// Most characters of a line in the list of source files.
const LIST_WIDTH: usize = 120;

/// The part of docs/developers/architecture.md with the names of all source files that people write.
fn list_of_files() -> String {
    let mut lines = Vec::new();
    for name in entries_of("crates/") {
        list_folder(&mut lines, &format!("crates/{name}/src/"), "", ".rs");
    }
    list_folder(&mut lines, "python/osim_contact_scale/", "", ".py");
    list_folder(&mut lines, "web/src/", "", ".ts");
    format!("```text\n{}\n```\n", lines.join("\n"))
}

/// Adds to `lines` the names of the files with an ending in the folder `inside` of the folder `top`, and in the folders below it.
fn list_folder(lines: &mut Vec<String>, top: &str, inside: &str, ending: &str) {
    let folder = format!("{top}{inside}");
    let entries = entries_of(&folder);
    let is_written_by_hand = |name: &str| {
        let text = std::fs::read_to_string(project_path(&format!("{folder}{name}{ending}"))).unwrap();
        text.lines().next().is_none_or(|line| !line.contains("do not edit"))
    };
    let sources: Vec<&str> = entries.iter().filter_map(|name| name.strip_suffix(ending)).collect();
    let mut line = if inside.is_empty() { folder.clone() } else { format!("  {inside}") };
    for &name in sources.iter().filter(|name| !OMITTED_NAMES.contains(name) && is_written_by_hand(name)) {
        if line.len() + 1 + name.len() > LIST_WIDTH {
            lines.push(std::mem::replace(&mut line, "   ".to_owned()));
        }
        line.push_str(&format!(" {name}"));
    }
    if !sources.is_empty() {
        lines.push(line);
    }
    for name in entries.iter().filter(|name| project_path(&format!("{folder}{name}")).is_dir()) {
        list_folder(lines, top, &format!("{inside}{name}/"), ending);
    }
}

/// The sorted names of everything in a folder of the project.
fn entries_of(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(project_path(folder)).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// All generated parts of docs/: the page, the name and the text of each.
fn parts_of_pages() -> Vec<(&'static str, &'static str, String)> {
    const FINDINGS_PAGE: &str = "reference/findings.md";
    const ERRORS_PAGE: &str = "reference/errors.md";
    const JSON_PAGE: &str = "reference/json.md";
    let published = published_models_table().map(|text| ("check.md", "published", text));
    let others = vec![
        (FINDINGS_PAGE, "findings-error", findings_table(Severity::Error)),
        (FINDINGS_PAGE, "findings-warning", findings_table(Severity::Warning)),
        (FINDINGS_PAGE, "findings-remark", findings_table(Severity::Remark)),
        ("check.md", "limits", limits_table()),
        (JSON_PAGE, "figures", figures_table()),
        (JSON_PAGE, "design-figures", design_figures_table()),
        (ERRORS_PAGE, "exit-statuses", exit_statuses_table()),
        (ERRORS_PAGE, "errors-file", errors_table(ErrorGroup::File)),
        (ERRORS_PAGE, "errors-model", errors_table(ErrorGroup::Model)),
        (ERRORS_PAGE, "errors-question", errors_table(ErrorGroup::Question)),
        (ERRORS_PAGE, "errors-request", errors_table(ErrorGroup::Request)),
        ("developers/architecture.md", "files", list_of_files()),
    ];
    let records = records::PARTS_OF_JSON_PAGE
        .iter()
        .map(|(part, schemas)| (JSON_PAGE, *part, records::table_of_records(schemas)));
    others.into_iter().chain(records).chain(published).collect()
}

fn page_path(name: &str) -> PathBuf {
    project_path("docs").join(name)
}

fn project_path(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// The page with `text` between the marks of the part `name`.
fn with_part_replaced(page: &str, name: &str, text: &str) -> Option<String> {
    let (begin, end) = (format!("<!-- begin {name} -->\n"), format!("<!-- end {name} -->"));
    let (before, rest) = page.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}\n{text}\n{end}{after}"))
}

#[test]
fn generated_parts_of_the_docs_are_up_to_date() {
    let update = std::env::var_os("UPDATE_DOCS").is_some();
    let mut differ = Vec::new();
    for (name, part, text) in parts_of_pages() {
        let path = page_path(name);
        let current = std::fs::read_to_string(&path).unwrap();
        let to_docs = "../".repeat(name.matches('/').count());
        let new = with_part_replaced(
            &current,
            part,
            &text.replace(&format!("]({DOCS_MARK}"), &format!("]({to_docs}")),
        )
        .unwrap_or_else(|| panic!("{name} has no marks of {part}"));
        if update && new != current {
            std::fs::write(&path, new).unwrap();
        } else if new != current {
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
fn a_changed_part_of_a_generated_page_is_detected() {
    let page = "before\n<!-- begin x -->\n\nold\n<!-- end x -->\nafter\n";
    assert_eq!(
        with_part_replaced(page, "x", "old").as_deref(),
        Some("before\n<!-- begin x -->\n\nold\n<!-- end x -->\nafter\n")
    );
    assert_ne!(with_part_replaced(page, "x", "new").as_deref(), Some(page));
    assert_eq!(with_part_replaced(page, "y", "new"), None);
}
