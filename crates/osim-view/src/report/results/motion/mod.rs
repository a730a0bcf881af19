//! Contacts along a motion: in words, as tables, as JSON, and as a file of OpenSim.

mod columns;
mod record;
mod storage;
mod text;

pub use columns::{MotionCells, MotionColumn, motion_columns, motion_csv};
pub use record::{
    MotionComparisonRecord, MotionFootRecord, MotionRecord, MotionRemarkRecord, MotionSphereRecord,
    MotionStanceRecord, MotionTouchDownRecord,
};
pub use storage::{external_loads_xml, ground_reactions_sto};
pub use text::{motion_feet, motion_text};
