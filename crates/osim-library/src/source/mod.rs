//! Finds the models that a call names, and reads them from the disk.

mod disk;
mod find_models;
mod workbook;

pub(crate) use disk::MemoryFirst;
pub use disk::{Disk, LoadedModel, ModelOrigin, OrdinaryFiles};
pub(crate) use find_models::SWEEP_FOLDER_ENDING;
pub use find_models::{ModelSource, Sources, SplitName};
pub use workbook::workbook_as_csv;
