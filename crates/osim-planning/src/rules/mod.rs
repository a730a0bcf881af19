//! All rules, in the order of their codes; and those about files beside a model: two are raised by the library, which finds them.

pub(crate) mod bottoms_moved;
pub mod compiled_model_beside;
pub mod hard_linked;
pub(crate) mod odd_mesh;

use std::sync::LazyLock;

use osim_model::{FindingCode, Rule};

/// The rules of this crate.
const RULES: &[&Rule] =
    &[&bottoms_moved::RULE, &compiled_model_beside::RULE, &hard_linked::RULE, &odd_mesh::RULE];

/// Every rule of every crate, one for each code.
#[must_use]
pub fn all() -> &'static [&'static Rule] {
    static ALL: LazyLock<Vec<&Rule>> = LazyLock::new(|| {
        let crates =
            [osim_model::RULES, osim_model::compare::RULES, osim_inspect::RULES, osim_patch::RULES, RULES];
        let mut all = crates.concat();
        all.sort_by_key(|rule| rule.code);
        all
    });
    &ALL
}

/// Those of `codes`, in the order of the codes.
pub fn of<'c>(codes: impl Fn(FindingCode) -> bool + 'c) -> impl Iterator<Item = &'static Rule> + 'c {
    all().iter().copied().filter(move |rule| codes(rule.code))
}
