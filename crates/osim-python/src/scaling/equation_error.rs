//! The error of an equation without a value: the refused argument, the element of the argument, and the expected values.

use std::fmt;

use contact_scaling::DomainError;

/// The name of the quantity in an error about a list that is too long or too short.
const NUMBER_OF_ELEMENTS: &str = "the number of elements";

/// The reason why an equation has no value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EquationError {
    /// The refused argument; `None` if several arguments together were refused.
    pub parameter: Option<&'static str>,
    /// Name of the refused quantity.
    pub quantity: &'static str,
    /// The refused value, in SI units.
    pub value: f64,
    /// Description of the allowed values.
    pub expected: &'static str,
    /// Index from 0 of the refused element in a list or flattened array; `None` if the argument is one number.
    pub index: Option<usize>,
}

impl EquationError {
    /// An error about the value of a quantity, not about an element of a list.
    fn new(
        parameter: Option<&'static str>,
        quantity: &'static str,
        value: f64,
        expected: &'static str,
    ) -> Self {
        Self { parameter, quantity, value, expected, index: None }
    }

    /// Refuses arguments that are not finite.
    ///
    /// # Errors
    /// The first argument without a finite value: a gap in an array, or the result of a division by 0.
    pub(super) fn unless_finite(
        mut arguments: impl Iterator<Item = (&'static str, f64)>,
    ) -> Result<(), Self> {
        let Some((name, value)) = arguments.find(|(_, value)| !value.is_finite()) else { return Ok(()) };
        Err(Self::new(Some(name), name, value, "a finite number"))
    }

    /// The error that the result is too large for a float, although every argument is allowed.
    pub(super) fn result(value: f64) -> Self {
        let expected = "a finite number: an argument is far too large or too small";
        Self::new(None, "the result", value, expected)
    }

    /// The error that an equation got `found` arguments, and takes another number of arguments.
    pub(super) fn arguments(found: usize) -> Self {
        let expected = "a number for each argument of the equation";
        Self::new(None, "the number of arguments", count(found), expected)
    }

    /// The error that a body has no spheres to rest on.
    pub(super) fn no_sphere() -> Self {
        Self::new(None, "the number of spheres", 0.0, "1 or more")
    }

    /// The error that heights of spheres are not measured from the lowest sphere.
    pub(super) fn lowest(parameter: &'static str, value: f64) -> Self {
        let expected = "0 for the lowest sphere: heights are above that one";
        Self::new(Some(parameter), "height of the lowest sphere", value, expected)
    }

    /// The error that a list has neither one element nor as many elements as the other lists.
    pub(super) fn length(parameter: &'static str, found: usize) -> Self {
        let expected = "one, or as many as the other arguments have";
        Self::new(Some(parameter), NUMBER_OF_ELEMENTS, count(found), expected)
    }

    /// Finds the refused argument: its value is the refused value, and its name is the refused quantity or ends with the same word.
    pub(super) fn with_argument<'a>(
        self,
        arguments: impl Iterator<Item = (&'static str, f64)> + Clone + 'a,
    ) -> Self {
        if self.parameter.is_some() {
            return self;
        }
        let quantity = self.quantity.replace('\'', "");
        let last = quantity.rsplit(' ').next().unwrap_or_default();
        let mut alike = arguments.filter(|(_, value)| *value == self.value);
        let same = alike.clone().find(|(name, _)| name.replace('_', " ") == quantity);
        let found = same.or_else(|| alike.find(|(name, _)| name.rsplit('_').next() == Some(last)));
        Self { parameter: found.map(|(name, _)| name), ..self }
    }

    /// The error about the element of this index.
    pub(super) fn at(self, index: usize) -> Self {
        Self { index: Some(index), ..self }
    }

    /// The message in one sentence; `place` has the indices of the refused element, such as `[2, 0]`, or is empty.
    pub(crate) fn message(&self, place: &str) -> String {
        let Self { parameter, quantity, value, expected, .. } = *self;
        match parameter {
            Some(name) if quantity == NUMBER_OF_ELEMENTS => {
                format!("{name}: {quantity} is {value}, expected {expected}")
            }
            Some(name) => format!("{name}{place} is {value:?}, expected {expected}"),
            None if place.is_empty() => format!("{quantity} is {value:?}, expected {expected}"),
            None => format!("{quantity} at {place} is {value:?}, expected {expected}"),
        }
    }
}

impl From<DomainError> for EquationError {
    fn from(error: DomainError) -> Self {
        Self::new(None, error.quantity(), error.value(), error.expected())
    }
}

impl fmt::Display for EquationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message(&self.index.map(|index| format!("[{index}]")).unwrap_or_default()))
    }
}

/// A number of things as a float, because the values in errors are floats.
fn count(things: usize) -> f64 {
    u32::try_from(things).map_or(f64::INFINITY, f64::from)
}
