//! The words of a language, for requests too.

use osim_messages::Dialect;

use crate::request::Request;

/// The words of a front end, for requests too.
pub trait Speller: Dialect {
    /// A request, as the reader types it.
    fn request(&self, request: &Request) -> String;
}
