//! What a path means: looks names up as the compiler does, through imports and re-exports.

mod build;
mod resolver;
mod scopes;
mod target;

pub(crate) use resolver::Resolver;
pub(crate) use target::Target;
