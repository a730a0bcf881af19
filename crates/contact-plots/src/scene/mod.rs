//! Things in space, seen from several sides: circles, points and outlines with names, on axes of one scale.

mod data;
mod draw;
mod labels;
mod layout;
mod marks;
mod samples;

pub use data::{Ball, Block, Level, LevelKind, Outline, Scene, SceneNames, Spot, State, View};
pub use draw::scene;
