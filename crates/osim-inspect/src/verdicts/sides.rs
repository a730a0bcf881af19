//! Whether left and right agree.

use osim_model::messages::{Phrase, counted};

use super::known::Known;

/// How many spheres each side has.
pub(super) fn right(known: &Known<'_>) -> Result<Phrase, Phrase> {
    let inspected = known.inspected;
    let Some(limbs) = inspected.limbs.as_deref().filter(|limbs| !limbs.is_empty()) else {
        return Err(inspected.limbs_unknown.clone().unwrap_or_else(|| "limbs are not known".into()));
    };
    let on = |side: &str| -> usize {
        limbs.iter().filter(|limb| limb.side == side).map(|limb| limb.spheres.len()).sum()
    };
    Ok(match (on("right"), on("left")) {
        (0, some) | (some, 0) => format!("there is one side only, with {}", spheres(some)),
        (right, left) if right == left => format!("they agree: {} on each side", spheres(right)),
        (right, left) => {
            format!("what both have agrees: {} on the right, {} on the left", spheres(right), spheres(left))
        }
    }
    .into())
}

fn spheres(count: usize) -> String {
    counted(count, "sphere")
}
