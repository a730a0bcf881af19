//! The words of a front end.

use osim_requests::spell::FrontEnd;

/// A front end's words that every thread can use.
pub type Words = &'static (dyn FrontEnd + Sync);
