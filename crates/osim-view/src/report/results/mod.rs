//! Results of requests that change no model: drops, fits, presets, designs without a model.

mod drop;
mod fit;
mod moco_and_nmsm;
mod motion;
mod motion_record;
mod preset_and_design;

pub use drop::{DropDifferenceRecord, DropRecord, DropSeriesRecord, drop_chart, drop_csv, drop_text};
pub use fit::{EstimateRecord, FitRecord, FitWarningRecord, ResidualsRecord, fit_text};
pub use moco_and_nmsm::{MOCO_FILES, NMSM_FILES, moco_files, nmsm_files};
pub(crate) use motion::motion_feet;
pub use motion::{
    MotionCells, MotionColumn, MotionComparisonRecord, MotionFootRecord, MotionRecord, MotionRemarkRecord,
    MotionSphereRecord, MotionStanceRecord, MotionTouchDownRecord, corrected_files, external_loads_xml,
    ground_reactions_sto, motion_columns, motion_csv, motion_text,
};
pub use preset_and_design::{PresetRecord, SweepRecord, design_sheet_text, preset_text};
