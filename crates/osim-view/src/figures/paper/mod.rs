//! The figures of the paper, from its Table 1.

mod animals;
mod fig4;
mod fig_c5;

pub use fig_c5::fig_c5;
pub use fig4::fig4;
