//! What else follows the size of a body, beside its contacts: what geometric similarity would make of each number, and what was made
//! of it.

mod compared;
mod moco;
mod model_size;
mod ratios;
mod spread;
mod verdict;

pub use compared::{ComparedFactors, LengthFrom, Similarity, SimilarityRow};
pub use moco::{moco_bounds, refuse_without_moco_phase};
pub use model_size::ModelSize;
pub use ratios::{SizeRatios, formula};
pub use spread::Spread;
pub use verdict::SizeVerdict;
