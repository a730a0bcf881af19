//! Many models in one table: a row for each model, and as many columns as fit into a line.

use osim_inspect::{Counts, Figure, InspectedForce, Inspection, SphereFigures};
use osim_model::messages::{Dialect, Phrase, counted, four_significant, named, shown, three_significant};
use osim_model::{Property, least_and_most};

use crate::report::layout::{
    Colour, OUTSIDE_MARK, WIDTH, colour_marks, shorten, table, wrapped, wrapped_with_path,
};
use crate::report::messages::{NO_CONTACTS_CELL, failure_in_cell};

named! {
    /// The columns after the name of the model, in the order of the table, with their headings.
    enum Column {
        Mass = "kg",
        Spheres = "n",
        Class = "class",
        Stiffness = "E1*",
        Radius = "R",
        Indentation = "x/R",
        Restitution = "c_r",
        Findings = "findings",
    }
}

/// The columns that are left out on a narrow terminal, in this order.
const COLUMNS_LEFT_OUT: [Column; 5] =
    [Column::Restitution, Column::Radius, Column::Class, Column::Stiffness, Column::Spheres];

/// The width in columns that long names of models keep at least.
const LEAST_NAME_WIDTH: usize = 18;

/// The number of blanks between two columns of the table.
const COLUMN_GAP: usize = 2;

/// The models of one call, collected for a table.
#[derive(Debug, Default)]
pub struct ModelsTable {
    rows: Vec<(String, Cells)>,
    with_findings: usize,
    without_contacts: usize,
    failed: usize,
}

/// The cells of a row, in the order of [`Column::ALL`].
type Cells = Vec<String>;

impl Column {
    /// The meaning of the column's heading; empty if the heading says it.
    const fn meaning(self) -> &'static str {
        match self {
            Self::Mass => "kg: mass of the model",
            Self::Findings => "",
            Self::Spheres => "n: spheres that share the body weight, of how many",
            Self::Class => "class: of the contact forces",
            Self::Stiffness => "E1*: OpenSim's stiffness, N/m2",
            Self::Radius => "R: radius of the spheres, m",
            Self::Indentation => {
                "x/R: deepest indentation at rest over the radius, by the force law of that class"
            }
            Self::Restitution => "c_r: lowest coefficient of restitution",
        }
    }

    /// Whether the column has numbers, which are aligned on the right.
    const fn is_number(self) -> bool {
        !matches!(self, Self::Class | Self::Findings)
    }

    fn cell(self, inspected: &Inspection, counts: Counts) -> String {
        match self {
            Self::Mass => inspected.mass_kg.map_or_else(|| "?".to_owned(), four_significant),
            Self::Spheres if inspected.spheres.is_empty() => MISSING_VALUE.to_owned(),
            Self::Spheres => format!("{} of {}", sharing_spheres(inspected), inspected.spheres.len()),
            Self::Class => class_of_forces(inspected).to_owned(),
            Self::Stiffness => {
                let values =
                    chosen_forces(inspected).filter_map(|force| force.parameter(Property::Stiffness));
                range_in_words(values, powers_of_ten)
            }
            Self::Radius => range_in_words(
                sphere_figures(inspected).filter_map(|sphere| sphere.value(Figure::Radius)),
                four_significant,
            ),
            Self::Indentation => {
                worst_in_words(sphere_figures(inspected).filter_map(indentation_at_rest), f64::max)
            }
            Self::Restitution => {
                worst_in_words(sphere_figures(inspected).filter_map(judged_restitution), f64::min)
            }
            Self::Findings => findings_in_words(inspected, counts),
        }
    }
}

impl ModelsTable {
    /// Adds a model that was inspected, with the numbers of its findings.
    pub fn add(&mut self, inspected: &Inspection, counts: Counts) {
        self.with_findings += usize::from(counts.error + counts.warning > 0);
        self.without_contacts += usize::from(inspected.forces.is_empty());
        let cells = Column::ALL.iter().map(|column| column.cell(inspected, counts)).collect();
        self.rows.push((inspected.model.clone(), cells));
    }

    /// Adds a model that could not be inspected, because of a failure with this code.
    pub fn add_failed(&mut self, model: &str, code: &str) {
        let why = failure_in_cell(code);
        *(if why == NO_CONTACTS_CELL { &mut self.without_contacts } else { &mut self.failed }) += 1;
        let cell = |column| if column == Column::Findings { why } else { "" };
        let cells = Column::ALL.iter().map(|&column| cell(column).to_owned()).collect();
        self.rows.push((model.to_owned(), cells));
    }

