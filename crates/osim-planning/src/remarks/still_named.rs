//! Remarks about objects that were removed and are still named.

use osim_model::messages::{Phrase, listed};
use osim_patch::{Leftover, Rebuilt, leftovers};

/// Objects and names that are listed; more are counted.
const SAID: usize = 3;

/// Which objects of `rebuilt` name others that it does not have any more, one sentence for each.
pub(crate) fn still_named(rebuilt: &Rebuilt) -> Vec<Phrase> {
    let left = leftovers(rebuilt);
    let one = |leftover: &Leftover| {
        let names = listed(&leftover.names, SAID);
        Phrase::from(format!(
            "{} still names {names}, gone from this model: change that in OpenSim",
            leftover.object
        ))
    };
    let mut said: Vec<Phrase> = left.iter().take(SAID).map(one).collect();
    if let Some(more) = left.len().checked_sub(SAID).filter(|more| *more > 0) {
        said.push(format!("and so do {more} more").into());
    }
    said
}
