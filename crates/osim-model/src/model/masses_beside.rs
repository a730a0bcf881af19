//! A mass among those of the other rows of its table.

use crate::model::mass_slip::{MassSlip, POUND_KG};

/// So many other rows are needed to say what is usual.
const FEWEST: usize = 3;
/// A mass that is so many times below or above all others is out of line.
const MARGIN: f64 = 1.3;
/// Bodies that are further apart are of several kinds, and nothing is usual among them: children and adults differ by a factor of 5.
const MOST_APART: f64 = 5.0;
/// From this many others on, the lightest and the heaviest twentieth of them do not count: slips are seldom alone.
const MANY: usize = 20;

/// The masses that other rows of a table have in the same column.
///
/// ```
/// use osim_model::{MassSlip, MassesBeside};
///
/// // The row of 150 kg among four adults, from the lightest to the heaviest.
/// let adults = MassesBeside::of(&[55.0, 62.0, 71.0, 80.0, 150.0], 150.0).unwrap();
/// // 150 lb are 68 kg.
/// assert_eq!(adults.slip(150.0), Some(MassSlip::Pounds));
/// assert_eq!(adults.slip(620.0), Some(MassSlip::TenTimes));
/// assert_eq!(adults.slip(95.0), None);
/// // A mouse among adults is meant: no slip makes 20 g of a person.
/// assert_eq!(adults.slip(0.02), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassesBeside {
    /// The lightest of them, kg.
    pub lightest_kg: f64,
    /// The heaviest, kg.
    pub heaviest_kg: f64,
}

impl MassesBeside {
    /// What is usual among the masses of a column but one, `own_kg`. `sorted` are all of them in kg, from the lightest to the
    /// heaviest. `None` where the others are too few to say, or of several kinds.
    #[must_use]
    pub fn of(sorted: &[f64], own_kg: f64) -> Option<Self> {
        let count = sorted.len().checked_sub(1).filter(|&count| count >= FEWEST)?;
        let own = sorted.partition_point(|&kg| kg < own_kg);
        let other = |at: usize| sorted.get(if at < own { at } else { at + 1 }).copied();
        let ends = if count < MANY { 0 } else { count / MANY };
        let (lightest_kg, heaviest_kg) = (other(ends)?, other(count - 1 - ends)?);
        (heaviest_kg <= lightest_kg * MOST_APART).then_some(Self { lightest_kg, heaviest_kg })
    }

    /// What would bring `kg` among them, where it is out of line.
    #[must_use]
    pub fn slip(&self, kg: f64) -> Option<MassSlip> {
        let usual = self.lightest_kg..=self.heaviest_kg;
        if (self.lightest_kg / MARGIN..=self.heaviest_kg * MARGIN).contains(&kg) {
            return None;
        }
        let slips = [
            (MassSlip::Grams, 1000.0),
            (MassSlip::TenTimes, 10.0),
            (MassSlip::Pounds, 1.0 / POUND_KG),
            (MassSlip::OthersInPounds, POUND_KG),
            (MassSlip::Tenth, 0.1),
            (MassSlip::Tonnes, 1.0 / 1000.0),
        ];
        slips.into_iter().find(|(_, times)| usual.contains(&(kg / times))).map(|(slip, _)| slip)
    }
}
