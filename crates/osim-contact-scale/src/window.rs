//! A window that closes too soon: Windows takes it away, with all it shows, when a program that Explorer started ends.

use crate::terminal::Terminal;

/// Waits for Enter where a model was dropped on the program, so that there is time to read.
#[cfg(windows)]
pub(crate) fn keep_open(terminal: &mut Terminal) {
    use std::io::{IsTerminal, stdin, stdout};
    // Asking for the parent costs some milliseconds; elsewhere there is no need to.
    if !stdout().is_terminal() || !stdin().is_terminal() {
        return;
    }
    if parent_of(std::process::id()).is_some_and(|name| name.eq_ignore_ascii_case("explorer.exe")) {
        terminal.error("\npress Enter to close this window");
        // Whatever comes, the window may go.
        let _ = stdin().read_line(&mut String::new());
    }
}

#[cfg(not(windows))]
pub(crate) fn keep_open(_terminal: &mut Terminal) {}

/// File name of the program that started `process`.
#[cfg(windows)]
fn parent_of(process: u32) -> Option<String> {
    use winsafe::{HPROCESSLIST, co::TH32CS};
    let mut list = HPROCESSLIST::CreateToolhelp32Snapshot(TH32CS::SNAPPROCESS, None).ok()?;
    let mut parents = std::collections::HashMap::new();
    for entry in list.iter_processes() {
        let entry = entry.ok()?;
        parents.insert(entry.th32ProcessID, (entry.th32ParentProcessID, entry.szExeFile()));
    }
    let (parent, _) = parents.get(&process)?;
    Some(parents.get(parent)?.1.clone())
}

#[cfg(all(test, windows))]
mod tests {
    #[test]
    fn the_parent_of_a_child_is_this_program() {
        let mut child = std::process::Command::new("cmd")
            .args(["/c", "pause"])
            .stdin(std::process::Stdio::piped())
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let parent = super::parent_of(child.id());
        child.kill().unwrap();
        child.wait().unwrap();
        let this = std::env::current_exe().unwrap();
        assert_eq!(parent.as_deref(), this.file_name().and_then(|name| name.to_str()));
    }
}
