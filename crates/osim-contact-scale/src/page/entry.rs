//! A model in the table of a library, and its details below.

use maud::{Markup, html};
use osim_patch::{Plan, Property};

use super::explained::Topics;
use super::fragment::{Fragment, header_cell};
use crate::check::Counts;
use crate::explain::{self, ErrorCode};
use crate::failure::Failure;
use crate::look::Inspection;
use crate::report::{four, number};
use crate::run::Record;

pub(super) const MODELS: (&str, &str) = ("models", "Models");
pub(super) const IN_FULL: (&str, &str) = ("in-full", "Each model in full");

/// Factors that differ from place to place.
const UNLIKE: &str = "unlike";

pub(super) const TABLE_END: &str = "</tbody></table></div></section>\n";
pub(super) const DETAILS_BEGIN: &str = "<section id=\"in-full\" aria-labelledby=\"in-full-title\">\
                                        <h2 id=\"in-full-title\">Each model in full</h2>\n";
pub(super) const DETAILS_END: &str = "</section>\n";

/// Which table the models stand in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Columns {
    /// What changed.
    Changes,
    /// What was found.
    Looks,
}

impl Columns {
    fn headers(self) -> &'static [&'static str] {
        match self {
            Self::Changes => &[
                " became",
                "from, kg",
                "to, kg",
                "changes",
                "radius ×",
                "stiffness ×",
                "dissipation ×",
                "said",
                "errors",
                "warnings",
                "remarks",
            ],
            Self::Looks => &[
                " became",
                "weighs, kg",
                "contacts for, kg",
                "spheres per limb",
                "deepest x/R at 1 BW",
                "errors",
                "warnings",
                "remarks",
            ],
        }
    }

    fn explained(self) -> &'static str {
        match self {
            Self::Changes => {
                "From and to: the body mass that the contacts stand for. ×: new over old; “unlike” where it is not \
                 the same everywhere. Said: warnings of the change. Errors, warnings, remarks: findings in the new model."
            }
            Self::Looks => {
                "Deepest x/R: indentation over radius of the sphere that sinks in most under the body weight on one \
                 limb, by the Hertz law."
            }
        }
    }
}

/// What became of one model.
pub(crate) struct Entry {
    pub model: String,
    /// In the order of the columns.
    pub cells: Vec<String>,
    /// Behind its name where its details are closed.
    pub said: String,
    /// Everything else about it; none where it could not be done.
    pub fragment: Option<Box<Fragment>>,
    /// What was wrong, where it could not be done.
    pub error: Option<&'static ErrorCode>,
}

impl Entry {
    /// A model that was changed; `found` in the new one.
    pub(crate) fn of_change(record: &Record, plan: &Plan, found: Counts, fragment: Fragment) -> Self {
        let mass = |kg: Option<f64>| kg.map(number).unwrap_or_default();
        let became = record.status.told().to_owned();
        let mut cells = vec![
            became.clone(),
            mass(record.contacts_mass_from_kg),
            mass(record.contacts_mass_to_kg),
            record.changes.to_string(),
            ratio(plan, Property::Radius),
            ratio(plan, Property::Stiffness),
            ratio(plan, Property::Dissipation),
            some(plan.warnings.len()),
        ];
        cells.extend(counts(found));
        let said = format!("{became}; {} in the new model", found.told("no findings"));
        Self { model: name(record), cells, said, fragment: Some(Box::new(fragment)), error: None }
    }

    /// The same of a model that an earlier run has done.
    pub(crate) fn of_earlier_run(mut self) -> Self {
        for text in self.cells.first_mut().into_iter().chain([&mut self.said]) {
            text.insert_str(0, "done by an earlier run: ");
        }
        self
    }

    /// A model that an earlier run has done, of which there is nothing but the record.
    pub(crate) fn of_earlier_record(record: &Record) -> Self {
        let mass = |kg: Option<f64>| kg.map(number).unwrap_or_default();
        let factor = |factor: Option<f64>, property: Property| match factor {
            Some(factor) => four(factor),
            None if record.unlike.split(' ').any(|name| name == property.name()) => UNLIKE.to_owned(),
            None => String::new(),
        };
        let became = format!("done by an earlier run: {}", record.status.told());
        let cells = vec![
            became.clone(),
            mass(record.contacts_mass_from_kg),
            mass(record.contacts_mass_to_kg),
            record.changes.to_string(),
            factor(record.radius_factor, Property::Radius),
            factor(record.stiffness_factor, Property::Stiffness),
            factor(record.dissipation_factor, Property::Dissipation),
            some(record.warnings.split_whitespace().count()),
        ];
        Self { model: name(record), cells, said: became, fragment: None, error: None }
    }

    /// A model that was to be changed, and of which there is nothing but the record.
    pub(crate) fn of_record(record: &Record) -> Self {
        let became = match &record.error {
            Some(error) => format!("{}: {}{error}", record.status.told(), place(record.line, record.column)),
            None => record.status.told().to_owned(),
        };
        let error = record.error_code.as_deref().and_then(explain::error);
        Self { error, ..Self::not_done(&name(record), became) }
    }

