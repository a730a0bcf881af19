//! Table 1 of the paper beside what its equations give: as text, CSV and a record; and what Fig. 1 needs.

mod record;
mod text;

pub use record::{AnimalRecord, NumberRecord, ReproductionRecord};
pub use text::{fig1_text, reproduction_csv, reproduction_text};
