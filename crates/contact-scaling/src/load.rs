//! A load and the spheres that share it.

use crate::Scale;
use crate::error::{DomainError, at_least_one, positive};

/// A total load F, in N, on n spheres that share it equally (4).
///
/// F > 0 and n ≥ 1, finite: checked once. The load need not be body weight: a multiple of it, or a bite.
///
/// ```
/// # use contact_scaling::SharedLoad;
/// assert_eq!(SharedLoad::new(600.0, 6.0)?.per_sphere_n(), 100.0);
/// assert!(SharedLoad::new(600.0, 0.5).is_err());
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SharedLoad {
    load_n: f64,
    sphere_count: f64,
}

impl SharedLoad {
    /// The load F (N) on n spheres.
    ///
    /// # Errors
    /// [`DomainError`] unless F is finite and above 0, and n finite and at least 1.
    pub fn new(load_n: f64, sphere_count: f64) -> Result<Self, DomainError> {
        Ok(Self {
            load_n: positive("load", load_n)?,
            sphere_count: at_least_one("sphere count", sphere_count)?,
        })
    }

    /// A multiple of the body weight of `scale` on its spheres.
    ///
    /// # Errors
    /// [`DomainError`] unless the load is finite and above 0.
    pub fn body_weights(scale: &Scale, multiple: f64) -> Result<Self, DomainError> {
        Self::new(positive("body weights", multiple)? * scale.body_weight_n(), scale.sphere_count())
    }

    /// The total load F, in N.
    #[must_use]
    pub fn load_n(&self) -> f64 {
        self.load_n
    }

    /// The spheres n that share it.
    #[must_use]
    pub fn sphere_count(&self) -> f64 {
        self.sphere_count
    }

    /// The load on each sphere, F / n, in N.
    #[must_use]
    pub fn per_sphere_n(&self) -> f64 {
        self.load_n / self.sphere_count
    }
}