    /// A model that was looked at.
    pub(crate) fn of_inspection(seen: &Inspection, found: Counts, fragment: Fragment) -> Self {
        let hertz = |sphere: &crate::look::SphereFigures| sphere.load(1.0).and_then(|load| load.hertz);
        let deepest = seen.figures.spheres().filter_map(hertz).reduce(f64::max);
        let mut cells = vec![
            "read".to_owned(),
            seen.mass_kg.map(number).unwrap_or_default(),
            seen.contacts_mass_kg.as_ref().map(|mass| number(mass.value)).unwrap_or_default(),
            seen.spheres_per_limb.map(|count| count.to_string()).unwrap_or_default(),
            deepest.map(four).unwrap_or_default(),
        ];
        cells.extend(counts(found));
        let said = found.told("no findings");
        Self { model: seen.model.clone(), cells, said, fragment: Some(Box::new(fragment)), error: None }
    }

    /// A model that could not be read.
    pub(crate) fn lost(failure: &Failure) -> Self {
        let became = format!("failed: {}{}", place(failure.line, failure.column), failure.message);
        Self { error: explain::error(failure.code), ..Self::not_done(&failure.model, became) }
    }

    /// A model of a folder that has no contacts.
    pub(crate) fn passed_over(model: &str) -> Self {
        Self::not_done(model, "passed over: no contacts".to_owned())
    }

    /// A model of which there is nothing but what became of it.
    pub(crate) fn not_done(model: &str, became: String) -> Self {
        Self {
            model: model.to_owned(),
            cells: vec![became.clone()],
            said: became,
            fragment: None,
            error: None,
        }
    }
}

/// The model; in a manifest, where several rows may use one, with its row and what comes of it.
fn name(record: &Record) -> String {
    match (record.row, &record.output) {
        (Some(row), Some(output)) => format!("row {row}: {} → {output}", record.model),
        (Some(row), None) => format!("row {row}: {}", record.model),
        (None, _) => record.model.clone(),
    }
}

/// Where in the model something is wrong.
fn place(line: Option<usize>, column: Option<usize>) -> String {
    match (line, column) {
        (Some(line), Some(column)) => format!("line {line}, column {column}: "),
        _ => String::new(),
    }
}

/// New over old, where it is the same everywhere.
fn ratio(plan: &Plan, property: Property) -> String {
    let mut ratios = plan.changes.iter().filter(|change| change.property == property).map(|c| c.to / c.from);
    let Some(first) = ratios.next() else { return String::new() };
    let same = |ratio: f64| four(ratio) == four(first);
    if ratios.all(same) { four(first) } else { UNLIKE.to_owned() }
}

fn counts(found: Counts) -> [String; 3] {
    [found.error, found.warn, found.info].map(some)
}

fn some(count: usize) -> String {
    if count == 0 { "–".to_owned() } else { count.to_string() }
}

/// The table as far as its first row; `left_out` says what the page does not show.
pub(super) fn table_opening(columns: Columns, left_out: &[String]) -> String {
    let (id, title) = MODELS;
    let before = html! {
        h2 id="models-title" { (title) }
        @for text in left_out { p.note { (text) } }
    };
    let head = html! {
        caption { span { (columns.explained()) } }
        thead { tr { th scope="col" { "model" } @for header in columns.headers() { (header_cell(header)) } } }
    };
    let (before, head) = (before.0, head.0);
    format!(
        "<section id=\"{id}\" aria-labelledby=\"models-title\">{before}\
         <div class=\"wide\" role=\"region\" aria-label=\"{title}\" tabindex=\"0\">\
         <table class=\"models\">{head}<tbody>\n"
    )
}

/// The row of model `number`, linked to its details where it has some.
pub(super) fn row(
    entry: &Entry,
    columns: Columns,
    (number, in_full): (usize, bool),
    topics: &mut Topics,
) -> String {
    let missing = columns.headers().len().saturating_sub(entry.cells.len());
    let row = html! {
        tr {
            th scope="row" {
                @if in_full { a href={ "#model-" (number) } { (entry.model) } } @else { (entry.model) }
            }
            @for (index, cell) in entry.cells.iter().enumerate() {
                @if index == 0 { td.words { (cell) (code(entry, topics)) } } @else { td { (cell) } }
            }
            @for _ in 0..missing { td {} }
        }
    };
    format!("{}\n", row.0)
}

/// Everything about model `number`, closed until somebody asks.
///
/// The anchor stands inside: a browser that follows a link into closed details opens them.
pub(super) fn details(entry: &Entry, number: usize, inside: &str) -> String {
    let summary = html! { h3 { (entry.model) } " " span.quiet { (entry.said) } };
    format!(
        "<details><summary>{}</summary><div class=\"model\" id=\"model-{number}\">{inside}</div></details>\n",
        summary.0
    )
}

/// The one model of a page, where there is nothing to show of it.
pub(super) fn alone(entry: &Entry, topics: &mut Topics) -> String {
    html! { p.note { b { (entry.model) } ": " (entry.said) (code(entry, topics)) } }.0
}

/// The code of what was wrong, linked to its explanation.
fn code(entry: &Entry, topics: &mut Topics) -> Markup {
    html! { @if let Some(error) = entry.error { " [" (topics.error(error)) "]" } }
}
