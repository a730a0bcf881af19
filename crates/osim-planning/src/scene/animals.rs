//! Animals of the paper's Table 1 that fall on the contacts of a human, and on their own.

use contact_scaling::drop_test::{DropError, DropReport, DropTest};
use contact_scaling::table1::{Animal, animals};
use contact_scaling::{Contact, falisse2022};
use serde::Serialize;

/// Height of the fall, in radii, as in the paper's drop tests.
const HEIGHT_RADII: f64 = 0.25;
/// How long they are followed, in √(R/g): bodies of all sizes fall alike in it.
const TIMES: f64 = 12.0;
/// Moments that are shown.
const MOMENTS: usize = 181;
const SHOWN: [&str; 3] = ["mouse", "human", "giraffe"];

/// An animal that falls twice. Heights are those of its spheres' bottoms over the ground in radii, at equal times in √(R/g).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct AnimalFall {
    /// What it is called.
    pub name: &'static str,
    /// What it weighs, kg.
    pub mass_kg: f64,
    /// On the contacts of the paper's human, left as they are.
    pub left_behind: Vec<f64>,
    /// On contacts that are scaled to it.
    pub scaled: Vec<f64>,
}

impl AnimalFall {
    /// A mouse, a human and a giraffe.
    ///
    /// # Errors
    /// None with the numbers of the table.
    pub fn all() -> Result<Vec<Self>, DropError> {
        let human = falisse2022().contact;
        let first = |name: &&str| animals().find(|animal| animal.taxon() == *name);
        let of = |animal: Animal| {
            Ok(Self {
                name: animal.taxon(),
                mass_kg: animal.scale().mass_kg(),
                left_behind: heights(&human, &animal)?,
                scaled: heights(&animal.contact()?, &animal)?,
            })
        };
        SHOWN.iter().filter_map(first).map(of).collect()
    }
}

fn heights(contact: &Contact, animal: &Animal) -> Result<Vec<f64>, DropError> {
    let scale = animal.scale();
    let radius_m = scale.radius_m();
    let duration_s = TIMES * (radius_m / scale.gravity_m_s2()).sqrt();
    let report: DropReport = DropTest::of(contact, &scale, HEIGHT_RADII, duration_s)?.run()?;
    let last = report.series.len().saturating_sub(1);
    let moment = |index: usize| report.series.get(index * last / (MOMENTS - 1));
    Ok((0..MOMENTS).filter_map(moment).map(|sample| sample.height_m / radius_m).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn animals_of_all_sizes_fall_alike_on_their_own_contacts_and_not_on_those_of_a_human() {
        let falls = AnimalFall::all().unwrap();
        let end = |heights: &[f64]| *heights.last().unwrap();
        let scaled: Vec<f64> = falls.iter().map(|fall| end(&fall.scaled)).collect();
        assert!(scaled.iter().all(|height| (height / scaled[1] - 1.0).abs() < 1e-3), "{scaled:?}");
        let left: Vec<f64> = falls.iter().map(|fall| end(&fall.left_behind) / scaled[1]).collect();
        // Table 1: the mouse needs a quarter of the human's modulus, the giraffe sixteen times it.
        assert!(left[0] < 0.6 && (left[1] - 1.0).abs() < 1e-6 && left[2] > 3.0, "{left:?}");
    }
}
