//! The table that says what is in which file.

use osim_model::{Property, shortest};

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

/// Names of the columns: the file, what was asked, what is in the file, what follows from it.
pub(super) fn header(asked: Vec<String>) -> Vec<String> {
    let properties = PROPERTIES.map(|property| property.name().to_owned());
    let follows =
        ["relative_indentation", "dimensionless_stiffness", "restitution", "sha256"].map(str::to_owned);
    let first = std::iter::once("file".to_owned());
    first.chain(asked).chain(properties).chain(follows).collect()
}

/// One variant; `sha256` is that of its bytes.
pub(super) fn row(file: String, asked: Vec<String>, variant: &Variant, sha256: String) -> Vec<String> {
    let cell = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let properties = PROPERTIES.map(|property| cell(variant.common(property)));
    let follows = [
        cell(variant.indentation()),
        cell(variant.dimensionless_stiffness()),
        cell(variant.restitution()),
        sha256,
    ];
    std::iter::once(file).chain(asked).chain(properties).chain(follows).collect()
}
