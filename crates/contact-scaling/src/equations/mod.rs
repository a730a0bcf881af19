//! A register of every equation: number, formula, symbols with units, and where it comes from.
//!
//! The functions of this crate compute; the register says what they compute, for help texts and reports. A test compares it
//! with `docs/reference/equations.md`, formula by formula.
//!
//! ```
//! use contact_scaling::equations;
//!
//! let scaling = equations::find("(10)").unwrap();
//! assert_eq!(scaling.forms[0].formula, "E*_b = (M_b / M_a) (n_a / n_b) (R_a² / R_b²) E*_a");
//! assert_eq!(equations::find("eq. c.5").unwrap().label, "C.5");
//! assert!(equations::find("C.11").is_none());
//! ```

mod beyond;
mod equation;
mod hertz;
mod register;
mod smooth;
mod stiffness;
mod surfaces;
pub mod symbols;

pub use equation::{Equation, Form};
pub use register::{all, find, reference};
pub use symbols::Symbol;
