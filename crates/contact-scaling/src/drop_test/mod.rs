//! A body let fall on its spheres: one vertical degree of freedom, bottoms of the spheres level.
//!
//! M ẍ = M g − Σ F_i(x, ẋ), with x the common indentation of the spheres, −height before contact. It is the
//! experiment of the paper's Table 1 and Fig. 4.
//!
//! ```
//! use contact_scaling::drop_test::DropTest;
//! use contact_scaling::falisse2022;
//!
//! let human = falisse2022();
//! let report = DropTest::of(&human.contact, &human.scale, 0.25, 2.0)?.run()?;
//! let x_hat = report.final_indentation_m / 0.032;
//! assert!((x_hat - 0.3396).abs() < 2e-4); // the smoothed law rests here, the Hertz law at 0.353
//! assert!(report.first_contact.is_some_and(|contact| contact.end.is_none())); // it never leaves the ground
//! # Ok::<(), contact_scaling::drop_test::DropError>(())
//! ```

mod body;
mod compare;
mod error;
mod falling;
mod motion;
mod report;
mod values;

pub use compare::{Difference, compare};
pub use error::DropError;
pub use falling::DropTest;
pub use report::{DropReport, FirstContact, Lift, Sample};
pub use values::DropValues;
