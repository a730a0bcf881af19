//! Requests for contact parameters: from wanted behaviour, and from a measurement.

use std::path::PathBuf;

use contact_scaling::fit::FittedBranch;
use osim_model::messages::{Input, phrase};

use crate::RequestFault;
use crate::options::{
    AnswerOptions, CountOptions, ForceOptions, LoadOptions, MassOptions, OutputOptions, RunOptions, SetFiles,
    WantedOptions,
};
use crate::request::inspect::AngleChoice;
use crate::values::serial::{choices, fields, meanings};
use crate::values::{ContactOnset, Count, PoissonRatio, Positive, RelativeIndentation, Signed, path};

fields! {
    /// Finds parameters from what is wanted: indentation, stiffness, restitution.
    struct DesignRequest {
        models: Vec<PathBuf> as "path::List",
        wanted: ..WantedOptions,
        dimensionless_stiffness: Option<Positive>,
        stress: Option<Positive>,
        other_young: Option<Positive>,
        other_poisson: Option<PoissonRatio>,
        state_smoothing: Option<Positive>,
        speed_smoothing: Option<Positive>,
        load: ..LoadOptions,
        masses: ..MassOptions,
        counts: ..CountOptions,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where
        Excludes("dimensionless_stiffness", "indentation"), Excludes("stress", "indentation"),
        Excludes("stress", "dimensionless_stiffness"), Needs("other_young", "other_poisson"),
        Needs("other_poisson", "other_young"), Needs("other_young", "young"),
        Excludes("state_smoothing", "state_width"), Excludes("speed_smoothing", "speed_width");

    /// Finds contact parameters from a measured indentation and force, or those of a model from recordings of its gait.
    struct FitRequest {
        file: Option<PathBuf> as "path::Optional",
        motion: Vec<PathBuf> as "path::List",
        plates: Vec<PathBuf> as "path::List",
        loads: Vec<PathBuf> as "path::List",
        fit: Vec<FittedChoice>,
        unbounded: bool,
        height_in: HeightChoice,
        belt: Option<Signed>,
        belt_column: Option<String>,
        start: Option<Signed>,
        end: Option<Signed>,
        angles: Option<AngleChoice>,
        low_pass: Option<Positive>,
        plates_delay: Option<Signed>,
        radius: Option<Positive>,
        spheres: Count,
        onset: ContactOnset,
        branch: BranchChoice,
        columns: ..ColumnOptions,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where
        Required("file"), RequiredUnless("radius", "motion"), Needs("motion", "plates"),
        Needs("plates", "motion"), Needs("loads", "motion"), Needs("fit", "motion"),
        Needs("unbounded", "motion"), Needs("height_in", "motion"), Needs("belt", "motion"),
        Needs("belt_column", "motion"), Needs("start", "motion"), Needs("end", "motion"), Excludes("belt", "belt_column"), Needs("angles", "motion"),
        Needs("low_pass", "motion"), Needs("plates_delay", "motion"), Needs("output", "motion"), Needs("output_dir", "motion"),
        Needs("in_place", "motion"), Needs("report", "motion"), Needs("summary", "motion"),
        Excludes("radius", "motion"), Excludes("spheres", "motion"), Excludes("onset", "motion"),
        Excludes("branch", "motion"), Excludes("indentation_column", "motion"),
        Excludes("force_column", "motion"), Excludes("speed_column", "motion"),
        Excludes("time_column", "motion"), Excludes("indentation_unit", "motion"),
        Excludes("force_unit", "motion"), Excludes("speed_unit", "motion"), Excludes("time_unit", "motion");

    /// Columns of the file and their units.
    struct ColumnOptions {
        indentation_column: String = "indentation".to_owned(),
        force_column: String = "force".to_owned(),
        speed_column: Option<String>,
        time_column: Option<String>,
        indentation_unit: LengthUnit,
        force_unit: ForceUnit,
        speed_unit: SpeedUnit,
        time_unit: TimeUnit,
    } where Excludes("speed_column", "time_column");
}

choices! {
    /// Which part of a measurement.
    BranchChoice: Both {
        Both = "both";
        Loading = "loading";
        Unloading = "unloading";
    }

    /// A parameter that is fitted to a recording.
    FittedChoice {
        Stiffness = "stiffness", "All stiffnesses, by one factor";
        Dissipation = "dissipation", "The dissipation of all forces";
        Height = "height", "How high the floor is";
    }

    /// The object that a fitted height moves.
    HeightChoice: Floor {
        Floor = "floor", "The floor, along its normal: spheres stay on the sole";
        Spheres = "spheres", "All spheres, in their bodies: the floor stays";
    }

    /// Unit of a length.
    LengthUnit: M {
        M = "m";
        Mm = "mm";
        Um = "um";
    }

    /// Unit of a force.
    ForceUnit: Newton {
        Newton = "N";
        Kilonewton = "kN";
        Millinewton = "mN";
    }

    /// Unit of a speed.
    SpeedUnit: MetresPerSecond {
        MetresPerSecond = "m/s";
        MillimetresPerSecond = "mm/s";
    }

    /// Unit of a time.
    TimeUnit: S {
        S = "s";
        Ms = "ms";
    }
}

meanings! {
    /// The part of the measurement that is fitted.
    BranchChoice.branch: FittedBranch {
        Both => FittedBranch::Both,
        Loading => FittedBranch::Loading,
        Unloading => FittedBranch::Unloading,
    }

    /// Length of the unit in m.
    LengthUnit.metres: f64 { M => 1.0, Mm => 1e-3, Um => 1e-6 }

    /// Size of the unit in N.
    ForceUnit.newtons: f64 { Newton => 1.0, Kilonewton => 1e3, Millinewton => 1e-3 }

    /// Size of the unit in m/s.
    SpeedUnit.metres_per_second: f64 { MetresPerSecond => 1.0, MillimetresPerSecond => 1e-3 }

    /// Size of the unit in s.
    TimeUnit.seconds: f64 { S => 1.0, Ms => 1e-3 }
}

impl DesignRequest {
    /// The request with the indentation x/R = 3/(2 k̂) in the place of the dimensionless stiffness k̂ (B.3).
    ///
    /// # Errors
    /// k̂ is below 1.5, so that x/R would be above 1.
    pub fn with_indentation_of_stiffness(mut self) -> Result<Self, RequestFault> {
        let Some(stiffness) = self.dimensionless_stiffness.take() else { return Ok(self) };
        let indentation = RelativeIndentation::new(1.5 / stiffness.get()).map_err(|_| {
            let why = phrase![
                "{} is {}, expected 1.5 or more: x/R is 3/(2 K), at most 1";
                Input::DimensionlessStiffness, stiffness.to_string()
            ];
            RequestFault::refused(Input::DimensionlessStiffness, why)
        })?;
        self.wanted.indentation = Some(indentation);
        Ok(self)
    }
}

impl FitRequest {
    /// Whether a model is fitted to recorded motions, and not a contact to one measured curve.
    pub fn is_of_motion(&self) -> bool {
        !self.motion.is_empty()
    }
}
