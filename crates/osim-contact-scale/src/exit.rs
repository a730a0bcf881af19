//! The exit status.

use std::fmt;

use osim_library::Cause;
pub(crate) use osim_view::report::ExitStatus as Exit;

/// An error that ends the run with a status of its own; any other is wrong usage.
#[derive(Debug)]
pub(crate) struct Ended {
    pub text: String,
    pub exit: Exit,
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for Ended {}

/// The status of a run that ended with `error`. Standard output that cannot be written is not the call's fault.
pub(crate) fn exit_of(error: &anyhow::Error) -> Exit {
    let is_of_system = error.downcast_ref::<std::io::Error>().is_some();
    let otherwise = if is_of_system { Exit::Failed } else { Exit::Usage };
    error.downcast_ref::<Ended>().map_or(otherwise, |ended| ended.exit)
}

/// The message for the reader.
pub(crate) fn text_of(error: &anyhow::Error) -> String {
    match error.downcast_ref::<std::io::Error>() {
        Some(why) => format!("cannot write to standard output: {why}"),
        None => format!("{error:#}"),
    }
}

/// The status of a run that a fault with this cause ends.
pub(crate) fn exit_of_cause(cause: Cause) -> Exit {
    match cause {
        Cause::Call => Exit::Usage,
        Cause::System => Exit::Failed,
        Cause::Busy => Exit::Busy,
    }
}
