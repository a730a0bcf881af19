//! Numbers as they are written into files. Here they become text, for every verb, and what is not finite does not.

use osim_model::messages::shortest;
use osim_model::{Fault, FaultKind, Property};

/// The text of the new `value` of `property`; `origin` says what it comes from, for the message.
///
/// # Errors
/// A value that is not finite, or in which the contact laws do not hold ([`FaultKind::NewValue`]).
pub(crate) fn value(
    value: f64,
    property: Property,
    origin: impl FnOnce() -> String,
) -> Result<String, Fault> {
    check(value, property, origin)?;
    Ok(shortest(value))
}

/// Whether the new `value` of `property` may be written.
///
/// # Errors
/// As [`value`].
pub(crate) fn check(value: f64, property: Property, origin: impl FnOnce() -> String) -> Result<(), Fault> {
    if property.allows(value) {
        return Ok(());
    }
    Err(refused(property.name(), value, property.domain(), origin()))
}

/// The text of a place or an orientation, which is called `name`.
///
/// # Errors
/// One of its numbers is not finite ([`FaultKind::NewValue`]).
pub(crate) fn triple(values: [f64; 3], name: &str, origin: impl FnOnce() -> String) -> Result<String, Fault> {
    match values.into_iter().find(|value| !value.is_finite()) {
        Some(value) => Err(refused(name, value, "three finite numbers", origin())),
        None => Ok(values.map(shortest).join(" ")),
    }
}

fn refused(property: &str, value: f64, expected: &'static str, origin: String) -> Fault {
    Fault::new(FaultKind::NewValue { property: property.to_owned(), value, expected, origin })
}
