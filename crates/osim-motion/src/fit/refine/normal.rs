//! Normal equations of many residuals: some unknowns are in all of them, the others each in one window.

use super::cholesky::{Factor, product};

/// What is added to a diagonal that nothing answers to.
const LEAST: f64 = 1e-12;

/// The unknowns of one window.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Block {
    /// Among each other.
    pub(super) own: Vec<Vec<f64>>,
    /// For each of them, with the shared ones.
    pub(super) with_shared: Vec<Vec<f64>>,
    /// Half of the slope of the cost.
    pub(super) slope: Vec<f64>,
}

/// The sum of products of slopes, and of slopes and residuals.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Normal {
    pub(super) shared: Vec<Vec<f64>>,
    pub(super) slope: Vec<f64>,
    pub(super) blocks: Vec<Block>,
    /// The sum of squares of the residuals.
    pub(super) cost: f64,
}

/// A step of all unknowns.
pub(super) struct Step {
    pub(super) shared: Vec<f64>,
    pub(super) blocks: Vec<Vec<f64>>,
}

impl Block {
    pub(super) fn new(size: usize, shared: usize) -> Self {
        Self {
            own: vec![vec![0.0; size]; size],
            with_shared: vec![vec![0.0; shared]; size],
            slope: vec![0.0; size],
        }
    }
}

impl Normal {
    pub(super) fn new(shared: usize) -> Self {
        Self {
            shared: vec![vec![0.0; shared]; shared],
            slope: vec![0.0; shared],
            blocks: Vec::new(),
            cost: 0.0,
        }
    }

    /// Adds a residual with its slopes by the shared unknowns.
    pub(super) fn add_shared(&mut self, value: f64, slopes: &[f64]) {
        self.cost += value * value;
        add_outer(&mut self.shared, slopes, slopes);
        add_times(&mut self.slope, value, slopes);
    }

    /// The step to where the cost would be least if residuals were straight lines, shortened by `damping` (Levenberg–Marquardt). A
    /// shared unknown that is `held` stays. `None` if the equations have no single solution.
    pub(super) fn step(&self, damping: f64, held: &[bool]) -> Option<Step> {
        let mut left = damped(&self.shared, damping);
        let mut slope = self.slope.clone();
        let mut eliminated = Vec::with_capacity(self.blocks.len());
        for block in &self.blocks {
            let factor = Factor::of(&damped(&block.own, damping))?;
            let size = slope.len();
            // For each shared unknown, what the window's unknowns would do.
            let column = |place: usize| -> Vec<f64> {
                block.with_shared.iter().map(|row| row.get(place).copied().unwrap_or_default()).collect()
            };
            let columns: Vec<Vec<f64>> = (0..size).map(column).collect();
            let own = factor.solve(&block.slope);
            for ((row, value), column) in left.iter_mut().zip(&mut slope).zip(&columns) {
                *value -= product(column, &own);
                let answer = factor.solve(column);
                row.iter_mut().zip(&columns).for_each(|(cell, other)| *cell -= product(&answer, other));
            }
            eliminated.push((factor, columns));
        }
        hold(&mut left, &mut slope, held);
        let shared: Vec<f64> = match slope.is_empty() {
            true => Vec::new(),
            false => Factor::of(&left)?.solve(&slope).iter().map(|value| -value).collect(),
        };
        let blocks = self.blocks.iter().zip(&eliminated).map(|(block, (factor, columns))| {
            let mut right = block.slope.clone();
            columns.iter().zip(&shared).for_each(|(column, step)| add_times(&mut right, *step, column));
            factor.solve(&right).iter().map(|value| -value).collect()
        });
        Some(Step { blocks: blocks.collect(), shared })
    }

    /// The inverse of what is left of the shared unknowns once the others follow them: their covariance, for residuals with a variance
    /// of 1. Those that are `held` have none.
    pub(super) fn covariance(&self, held: &[bool]) -> Option<Vec<Vec<f64>>> {
        let unit = |place: usize| -> Option<Vec<f64>> {
            let mut one = self.clone();
            one.slope.fill(0.0);
            one.blocks.iter_mut().for_each(|block| block.slope.fill(0.0));
            *one.slope.get_mut(place)? = -1.0;
            Some(one.step(0.0, held)?.shared)
        };
        (0..self.slope.len()).map(unit).collect()
    }
}

/// A row and column of an unknown that stays become those of the unit matrix.
fn hold(matrix: &mut [Vec<f64>], slope: &mut [f64], held: &[bool]) {
    for (place, row) in matrix.iter_mut().enumerate() {
        let own = held.get(place).copied().unwrap_or(false);
        for (other, cell) in row.iter_mut().enumerate() {
            if own || held.get(other).copied().unwrap_or(false) {
                *cell = if other == place { 1.0 } else { 0.0 };
            }
        }
    }
    for (value, _) in slope.iter_mut().zip(held).filter(|(_, held)| **held) {
        *value = 0.0;
    }
}

fn damped(matrix: &[Vec<f64>], damping: f64) -> Vec<Vec<f64>> {
    let mut matrix = matrix.to_vec();
    for (place, row) in matrix.iter_mut().enumerate() {
        if let Some(diagonal) = row.get_mut(place) {
            *diagonal += damping * *diagonal + LEAST;
        }
    }
    matrix
}

/// Adds the outer product of two lists.
pub(super) fn add_outer(matrix: &mut [Vec<f64>], rows: &[f64], columns: &[f64]) {
    for (row, &part) in matrix.iter_mut().zip(rows) {
        if part != 0.0 {
            add_times(row, part, columns);
        }
    }
}

/// Adds a multiple of a list.
pub(super) fn add_times(sum: &mut [f64], factor: f64, parts: &[f64]) {
    sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += factor * part);
}
