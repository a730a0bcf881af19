//! Normal equations with a band for splines and full rows for constants, and damped Gauss-Newton steps.

use std::ops::Range;

/// The number of constants: the height of the floor, two components of the belt's velocity, and how much higher the floor is under the
/// second foot.
pub(super) const CONSTANTS: usize = 4;

/// The normal equations A d = -g. The coefficients of the splines come first, then the constants.
#[derive(Debug, Clone)]
pub(super) struct NormalEquations {
    /// For each unknown, its row of A from the first related unknown to the diagonal; and where this row ends in `entries`.
    entries: Vec<f64>,
    ends: Vec<usize>,
    pub(super) gradient: Vec<f64>,
}

impl NormalEquations {
    /// Equations for `coefficients` of cubic splines, in blocks of this size of which each is related to the three before it, and for the
    /// constants.
    pub(super) fn new(coefficients: usize, block: usize) -> Self {
        let count = coefficients + CONSTANTS;
        let first = |i: usize| if i < coefficients { (i / block).saturating_sub(3) * block } else { 0 };
        let length = |i: usize| i + 1 - first(i);
        let mut ends: Vec<usize> = (0..count).map(length).collect();
        (1..count).for_each(|i| ends[i] += ends[i - 1]);
        Self { entries: vec![0.0; ends.last().copied().unwrap_or(0)], ends, gradient: vec![0.0; count] }
    }

    /// The first unknown that is related to unknown `i`, and its row.
    fn row(&self, i: usize) -> (usize, Range<usize>) {
        let start = if i > 0 { self.ends[i - 1] } else { 0 };
        (i + 1 - (self.ends[i] - start), start..self.ends[i])
    }

    /// Adds residuals that depend on the same `unknowns`, in rising order; `slopes` has the derivatives of the first residual, then of the
    /// next.
    pub(super) fn add(&mut self, unknowns: &[usize], slopes: &[f64], residuals: &[f64]) {
        // Unknowns without a gap between them are next to each other in a row, too: where each run begins and ends, and its first unknown.
        let mut runs: Vec<(Range<usize>, usize)> = Vec::new();
        for run in unknowns.chunk_by(|a, b| a + 1 == *b) {
            let start = runs.last().map_or(0, |(before, _)| before.end);
            runs.push((start..start + run.len(), run[0]));
        }
        let mut products = vec![0.0; unknowns.len()];
        for (number, &i) in unknowns.iter().enumerate() {
            products.fill(0.0);
            for (row, residual) in slopes.chunks_exact(unknowns.len()).zip(residuals) {
                let slope = row[number];
                self.gradient[i] += slope * residual;
                products[..=number].iter_mut().zip(row).for_each(|(sum, other)| *sum += slope * other);
            }
            let (first, row) = self.row(i);
            for (run, unknown) in runs.iter().take_while(|(run, _)| run.start <= number) {
                let entries = &mut self.entries[row.start + unknown - first..];
                let products = &products[run.start..run.end.min(number + 1)];
                entries.iter_mut().zip(products).for_each(|(entry, product)| *entry += product);
            }
        }
    }

    /// Adds sums of squares without a gradient: `products` (row by row) are those of the derivatives by the values of some curves, and
    /// each value is a weighted sum of unknowns: `blocks` has where those of all curves begin, with their weight; `curves` are places
    /// in a block.
    pub(super) fn add_products(&mut self, blocks: &[(usize, f64)], curves: &[usize], products: &[f64]) {
        for (number, (start, weight)) in blocks.iter().enumerate() {
            for (curve, products) in curves.iter().zip(products.chunks_exact(curves.len())) {
                let (first, row) = self.row(start + curve);
                for (other_start, other_weight) in &blocks[..=number] {
                    let others = curves.iter().map(|other| other_start + other);
                    let entries = others.zip(products).filter(|(other, _)| *other <= start + curve);
                    entries.for_each(|(other, product)| {
                        self.entries[row.start + other - first] += weight * other_weight * product;
                    });
                }
            }
        }
    }