    /// One row for each model in lines of at most `width` columns, then the meanings of the headings, and the number of models.
    ///
    /// Names are whole and no column is left out where lines have no end, in a file or a pipe. `names_full`: the front end can ask for
    /// all models in full.
    pub fn text(
        &self,
        width: Option<usize>,
        dialect: &dyn Dialect,
        colour: Colour,
        names_full: bool,
    ) -> String {
        // A line with an end has no room for the folder that they are all in.
        let folder = width.map(|_| self.common_folder()).unwrap_or_default();
        let (columns, name_width) = self.columns_that_fit(width, folder);
        let headings: Vec<&str> =
            std::iter::once("model").chain(columns.iter().map(|column| column.as_str())).collect();
        let mut table = table(&headings);
        for (name, cells) in &self.rows {
            let name = name.strip_prefix(folder).unwrap_or(name);
            let name = name_width.map_or_else(|| name.to_owned(), |width| shorten(name, width));
            let shown = Column::ALL.iter().zip(cells).filter(|(column, _)| columns.contains(column));
            table.add_row(std::iter::once(&name).chain(shown.map(|(_, cell)| cell)));
        }
        let numbers = columns.iter().enumerate().filter(|(_, column)| column.is_number());
        table.right_aligned(&numbers.map(|(index, _)| index + 1).collect::<Vec<_>>());
        let table = colour_marks(&format!("{}\n", table.trim_fmt()), colour);
        let folder = if folder.is_empty() {
            String::new()
        } else {
            wrapped_with_path(folder, "", "", width.unwrap_or(WIDTH))
        };
        format!(
            "{folder}{table}\n{}{}",
            legend_of_columns(&columns, dialect, names_full, width.unwrap_or(WIDTH)),
            self.counted_models()
        )
    }

    /// The folder that has all models, with the separator at its end; empty if there is none.
    fn common_folder(&self) -> &str {
        let mut names = self.rows.iter().map(|(name, _)| name.as_str());
        let first = names.next().unwrap_or_default();
        names.fold(folder_of(first), |common, name| {
            let alike = common.char_indices().zip(name.chars()).take_while(|((_, a), b)| a == b);
            let end = alike.last().map_or(0, |((at, letter), _)| at + letter.len_utf8());
            folder_of(common.get(..end).unwrap_or_default())
        })
    }

    /// The columns that fit into lines of at most `width` columns, and the largest width of names; `None` if lines have no limit.
    fn columns_that_fit(&self, width: Option<usize>, folder: &str) -> (Vec<Column>, Option<usize>) {
        let mut columns = Column::ALL.to_vec();
        let Some(width) = width else { return (columns, None) };
        let longest = self
            .rows
            .iter()
            .map(|(name, _)| shown(name.strip_prefix(folder).unwrap_or(name)).to_string().chars().count())
            .max();
        let wanted = longest.unwrap_or_default().clamp("model".len(), LEAST_NAME_WIDTH);
        let room = |columns: &[Column]| {
            let taken: usize = columns.iter().map(|&column| self.width(column) + COLUMN_GAP).sum();
            width.saturating_sub(taken + COLUMN_GAP)
        };
        for left_out in COLUMNS_LEFT_OUT {
            if room(&columns) >= wanted {
                break;
            }
            columns.retain(|&column| column != left_out);
        }
        let room = room(&columns).max("model".len());
        (columns, Some(room))
    }

    fn width(&self, column: Column) -> usize {
        let cells = self.rows.iter().flat_map(|(_, cells)| Column::ALL.iter().zip(cells));
        let own = cells.filter(|(of, _)| **of == column).map(|(_, cell)| cell.chars().count());
        own.max().unwrap_or_default().max(column.as_str().chars().count())
    }

    fn counted_models(&self) -> String {
        let models = self.rows.len();
        let mut text = counted(models, "model");
        for (count, what) in [
            (self.with_findings, "with errors or warnings"),
            (self.without_contacts, "without contacts"),
            (self.failed, "not read"),
        ] {
            if count > 0 {
                text.push_str(&format!(", {count} {what}"));
            }
        }
        format!("{text}\n")
    }
}

/// The folders in a path, with the separator at the end.
fn folder_of(name: &str) -> &str {
    name.rfind(['/', '\\']).and_then(|end| name.get(..=end)).unwrap_or_default()
}

