//! What a front end spells beyond requests and sentences.

use osim_model::messages::Call;

use super::speller::Speller;

/// The words of a front end, for calls that stand alone too.
pub trait FrontEnd: Speller {
    /// A call that stands alone, to be copied: on a command line it begins with the name of the program.
    fn command(&self, call: &Call) -> String {
        self.call(call)
    }

    /// A name as one word of a call.
    fn word(&self, name: &str) -> String {
        name.to_owned()
    }

    /// What is before a remedy that is there to be copied.
    fn prompt(&self) -> &'static str {
        ""
    }

    /// Where more is written, for the end of a message about a call that cannot be understood.
    fn see_also(&self) -> &'static str {
        ""
    }
}
