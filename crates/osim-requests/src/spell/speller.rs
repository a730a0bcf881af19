//! What a language spells: requests, beside the inputs and calls in sentences.

use osim_model::messages::Dialect;

use crate::request::Request;

/// The words of a language, for whole requests too.
///
/// Texts are as they are in the request, with the quotation marks of the language. Only a name of a file that it would take for
/// something else gets `./` before it. A name that is not UTF-8 cannot be copied: it has U+FFFD in it.
///
/// ```
/// use osim_requests::Request;
/// use osim_requests::spell::{CommandLine, Matlab, Python, Speller};
///
/// let request = br#"{"verb": "rescale", "models": "human.osim", "target_mass": 500}"#;
/// let request = Request::from_json(request)?;
/// assert_eq!(CommandLine.request(&request), "osim-contact-scale rescale human.osim --target-mass 500");
/// assert_eq!(Python.request(&request), r#"ocs.rescale("human.osim", target_mass=500)"#);
/// assert_eq!(Matlab.request(&request), "osimcontact.rescale('human.osim', 'TargetMass', 500)");
/// # Ok::<(), osim_requests::RequestFault>(())
/// ```
pub trait Speller: Dialect {
    /// A request, as the reader types it.
    fn request(&self, request: &Request) -> String;

    /// Lines that do all of a request, files that it writes and results that it shows among them.
    fn script(&self, request: &Request) -> String {
        self.request(request)
    }
}
