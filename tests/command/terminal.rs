//! Runs a command in a terminal of a given width.

use std::ffi::OsStr;
use std::fs::File;
use std::io::Read;
use std::os::unix::ffi::OsStrExt;
use std::process::{Command, Stdio};
use std::thread::{JoinHandle, spawn};

use rustix::fs::{Mode, OFlags};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};

/// The texts that a command prints on its two streams, each in a terminal of this width.
pub(crate) fn terminal_output(mut command: Command, columns: u16) -> (String, String) {
    let ((out, printed), (err, errors)) = (terminal(columns), terminal(columns));
    let mut child = command.stdout(out).stderr(err).spawn().unwrap();
    // The terminals end when no process can write to them.
    drop(command);
    child.wait().unwrap();
    (printed.join().unwrap(), errors.join().unwrap())
}

/// Makes a terminal: the end that a process writes to, and a thread that reads all text.
fn terminal(columns: u16) -> (Stdio, JoinHandle<String>) {
    let screen = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&screen).unwrap();
    unlockpt(&screen).unwrap();
    let name = ptsname(&screen, Vec::new()).unwrap();
    let line =
        rustix::fs::open(OsStr::from_bytes(name.as_bytes()), OFlags::RDWR | OFlags::NOCTTY, Mode::empty())
            .unwrap();
    tcsetwinsize(&line, Winsize { ws_row: 24, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 }).unwrap();
    let read = spawn(move || {
        let (mut screen, mut text) = (File::from(screen), Vec::new());
        // Linux ends with an error, where macOS ends.
        let _ = screen.read_to_end(&mut text);
        String::from_utf8(text).unwrap().replace("\r\n", "\n")
    });
    (line.into(), read)
}
