//! Random numbers from a seed, for tests with random models. A variable of the environment has the number of runs, `GENERATED_RUNS` for
//! most tests; `GENERATED_SEED` has the first seed. A failed test names its seed.

/// A generator of random numbers from a seed: SplitMix64.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn of(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    pub(crate) fn integer_below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    pub(crate) fn index(&mut self, end: usize) -> usize {
        usize::try_from(self.integer_below(end as u64)).unwrap()
    }

    pub(crate) fn one_of<'t>(&mut self, choices: &[&'t str]) -> &'t str {
        choices[self.index(choices.len())]
    }

    /// A random number from 0 to 1, with all 53 bits of a double.
    pub(crate) fn fraction(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The number in the environment variable `variable`; `otherwise` if it is not set.
pub(crate) fn number_from_environment(variable: &str, otherwise: u64) -> u64 {
    std::env::var(variable).map_or(otherwise, |text| text.parse().unwrap())
}

/// The seeds with which a test runs.
pub(crate) fn seeds() -> std::ops::Range<u64> {
    let first = number_from_environment("GENERATED_SEED", 1);
    first..first + number_from_environment("GENERATED_RUNS", 200)
}