/// A legend: the meanings of the headings, the columns that are left out, and the commands that show more.
fn legend_of_columns(columns: &[Column], dialect: &dyn Dialect, names_full: bool, width: usize) -> String {
    let meanings = columns.iter().map(|column| column.meaning()).filter(|meaning| !meaning.is_empty());
    let meanings: Vec<&str> = meanings.collect();
    let mut text =
        wrapped(&format!("({}; {OUTSIDE_MARK}: outside the limit)", meanings.join("; ")), " ", width);
    let left_out: Vec<&str> = COLUMNS_LEFT_OUT
        .iter()
        .filter(|column| !columns.contains(column))
        .map(|column| column.as_str())
        .collect();
    if !left_out.is_empty() {
        let left_out = format!(
            "(left out for want of room: {}; a wider terminal or a file has all)",
            left_out.join("; ")
        );
        text.push_str(&wrapped(&left_out, " ", width));
    }
    let more = Phrase::template(if names_full {
        "One model in full: `inspect MODEL`; all of them: `full`. What was found: `check MODEL`."
    } else {
        "One model in full: `inspect MODEL`. What was found: `check MODEL`."
    });
    text.push_str(&wrapped(&more.spelled(dialect), "", width));
    text
}

fn sphere_figures(inspected: &Inspection) -> impl Iterator<Item = &SphereFigures> {
    inspected.figures.limbs.iter().flat_map(|limb| &limb.spheres)
}

/// The forces that OpenSim computes and that a change would change.
fn chosen_forces(inspected: &Inspection) -> impl Iterator<Item = &InspectedForce> {
    inspected.forces.iter().filter(|force| force.applies && force.selected)
}

/// The number n of spheres that share the weight, if it is known; if limbs differ, the smallest and the largest n.
fn sharing_spheres(inspected: &Inspection) -> String {
    let text =
        range_in_words(inspected.figures.limbs.iter().filter_map(|limb| limb.sphere_count), four_significant);
    if text == MISSING_VALUE { "?".to_owned() } else { text }
}

/// The text in place of a value that is missing.
const MISSING_VALUE: &str = "-";

fn class_of_forces(inspected: &Inspection) -> &'static str {
    let is_smooth = |force: &InspectedForce| force.parameter(Property::HertzSmoothing).is_some();
    match (chosen_forces(inspected).any(is_smooth), chosen_forces(inspected).any(|force| !is_smooth(force))) {
        (true, true) => "both",
        (true, false) => "smooth",
        (false, true) => "HuntCrossley",
        (false, false) => MISSING_VALUE,
    }
}

/// x̂ of a sphere under one body weight, by the law of its force's class, and whether it is within its limit.
fn indentation_at_rest(sphere: &SphereFigures) -> Option<(f64, bool)> {
    let known = [Figure::IndentationModelLaw, Figure::Indentation];
    let figure = known.into_iter().find(|&figure| sphere.value(figure).is_some())?;
    Some((sphere.value(figure)?, sphere.is_within(figure) != Some(false)))
}

/// The restitution by the contact law itself, judged by the limit that the paper gives with (13), so that the mark is about the number
/// beside it.
fn judged_restitution(sphere: &SphereFigures) -> Option<(f64, bool)> {
    let value = sphere.value(Figure::RestitutionExact)?;
    let limit = Figure::RestitutionApproximate.info().limit;
    Some((value, limit.is_none_or(|limit| limit.admits(value))))
}

/// The value with three digits and a power of ten, because moduli have many zeros.
fn powers_of_ten(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    format!("{rounded:e}")
}

/// The value, or the smallest and the largest if there are several.
fn range_in_words(values: impl Iterator<Item = f64>, written: fn(f64) -> String) -> String {
    let (least, most) = least_and_most(values);
    match (written(least), written(most)) {
        _ if least > most => MISSING_VALUE.to_owned(),
        (low, high) if low == high => low,
        (low, high) => format!("{low}-{high}"),
    }
}

/// The worst of all values, as `worse` decides, with a mark if any value is not within its limit.
fn worst_in_words(values: impl Iterator<Item = (f64, bool)>, worse: fn(f64, f64) -> f64) -> String {
    match values.reduce(|a, b| (worse(a.0, b.0), a.1 && b.1)) {
        Some((value, true)) => three_significant(value),
        Some((value, false)) => format!("{} {OUTSIDE_MARK}", three_significant(value)),
        None => MISSING_VALUE.to_owned(),
    }
}

/// The number of findings of the worst severity; or a note that the model has no contacts.
fn findings_in_words(inspected: &Inspection, counts: Counts) -> String {
    // What is found in a model without contacts is that it has none.
    if inspected.forces.is_empty() && counts.error + counts.warning == 0 {
        return NO_CONTACTS_CELL.to_owned();
    }
    counts.only_worst().describe(MISSING_VALUE)
}
