//! Numbers in the text of meshes, and how many points there may be.

use super::fault::MeshFault;

/// Points that a mesh may have at most.
pub(super) const MOST_POINTS: usize = 2_000_000;

/// Triples of numbers in text; `what` they are, for messages.
pub(super) fn triples<'t>(
    words: impl Iterator<Item = &'t str>,
    what: &'static str,
) -> Result<Vec<[f64; 3]>, MeshFault> {
    let mut points = Vec::new();
    let mut point = [0.0; 3];
    let mut filled = 0;
    for word in words {
        let value = number(word, what)?;
        if let Some(slot) = point.get_mut(filled) {
            *slot = value;
        }
        filled += 1;
        if filled == point.len() {
            add(&mut points, point)?;
            filled = 0;
        }
    }
    if filled == 0 { Ok(points) } else { Err(MeshFault::Truncated(what)) }
}

pub(super) fn number(word: &str, what: &str) -> Result<f64, MeshFault> {
    let broken = || MeshFault::NotUnderstood(format!("{:?} among {what} is not a number", shortened(word)));
    word.parse().map_err(|_| broken())
}

/// The start of a word, for messages.
pub(super) fn shortened(word: &str) -> String {
    word.chars().take(30).collect()
}

pub(super) fn add(points: &mut Vec<[f64; 3]>, point: [f64; 3]) -> Result<(), MeshFault> {
    points.push(point);
    within(points.len())
}

pub(super) fn within(points: usize) -> Result<(), MeshFault> {
    let most = MOST_POINTS;
    if points > most { Err(MeshFault::TooManyPoints { most }) } else { Ok(()) }
}
