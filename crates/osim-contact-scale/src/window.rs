//! A window that closes too soon: Windows takes it away, with all it shows, when a program that Explorer started ends.

use std::ffi::OsString;
use std::io::{IsTerminal, stdin, stdout};

use sysinfo::{Pid, ProcessRefreshKind, ProcessesToUpdate, System};

use crate::terminal::Terminal;

/// Waits for Enter where a model was dropped on the program, so that there is time to read.
pub(crate) fn keep_open(terminal: &mut Terminal) {
    // Asking for the parent costs some milliseconds; elsewhere there is no need to.
    if !cfg!(windows) || !stdout().is_terminal() || !stdin().is_terminal() {
        return;
    }
    if parent_name().is_some_and(|name| name.eq_ignore_ascii_case("explorer.exe")) {
        terminal.error("\npress Enter to close this window");
        // Whatever comes, the window may go.
        let _ = stdin().read_line(&mut String::new());
    }
}

/// File name of the program that started this one.
fn parent_name() -> Option<OsString> {
    let mut system = System::new();
    let mut refreshed = |pid: Pid| {
        system.refresh_processes_specifics(
            ProcessesToUpdate::Some(&[pid]),
            false,
            ProcessRefreshKind::nothing(),
        );
        system.process(pid).map(|process| (process.parent(), process.name().to_owned()))
    };
    let (parent, _) = refreshed(sysinfo::get_current_pid().ok()?)?;
    Some(refreshed(parent?)?.1)
}

#[cfg(test)]
mod tests {
    #[cfg(target_os = "linux")]
    #[test]
    fn the_parent_is_the_one_the_kernel_names() {
        let parent = std::os::unix::process::parent_id();
        let name = std::fs::read_to_string(format!("/proc/{parent}/comm")).unwrap();
        assert_eq!(super::parent_name().unwrap().to_str(), Some(name.trim_end()));
    }
}
