//! Equations with a symmetric positive definite matrix. A library for such small ones would be a twentieth of all that is compiled.

/// L of a matrix A = L Lᵀ: the rows of its lower half.
pub(super) struct Factor {
    rows: Vec<Vec<f64>>,
}

impl Factor {
    /// That of a matrix of which the lower half is read; `None` where it is not positive definite.
    pub(super) fn of(matrix: &[Vec<f64>]) -> Option<Self> {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(matrix.len());
        for (place, row) in matrix.iter().enumerate() {
            let mut own = Vec::with_capacity(place + 1);
            for (above, value) in rows.iter().zip(row) {
                own.push((value - product(&own, above)) / above.last()?);
            }
            let left = row.get(place)? - product(&own, &own);
            own.push(Some(left).filter(|&left| left > 0.0)?.sqrt());
            rows.push(own);
        }
        Some(Self { rows })
    }

    /// x of A x = b.
    pub(super) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(right.len());
        for (row, value) in self.rows.iter().zip(right) {
            let diagonal = row.last().copied().unwrap_or(1.0);
            values.push((value - product(row, &values)) / diagonal);
        }
        for (place, row) in self.rows.iter().enumerate().rev() {
            let (before, rest) = values.split_at_mut(place);
            let Some((value, diagonal)) = rest.first_mut().zip(row.last()) else { continue };
            *value /= diagonal;
            before.iter_mut().zip(row).for_each(|(above, part)| *above -= part * *value);
        }
        values
    }
}

/// The sum of products, over as many as the shorter one has.
pub(super) fn product(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_solved() {
        // By hand: 4x + 2y + z = 11, 2x + 5y + 3z = 21, x + 3y + 6z = 25 for x, y, z = 1, 2, 3.
        let matrix = [vec![4.0, 2.0, 1.0], vec![2.0, 5.0, 3.0], vec![1.0, 3.0, 6.0]];
        let solved = Factor::of(&matrix).unwrap().solve(&[11.0, 21.0, 25.0]);
        assert!(solved.iter().zip([1.0, 2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{solved:?}");
    }

    #[test]
    fn a_matrix_that_is_not_positive_has_no_factor() {
        assert!(Factor::of(&[vec![1.0, 2.0], vec![2.0, 1.0]]).is_none());
        assert!(Factor::of(&[vec![f64::NAN]]).is_none());
        assert!(Factor::of(&[vec![0.0]]).is_none());
    }
}
