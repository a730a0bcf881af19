//! Forces with their moments, and where they act.

use osim_model::cross;
use osim_model::feet::dot;

use crate::states::ContactState;

/// Forces of several contacts, as one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// Their sum, N.
    pub force_n: [f64; 3],
    /// Their moment about the origin of ground, N m.
    pub moment_n_m: [f64; 3],
}

impl Wrench {
    /// The sum of forces at points of ground.
    pub fn of<'s>(states: impl IntoIterator<Item = &'s ContactState>) -> Self {
        states.into_iter().fold(Self::default(), |sum, state| sum.plus(state.force_n, state.point_m))
    }

    /// With another force at a point, N and m.
    pub fn plus(mut self, force_n: [f64; 3], point_m: [f64; 3]) -> Self {
        let moment = cross(point_m, force_n);
        self.force_n = std::array::from_fn(|i| self.force_n[i] + force_n[i]);
        self.moment_n_m = std::array::from_fn(|i| self.moment_n_m[i] + moment[i]);
        self
    }

    pub fn and(&self, other: &Self) -> Self {
        let sum = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| a[i] + b[i]);
        Self { force_n: sum(self.force_n, other.force_n), moment_n_m: sum(self.moment_n_m, other.moment_n_m) }
    }

    /// Where the force meets the plane through `on_plane_m` (m) with the unit `normal`, and the moment about the normal there:
    /// p = p0 + n × M0/(F·n) with M0 = M − p0 × F, and n·(M0 − (p − p0) × F). `None` where the force along the normal is not
    /// above `least_n`.
    pub fn centre_of_pressure(
        &self,
        normal: [f64; 3],
        on_plane_m: [f64; 3],
        least_n: f64,
    ) -> Option<CentreOfPressure> {
        let along = dot(self.force_n, normal);
        if along.is_nan() || along.abs() <= least_n {
            return None;
        }
        let arm = cross(on_plane_m, self.force_n);
        let moment: [f64; 3] = std::array::from_fn(|i| self.moment_n_m[i] - arm[i]);
        let from_plane = cross(normal, moment).map(|part| part / along);
        let turned = cross(from_plane, self.force_n);
        let left: [f64; 3] = std::array::from_fn(|i| moment[i] - turned[i]);
        Some(CentreOfPressure {
            point_m: std::array::from_fn(|i| on_plane_m[i] + from_plane[i]),
            free_moment_n_m: dot(left, normal),
        })
    }
}

/// Where a ground reaction acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentreOfPressure {
    pub point_m: [f64; 3],
    /// The moment about the normal there, N m.
    pub free_moment_n_m: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_push_acts_where_it_is() {
        // 100 N up and 20 N forward at (0.3, 0, 0.1): the point comes back, and nothing turns about the normal.
        let up = [0.0, 1.0, 0.0];
        let wrench = Wrench::default().plus([20.0, 100.0, 0.0], [0.3, 0.0, 0.1]);
        let centre = wrench.centre_of_pressure(up, [5.0, 0.0, -7.0], 1.0).unwrap();
        assert!(centre.point_m.iter().zip([0.3, 0.0, 0.1]).all(|(a, b)| (a - b).abs() < 1e-12), "{centre:?}");
        assert!(centre.free_moment_n_m.abs() < 1e-12);
        // Two opposite pulls along x, 0.2 m apart in z, turn about y by z × x = y: 0.1 * 20 + 0.1 * 20.
        let turned = wrench.plus([20.0, 0.0, 0.0], [0.3, 0.0, 0.2]).plus([-20.0, 0.0, 0.0], [0.3, 0.0, 0.0]);
        let centre = turned.centre_of_pressure(up, [0.0; 3], 1.0).unwrap();
        assert!((centre.free_moment_n_m - 4.0).abs() < 1e-12, "{centre:?}");
        assert_eq!(turned.centre_of_pressure(up, [0.0; 3], 100.0), None);
    }
}
