//! The table that says what is in which file.

use anyhow::{Result, anyhow};
use osim_patch::{Property, shortest};

use super::variant::Variant;
use crate::digest::sha256;

/// Properties that a manifest tells.
const PROPERTIES: [Property; 6] = [
    Property::Radius,
    Property::Stiffness,
    Property::Dissipation,
    Property::ConstantContactForce,
    Property::HertzSmoothing,
    Property::HuntCrossleySmoothing,
];

/// Names of the columns: the file, what was asked, what stands in the file, what follows from it.
pub(super) fn header(asked: &[String]) -> Result<Vec<u8>> {
    let properties = PROPERTIES.map(|property| property.name().to_owned());
    let follows =
        ["relative_indentation", "dimensionless_stiffness", "restitution", "sha256"].map(str::to_owned);
    let first = std::iter::once("file".to_owned());
    line(first.chain(asked.iter().cloned()).chain(properties).chain(follows))
}

/// One variant.
pub(super) fn row(file: &str, asked: &[String], variant: &Variant) -> Result<Vec<u8>> {
    let cell = |value: Option<f64>| value.map(shortest).unwrap_or_default();
    let properties = PROPERTIES.map(|property| cell(variant.common(property)));
    let follows = [
        cell(variant.indentation()),
        cell(variant.dimensionless_stiffness()),
        cell(variant.restitution()),
        sha256(&variant.bytes),
    ];
    let first = std::iter::once(file.to_owned());
    line(first.chain(asked.iter().cloned()).chain(properties).chain(follows))
}

fn line(cells: impl Iterator<Item = String>) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(cells)?;
    writer.into_inner().map_err(|error| anyhow!(error.to_string()))
}
