//! Ctrl-C: the models in hand are finished, no further one is begun. A second one ends the program at once.
//!
//! A limit on the size of files (`ulimit -f`) is met like a full disk, not by ending the program.

use std::ffi::c_int;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::{consts, flag};

use crate::exit::Exit;

static CAME: AtomicBool = AtomicBool::new(false);

/// Ctrl-C, and what else asks a program to end: a batch system that stops a job, a terminal that closes.
#[cfg(unix)]
const REQUESTS: [c_int; 3] = [consts::SIGINT, consts::SIGTERM, consts::SIGHUP];
/// Ctrl-C and Ctrl-Break. Windows itself ends a program whose window closes, whatever it listens to.
#[cfg(windows)]
const REQUESTS: [c_int; 2] = [consts::SIGINT, consts::SIGBREAK];

/// From now on Ctrl-C is a wish, not an end.
pub(crate) fn listen() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for signal in REQUESTS {
            // In this order, so that the first one finds nothing yet that would end the program. What the second one
            // leaves behind has a temporary name, and the next run removes it. Where a signal cannot be caught, it
            // ends the program as ever: no file is torn by that.
            let end = flag::register_conditional_shutdown(signal, Exit::Interrupted.code().into(), &CAME);
            drop(end.and_then(|_| flag::register(signal, &CAME)));
        }
    });
}

/// From now on a file that grows beyond the limit is an error of that file.
#[cfg(unix)]
pub(crate) fn outlive_size_limit() {
    static MET: AtomicBool = AtomicBool::new(false);
    // Where it cannot be caught, it ends the program as ever: no file is torn by that.
    drop(flag::register(consts::SIGXFSZ, &MET));
}

#[cfg(not(unix))]
pub(crate) fn outlive_size_limit() {}

/// Whether it was pressed.
pub(crate) fn came() -> bool {
    CAME.load(Ordering::Relaxed)
}

#[cfg(all(test, windows))]
mod tests {
    /// Elsewhere whole runs are stopped in `tests/library/stopped.rs`.
    #[test]
    fn ctrl_c_is_a_wish() {
        super::listen();
        assert!(!super::came());
        signal_hook::low_level::raise(super::consts::SIGINT).unwrap();
        assert!(super::came());
    }
}