    /// A times `vector`.
    pub(super) fn times_vector(&self, vector: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; vector.len()];
        for i in 0..vector.len() {
            let (first, row) = self.row(i);
            let entries = &self.entries[row.start..row.end - 1];
            product[i] += self.entries[row.end - 1] * vector[i] + dot_product(entries, &vector[first..]);
            let value = vector[i];
            product[first..i].iter_mut().zip(entries).for_each(|(sum, entry)| *sum += entry * value);
        }
        product
    }

    /// The step d of (A + damping · diag A) d = -g; `None` if the matrix is not positive definite.
    pub(super) fn damped_step(&self, damping: f64) -> Option<Vec<f64>> {
        let mut factor = self.entries.clone();
        let mut step: Vec<f64> = Vec::with_capacity(self.ends.len());
        for i in 0..self.ends.len() {
            let (first, range) = self.row(i);
            let (above, rest) = factor.split_at_mut(range.start);
            let row = &mut rest[..range.len()];
            for j in first..i {
                let (begin, other) = self.row(j);
                let from = begin.max(first);
                let sum = dot_product(&row[from - first..j - first], &above[other.start + from - begin..]);
                row[j - first] = (row[j - first] - sum) / above[other.end - 1];
            }
            let (diagonal, entries) = row.split_last_mut()?;
            let square = *diagonal * (1.0 + damping) - dot_product(entries, entries);
            *diagonal = Some(square.sqrt()).filter(|root| *root > 0.0)?;
            step.push((-self.gradient[i] - dot_product(entries, &step[first..])) / *diagonal);
        }
        for i in (0..step.len()).rev() {
            let (first, range) = self.row(i);
            let (diagonal, entries) = factor[range].split_last()?;
            step[i] /= diagonal;
            let value = step[i];
            step[first..i].iter_mut().zip(entries).for_each(|(one, entry)| *one -= entry * value);
        }
        Some(step)
    }
}

/// The sum of the products of as many numbers as both lists have: eight sums at a time, which a processor computes side by side.
pub(super) fn dot_product(one: &[f64], other: &[f64]) -> f64 {
    let count = one.len().min(other.len());
    let (ones, others) = (one[..count].chunks_exact(8), other[..count].chunks_exact(8));
    let rest: f64 = ones.remainder().iter().zip(others.remainder()).map(|(a, b)| a * b).sum();
    let add = |sums: [f64; 8], (a, b): (&[f64], &[f64])| std::array::from_fn(|i| sums[i] + a[i] * b[i]);
    ones.zip(others).fold([0.0; 8], add).into_iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equations of 9 coefficients and all constants, and the same as a dense matrix.
    fn equations() -> (NormalEquations, Vec<Vec<f64>>) {
        let mut equations = NormalEquations::new(9, 1);
        let mut dense = vec![vec![0.0; 13]; 13];
        for number in 0..40_usize {
            let first = number % 6;
            let slope = |place: usize| ((number * 7 + place * 3 + number * place) as f64).sin();
            let places: Vec<usize> = (first..first + 4).chain(9..13).collect();
            let of_row =
                |row: usize| places.iter().map(move |place| slope(place + row)).collect::<Vec<f64>>();
            let rows = [of_row(0), of_row(20)];
            equations.add(&places, &rows.concat(), &[slope(30), slope(31)]);
            for row in rows {
                for (&i, a) in places.iter().zip(&row) {
                    places.iter().zip(&row).for_each(|(&j, b)| dense[i][j] += a * b);
                }
            }
        }
        (equations, dense)
    }

    #[test]
    fn a_step_solves_the_damped_equations() {
        let (equations, dense) = equations();
        for damping in [0.0, 0.3] {
            let step = equations.damped_step(damping).unwrap();
            for (i, row) in dense.iter().enumerate() {
                let left = dot_product(row, &step) + damping * row[i] * step[i];
                assert!((left + equations.gradient[i]).abs() < 1e-9, "{damping} {i}");
            }
        }
    }

    #[test]
    fn the_product_is_that_of_the_dense_matrix() {
        let (equations, dense) = equations();
        let vector: Vec<f64> = (0..13).map(|place| f64::from(place).cos()).collect();
        for (product, row) in equations.times_vector(&vector).iter().zip(&dense) {
            assert!((product - dot_product(row, &vector)).abs() < 1e-12);
        }
    }

    #[test]
    fn products_of_curves_are_those_of_their_rows() {
        // Two blocks of four unknowns; of each the curves 0, 1 and 3, with two residuals.
        let (blocks, curves) = ([(1, 0.4), (5, 0.6)], [0, 1, 3]);
        let rows = [[0.3, -0.8, 1.7], [2.0, 0.1, -0.4]];
        let (mut one, mut other) = (NormalEquations::new(9, 4), NormalEquations::new(9, 4));
        for row in rows {
            let slopes = blocks.iter().flat_map(|(start, weight)| {
                curves.iter().zip(row).map(move |(curve, slope)| (start + curve, weight * slope))
            });
            let (unknowns, slopes): (Vec<usize>, Vec<f64>) = slopes.unzip();
            one.add(&unknowns, &slopes, &[0.0]);
        }
        let product = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
        let products: Vec<f64> = (0..9).map(|place| product(place / 3, place % 3)).collect();
        other.add_products(&blocks, &curves, &products);
        assert!(one.entries.iter().zip(&other.entries).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!(one.entries.iter().any(|entry| *entry != 0.0));
    }

    #[test]
    fn equations_without_a_solution_have_no_step() {
        assert_eq!(NormalEquations::new(2, 1).damped_step(0.0), None);
    }
}
