//! A model in space, as a view that can be turned needs it: bodies, spheres, floors and forces; bones; falls.

mod animals;
mod falls;
mod lines;
mod played;
mod rounded;
mod surfaces;
mod view;

pub use animals::AnimalFall;
pub use falls::Fall;
pub use played::Played;
pub use surfaces::{BoneSurface, Bones};
pub use view::Scene;
