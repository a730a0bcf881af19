//! Results of requests that are not about a change: drops, fits, presets, designs without a model.

mod design_sheet;
mod drop_record;
mod drop_test;
mod fit;
mod fit_record;
mod motion;
mod preset;
mod sweep;

pub use design_sheet::design_sheet_text;
pub use drop_record::{DropDifferenceRecord, DropRecord, DropSeriesRecord};
pub use drop_test::{drop_chart, drop_csv, drop_text};
pub use fit::fit_text;
pub use fit_record::{EstimateRecord, FitRecord, FitWarningRecord, ResidualsRecord};
pub use motion::{
    MotionCells, MotionColumn, MotionComparisonRecord, MotionFootRecord, MotionRecord, MotionRemarkRecord,
    MotionSphereRecord, MotionStanceRecord, MotionTouchDownRecord, external_loads_xml, ground_reactions_sto,
    motion_columns, motion_csv, motion_feet, motion_text,
};
pub use preset::{PresetRecord, preset_text};
pub use sweep::SweepRecord;
