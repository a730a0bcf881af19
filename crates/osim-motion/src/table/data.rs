//! A table over time.

use super::header::AngleUnit;
use super::times::rising;
use crate::fault::MotionFault;

/// A table over time, as OpenSim's `.mot` and `.sto` files have it.
///
/// ```
/// use osim_motion::Table;
///
/// let text = "name walk\ninDegrees=yes\nendheader\ntime\tknee_angle_r\n0.0\t10\n0.1\t12\n";
/// let table = Table::read(text.as_bytes())?;
/// assert_eq!((table.time_s.as_slice(), table.column("knee_angle_r").unwrap().values.as_slice()), ([0.0, 0.1].as_slice(), [10.0, 12.0].as_slice()));
/// # Ok::<(), osim_motion::MotionFault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Table {
    /// The time of each row, s, rising.
    pub time_s: Vec<f64>,
    /// All other columns, in the order of the file.
    pub columns: Vec<Column>,
    /// The unit of its angles, where the header says it.
    pub declared: Option<AngleUnit>,
    /// Whether the header has a `version`: then OpenSim takes angles of an undeclared unit for radians.
    pub has_version: bool,
    /// The line of each row in the file, from 1.
    pub lines: Vec<usize>,
}

/// One column of a table.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Column {
    /// Its name, as in the file.
    pub name: String,
    /// One number for each row; NaN where the file says so.
    pub values: Vec<f64>,
}

impl Table {
    /// A table that was not in a file.
    ///
    /// # Errors
    /// Columns of other lengths than `time_s`, or times that do not rise; lines count from the first row.
    pub fn of_columns(
        time_s: Vec<f64>,
        columns: Vec<(String, Vec<f64>)>,
        unit: AngleUnit,
    ) -> Result<Self, MotionFault> {
        let lines: Vec<usize> = (1..=time_s.len()).collect();
        rising(&time_s, &lines)?;
        if let Some((name, values)) = columns.iter().find(|(_, values)| values.len() != time_s.len()) {
            let (given, rows) = (values.len(), time_s.len());
            return Err(MotionFault::new(format!(
                "column '{name}' has {given} values, but there are {rows} times"
            )));
        }
        let columns = columns.into_iter().map(|(name, values)| Column { name, values }).collect();
        Ok(Self { time_s, columns, declared: Some(unit), has_version: true, lines })
    }

    /// The first column of this name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// How many rows it has.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.time_s.len()
    }

    /// Checks that a column has a finite number in each row.
    ///
    /// # Errors
    /// The first row in which it has none.
    pub fn finite(&self, column: &Column) -> Result<(), MotionFault> {
        let odd = column.values.iter().position(|value| !value.is_finite());
        match odd.and_then(|row| Some((row, *self.lines.get(row)?))) {
            None => Ok(()),
            Some((row, line)) => {
                let value = column.values.get(row).copied().unwrap_or(f64::NAN);
                Err(MotionFault::at(
                    line,
                    format!("column '{}' is {value}, expected a finite number", column.name),
                ))
            }
        }
    }

    /// The time between rows, s, where all are equally far apart within one percent.
    #[must_use]
    pub fn even_step_s(&self) -> Option<f64> {
        let (first, last) = (self.time_s.first()?, self.time_s.last()?);
        let mean = (last - first) / self.rows().checked_sub(1).filter(|&steps| steps > 0)? as f64;
        let is_even = |pair: &[f64]| matches!(pair, [a, b] if ((b - a) - mean).abs() <= 0.01 * mean);
        self.time_s.windows(2).all(is_even).then_some(mean)
    }
}
