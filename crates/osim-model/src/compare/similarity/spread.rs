//! Many numbers in three.

/// The median of some numbers, and their range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The middle one; the mean of both where their number is even.
    pub median: f64,
    /// The least.
    pub min: f64,
    /// The greatest.
    pub max: f64,
}

impl Spread {
    /// Of these numbers; `None` where there is none.
    ///
    /// ```
    /// use osim_model::compare::Spread;
    ///
    /// let spread = Spread::of([3.0, 1.0, 2.0, 6.0]);
    /// assert_eq!(spread, Some(Spread { median: 2.5, min: 1.0, max: 6.0 }));
    /// ```
    #[must_use]
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let (min, max) = (*sorted.first()?, *sorted.last()?);
        let upper = *sorted.get(sorted.len() / 2)?;
        let lower = *sorted.get((sorted.len() - 1) / 2)?;
        Some(Self { median: lower / 2.0 + upper / 2.0, min, max })
    }
}
