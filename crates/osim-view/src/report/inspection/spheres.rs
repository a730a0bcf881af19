//! The figures of spheres: as rows for the text and the page, as a table, and as CSV.

use std::collections::{HashMap, HashSet};

use osim_inspect::{
    Figure, FigureVisibility, Figures, InspectedForce, Inspection, LimbFigures, Quantity, SphereFigures,
};
use osim_model::messages::{Dialect, Phrase, four_significant, shortest};
use osim_model::{Class, Property};

use crate::report::extent::{Extent, Layout};
use crate::report::layout::{OUTSIDE_MARK, csv_text, table};

/// Properties of the spheres in a table, which decide on its rows.
#[derive(Clone, Copy)]
pub struct Spheres {
    /// Whether the spheres of a limb differ in radius or parameters.
    pub mixed: bool,
    /// Whether some of the spheres follow the smoothed law.
    pub smooth: bool,
}

impl Spheres {
    /// The properties of `spheres`. `mixed` says that the spheres of a limb differ.
    pub fn new<'s>(mixed: bool, mut spheres: impl Iterator<Item = &'s SphereFigures>) -> Self {
        let smooth = spheres.any(|sphere| sphere.value(Figure::ConstantIndentation).is_some());
        Self { mixed, smooth }
    }

    /// The figures that a table of these spheres shows, in their order.
    pub fn figures(self) -> impl Iterator<Item = Figure> {
        let shown = move |figure: &Figure| match figure.visibility() {
            FigureVisibility::Always => true,
            FigureVisibility::Never => false,
            FigureVisibility::IfSmooth => self.smooth,
            FigureVisibility::IfMixed => self.mixed,
            FigureVisibility::IfMixedAndSmooth => self.mixed && self.smooth,
        };
        Figure::ALL.iter().copied().filter(shown)
    }
}

/// The first cell of a row: the name of the figure; for restitution with the impact speed (m/s), if it is known.
pub fn heading(figure: Figure, impact_speed_m_s: Option<f64>, extent: Extent) -> String {
    match (figure, impact_speed_m_s) {
        (Figure::RestitutionExact, Some(speed)) => {
            format!("restitution at {} m/s", extent.number(speed, four_significant))
        }
        _ => figure.info().heading(),
    }
}

/// The second cell of a row: the limit of the figure.
pub fn limit(figure: Figure) -> String {
    figure.info().limit.map(ToString::to_string).unwrap_or_default()
}

/// A number of a sphere as the table shows it.
pub struct FigureText {
    pub text: String,
    /// Whether the figure is outside its limit.
    pub outside: bool,
}

/// The figure of a sphere as the table shows it; `None` if it is not known.
pub fn value(figure: Figure, sphere: &SphereFigures, extent: Extent) -> Option<FigureText> {
    let outside = sphere.is_within(figure) == Some(false);
    match sphere.value(figure) {
        Some(value) => Some(FigureText { text: extent.number(value, four_significant), outside }),
        // (13) has no answer below 0, and that is outside.
        None => outside.then(|| FigureText { text: "below 0".to_owned(), outside }),
    }
}

fn shown_figures(extent: Extent) -> impl Iterator<Item = Figure> {
    Figure::ALL
        .iter()
        .copied()
        .filter(move |figure| extent.is_full() || figure.visibility() != FigureVisibility::Never)
}

/// All values of a sphere as the table shows them. Spheres with the same key share a column.
pub fn key(sphere: &SphereFigures, extent: Extent) -> Vec<String> {
    let text = |figure| sphere.value(figure).map(|value| extent.number(value, four_significant));
    shown_figures(extent).map(|figure| text(figure).unwrap_or_default()).collect()
}

/// All values of a sphere as numbers. If these are equal for two spheres, so is the [`key`], which takes longer to make.
pub(crate) fn exact_key(sphere: &SphereFigures, extent: Extent) -> Vec<Option<u64>> {
    shown_figures(extent).map(|figure| sphere.value(figure).map(f64::to_bits)).collect()
}

// How deep spheres are where each is at its own height, as rows: the text and the page share them.

