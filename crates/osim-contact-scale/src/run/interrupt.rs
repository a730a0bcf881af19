//! Ctrl-C: the models in hand are finished, no further one is begun. A second one ends the program at once.
//!
//! A limit on the size of files (`ulimit -f`) is met like a full disk, not by ending the program.

use std::sync::atomic::{AtomicBool, Ordering};

static CAME: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C is a wish, not an end.
pub(crate) fn listen() {
    let stop = || {
        if CAME.swap(true, Ordering::Relaxed) {
            // Files under temporary names stay behind; the next run removes them.
            std::process::exit(i32::from(crate::terminal::Exit::Interrupted.code()));
        }
    };
    // Where it cannot be caught, it ends the program as ever: no file is torn by that.
    drop(ctrlc::set_handler(stop));
}

/// From now on a file that grows beyond the limit is an error of that file.
#[cfg(unix)]
pub(crate) fn outlive_size_limit() {
    let unasked = std::sync::Arc::new(AtomicBool::new(false));
    // Where it cannot be caught, it ends the program as ever: no file is torn by that.
    drop(signal_hook::flag::register(signal_hook::consts::SIGXFSZ, unasked));
}

#[cfg(not(unix))]
pub(crate) fn outlive_size_limit() {}

/// Whether it was pressed.
pub(crate) fn came() -> bool {
    CAME.load(Ordering::Relaxed)
}
