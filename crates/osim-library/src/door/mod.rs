//! The one door through which files come in: everything that this project reads from a disk is opened here.
//!
//! What a name leads to is decided by those who made the file, not by those who run the program: a pipe that nobody writes into, a
//! device that never ends, a file larger than the memory. So a file is opened without waiting, the opened file itself is
//! looked at, not its name, and no more is read than a limit that `docs/libraries.md` names. Pipes and
//! devices are read only where the user named them: [`Kinds::Streams`].
//!
//! `clippy.toml` forbids the other ways to open a file.
#![cfg_attr(
    not(test),
    expect(clippy::disallowed_methods, reason = "this is the door: nothing else opens files")
)]

#[cfg(unix)]
mod unix;
#[cfg(windows)]
mod windows;

use std::fmt;
use std::fs::{File, Metadata, OpenOptions};
use std::io::{ErrorKind, Read};
use std::path::Path;

use osim_model::files::FileError;

#[cfg(unix)]
use unix as system;
#[cfg(windows)]
use windows as system;

/// The most that is read of one file or pipe, in bytes: far above any model, summary or table.
const MOST: u64 = 2 << 30;

/// The most that is read of a device, such as a terminal: nobody types more, and `/dev/zero` does not end.
const MOST_OF_DEVICE: u64 = 16 << 20;

/// What may be read under a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kinds {
    /// Ordinary files: for every name that the user did not give, such as those in models, tables and folders.
    Ordinary,
    /// Pipes and devices too, and they are waited for: names that the user gave.
    Streams,
}

/// Why something is not read.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// The system says so.
    System(std::io::Error),
    Kind(&'static str),
    /// It is larger than this.
    Large(u64),
    /// It does not fit into the memory.
    Memory,
    /// Another program writes it.
    Changed,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System(error) if error.kind() == ErrorKind::NotFound => FileError::not_found().fmt(f),
            Self::System(error) => write!(f, "cannot be read: {}", reason(error)),
            Self::Kind(what) => write!(f, "this is {what}, expected an ordinary file"),
            Self::Large(most) => write!(
                f,
                "larger than {}, the most that is read of it: check that it is the right file",
                size(*most)
            ),
            Self::Memory => f.write_str("cannot be read: too large for this computer's memory"),
            Self::Changed => {
                f.write_str("another program changed it while it was being read: run again when that is done")
            }
        }
    }
}

impl From<Refusal> for FileError {
    fn from(refusal: Refusal) -> Self {
        Self::new(refusal.to_string())
    }
}

impl From<std::io::Error> for Refusal {
    fn from(error: std::io::Error) -> Self {
        Self::System(error)
    }
}

fn as_error(refusal: Refusal) -> std::io::Error {
    match refusal {
        Refusal::System(error) => error,
        refusal => std::io::Error::other(refusal.to_string()),
    }
}

/// A limit, as people say it.
fn size(bytes: u64) -> String {
    match bytes {
        bytes if bytes >= 1 << 30 => format!("{} GiB", bytes >> 30),
        bytes if bytes >= 1 << 20 => format!("{} MiB", bytes >> 20),
        bytes => format!("{bytes} bytes"),
    }
}

/// What the system says, with a way out where it needs one.
pub fn reason(error: &std::io::Error) -> String {
    if system::is_out_of_files(error) {
        return "too many open files: allow more (`ulimit -n 256`), or work on fewer models at once"
            .to_owned();
    }
    error.to_string()
}

/// Reads a whole file, with its metadata when it was opened.
///
/// # Errors
/// It is not there, cannot be read, is not one of `kinds`, is too large, or changes while it is being read.
pub(crate) fn read(path: &Path, kinds: Kinds) -> Result<(Vec<u8>, Metadata), Refusal> {
    let (file, metadata) = open(path, kinds)?;
    if metadata.is_file() {
        return Ok((whole(&file, &metadata)?, metadata));
    }
    Ok((until_end(file, most_of(&metadata))?, metadata))
}

pub(crate) fn ordinary(path: &Path) -> Result<Vec<u8>, Refusal> {
    read(path, Kinds::Ordinary).map(|(bytes, _)| bytes)
}

/// The first bytes of an ordinary file, at most `most` of them.
///
/// # Errors
/// It is not there, cannot be read, or is not an ordinary file.
pub fn head(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    let (file, _) = open(path, Kinds::Ordinary).map_err(as_error)?;
    let mut head = Vec::with_capacity(most);
    file.take(most as u64).read_to_end(&mut head)?;
    Ok(head)
}

/// An ordinary file to be read piece by piece, and its length.
pub(crate) fn to_read(path: &Path) -> std::io::Result<(File, u64)> {
    let (file, metadata) = open(path, Kinds::Ordinary).map_err(as_error)?;
    Ok((file, metadata.len()))
}

/// Reads standard input.
///
/// # Errors
/// It cannot be read, or gives more than is read of it.
pub(crate) fn standard_input() -> Result<Vec<u8>, Refusal> {
    let most = if system::types_standard_input() { MOST_OF_DEVICE } else { MOST };
    until_end(std::io::stdin().lock(), most)
}

