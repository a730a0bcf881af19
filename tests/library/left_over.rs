//! Files under temporary names that a killed process left behind; and what reaches the disk before a rename.

use std::process::{Command, Stdio};

use crate::library::{library, shell_command};
use crate::support::{Bench, skipped};

const CALL: &str = "lib --target-mass 500 -d out --summary notes/done.csv";

/// The name of a temporary file of `process` on `host`.
pub(crate) fn temporary(host: &str, process: u32) -> String {
    format!(".osim-contact-scale-{host}-{process}-a1B2c3.tmp")
}

pub(crate) fn this_host() -> String {
    let name = String::from_utf8(Command::new("uname").arg("-n").output().unwrap().stdout).unwrap();
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '.' || c == '_' { c } else { '_' };
    name.trim().chars().take(64).map(plain).collect()
}

pub(crate) fn dead_process() -> u32 {
    let mut child = Command::new("true").spawn().unwrap();
    child.wait().unwrap();
    child.id()
}

#[test]
fn only_what_a_dead_process_of_this_computer_left_is_removed() {
    let bench = library(3);
    let mut living = Command::new("sleep").arg("600").spawn().unwrap();
    let dead = temporary(&this_host(), dead_process());
    let kept = [
        temporary(&this_host(), living.id()),
        temporary("another-computer", dead_process()),
        ".osim-contact-scale-of-mine.tmp".to_owned(),
        ".osim-contact-scale-notes.txt".to_owned(),
    ];
    let folders = ["out/even", "out/odd", "notes"];
    for folder in folders {
        kept.iter().chain([&dead]).for_each(|name| bench.write(&format!("{folder}/{name}"), "half a mod"));
    }
    bench.run("lib --target-mass 500 -d out --dry-run").done();
    assert!(bench.has(&format!("out/odd/{dead}")), "a dry run changes nothing");
    // `run` insists that no file goes: this one may.
    let status = bench.command(CALL).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    living.kill().unwrap();
    living.wait().unwrap();
    assert!(status.success());
    for folder in folders {
        assert!(!bench.has(&format!("{folder}/{dead}")), "{folder}");
        assert!(kept.iter().all(|name| bench.has(&format!("{folder}/{name}"))), "{folder}");
    }
}

#[test]
fn what_is_left_beside_the_file_a_link_leads_to_goes_too() {
    let bench = library(1);
    std::os::unix::fs::symlink("lib/even/model00.osim", bench.path("link.osim")).unwrap();
    let dead = format!("lib/even/{}", temporary(&this_host(), dead_process()));
    bench.write(&dead, "half a mod");
    let mut command = bench.command("link.osim --target-mass 500 --in-place --quiet");
    assert!(command.status().unwrap().success());
    assert!(!bench.has(&dead));
}

/// Whoever may read a write-protected leftover may remove it.
#[test]
fn a_write_protected_leftover_goes_too() {
    use std::os::unix::fs::PermissionsExt;
    let bench = library(2);
    let dead = format!("out/even/{}", temporary(&this_host(), dead_process()));
    bench.write(&dead, "half a mod");
    for (path, mode) in [("out", 0o777), ("out/even", 0o777), (dead.as_str(), 0o444)] {
        std::fs::set_permissions(bench.path(path), PermissionsExt::from_mode(mode)).unwrap();
    }
    let Some(mut words) = crate::library::bound_by_permissions(&bench, "a write-protected leftover") else {
        return;
    };
    words.extend(["sh", "-c", "\"$COMMAND\" lib --target-mass 500 -d out --quiet"]);
    let output = shell_command(&bench, &words).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(!bench.has(&dead));
}

/// The order of system calls, as strace saw them.
fn traced(bench: &Bench, arguments: &str) -> Option<String> {
    let script = format!(
        "exec strace -f -y -qq -o trace -e trace=fsync,fdatasync,rename,renameat,renameat2,link,linkat \"$COMMAND\" {arguments}"
    );
    let output = shell_command(bench, &["sh", "-c", &script]).output().unwrap();
    if !output.status.success() {
        skipped("what reaches the disk before a rename", "strace is missing or may not trace here");
        return None;
    }
    Some(bench.text("trace"))
}

#[test]
fn a_file_is_on_the_disk_before_it_replaces_another() {
    let bench = library(4);
    let Some(trace) = traced(&bench, "lib --target-mass 500 --in-place --jobs 2 --quiet") else { return };
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
