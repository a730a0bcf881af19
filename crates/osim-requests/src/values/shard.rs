//! A part of a large job: a share of the models, or one point of a grid.

use std::fmt;
use std::iter::StepBy;
use std::ops::Range;
use std::path::Path;
use std::str::FromStr;

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::values::serial::{self, values_as_text};
use crate::values::typed_numbers::trimmed;

/// The largest number of shares; no cluster runs more jobs.
const MOST_JOBS: u64 = 1_000_000_000;

/// Share `i` (from 1) of `n`: `i/n`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Whether the share contains the number `number`.
    pub const fn has_number(self, number: u64) -> bool {
        number % self.count == self.index - 1
    }

    /// The indices, from 0, of the items in this share among `count` items: every n-th. Neighbouring items take about the
    /// same time, so that all shares take about the same time.
    pub fn of(self, count: usize) -> StepBy<Range<usize>> {
        // No computer has more things than it can count.
        let whole = |number: u64| usize::try_from(number).unwrap_or(usize::MAX);
        (whole(self.index - 1)..count).step_by(whole(self.count))
    }

    /// The share as a part of a file name; sorted by name, the files have the order of the shares.
    pub fn file_part(self) -> String {
        let count = self.count.to_string();
        format!("shard-{:0width$}-of-{count}", self.index, width = count.len())
    }

    /// Whether the share contains the model `name`.
    ///
    /// The share of a model depends only on its name. It stays the same if other models are added or removed while the shares
    /// run.
    pub fn has_name(self, name: &Path) -> bool {
        self.has_number(hash_of_name(name.as_os_str().as_encoded_bytes()))
    }
}

fn hash_of_name(name: &[u8]) -> u64 {
    // Windows separates folders with `\`; the share is the same there.
    let name: Vec<u8> = name.iter().map(|&byte| if byte == b'\\' { b'/' } else { byte }).collect();
    let digest = Sha256::digest(&name);
    digest.iter().take(8).fold(0, |number, &byte| number << 8 | u64::from(byte))
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || format!("expected i/n with i from 1 to n, and n up to {MOST_JOBS}, such as 2/8");
        let (index, count) = text.split_once('/').ok_or_else(expected)?;
        let whole = |text: &str| trimmed(text).parse::<u64>().map_err(|_| expected());
        let shard = Self { index: whole(index)?, count: whole(count)? };
        if shard.count <= MOST_JOBS && (1..=shard.count).contains(&shard.index) {
            Ok(shard)
        } else {
            Err(expected())
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

values_as_text! {
    Shard = {"type": "string"};
}

/// The number of one grid point, from 1, or a number that is too large to count.
struct PointNumber(usize);

impl FromStr for PointNumber {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || "expected the number of one point, counted from 1".to_owned();
        trimmed(text).parse().map(Self).map_err(|_| expected())
    }
}

/// Reads the number of a point of a sweep.
pub(crate) fn point_of_json<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Option<usize>, D::Error> {
    let Some(value) = Option::<Value>::deserialize(deserializer)? else { return Ok(None) };
    let PointNumber(number) = serial::from_text(value).map_err(D::Error::custom)?;
    Ok(Some(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_read_from_its_number_and_count() {
        assert_eq!("2/8".parse(), Ok(Shard { index: 2, count: 8 }));
        for text in
            ["0/8", "9/8", "1/0", "1", "a/b", "1/8/2", "-1/8", "1/1000000001", "1/99999999999999999999"]
        {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
    }

    #[test]
    fn every_item_is_in_exactly_one_share() {
        let of = |text: &str, count| text.parse::<Shard>().unwrap().of(count).collect::<Vec<_>>();
        assert_eq!([of("1/3", 7), of("2/3", 7), of("3/3", 7)], [vec![0, 3, 6], vec![1, 4], vec![2, 5]]);
        assert_eq!([of("1/1", 2), of("3/4", 2), of("4/4", 0)], [vec![0, 1], vec![], vec![]]);
        assert_eq!("1000000000/1000000000".parse::<Shard>().unwrap().of(2).len(), 0);
        assert_eq!("2/12".parse::<Shard>().unwrap().file_part(), "shard-02-of-12");
    }

    #[test]
    fn the_share_of_a_name_never_changes() {
        // First 8 bytes of `printf 'a/x.osim' | sha256sum`.
        assert_eq!(hash_of_name(b"a/x.osim"), 0xdc2e_ddeb_2914_d027);
        assert_eq!(hash_of_name(b"a\\x.osim"), hash_of_name(b"a/x.osim"));
    }
}
