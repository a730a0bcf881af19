//! Each kind of circle, in a crate of a few lines; and what looks like a circle and is none.

mod facades;
mod macros;
mod modules;
mod none;
mod paths;
mod shown;
mod uses;
