//! Requests to inspect models alone, along a recorded motion, and in a fall; and to write facts about their contacts into a note.

use std::path::PathBuf;

use crate::options::{
    AnswerOptions, ContactNumbers, CountOptions, Deny, ForceOptions, InspectionOptions, MassOptions,
    OutputOptions, ReportOptions, RunOptions, SetFiles, SheetFormat,
};
use crate::values::serial::{choices, fields};
use crate::values::{
    Acceleration, Count, DropHeight, Kilograms, Positive, Samples, Signed, UsualErrors, path,
};

fields! {
    /// Shows what contacts models have.
    struct InspectRequest {
        models: Vec<PathBuf> as "path::List",
        from: Option<PathBuf> as "path::Optional",
        body_scale_file: Option<PathBuf> as "path::Optional",
        target_mass: Option<Kilograms>,
        full: bool,
        format: SheetFormat,
        report: ..ReportOptions,
        options: ..InspectionOptions,
    } where Required("models"), Needs("body_scale_file", "from"), Needs("force", "report");

    /// Compares models with the limits of the paper and the traps of the format.
    struct CheckRequest {
        models: Vec<PathBuf> as "path::List",
        from: Option<PathBuf> as "path::Optional",
        body_scale_file: Option<PathBuf> as "path::Optional",
        moco_setup: Option<PathBuf> as "path::Optional",
        from_moco_setup: Option<PathBuf> as "path::Optional",
        motion: Option<PathBuf> as "path::Optional",
        plates: Option<PathBuf> as "path::Optional",
        loads: Option<PathBuf> as "path::Optional",
        angles: Option<AngleChoice>,
        full: bool,
        deny: Deny,
        format: SheetFormat,
        fix: bool,
        output: Option<PathBuf> as "path::Optional",
        output_dir: Option<PathBuf> as "path::Optional",
        in_place: bool,
        report: ..ReportOptions,
        options: ..InspectionOptions,
    } where
        Required("models"), Needs("body_scale_file", "from"), Needs("moco_setup", "from"),
        Needs("from_moco_setup", "moco_setup"), Needs("motion", "plates"), Needs("plates", "motion"),
        Needs("loads", "motion"), Needs("angles", "motion"), Needs("output", "fix"),
        Needs("output_dir", "fix"), Needs("in_place", "fix"), Excludes("output_dir", "output"),
        Excludes("in_place", "output"), Excludes("in_place", "output_dir");

    /// Writes into models which mass their contacts were made for, or how many limbs share the weight; no number changes.
    struct NoteRequest {
        models: Vec<PathBuf> as "path::List",
        contacts_mass: Option<Kilograms>,
        contacts_gravity: Option<Acceleration>,
        stance_limbs: Option<Count>,
        output: ..OutputOptions,
        run: ..RunOptions,
        answers: ..AnswerOptions,
        set_files: ..SetFiles,
    } where Expected("models"), ExpectedUnless("contacts_mass", "stance_limbs");

    /// Shows what contacts do along a recorded motion, beside what force plates measured.
    struct MotionRequest {
        subject: Option<PathBuf> as "path::Optional",
        motion: Option<PathBuf> as "path::Optional",
        plates: Option<PathBuf> as "path::Optional",
        loads: Option<PathBuf> as "path::Optional",
        angles: Option<AngleChoice>,
        low_pass: Option<Positive>,
        plates_delay: Option<Signed>,
        belt: Option<Signed>,
        belt_column: Option<String>,
        start: Option<Signed>,
        end: Option<Signed>,
        correct: Option<PathBuf> as "path::Optional",
        vertical: bool,
        floor: Option<Signed>,
        moco: Option<PathBuf> as "path::Optional",
        nmsm: Option<PathBuf> as "path::Optional",
        error: Option<UsualErrors>,
        output: Option<PathBuf> as "path::Optional",
        force: bool,
        format: MotionFormat,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        set_files: ..SetFiles,
    } where
        Required("subject"), Required("motion"), Needs("loads", "plates"), Excludes("belt", "belt_column"),
        Needs("correct", "plates"), Needs("plates_delay", "plates"), Needs("vertical", "correct"), Needs("floor", "correct"),
        Needs("moco", "correct"), Needs("nmsm", "correct"), Needs("error", "correct");

    /// Lets a model fall on its contacts and shows what they do.
    struct DropTestRequest {
        subject: Option<PathBuf> as "path::Optional",
        height: DropHeight,
        duration: Positive = Positive::DROP_DURATION_S,
        samples: Samples,
        compare: Option<PathBuf> as "path::Optional",
        compare_spheres: Option<Count>,
        foot_mass: Option<Kilograms>,
        presets: Option<PathBuf> as "path::Optional",
        format: SeriesFormat,
        numbers: ..ContactNumbers,
        counts: ..CountOptions,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        set_files: ..SetFiles,
        answers: ..AnswerOptions,
    } where Needs("compare_spheres", "compare");
}

impl CheckRequest {
    /// The options for the results of `fix`.
    pub fn output(&self) -> OutputOptions {
        OutputOptions {
            output: self.output.clone(),
            output_dir: self.output_dir.clone(),
            in_place: self.in_place,
            force: self.report.force,
            ..OutputOptions::default()
        }
    }
}

choices! {
    /// The unit of the angles of a motion.
    AngleChoice {
        Degrees = "degrees";
        Radians = "radians";
    }

    /// How a motion is shown.
    MotionFormat: Table {
        Table = "table", "In sentences, and with the values of each foot and sphere";
        Json = "json", "One JSON object";
        Csv = "csv", "One row per frame, sphere and force";
    }

    /// How a drop is shown.
    SeriesFormat: Table {
        Table = "table", "Figures (and a chart on a terminal)";
        Json = "json", "One JSON object";
        Csv = "csv", "The series, one row per moment";
    }
}