/// An ordinary file that this process alone writes and may shorten; a new one is made if there is none. `None` if another
/// process has it. Others may read it.
pub(crate) fn alone(path: &Path) -> std::io::Result<Option<File>> {
    let file = system::alone(path)?;
    if let Some(file) = &file {
        check(&file.metadata()?, Kinds::Ordinary).map_err(as_error)?;
    }
    Ok(file)
}

/// Whether another process has a file [`alone`]. Asking keeps others from opening it so only for that moment, and does not keep
/// them from asking.
pub(crate) fn is_taken(path: &Path) -> std::io::Result<bool> {
    match system::is_taken(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        taken => taken,
    }
}

/// An ordinary file, open to be locked: for writing, which network file systems ask for, or as it can be.
pub(crate) fn to_lock(path: &Path) -> std::io::Result<File> {
    let mut options = File::options();
    options.write(true);
    let mut file = system::without_waiting(&mut options).open(path);
    // Like the model it was made from, a leftover may be write-protected. On Windows only writing shows who has it open.
    if file.is_err() && cfg!(unix) {
        file = system::without_waiting(File::options().read(true)).open(path);
    }
    let file = file?;
    check(&file.metadata()?, Kinds::Ordinary).map_err(as_error)?;
    Ok(file)
}

/// A folder, open to be synchronised; Windows opens none.
pub(crate) fn folder(path: &Path) -> std::io::Result<File> {
    system::without_waiting(File::options().read(true)).open(path)
}

/// A new file that nothing is in.
///
/// # Errors
/// Something has that name, or the folder cannot be written.
pub(crate) fn make_new(path: &Path, options: &mut OpenOptions) -> std::io::Result<File> {
    options.read(true).write(true).create_new(true).open(path)
}

fn open(path: &Path, kinds: Kinds) -> Result<(File, Metadata), Refusal> {
    let mut options = File::options();
    options.read(true);
    if !(kinds == Kinds::Streams && system::is_stream(path)) {
        // Also where something else takes the name at this very moment.
        system::without_waiting(&mut options);
    }
    if kinds == Kinds::Ordinary && system::is_device_name(path) {
        return Err(Refusal::Kind("a device"));
    }
    let file = match options.open(path) {
        Err(error) => {
            return Err(system::kind_that_cannot_be_opened(path).map_or(error.into(), Refusal::Kind));
        }
        Ok(file) => file,
    };
    let metadata = file.metadata()?;
    check(&metadata, kinds)?;
    Ok((file, metadata))
}

fn check(metadata: &Metadata, kinds: Kinds) -> Result<(), Refusal> {
    let is_stream = system::is_pipe(metadata) || system::is_device(metadata);
    if metadata.is_file() || (kinds == Kinds::Streams && is_stream) {
        return Ok(());
    }
    Err(Refusal::Kind(system::kind(metadata)))
}

fn most_of(metadata: &Metadata) -> u64 {
    if system::is_device(metadata) { MOST_OF_DEVICE } else { MOST }
}

/// All of an ordinary file. One that grows is read no further than to its size.
fn whole(mut file: &File, metadata: &Metadata) -> Result<Vec<u8>, Refusal> {
    let length = metadata.len();
    if length > MOST {
        return Err(Refusal::Large(MOST));
    }
    let mut bytes = Vec::new();
    let capacity = usize::try_from(length).map_err(|_| Refusal::Memory)?;
    bytes.try_reserve_exact(capacity).map_err(|_| Refusal::Memory)?;
    file.by_ref().take(length + 1).read_to_end(&mut bytes)?;
    let after = file.metadata()?;
    let same_time = after.modified().ok() == metadata.modified().ok();
    if !same_time || bytes.len() as u64 != after.len() {
        return Err(Refusal::Changed);
    }
    Ok(bytes)
}

/// All that a stream gives, up to a limit.
fn until_end(stream: impl Read, most: u64) -> Result<Vec<u8>, Refusal> {
    let mut bytes = Vec::new();
    stream.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(Refusal::Large(most)) } else { Ok(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_is_read_to_its_limit_and_no_further() {
        assert_eq!(until_end([7; 4].as_slice(), 4).unwrap(), [7; 4]);
        assert!(matches!(until_end([7; 5].as_slice(), 4), Err(Refusal::Large(4))));
        // Of what never ends, a byte more than the limit.
        assert!(matches!(until_end(std::io::repeat(0), 1 << 16), Err(Refusal::Large(65536))));
    }

    #[test]
    fn a_file_that_grows_or_shrinks_while_it_is_read_is_not_taken() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.osim");
        for after in ["longer than before", "short"] {
            std::fs::write(&path, "at the start").unwrap();
            let (file, metadata) = open(&path, Kinds::Ordinary).unwrap();
            std::fs::write(&path, after).unwrap();
            assert!(matches!(whole(&file, &metadata), Err(Refusal::Changed)), "{after}");
        }
        let (file, metadata) = open(&path, Kinds::Ordinary).unwrap();
        assert_eq!(whole(&file, &metadata).unwrap(), b"short");
    }

    #[test]
    fn limits_are_said_as_in_the_documentation() {
        assert_eq!((size(MOST), size(MOST_OF_DEVICE)), ("2 GiB".to_owned(), "16 MiB".to_owned()));
    }
}
