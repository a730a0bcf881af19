//! How Windows opens files: nothing waits but devices, which have names of their own.
#![cfg_attr(not(test), expect(clippy::disallowed_methods, reason = "a part of the door"))]

use std::fs::{Metadata, OpenOptions};
use std::path::{Component, Path, Prefix};

pub(super) fn without_waiting(options: &mut OpenOptions) -> &mut OpenOptions {
    options
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

/// `CON`, `nul.osim`, `\\.\COM1`, `\\.\pipe\name`.
pub(super) fn is_device_name(path: &Path) -> bool {
    const NAMES: [&str; 6] = ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"];
    if let Some(Component::Prefix(prefix)) = path.components().next()
        && matches!(prefix.kind(), Prefix::DeviceNS(_))
    {
        return true;
    }
    let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_uppercase()).unwrap_or_default();
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end_matches(' ');
    let numbered = |port: &str| stem.strip_prefix(port).is_some_and(|number| number.chars().count() == 1);
    NAMES.contains(&stem) || numbered("COM") || numbered("LPT")
}

pub(super) fn kind_that_cannot_be_opened(path: &Path) -> Option<&'static str> {
    path.is_dir().then_some("a folder")
}

pub(super) fn kind(metadata: &Metadata) -> &'static str {
    if metadata.is_dir() { "a folder" } else { "a device" }
}

pub(super) fn is_out_of_files(error: &std::io::Error) -> bool {
    const ERROR_TOO_MANY_OPEN_FILES: i32 = 4;
    error.raw_os_error() == Some(ERROR_TOO_MANY_OPEN_FILES)
}

/// Whether standard input is a device, such as a terminal.
pub(super) fn types_standard_input() -> bool {
    std::io::IsTerminal::is_terminal(&std::io::stdin())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names that Windows gives to devices in every folder, whatever their ending.
    #[test]
    fn names_of_devices_are_known() {
        for name in ["CON", "nul.osim", r"lib\aux.xml", r"\\.\COM1", r"\\.\pipe\x", "com3.osim", "LPT1"] {
            assert!(is_device_name(Path::new(name)), "{name}");
        }
        for name in
            ["console.osim", "com.osim", "com12.osim", r"C:\nul_models\a.osim", r"\\server\con\a.osim"]
        {
            assert!(!is_device_name(Path::new(name)), "{name}");
        }
    }
}