/// Spheres of a limb with the same indentation.
pub struct EquallyDeep<'f> {
    pub limb: &'f str,
    /// x/R by the Hertz law, and by the law of the model.
    pub indentation: [String; 2],
    pub spheres: Vec<&'f str>,
}

/// The caption of the table of figures of spheres that are at different heights.
pub(crate) const UNEVEN_CAPTION: &str =
    "The spheres of a limb are not level at the default pose; x/R at 1 BW with each sphere at its own height";

/// The spheres of limbs that stand on all their spheres, if these are at different heights, grouped by depth.
pub(crate) fn equally_deep(figures: &Figures, extent: Extent) -> Vec<EquallyDeep<'_>> {
    let mut rows: Vec<EquallyDeep<'_>> = Vec::new();
    for limb in figures.limbs.iter().filter(|limb| stands_unevenly(limb)) {
        let first = rows.len();
        for sphere in &limb.spheres {
            let value = |figure| {
                let value = sphere.value(figure);
                value.map(|value| extent.number(value, four_significant)).unwrap_or_default()
            };
            let indentation = [Figure::StandingIndentation, Figure::StandingIndentationModelLaw].map(value);
            match rows.iter_mut().skip(first).find(|row| row.indentation == indentation) {
                Some(row) => row.spheres.push(&sphere.sphere),
                None => rows.push(EquallyDeep {
                    limb: limb.limb.as_deref().unwrap_or_default(),
                    indentation,
                    spheres: vec![&sphere.sphere],
                }),
            }
        }
    }
    rows
}

/// Whether indentations at own heights differ from those of level bottoms by more than rounding errors, and all spheres touch the floor.
fn stands_unevenly(limb: &LimbFigures) -> bool {
    const ROUNDING_OF_FIGURES: f64 = 1e-6;
    let differs = |sphere: &SphereFigures| {
        let level = sphere.value(Figure::LevelIndentation).or(sphere.value(Figure::Indentation));
        let own = sphere.value(Figure::StandingIndentation);
        own.zip(level).is_some_and(|(own, level)| (own - level).abs() > ROUNDING_OF_FIGURES)
    };
    let touches =
        |sphere: &SphereFigures| sphere.value(Figure::StandingIndentation).is_some_and(|own| own > 0.0);
    limb.spheres.iter().all(touches) && limb.spheres.iter().any(differs)
}

// What the spheres do, with a column for each group of spheres that do the same.

/// The largest number of groups of spheres in one table. Further groups go into another table.
const MOST_GROUPS_IN_TABLE: usize = 4;

/// The largest number of names that are listed. If there are more, the text has their number.
const MOST_NAMES_LISTED: usize = 6;

/// The text in place of a figure that is not known. Its two blanks keep digits below digits.
const UNKNOWN_FIGURE: &str = "-  ";

/// Spheres with the same figures, on any limb.
struct AlikeSpheres<'a> {
    names: Vec<&'a str>,
    first: &'a SphereFigures,
    mixed: bool,
}

/// The tables of figures; empty if there are no figures and no reason has to be given.
pub(super) fn sphere_sheet(inspected: &Inspection, dialect: &dyn Dialect, layout: Layout) -> String {
    let extent = layout.extent;
    let groups = alike_spheres(inspected, extent);
    let mut text = String::new();
    if let Some(why) = &inspected.figures.why_no_body_weight {
        text.push_str(&layout.wrapped(&format!("no values under body weight: {why}"), ""));
    }
    if !groups.is_empty() {
        text.push_str("What the spheres do (BW: body weight, on one limb unless you say otherwise):\n");
    }
    for (number, chunk) in groups.chunks(MOST_GROUPS_IN_TABLE).enumerate() {
        for (index, group) in chunk.iter().enumerate() {
            let label = format!("S{}", number * MOST_GROUPS_IN_TABLE + index + 1);
            text.push_str(
                &layout
                    .wrapped(&format!("{label}  {}", extent.names(&group.names, MOST_NAMES_LISTED)), "    "),
            );
        }
        text.push('\n');
        text.push_str(&group_table(inspected, chunk, number * MOST_GROUPS_IN_TABLE, layout));
    }
    text.push_str(&own_heights_table(inspected, layout));
    if text.contains(OUTSIDE_MARK) {
        let more = Phrase::template("outside the limit: `check MODEL` says more").spelled(dialect);
        text.push_str(&format!("  ({OUTSIDE_MARK} {more})\n"));
    }
    text
}

