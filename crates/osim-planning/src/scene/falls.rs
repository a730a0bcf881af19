//! Heights of bodies that fall on their contacts, moment by moment: bodies of a model, and animals of the paper's Table 1.

use contact_scaling::drop_test::{DropError, DropReport, DropTest, Sample};
use contact_scaling::table1::{Animal, animals};
use contact_scaling::{Contact, falisse2022};
use osim_inspect::series::{self, ContactBody};
use osim_model::files::Failure;
use osim_requests::DropHeight;
use serde::Serialize;

/// Bodies fall from a quarter of the radius, as in the paper's drop tests.
const HEIGHT_OF_FALLS: DropHeight = DropHeight::Radii(0.25);
/// The number of moments of a fall that are shown.
const MOMENTS_OF_FALL: usize = 361;
/// The duration of a fall, in √(R/g). A body that bounces like feet is at rest before. In this unit, bodies of all sizes fall alike.
const DURATION_IN_TIME_UNITS: f64 = 12.0;

/// A body that falls on its contacts.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct BodyFall {
    /// Name of the body.
    pub name: String,
    /// Time from one moment to the next, s.
    pub step_s: f64,
    /// Root of the mean R² of the body's spheres, √(Σ R²/n), m.
    pub radius_m: f64,
    /// Height of the spheres' bottoms over the ground at each moment, m; below 0 in contact.
    pub heights_m: Vec<f64>,
    /// Force of all spheres at each moment, body weights.
    pub forces_bw: Vec<f64>,
    /// Why the fall cannot be calculated; then there are no moments.
    pub why_not: Option<String>,
}

impl BodyFall {
    /// The falls of `bodies`, all with the same duration.
    pub fn all(bodies: &[ContactBody]) -> Vec<Self> {
        let radii = bodies.iter().filter_map(|body| {
            let weight = body.weight().ok()?;
            let largest = body.kinds.iter().map(|kind| kind.radius_m).fold(0.0, f64::max);
            Some((largest / weight.gravity_m_s2).sqrt())
        });
        let duration_s = DURATION_IN_TIME_UNITS * radii.fold(0.0, f64::max);
        bodies.iter().map(|body| Self::of_body(body, duration_s)).collect()
    }

    /// The fall of one body from a quarter of its radius.
    fn of_body(body: &ContactBody, duration_s: f64) -> Self {
        let none = |failure: Failure| Self {
            name: body.name.clone(),
            why_not: Some(failure.message.to_string()),
            ..Self::default()
        };
        let report = match series::run_drop_test(body, HEIGHT_OF_FALLS, duration_s, MOMENTS_OF_FALL) {
            Ok(report) => report,
            Err(failure) => return none(failure),
        };
        let of = |value: &dyn Fn(&Sample) -> f64| report.series.iter().map(value).collect();
        let intervals = (MOMENTS_OF_FALL - 1) as f64;
        Self {
            name: body.name.clone(),
            step_s: duration_s / intervals,
            radius_m: report.reference_radius_m,
            heights_m: of(&|sample| sample.height_m),
            forces_bw: of(&|sample| sample.force_n / report.body_weight_n),
            why_not: None,
        }
    }
}

/// The height from which animals of the paper's Table 1 fall, in radii, as in the drop tests of the paper.
const ANIMAL_DROP_HEIGHT_RADII: f64 = 0.25;
/// The number of moments of an animal's fall that are shown.
const ANIMAL_MOMENTS: usize = 181;
/// The animals of Table 1 whose falls are shown, from the smallest to the largest.
const ANIMALS_SHOWN: [&str; 3] = ["mouse", "human", "giraffe"];

/// An animal that falls on two kinds of contacts. Heights are those of its spheres' bottoms over the ground in radii, at equal times
/// in √(R/g).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimalFall {
    pub name: &'static str,
    pub mass_kg: f64,
    /// Heights on the contacts of the paper's human, left as they are.
    pub left_behind: Vec<f64>,
    /// Heights on contacts that are scaled to the animal.
    pub scaled: Vec<f64>,
}

impl AnimalFall {
    /// The falls of a mouse, a human and a giraffe.
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
                left_behind: heights_in_radii(&human, &animal)?,
                scaled: heights_in_radii(&animal.contact()?, &animal)?,
            })
        };
        ANIMALS_SHOWN.iter().filter_map(first).map(of).collect()
    }
}

/// The heights of an animal's sphere bottoms in radii while it falls on `contact`, at equal times.
fn heights_in_radii(contact: &Contact, animal: &Animal) -> Result<Vec<f64>, DropError> {
    let scale = animal.scale();
    let radius_m = scale.radius_m();
    let duration_s = DURATION_IN_TIME_UNITS * (radius_m / scale.gravity_m_s2()).sqrt();
    let report: DropReport = DropTest::of(contact, &scale, ANIMAL_DROP_HEIGHT_RADII, duration_s)?.run()?;
    let last = report.series.len().saturating_sub(1);
    let moment = |index: usize| report.series.get(index * last / (ANIMAL_MOMENTS - 1));
    Ok((0..ANIMAL_MOMENTS).filter_map(moment).map(|sample| sample.height_m / radius_m).collect())
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
