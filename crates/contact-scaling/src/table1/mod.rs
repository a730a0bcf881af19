//! Table 1 of the paper: what it prints, and the same computed.
//!
//! `printed.csv` is typed from the paper. Figures, the models of `fixtures/table1` and the tests of printed numbers read it.
//!
//! ```
//! use contact_scaling::table1;
//!
//! let taxa: Vec<&str> = table1::animals().map(|animal| animal.taxon()).collect();
//! assert_eq!(taxa, ["human", "human", "mouse", "emu", "emu", "horse", "giraffe"]);
//! ```

mod animal;
mod column;
mod compared;
mod printed;

pub use animal::{Animal, animals, called};
pub use column::Column;
pub use compared::Compared;
pub use printed::{DURATION_S, GRAVITY_M_S2, HEIGHT_RADII};
