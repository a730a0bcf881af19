//! The table that says what is in which file.

use osim_inspect::Figure;
use osim_model::Property;
use osim_model::messages::shortest;

use super::variant::Variant;

/// Properties that a manifest shows.
const PROPERTIES: [Property; 6] = [
    Property::Radius,
    Property::Stiffness,
    Property::Dissipation,
    Property::ConstantContactForce,
    Property::HertzSmoothing,
    Property::HuntCrossleySmoothing,
];

/// What is before the name of what was asked, in the name of a column.
pub(super) const GRID: &str = "grid_";
/// What a ladder asks at each step.
pub(super) const LADDER: [&str; 1] = ["wanted_dimensionless_stiffness"];
/// x̂ at rest by the Hertz law, in whose k̂ a ladder steps, and by the law of the class of the force.
const HERTZ: &str = "relative_indentation_hertz";
const MODEL_LAW: &str = "relative_indentation_model_law";
/// Codes of errors and warnings that the model itself has not.
const WORSE: &str = "worse";
/// The number of the point or step, from 1, and its file.
const FIRST: [&str; 2] = ["index", "file"];

/// Names of the columns: the number and the file, what was asked, what is in the file, what follows from it.
pub(super) fn header(asked: Vec<String>) -> Vec<String> {
    let properties = PROPERTIES.map(|property| property.name().to_owned());
    let follows =
        [HERTZ, MODEL_LAW, "dimensionless_stiffness", "restitution", WORSE, "sha256"].map(str::to_owned);
    let first = FIRST.map(str::to_owned).into_iter();
    first.chain(asked).chain(properties).chain(follows).collect()
}

/// Whether these are the columns of some sweep's table, by grid or by ladder.
pub(super) fn is_header<C: AsRef<str>>(columns: &[C]) -> bool {
    let others = header(Vec::new()).len();
    let Some(count) = columns.len().checked_sub(others) else { return false };
    let asked: Vec<&str> = columns.iter().skip(FIRST.len()).take(count).map(AsRef::as_ref).collect();
    let is_grid = asked.iter().all(|column| column.starts_with(GRID));
    let whole = header(asked.iter().map(|&column| column.to_owned()).collect());
    (is_grid || asked == LADDER) && columns.iter().map(AsRef::as_ref).eq(whole)
}

/// One variant, with its number from 1 and its file; `worse` are codes of what is wrong with it alone, `sha256` is that of its bytes.
pub(super) fn row(
    number: usize,
    file: String,
    asked: Vec<String>,
    variant: &Variant,
    (worse, sha256): (&[&str], String),
) -> Vec<String> {
    let cell = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let properties = PROPERTIES.map(|property| cell(variant.common(property)));
    let follows = [
        variant.indentations(Figure::Indentation),
        variant.indentations(Figure::IndentationModelLaw),
        cell(variant.dimensionless_stiffness()),
        cell(variant.restitution()),
        worse.join(" "),
        sha256,
    ];
    [number.to_string(), file].into_iter().chain(asked).chain(properties).chain(follows).collect()
}
