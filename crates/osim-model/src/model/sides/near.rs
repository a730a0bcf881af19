//! Places of two sets that belong together because they are near.

use foldhash::{HashMap, HashMapExt};

use super::mirror::distance;

/// How many places around one are looked at: where more are in so small a space, they are not those of a foot.
const MOST_AROUND: usize = 64;

/// Pairs of places, as indices of `images` and `others`, that are at most `within_m` apart: the nearest ones first, each place once.
pub(super) fn near(images: &[[[f64; 3]; 2]], others: &[[f64; 3]], within_m: f64) -> Vec<(usize, usize)> {
    if !(within_m.is_finite() && within_m > 0.0) {
        return Vec::new();
    }
    let cells = Cells::of(images, within_m);
    let mut found: Vec<(f64, usize, usize)> = Vec::new();
    for (other, &place) in others.iter().enumerate() {
        let around = cells.around(place).take(MOST_AROUND);
        let apart = around.map(|(image, there)| (distance(there, place), image, other));
        found.extend(apart.filter(|(apart, _, _)| *apart <= within_m));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    each_once(found.into_iter().map(|(_, image, other)| (image, other)), images.len(), others.len())
}

/// The first pairs whose places are in no earlier one.
fn each_once(
    pairs: impl Iterator<Item = (usize, usize)>,
    images: usize,
    others: usize,
) -> Vec<(usize, usize)> {
    let (mut image_used, mut other_used) = (vec![false; images], vec![false; others]);
    let mut chosen = Vec::new();
    for (image, other) in pairs {
        let (Some(one), Some(two)) = (image_used.get_mut(image), other_used.get_mut(other)) else { continue };
        if !*one && !*two {
            (*one, *two) = (true, true);
            chosen.push((image, other));
        }
    }
    chosen
}

/// Places by the cube of space that they are in, so that what is near is found without looking at all.
struct Cells {
    side_m: f64,
    places: HashMap<[i64; 3], Vec<(usize, [f64; 3])>>,
}

impl Cells {
    fn of(images: &[[[f64; 3]; 2]], side_m: f64) -> Self {
        let mut cells = Self { side_m, places: HashMap::new() };
        for (index, both) in images.iter().enumerate() {
            let twice = both[0] == both[1];
            for &place in both.iter().take(if twice { 1 } else { 2 }) {
                cells.places.entry(cells.cell(place)).or_default().push((index, place));
            }
        }
        cells
    }

    #[expect(clippy::cast_possible_truncation, reason = "a cast of a float ends at the largest number")]
    fn cell(&self, place: [f64; 3]) -> [i64; 3] {
        place.map(|value| (value / self.side_m).floor() as i64)
    }

    /// The places in the cell of `place` and those beside it.
    fn around(&self, place: [f64; 3]) -> impl Iterator<Item = (usize, [f64; 3])> {
        let [x, y, z] = self.cell(place);
        let beside = |value: i64| [value, value.saturating_sub(1), value.saturating_add(1)];
        let cells = beside(x)
            .into_iter()
            .flat_map(move |x| beside(y).into_iter().flat_map(move |y| beside(z).map(move |z| [x, y, z])));
        cells.filter_map(|cell| self.places.get(&cell)).flatten().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place_has_the_nearest_one_that_is_free() {
        let twice = |x: f64| [[x, 0.0, 0.0]; 2];
        let others = [[0.011, 0.0, 0.0], [0.002, 0.0, 0.0], [0.5, 0.0, 0.0]];
        // 1 mm and 2 mm apart; nothing is near 0.5.
        assert_eq!(near(&[twice(0.0), twice(0.01)], &others, 0.012), [(1, 0), (0, 1)]);
        assert_eq!(near(&[twice(0.0)], &others, f64::NAN), []);
        // Across the border of a cell.
        assert_eq!(near(&[twice(-1e-9)], &[[1e-9, 0.0, 0.0]], 0.01), [(0, 0)]);
        assert_eq!(near(&[twice(1e300)], &[[1e300, 0.0, 0.0]], 0.01), [(0, 0)]);
    }
}
