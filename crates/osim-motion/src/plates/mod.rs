//! Ground reactions as force plates measured them.

mod columns;
mod external_loads;

pub use external_loads::{ExternalLoads, Load};

use crate::fault::MotionFault;
use crate::table::{Column, Table};
use crate::wrench::Wrench;
use columns::Triples;

/// One plate: what it measured at its own times.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Plate {
    /// What its columns begin with, as in the file.
    pub name: String,
    /// The body that its force acts on, where somebody says it.
    pub body: Option<String>,
    /// Whether it has a centre of pressure; a file whose points are all 0 has none, and its moments mean nothing.
    pub has_points: bool,
    /// Its times, s.
    time_s: Vec<f64>,
    /// What it measured at each of them.
    wrenches: Vec<Wrench>,
}

impl Plate {
    /// The plates of a table of ground reactions, by the names of its columns.
    ///
    /// # Errors
    /// No columns of a force, or a number that is missing.
    pub fn all(table: &Table) -> Result<Vec<Self>, MotionFault> {
        let triples = Triples::of(table);
        if triples.forces.is_empty() {
            return Err(MotionFault::new(
                "it has no columns of a force that are known, such as ground_force_vx, ground_force_vy and ground_force_vz: an \
                 ExternalLoads file says which columns are forces",
            ));
        }
        triples
            .forces
            .iter()
            .map(|force| {
                let (point, torque) = (triples.point_of(force), triples.torque_of(force));
                Self::new(table, &force.stem, None, [Some(force.columns), point, torque])
            })
            .collect()
    }

    /// The plates that an `ExternalLoads` file names.
    ///
    /// # Errors
    /// Columns that are not there, a frame that is not ground, or a number that is missing.
    pub fn of_loads(table: &Table, loads: &ExternalLoads) -> Result<Vec<Self>, MotionFault> {
        let mut plates = Vec::new();
        for load in loads.all.iter().filter(|load| load.applies) {
            let columns = |prefix: &Option<String>| match prefix {
                Some(prefix) => columns::with_prefix(table, prefix).map(Some),
                None => Ok(None),
            };
            if let Some(frame) =
                [&load.force_frame, &load.point_frame].into_iter().find(|frame| !is_ground(frame))
            {
                return Err(MotionFault::new(format!(
                    "load '{}' is expressed in '{frame}': only loads in ground are understood",
                    load.name
                )));
            }
            let triples = [columns(&load.force)?, columns(&load.point)?, columns(&load.torque)?];
            let name = load.force.as_deref().unwrap_or(&load.name);
            plates.push(Self::new(table, name, load.body.clone(), triples)?);
        }
        if plates.is_empty() {
            return Err(MotionFault::new("none of the loads of the ExternalLoads file is applied"));
        }
        Ok(plates)
    }

    fn new(
        table: &Table,
        name: &str,
        body: Option<String>,
        [force, point, torque]: [Option<[&Column; 3]>; 3],
    ) -> Result<Self, MotionFault> {
        for column in [force, point, torque].into_iter().flatten().flatten() {
            table.finite(column)?;
        }
        let at = |columns: Option<[&Column; 3]>, row: usize| {
            columns.map_or([0.0; 3], |columns| {
                columns.map(|column| column.values.get(row).copied().unwrap_or(0.0))
            })
        };
        let has_points = point.is_some_and(|columns| {
            columns.iter().any(|column| column.values.iter().any(|&value| value != 0.0))
        });
        let wrenches = (0..table.rows())
            .map(|row| {
                let free = Wrench { force_n: [0.0; 3], moment_n_m: at(torque, row) };
                free.plus(at(force, row), at(point, row))
            })
            .collect();
        Ok(Self { name: name.to_owned(), body, has_points, time_s: table.time_s.clone(), wrenches })
    }

    /// What it measured at a time; straight lines between its own times. `None` before the first and after the last.
    #[must_use]
    pub fn at(&self, time_s: f64) -> Option<Wrench> {
        /// Times of two files that are as close are one, s: the kinematics may begin a rounding before the plates.
        const SAME: f64 = 1e-6;
        let after = self.time_s.partition_point(|&time| time < time_s);
        match (after.checked_sub(1).and_then(|before| self.point(before)), self.point(after)) {
            (Some((t0, w0)), Some((t1, w1))) => Some(w0.towards(&w1, (time_s - t0) / (t1 - t0))),
            (None, Some((first, wrench))) if first - time_s <= SAME => Some(wrench),
            (Some((last, wrench)), None) if time_s - last <= SAME => Some(wrench),
            _ => None,
        }
    }

    fn point(&self, row: usize) -> Option<(f64, Wrench)> {
        Some((*self.time_s.get(row)?, *self.wrenches.get(row)?))
    }
}

fn is_ground(frame: &str) -> bool {
    matches!(frame, "" | "ground" | "/ground")
}

impl Wrench {
    /// The part of the way to another one.
    fn towards(&self, other: &Self, part: f64) -> Self {
        let mixed = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| a[i] + part * (b[i] - a[i]));
        Self {
            force_n: mixed(self.force_n, other.force_n),
            moment_n_m: mixed(self.moment_n_m, other.moment_n_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Table {
        Table::read(text.as_bytes()).unwrap()
    }

    #[test]
    fn plates_are_found_by_their_columns() {
        let text = "endheader\ntime 1_ground_force_vx 1_ground_force_vy 1_ground_force_vz 1_ground_force_px 1_ground_force_py \
                    1_ground_force_pz 1_ground_torque_x 1_ground_torque_y 1_ground_torque_z F2x F2y F2z other\n\
                    0 0 100 0 0.5 0 0.1 0 7 0 1 2 3 9\n1 0 200 0 0.5 0 0.1 0 7 0 1 2 3 9\n";
        let plates = Plate::all(&table(text)).unwrap();
        assert_eq!(
            plates.iter().map(|plate| (plate.name.as_str(), plate.has_points)).collect::<Vec<_>>(),
            [("1_ground_force_v", true), ("F2", false)]
        );
        // Halfway: 150 N up at (0.5, 0, 0.1), and 7 N m about y.
        let half = plates[0].at(0.5).unwrap();
        assert_eq!((half.force_n, half.moment_n_m), ([0.0, 150.0, 0.0], [-15.0, 7.0, 75.0]));
        assert_eq!((plates[0].at(-0.1), plates[0].at(1.1)), (None, None));
        assert_eq!(plates[0].at(1.0).unwrap().force_n[1], 200.0);
        assert_eq!(plates[1].at(0.0).unwrap().force_n, [1.0, 2.0, 3.0]);
    }

    #[test]
    fn loads_name_their_columns() {
        let xml = "<OpenSimDocument Version=\"40000\"><ExternalLoads><objects><ExternalForce name=\"R\"><applied_to_body>calcn_r\
                   </applied_to_body><force_identifier>a_</force_identifier><point_identifier>b_</point_identifier>\
                   </ExternalForce></objects></ExternalLoads></OpenSimDocument>";
        let loads = ExternalLoads::read(xml.as_bytes()).unwrap();
        let text = "endheader\ntime a_x a_y a_z b_x b_y b_z\n0 0 10 0 0 0 0\n";
        let plates = Plate::of_loads(&table(text), &loads).unwrap();
        assert_eq!((plates[0].body.as_deref(), plates[0].has_points), (Some("calcn_r"), false));
        let lost = Plate::of_loads(&table("endheader\ntime a_x a_y\n0 0 1\n"), &loads).unwrap_err();
        assert!(lost.message.contains("'a_'"), "{lost}");
        assert!(Plate::all(&table(text)).is_err());
    }
}
