//! What the table of a sweep does not show: variants with the same contacts, and models of another sweep in its folder.

use std::collections::{HashMap, HashSet};
use std::ffi::OsString;
use std::path::Path;

use osim_planning::SweepPlan;

/// Variants whose contacts another one has already.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SameContacts {
    /// How many.
    pub count: usize,
    /// The first of them and the one that it is the same as, by their numbers from 1.
    pub first: Option<(usize, usize)>,
}

/// Contacts that were seen, by their digests, with the number of the variant.
#[derive(Debug, Default)]
pub(super) struct Seen(HashMap<String, usize>);

impl Seen {
    /// Counts variant `number`, from 1, with this digest of its contacts.
    pub(super) fn add(&mut self, digest: String, number: usize, same: &mut SameContacts) {
        match self.0.get(&digest) {
            Some(&earlier) => {
                same.count += 1;
                same.first.get_or_insert((number, earlier));
            }
            None => {
                self.0.insert(digest, number);
            }
        }
    }
}

/// Models in the folder of a sweep that are called like its own and are none of them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct OtherModels {
    /// How many.
    pub count: usize,
    /// The first of them by name.
    pub first: Option<String>,
}

impl OtherModels {
    /// Those in `folder`.
    pub(super) fn find(folder: &Path, plan: &SweepPlan<'_>) -> Self {
        let is_like = |name: &OsString| name.to_str().is_some_and(|name| plan.is_like_file_name(name));
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let there: HashSet<OsString> = entries.map(|entry| entry.file_name()).filter(is_like).collect();
        let own: HashSet<OsString> = (0..plan.count()).map(|index| plan.file_name(index).into()).collect();
        let mut others: Vec<String> =
            there.difference(&own).map(|name| name.to_string_lossy().into_owned()).collect();
        others.sort_unstable();
        Self { count: others.len(), first: others.into_iter().next() }
    }
}
