//! Opening of files on Windows, and the kinds of files there. Only devices would make `open` wait, and their names are known.
#![cfg_attr(
    not(test),
    expect(clippy::disallowed_methods, reason = "a part of `file_access`, which opens all files")
)]

use std::fs::{File, Metadata, OpenOptions};
use std::path::{Component, Path, Prefix};

pub(super) fn options_without_waiting(options: &mut OpenOptions) -> &mut OpenOptions {
    options
}

/// Windows' error for a file that another process has open.
const ERROR_SHARING_VIOLATION: i32 = 32;

/// Opens a file so that nobody else can open it for writing. A lock would also forbid other processes, and other handles of this
/// process, to read. A file that is opened only for appending could be neither shortened nor locked.
pub(super) fn open_exclusively(path: &Path) -> std::io::Result<Option<File>> {
    use std::os::windows::fs::OpenOptionsExt;
    const FILE_SHARE_READ: u32 = 1;
    const FILE_SHARE_DELETE: u32 = 4;
    let mut options = File::options();
    options.read(true).write(true).create(true).truncate(false);
    match options.share_mode(FILE_SHARE_READ | FILE_SHARE_DELETE).open(path) {
        Err(error) if error.raw_os_error() == Some(ERROR_SHARING_VIOLATION) => Ok(None),
        file => file.map(Some),
    }
}

/// Tries to open the file for writing, which fails if it is open by [`open_exclusively`].
pub(super) fn is_open_exclusively(path: &Path) -> std::io::Result<bool> {
    match File::options().write(true).open(path) {
        Err(error) if error.raw_os_error() == Some(ERROR_SHARING_VIOLATION) => Ok(true),
        file => file.map(|_| false),
    }
}

pub(super) fn is_stream(_path: &Path) -> bool {
    false
}

pub(super) fn is_pipe(_metadata: &Metadata) -> bool {
    false
}

pub(super) fn is_device(_metadata: &Metadata) -> bool {
    false
}

/// Whether a name means a device: `CON`, `nul.osim`, `\\.\COM1`, `\\.\pipe\name`. Ports have the numbers 1 to 9; 1 to 3 may be
/// superscripts.
pub(super) fn is_device_name(path: &Path) -> bool {
    const DEVICE_NUMBERS: [&str; 12] =
        ["1", "2", "3", "4", "5", "6", "7", "8", "9", "\u{b9}", "\u{b2}", "\u{b3}"];
    const DEVICE_NAMES: [&str; 6] = ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"];
    if let Some(Component::Prefix(prefix)) = path.components().next()
        && matches!(prefix.kind_name(), Prefix::DeviceNS(_))
    {
        return true;
    }
    let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_uppercase()).unwrap_or_default();
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end_matches(' ');
    let numbered =
        |port: &str| stem.strip_prefix(port).is_some_and(|number| DEVICE_NUMBERS.contains(&number));
    DEVICE_NAMES.contains(&stem) || numbered("COM") || numbered("LPT")
}

pub(super) fn name_of_unopenable_kind(path: &Path) -> Option<&'static str> {
    path.is_dir().then_some("a folder")
}

pub(super) fn kind_name(metadata: &Metadata) -> &'static str {
    if metadata.is_dir() { "a folder" } else { "a device" }
}

pub(super) fn is_out_of_files(error: &std::io::Error) -> bool {
    const ERROR_TOO_MANY_OPEN_FILES: i32 = 4;
    error.raw_os_error() == Some(ERROR_TOO_MANY_OPEN_FILES)
}

/// Whether standard input is a device, such as a terminal.
pub(super) fn standard_input_is_device() -> bool {
    std::io::IsTerminal::is_terminal(&std::io::stdin())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In every folder Windows takes these names for devices, with any ending.
    #[test]
    fn names_of_devices_are_known() {
        for name in [
            "CON",
            "nul.osim",
            r"lib\aux.xml",
            r"\\.\COM1",
            r"\\.\pipe\x",
            "com3.osim",
            "LPT1",
            "lpt\u{b2}.xml",
        ] {
            assert!(is_device_name(Path::new(name)), "{name}");
        }
        for name in
            ["console.osim", "com.osim", "com12.osim", r"C:\nul_models\a.osim", r"\\server\con\a.osim"]
                .into_iter()
                .chain([
                    r"lib\comb.osim",
                    "coma.xml",
                    "com_.osim",
                    "lptx.osim",
                    "com0.osim",
                    "com\u{b4}.osim",
                ])
        {
            assert!(!is_device_name(Path::new(name)), "{name}");
        }
    }
}
