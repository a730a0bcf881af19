//! Temporary files that a killed process left behind, and the order of syncs and renames.

use std::process::{Command, Stdio};

use crate::model_folder::{folder_with_models, shell_command};
use crate::support::{TestDir, report_skip};

const CALL: &str = "lib --target-mass 500 -d out --summary notes/done.csv";

/// The name of a temporary file of `process` on `host`.
pub(crate) fn temporary_name(host: &str, process: u32) -> String {
    format!(".osim-contact-scale-{host}-{process}-a1B2c3.tmp")
}

pub(crate) fn this_host() -> String {
    let name = String::from_utf8(Command::new("uname").arg("-n").output().unwrap().stdout).unwrap();
    let replace_sign = |c: char| if c.is_ascii_alphanumeric() || c == '.' || c == '_' { c } else { '_' };
    name.trim().chars().take(64).map(replace_sign).collect()
}

pub(crate) fn dead_process() -> u32 {
    let mut child = Command::new("true").spawn().unwrap();
    child.wait().unwrap();
    child.id()
}

#[test]
fn only_leftovers_of_ended_processes_of_this_computer_are_removed() {
    let dir = folder_with_models(3);
    let mut running_process = Command::new("sleep").arg("600").spawn().unwrap();
    let stale = temporary_name(&this_host(), dead_process());
    let kept_names = [
        temporary_name(&this_host(), running_process.id()),
        temporary_name("another-computer", dead_process()),
        ".osim-contact-scale-of-mine.tmp".to_owned(),
        ".osim-contact-scale-notes.txt".to_owned(),
    ];
    let folders = ["out/even", "out/odd", "notes"];
    for folder in folders {
        kept_names
            .iter()
            .chain([&stale])
            .for_each(|name| dir.write(&format!("{folder}/{name}"), "half a mod"));
    }
    dir.run("lib --target-mass 500 -d out --dry-run").succeeded();
    assert!(dir.has(&format!("out/odd/{stale}")), "a dry run changes nothing");
    // `run` fails if a file disappears, so it is not used here.
    let status = dir.command(CALL).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    running_process.kill().unwrap();
    running_process.wait().unwrap();
    assert!(status.success());
    for folder in folders {
        assert!(!dir.has(&format!("{folder}/{stale}")), "{folder}");
        assert!(kept_names.iter().all(|name| dir.has(&format!("{folder}/{name}"))), "{folder}");
    }
}

#[test]
fn a_leftover_beside_the_target_of_a_link_is_removed() {
    let dir = folder_with_models(1);
    std::os::unix::fs::symlink("lib/even/model00.osim", dir.path("link.osim")).unwrap();
    let stale = format!("lib/even/{}", temporary_name(&this_host(), dead_process()));
    dir.write(&stale, "half a mod");
    let mut command = dir.command("link.osim --target-mass 500 --in-place --quiet");
    assert!(command.status().unwrap().success());
    assert!(!dir.has(&stale));
}

/// A write-protected leftover can be removed by a user who may write into its folder.
#[test]
fn a_write_protected_leftover_is_removed() {
    use std::os::unix::fs::PermissionsExt;
    let dir = folder_with_models(2);
    let stale = format!("out/even/{}", temporary_name(&this_host(), dead_process()));
    dir.write(&stale, "half a mod");
    for (path, mode) in [("out", 0o777), ("out/even", 0o777), (stale.as_str(), 0o444)] {
        std::fs::set_permissions(dir.path(path), PermissionsExt::from_mode(mode)).unwrap();
    }
    let Some(mut words) = crate::model_folder::unprivileged_prefix(&dir, "a write-protected leftover") else {
        return;
    };
    words.extend(["sh", "-c", "\"$COMMAND\" lib --target-mass 500 -d out --quiet"]);
    let output = shell_command(&dir, &words).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(!dir.has(&stale));
}

/// The system calls of a run in their order, as strace records them.
fn strace_of_run(dir: &TestDir, arguments: &str) -> Option<String> {
    let script = format!(
        "exec strace -f -y -qq -o trace -e trace=fsync,fdatasync,rename,renameat,renameat2,link,linkat \"$COMMAND\" {arguments}"
    );
    let output = shell_command(dir, &["sh", "-c", &script]).output().unwrap();
    if !output.status.success() {
        report_skip("what reaches the disk before a rename", "strace is missing or may not trace here");
        return None;
    }
    Some(dir.text("trace"))
}

#[test]
fn a_file_is_synced_before_it_replaces_another() {
    let dir = folder_with_models(4);
    let Some(trace) = strace_of_run(&dir, "lib --target-mass 500 --in-place --jobs 2 --quiet") else {
        return;
    };
    let lines: Vec<&str> = trace.lines().collect();
    let name = |path: &str| path.rsplit('/').next().unwrap().to_owned();
    // Names of files that are on the disk; a new name of one of them is, too.
    let mut synced = std::collections::BTreeSet::new();
    let mut replaced = 0;
    for line in &lines {
        if let Some((_, path)) = line.split_once("sync(").and_then(|(_, call)| call.split_once('<')) {
            synced.insert(name(path.split('>').next().unwrap()));
        }
        let quoted: Vec<&str> = line.split('"').skip(1).step_by(2).collect();
        let [from, to] = quoted[..] else { continue };
        if line.contains("rename") || line.contains("link") {
            assert!(
                synced.contains(&name(from)),
                "{to} got its name before its bytes were on the disk:\n{trace}"
            );
            synced.insert(name(to));
            replaced += usize::from(to.ends_with(".osim"));
        }
    }
    assert_eq!(replaced, 4, "{trace}");
    // The folder's entry of the backup and of the model itself follow.
    assert!(lines.iter().any(|line| line.contains("fsync(") && line.contains("/lib/odd>")), "{trace}");
}
