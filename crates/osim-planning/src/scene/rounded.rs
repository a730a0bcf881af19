//! Places as whole numbers: a page shows no less, and reads these quickly.

/// Places are rounded to a hundredth of a millimetre.
const PER_M: f64 = 1e5;

/// Metres in hundredths of a millimetre; parts of an axis in hundred-thousandths.
#[expect(clippy::cast_possible_truncation, reason = "what is too far away is at the edge of what is drawn")]
pub(super) fn rounded(metres: f64) -> i32 {
    (metres * PER_M).round() as i32
}
