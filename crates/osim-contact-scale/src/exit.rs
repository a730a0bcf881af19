//! The end of the program: its exit status, the report of a failure, and Ctrl-C.

use std::ffi::c_int;
use std::fmt;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

pub(crate) use osim_view::report::ExitStatus as Exit;
use signal_hook::{consts, flag};

/// An error that ends the run with the exit status `exit`. All other errors end it with the status of wrong usage.
#[derive(Debug)]
pub(crate) struct ExitError {
    pub text: String,
    pub exit: Exit,
}

impl fmt::Display for ExitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::error::Error for ExitError {}

/// The exit status of a run that ended with `error`. If standard output cannot be written, the status is not that of wrong usage.
pub(crate) fn exit_of(error: &anyhow::Error) -> Exit {
    let is_of_system = error.downcast_ref::<std::io::Error>().is_some();
    let otherwise = if is_of_system { Exit::Failed } else { Exit::Usage };
    error.downcast_ref::<ExitError>().map_or(otherwise, |ended| ended.exit)
}

/// The message of an error as the program prints it.
pub(crate) fn text_of(error: &anyhow::Error) -> String {
    match error.downcast_ref::<std::io::Error>() {
        Some(why) => format!("cannot write to standard output: {why}"),
        None => format!("{error:#}"),
    }
}

// Ctrl-C: the models in hand are finished, no further one is begun. A second one ends the program at once.
//
// A limit on the size of files (`ulimit -f`) is met like a full disk, not by ending the program.

static STOP_REQUESTED: AtomicBool = AtomicBool::new(false);

/// Signals that ask the program to end: Ctrl-C, a batch system that stops a job, a terminal that closes.
#[cfg(unix)]
const STOP_SIGNALS: [c_int; 3] = [consts::SIGINT, consts::SIGTERM, consts::SIGHUP];
/// Signals that ask the program to end: Ctrl-C and Ctrl-Break. If its window closes, Windows itself ends the program.
#[cfg(windows)]
const STOP_SIGNALS: [c_int; 2] = [consts::SIGINT, consts::SIGBREAK];

/// Makes Ctrl-C a request to stop after the models that are being changed.
pub(crate) fn listen_for_stop_signals() {
    static LISTENING: Once = Once::new();
    LISTENING.call_once(|| {
        for signal in STOP_SIGNALS {
            // In this order, so that the first one finds nothing yet that would end the program. What the second one
            // leaves behind has a temporary name, and the next run removes it. Where a signal cannot be caught, it
            // ends the program as ever: no file is torn by that.
            let end =
                flag::register_conditional_shutdown(signal, Exit::Interrupted.code().into(), &STOP_REQUESTED);
            drop(end.and_then(|_| flag::register(signal, &STOP_REQUESTED)));
        }
    });
}

/// If a file would grow beyond the system's limit of file size, writing it fails, but the program does not end.
#[cfg(unix)]
pub(crate) fn outlive_size_limit() {
    static SIZE_LIMIT_MET: AtomicBool = AtomicBool::new(false);
    // Where it cannot be caught, it ends the program as ever: no file is torn by that.
    drop(flag::register(consts::SIGXFSZ, &SIZE_LIMIT_MET));
}

#[cfg(not(unix))]
pub(crate) fn outlive_size_limit() {}

/// Whether Ctrl-C was pressed, or another program asked this one to end.
pub(crate) fn stop_is_requested() -> bool {
    STOP_REQUESTED.load(Ordering::Relaxed)
}

#[cfg(all(test, windows))]
mod tests {
    /// Stops of whole runs are tested in `tests/library/interrupted.rs`.
    #[test]
    fn ctrl_c_asks_the_run_to_stop() {
        super::listen_for_stop_signals();
        assert!(!super::stop_is_requested());
        signal_hook::low_level::raise(super::consts::SIGINT).unwrap();
        assert!(super::stop_is_requested());
    }
}
