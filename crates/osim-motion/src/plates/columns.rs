//! Which columns are the three parts of a force, of its point, of a moment.

use crate::fault::MotionFault;
use crate::table::{Column, Table};

/// Columns that end in x, y and z and have the rest in common.
pub(super) struct Triple<'t> {
    /// What they have in common, as in the file.
    pub(super) stem: String,
    pub(super) columns: [&'t Column; 3],
    what: What,
    /// What distinguishes its plate from others: what is left of the stem without the words.
    plate: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum What {
    Force,
    Point,
    Torque,
}

/// All triples of a table of ground reactions.
pub(super) struct Triples<'t> {
    pub(super) forces: Vec<Triple<'t>>,
    others: Vec<Triple<'t>>,
}

impl<'t> Triples<'t> {
    pub(super) fn of(table: &'t Table) -> Self {
        let mut triples = Self { forces: Vec::new(), others: Vec::new() };
        for column in &table.columns {
            let Some(stem) = column.name.strip_suffix(['x', 'X']) else { continue };
            let Some((what, plate)) = meaning(stem) else { continue };
            let [Some(y), Some(z)] = [["y", "Y"], ["z", "Z"]]
                .map(|names| names.iter().find_map(|axis| table.column(&format!("{stem}{axis}"))))
            else {
                continue;
            };
            let triple = Triple { stem: stem.to_owned(), columns: [column, y, z], what, plate };
            match what {
                What::Force => triples.forces.push(triple),
                _ => triples.others.push(triple),
            }
        }
        triples
    }

    pub(super) fn point_of(&self, force: &Triple<'_>) -> Option<[&'t Column; 3]> {
        self.of_plate(What::Point, force)
    }

    pub(super) fn torque_of(&self, force: &Triple<'_>) -> Option<[&'t Column; 3]> {
        self.of_plate(What::Torque, force)
    }

    fn of_plate(&self, what: What, force: &Triple<'_>) -> Option<[&'t Column; 3]> {
        self.others.iter().find(|one| one.what == what && one.plate == force.plate).map(|one| one.columns)
    }
}

/// What columns of this stem are, and of which plate: `ground_force_v`, `1_ground_force_p`, `ground_torque_r_`, `l_ground_moment_m`,
/// `F1`, `M1`, `COP1`.
fn meaning(stem: &str) -> Option<(What, String)> {
    let lower = stem.to_ascii_lowercase();
    let numbered = lower.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    if !numbered.is_empty() && numbered.chars().all(|c| c.is_ascii_digit()) {
        let what = match lower.strip_suffix(numbered)? {
            "f" | "force" => What::Force,
            "p" | "cop" => What::Point,
            "m" | "t" | "moment" => What::Torque,
            _ => return None,
        };
        return Some((what, numbered.to_owned()));
    }
    let is_moment = lower.contains("torque") || lower.contains("moment");
    let what = match lower.rsplit(['_', '.']).next()? {
        "m" if is_moment || lower.contains("force") => What::Torque,
        _ if is_moment => What::Torque,
        "v" if lower.contains("force") => What::Force,
        "p" if lower.contains("force") || lower.contains("cop") => What::Point,
        _ => return None,
    };
    let words = ["ground", "force", "torque", "moment", "v", "p", "m", "cop"];
    let rest: Vec<&str> =
        lower.split(['_', '.']).filter(|part| !part.is_empty() && !words.contains(part)).collect();
    Some((what, rest.join("_")))
}

/// The three columns that begin with `prefix`, as `ExternalLoads` files name them.
pub(super) fn with_prefix<'t>(table: &'t Table, prefix: &str) -> Result<[&'t Column; 3], MotionFault> {
    let exact = ["x", "y", "z"].map(|axis| table.column(&format!("{prefix}{axis}")));
    if let [Some(x), Some(y), Some(z)] = exact {
        return Ok([x, y, z]);
    }
    let found: Vec<&Column> = table.columns.iter().filter(|column| column.name.starts_with(prefix)).collect();
    match found.as_slice() {
        [x, y, z] => Ok([x, y, z]),
        _ => Err(MotionFault::new(format!(
            "the ExternalLoads file names three columns that begin with '{prefix}', and the table has {}",
            found.len()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_laboratories_are_understood() {
        let plate = |stem: &str| meaning(stem).map(|(what, plate)| (what, plate.leak() as &str));
        assert_eq!(plate("ground_force_v"), Some((What::Force, "")));
        assert_eq!(plate("ground_force_p"), Some((What::Point, "")));
        assert_eq!(plate("ground_torque_"), Some((What::Torque, "")));
        assert_eq!(plate("l_ground_torque_"), Some((What::Torque, "l")));
        assert_eq!(plate("1_ground_force_v"), Some((What::Force, "1")));
        assert_eq!(plate("R_ground_force_v"), Some((What::Force, "r")));
        assert_eq!(plate("ground_force_r_v"), Some((What::Force, "r")));
        assert_eq!(plate("ground_torque_r_"), Some((What::Torque, "r")));
        assert_eq!(plate("ground_force_1_v"), Some((What::Force, "1")));
        assert_eq!(plate("ground_moment_1_m"), Some((What::Torque, "1")));
        assert_eq!(plate("1_ground_torque_m"), Some((What::Torque, "1")));
        assert_eq!(plate("F1"), Some((What::Force, "1")));
        assert_eq!(plate("M12"), Some((What::Torque, "12")));
        assert_eq!(plate("knee_"), None);
        assert_eq!(plate("emg1"), None);
    }
}