/// The table of spheres at their own heights, if these heights differ.
fn own_heights_table(inspected: &Inspection, layout: Layout) -> String {
    let extent = layout.extent;
    let rows = equally_deep(&inspected.figures, extent);
    if rows.is_empty() {
        return String::new();
    }
    let mut table = table(&["limb", "Hertz", "model's law", "spheres"]);
    for row in rows {
        let [hertz, model_law] = &row.indentation;
        table.add_row([row.limb, hertz, model_law, &extent.names(&row.spheres, MOST_NAMES_LISTED)]);
    }
    table.right_aligned(&[1, 2]);
    format!("\n{}{}\n", layout.wrapped(&format!("{UNEVEN_CAPTION}:"), ""), table.into_lines(layout.columns))
}

fn alike_spheres(inspected: &Inspection, extent: Extent) -> Vec<AlikeSpheres<'_>> {
    let mut groups: Vec<AlikeSpheres<'_>> = Vec::new();
    let (mut places, mut exact) = (HashMap::new(), HashMap::new());
    for limb in &inspected.figures.limbs {
        let mixed = limb.is_mixed();
        for sphere in &limb.spheres {
            let found = || *places.entry(key(sphere, extent)).or_insert(groups.len());
            let place = *exact.entry(exact_key(sphere, extent)).or_insert_with(found);
            match groups.get_mut(place) {
                Some(group) => group.names.push(&sphere.sphere),
                None => groups.push(AlikeSpheres { names: vec![&sphere.sphere], first: sphere, mixed }),
            }
        }
    }
    groups
}

fn group_table(inspected: &Inspection, groups: &[AlikeSpheres<'_>], before: usize, layout: Layout) -> String {
    let extent = layout.extent;
    let labels = (1..=groups.len()).map(|index| format!("S{}", before + index));
    let header: Vec<String> = ["figure".to_owned(), "limit".to_owned()].into_iter().chain(labels).collect();
    let mut table = table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    let mixed = groups.iter().any(|group| group.mixed);
    let spheres = Spheres::new(mixed, groups.iter().map(|group| group.first));
    let figures: Vec<Figure> =
        if extent.is_full() { Figure::ALL.to_vec() } else { spheres.figures().collect() };
    for figure in figures {
        let values: Vec<String> =
            groups.iter().map(|group| figure_cell(figure, group.first, extent)).collect();
        if values.iter().all(|value| value == UNKNOWN_FIGURE) {
            continue;
        }
        let name = heading(figure, inspected.figures.impact_speed_m_s, extent);
        table.add_row([vec![name, limit(figure)], values].concat());
    }
    table.right_aligned(&(2..2 + groups.len()).collect::<Vec<_>>());
    format!("{}\n", table.into_lines(layout.columns))
}

fn figure_cell(figure: Figure, sphere: &SphereFigures, extent: Extent) -> String {
    match value(figure, sphere, extent) {
        None => UNKNOWN_FIGURE.to_owned(),
        Some(FigureText { text, outside: false }) => format!("{text}  "),
        Some(FigureText { text, outside: true }) => format!("{text} {OUTSIDE_MARK}"),
    }
}

// A model's spheres as CSV: one row per sphere that stands, numbers in full.

/// The origin of a value in the CSV: the model, the limb, the sphere, and the force that presses the sphere.
struct SpherePlace<'p> {
    model: &'p Inspection,
    limb: &'p LimbFigures,
    sphere: &'p SphereFigures,
    force: Option<&'p InspectedForce>,
    /// The codes of all findings about the model, in one cell.
    findings: &'p str,
}

fn number_text(value: Option<f64>) -> String {
    value.map(shortest).unwrap_or_default()
}

