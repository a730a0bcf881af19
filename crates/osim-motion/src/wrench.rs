//! Forces with their moments, and their centre of pressure.

use osim_model::DVec3;

use crate::states::ContactState;

/// The sum of several forces, with its moment.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// The sum of the forces, N.
    pub force_n: DVec3,
    /// The moment of the forces about the origin of ground, N m.
    pub moment_n_m: DVec3,
}

impl Wrench {
    /// The sum of the forces of contacts.
    pub fn from_states<'s>(states: impl IntoIterator<Item = &'s ContactState>) -> Self {
        states.into_iter().fold(Self::default(), |sum, state| sum.with_force(state.force_n, state.point_m))
    }

    /// Adds a force at a point, N and m.
    pub fn with_force(mut self, force_n: DVec3, point_m: DVec3) -> Self {
        self.force_n += force_n;
        self.moment_n_m += point_m.cross(force_n);
        self
    }

    pub fn plus(&self, other: &Self) -> Self {
        Self { force_n: self.force_n + other.force_n, moment_n_m: self.moment_n_m + other.moment_n_m }
    }

    /// The centre of pressure in the plane through `on_plane_m` (m) with the unit `normal`, and the moment about the normal there:
    /// p = p0 + n × M0/(F·n) with M0 = M − p0 × F, and n·(M0 − (p − p0) × F). `None` if the force along the normal is not
    /// above `least_n`.
    pub fn centre_of_pressure(
        &self,
        normal: DVec3,
        on_plane_m: DVec3,
        least_n: f64,
    ) -> Option<CentreOfPressure> {
        let along = self.force_n.dot(normal);
        if along.is_nan() || along.abs() <= least_n {
            return None;
        }
        let moment = self.moment_n_m - on_plane_m.cross(self.force_n);
        let from_plane = normal.cross(moment) / along;
        Some(CentreOfPressure {
            point_m: on_plane_m + from_plane,
            free_moment_n_m: (moment - from_plane.cross(self.force_n)).dot(normal),
        })
    }
}

/// The centre of pressure of a ground reaction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CentreOfPressure {
    pub point_m: DVec3,
    /// The moment about the normal there, N m.
    pub free_moment_n_m: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_push_acts_where_it_is() {
        // 100 N up and 20 N forward at (0.3, 0, 0.1): the point comes back, and nothing turns about the normal.
        let (up, at) = (DVec3::Y, DVec3::new);
        let wrench = Wrench::default().with_force(at(20.0, 100.0, 0.0), at(0.3, 0.0, 0.1));
        let centre = wrench.centre_of_pressure(up, at(5.0, 0.0, -7.0), 1.0).unwrap();
        assert!(centre.point_m.abs_diff_eq(at(0.3, 0.0, 0.1), 1e-12), "{centre:?}");
        assert!(centre.free_moment_n_m.abs() < 1e-12);
        // Two opposite pulls along x, 0.2 m apart in z, turn about y by z × x = y: 0.1 * 20 + 0.1 * 20.
        let pull = at(20.0, 0.0, 0.0);
        let turned = wrench.with_force(pull, at(0.3, 0.0, 0.2)).with_force(-pull, at(0.3, 0.0, 0.0));
        let centre = turned.centre_of_pressure(up, DVec3::ZERO, 1.0).unwrap();
        assert!((centre.free_moment_n_m - 4.0).abs() < 1e-12, "{centre:?}");
        assert_eq!(turned.centre_of_pressure(up, DVec3::ZERO, 100.0), None);
    }
}
