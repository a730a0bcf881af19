//! What stands above the rows.

use crate::fault::MotionFault;

/// The unit of the angles of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleUnit {
    /// Degrees.
    Degrees,
    /// Radians.
    Radians,
}

impl AngleUnit {
    /// What a number of this unit is multiplied by to be in rad.
    #[must_use]
    pub const fn radians(self) -> f64 {
        match self {
            Self::Degrees => std::f64::consts::PI / 180.0,
            Self::Radians => 1.0,
        }
    }

    /// As in messages.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Degrees => "degrees",
            Self::Radians => "radians",
        }
    }
}

/// What a header says.
pub(super) struct Header {
    pub(super) declared: Option<AngleUnit>,
    pub(super) has_version: bool,
    /// Index of the line `endheader`, from 0.
    pub(super) end: usize,
}

impl Header {
    pub(super) fn read(text: &str) -> Result<Self, MotionFault> {
        let mut header = Self { declared: None, has_version: false, end: 0 };
        for (index, line) in text.lines().enumerate() {
            let line = line.trim_ascii();
            if line.eq_ignore_ascii_case("endheader") {
                header.end = index;
                return Ok(header);
            }
            header.take(line);
        }
        Err(MotionFault::new(
            "it has no line `endheader`: a motion is a .mot or .sto file of OpenSim, with a header that ends so",
        ))
    }

    fn take(&mut self, line: &str) {
        let lower = line.to_ascii_lowercase();
        // `inDegrees=yes`, `inDegrees yes`, and a sentence that OpenSim writes for people.
        let (key, value) = lower.split_once(['=', ' ', '\t']).unwrap_or((lower.as_str(), ""));
        match key.trim_ascii() {
            "indegrees" => {
                let yes = matches!(value.trim_start_matches('=').trim_ascii(), "yes" | "true" | "1" | "y");
                self.declared = Some(if yes { AngleUnit::Degrees } else { AngleUnit::Radians });
            }
            "version" => self.has_version = true,
            _ if lower.contains("angles are in degrees") => self.said(AngleUnit::Degrees),
            _ if lower.contains("angles are in radians") => self.said(AngleUnit::Radians),
            _ => {}
        }
    }

    /// A sentence counts where no property says it.
    fn said(&mut self, unit: AngleUnit) {
        self.declared.get_or_insert(unit);
    }
}