/// A function that makes the text of a cell.
type Cell = fn(&SpherePlace<'_>) -> String;

/// Columns with the model, limb and sphere that a row is about.
const PLACE_COLUMNS: [(&str, Cell); 12] = [
    ("model_file", |p| p.model.model.clone()),
    ("model_name", |p| p.model.name.clone()),
    ("mass_kg", |p| number_text(p.model.mass_kg)),
    ("mass_contacts_were_made_for_kg", |p| {
        number_text(p.model.contacts_mass_kg.as_ref().map(|mass| mass.value))
    }),
    ("gravity_m_per_s2", |p| number_text(p.model.gravity_m_s2)),
    ("impact_speed_m_per_s", |p| number_text(p.model.figures.impact_speed_m_s)),
    ("limb", |p| p.limb.limb.clone().unwrap_or_default()),
    ("side", |p| p.limb.side.unwrap_or_default().to_owned()),
    ("spheres_sharing_body_weight", |p| number_text(p.limb.sphere_count)),
    ("sphere", |p| p.sphere.sphere.clone()),
    ("sphere_path", |p| p.sphere.path.clone()),
    ("force_names", |p| p.sphere.forces.join(" ")),
];

/// Columns with the parameters of the first force that presses the sphere.
const PARAMETER_COLUMNS: &[Property] = Class::SmoothSphereHalfSpaceForce.parameters();

/// Columns after the figures: names of the figures that are beyond their limits, and codes of findings.
const LAST_COLUMNS: [&str; 2] = ["outside_limits", "findings"];

/// Names of the columns of the CSV of spheres. `docs/reference/json.md` explains them.
fn csv_header() -> Vec<String> {
    let place = PLACE_COLUMNS.iter().map(|(name, _)| (*name).to_owned());
    let parameters = PARAMETER_COLUMNS.iter().map(|&property| Quantity::property(property).column());
    let figures = Figure::ALL.iter().map(|figure| figure.info().column());
    place.chain(parameters).chain(figures).chain(LAST_COLUMNS.map(str::to_owned)).collect()
}

fn cells_of_place(place: &SpherePlace<'_>) -> Vec<String> {
    let parameter = |property| number_text(place.force.and_then(|force| force.parameter(property)));
    let figures = Figure::ALL.iter().map(|&figure| number_text(place.sphere.value(figure)));
    let is_outside = |figure: &&Figure| place.sphere.is_within(**figure) == Some(false);
    let outside: Vec<String> =
        Figure::ALL.iter().filter(is_outside).map(|figure| figure.info().column()).collect();
    let last = [outside.join(" "), place.findings.to_owned()];
    let parameters = PARAMETER_COLUMNS.iter().copied().map(parameter);
    let before = PLACE_COLUMNS.iter().map(|(_, cell)| cell(place)).chain(parameters);
    before.chain(figures).chain(last).collect()
}

/// The codes of the findings about a model, each once. Every row of the model has them.
fn codes_of_findings(inspected: &Inspection) -> String {
    let mut seen = HashSet::new();
    let codes = inspected.findings.iter().map(|finding| finding.code().as_str());
    codes.filter(|code| seen.insert(*code)).collect::<Vec<_>>().join(" ")
}

/// The rows of one model as CSV; with a header before them if `header` is true.
///
/// # Errors
/// None in practice: the rows are written into memory.
pub fn csv_rows(inspected: &Inspection, header: bool) -> Result<String, csv::Error> {
    let header = header.then(csv_header);
    let spheres =
        inspected.figures.limbs.iter().flat_map(|limb| limb.spheres.iter().map(move |sphere| (limb, sphere)));
    // The first force of each name that presses a sphere of each name.
    let mut pressing: HashMap<(&str, &str), usize> = HashMap::new();
    for (at, force) in inspected.forces.iter().enumerate() {
        for sphere in &force.spheres {
            pressing.entry((&force.name, sphere)).or_insert(at);
        }
    }
    let findings = codes_of_findings(inspected);
    let rows = spheres.map(|(limb, sphere)| {
        let presses = |force: &String| pressing.get(&(force.as_str(), sphere.sphere.as_str())).copied();
        let first = sphere.forces.iter().filter_map(presses).min();
        let force = first.and_then(|at| inspected.forces.get(at));
        cells_of_place(&SpherePlace { model: inspected, limb, sphere, force, findings: &findings })
    });
    csv_text(header.into_iter().chain(rows))
}
