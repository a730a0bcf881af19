//! Opening of files on Unix, and the kinds of files there.
#![cfg_attr(
    not(test),
    expect(clippy::disallowed_methods, reason = "a part of `file_access`, which opens all files")
)]

use std::fs::{File, FileType, Metadata, OpenOptions, TryLockError};
use std::os::unix::fs::{FileTypeExt, MetadataExt, OpenOptionsExt};
use std::path::Path;

use rustix::fs::OFlags;

/// Options with which `open` never waits, not even for a writer of a pipe. No terminal becomes the terminal of this process.
pub(super) fn options_without_waiting(options: &mut OpenOptions) -> &mut OpenOptions {
    options.custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY).bits().cast_signed())
}

/// How often a file is opened again that another run removed before it was locked. On some file systems a file has another number each
/// time it is looked at.
const MOST_TRIES: usize = 8;

/// Opens a file with a lock. Bytes are appended, so that lines stay whole also on a file system without locks.
pub(super) fn open_exclusively(path: &Path) -> std::io::Result<Option<File>> {
    let mut tries = 0;
    loop {
        let mut options = File::options();
        let file = options_without_waiting(options.read(true).append(true).create(true)).open(path)?;
        if file.try_lock().is_err_and(|error| matches!(error, TryLockError::WouldBlock)) {
            return Ok(None);
        }
        let number = |metadata: Metadata| (metadata.dev(), metadata.ino());
        let has_name = std::fs::metadata(path)
            .map(number)
            .is_ok_and(|there| file.metadata().map(number).is_ok_and(|own| own == there));
        tries += 1;
        if has_name || tries == MOST_TRIES {
            return Ok(Some(file));
        }
    }
}

/// Tries a shared lock, for which network file systems need only the right to read.
pub(super) fn is_open_exclusively(path: &Path) -> std::io::Result<bool> {
    let file = options_without_waiting(File::options().read(true)).open(path)?;
    Ok(file.try_lock_shared().is_err_and(|error| matches!(error, TryLockError::WouldBlock)))
}

fn type_of_path(path: &Path) -> Option<FileType> {
    std::fs::metadata(path).ok().map(|metadata| metadata.file_type())
}

pub(super) fn is_stream(path: &Path) -> bool {
    type_of_path(path).is_some_and(|kind| kind.is_fifo() || kind.is_char_device())
}

pub(super) fn is_pipe(metadata: &Metadata) -> bool {
    metadata.file_type().is_fifo()
}

pub(super) fn is_device(metadata: &Metadata) -> bool {
    metadata.file_type().is_char_device()
}

/// Whether a name means a device in every folder: always false, because Unix has no such names.
pub(super) fn is_device_name(_path: &Path) -> bool {
    false
}

/// The name of the only kind of file that cannot be opened: a socket.
pub(super) fn name_of_unopenable_kind(path: &Path) -> Option<&'static str> {
    type_of_path(path).is_some_and(|kind| kind.is_socket()).then_some("a socket")
}

/// The name of a file's kind, for messages.
pub(super) fn kind_name(metadata: &Metadata) -> &'static str {
    let kind = metadata.file_type();
    match () {
        () if kind.is_dir() => "a folder",
        () if kind.is_fifo() => "a pipe",
        () if kind.is_socket() => "a socket",
        () => "a device",
    }
}

/// Whether the system refuses to open a file because too many are open.
pub(super) fn is_out_of_files(error: &std::io::Error) -> bool {
    use rustix::io::Errno;
    Errno::from_io_error(error).is_some_and(|errno| [Errno::MFILE, Errno::NFILE].contains(&errno))
}

/// Whether standard input is a device, such as a terminal.
pub(super) fn standard_input_is_device() -> bool {
    let stat = rustix::fs::fstat(std::io::stdin());
    stat.is_ok_and(|stat| rustix::fs::FileType::from_raw_mode(stat.st_mode).is_char_device())
}
