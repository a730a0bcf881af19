//! How the floor moves under the feet: a treadmill's belt.

use crate::fault::MotionFault;
use crate::table::Table;

/// The velocity of the belt in ground, m/s.
#[derive(Debug, Clone, PartialEq)]
pub enum Belt {
    /// The same in all frames; 0 for a floor.
    Constant([f64; 3]),
    /// Frame by frame.
    Each(Vec<[f64; 3]>),
}

impl Belt {
    /// A belt that runs at this speed against x, under somebody who walks towards x, m/s.
    #[must_use]
    pub const fn against_x(speed_m_s: f64) -> Self {
        Self::Constant([-speed_m_s, 0.0, 0.0])
    }

    /// The same with the speed in a column of the recording, m/s.
    ///
    /// # Errors
    /// No such column, or a row without a number.
    pub fn of_column(table: &Table, name: &str) -> Result<Self, MotionFault> {
        let none = || MotionFault::new(format!("it has no column '{name}' for the speed of the belt"));
        let column = table.column(name).ok_or_else(none)?;
        table.finite(column)?;
        Ok(Self::Each(column.values.iter().map(|speed| [-speed, 0.0, 0.0]).collect()))
    }

    pub(crate) fn at(&self, frame: usize) -> [f64; 3] {
        match self {
            Self::Constant(velocity) => *velocity,
            Self::Each(all) => all.get(frame).copied().unwrap_or_default(),
        }
    }
}

impl Default for Belt {
    /// A floor.
    fn default() -> Self {
        Self::Constant([0.0; 3])
    }
}

impl From<[f64; 3]> for Belt {
    fn from(velocity: [f64; 3]) -> Self {
        Self::Constant(velocity)
    }
}
