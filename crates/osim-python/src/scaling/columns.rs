//! Lists of arguments as rows: each list has one element, or as many as the others.

use super::failure::Failure;

/// Lists of arguments, one for each parameter.
pub(super) struct Columns<'c> {
    names: Vec<&'static str>,
    lists: &'c [&'c [f64]],
    rows: usize,
}

impl<'c> Columns<'c> {
    /// Lists for the parameters of these names, in the same order.
    ///
    /// # Errors
    /// Lists that differ in length, or too many or too few of them.
    pub(super) fn new(
        names: impl Iterator<Item = &'static str>,
        lists: &'c [&'c [f64]],
    ) -> Result<Self, Failure> {
        let names: Vec<_> = names.collect();
        if lists.len() != names.len() {
            return Err(Failure::arguments(lists.len()));
        }
        let rows = lists.iter().map(|list| list.len()).find(|&length| length != 1).unwrap_or(1);
        let other = names.iter().zip(lists).find(|(_, list)| ![1, rows].contains(&list.len()));
        match other {
            Some((name, list)) => Err(Failure::length(name, list.len())),
            None => Ok(Self { names, lists, rows }),
        }
    }

    /// What `call` makes of each row.
    ///
    /// # Errors
    /// The first of `call`, with the element that it is about.
    pub(super) fn each<T>(&self, call: impl Fn(&[f64]) -> Result<T, Failure>) -> Result<Vec<T>, Failure> {
        let mut arguments = vec![0.0; self.lists.len()];
        let mut one = |row: usize| {
            for (argument, list) in arguments.iter_mut().zip(self.lists) {
                *argument = list.get(row).or(list.first()).copied().unwrap_or(f64::NAN);
            }
            call(&arguments)
                .map_err(|failure| if self.is_listed(&failure) { failure.at(row) } else { failure })
        };
        (0..self.rows).map(&mut one).collect()
    }

    /// Whether a failure is about an element of a list, not about a number that is the same in all rows.
    fn is_listed(&self, failure: &Failure) -> bool {
        let mut named = self.names.iter().zip(self.lists);
        named.any(|(&name, list)| list.len() > 1 && failure.parameter.is_none_or(|about| about == name))
    }
}
