//! Opens and reads files safely: everything that this project reads from a disk is opened here.
//!
//! A name may lead to a pipe into which nobody writes, to a device that never ends, or to a file larger than the memory. So a file
//! is opened without waiting, the kind of the opened file is checked, and at most as many bytes are read as the limit in
//! `docs/libraries.md`. Pipes and devices are read only if the user named them: [`FileKinds::Streams`].
//!
//! `clippy.toml` forbids the other ways to open a file. SHA-256 digests say which bytes a file had.
#![cfg_attr(not(test), expect(clippy::disallowed_methods, reason = "this module opens all files"))]

#[cfg(unix)]
mod unix;
#[cfg(windows)]
mod windows;

use std::ffi::OsStr;
use std::fmt;
use std::fs::{File, Metadata, OpenOptions};
use std::io::{ErrorKind, Read};
use std::path::Path;

use osim_model::files::FileError;
use sha2::{Digest, Sha256};

#[cfg(unix)]
use unix as system;
#[cfg(windows)]
use windows as system;

/// Most bytes that are read from a file or pipe: far more than any model, summary or table has.
const MOST_BYTES_OF_FILE: u64 = 2 << 30;

/// Most bytes that are read from a device: nobody types more in a terminal, and `/dev/zero` does not end.
const MOST_BYTES_OF_DEVICE: u64 = 16 << 20;

/// Which kinds of files may be read under a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FileKinds {
    /// Ordinary files: for names that the user did not give, such as those in models, tables and folders.
    Ordinary,
    /// Ordinary files, and pipes and devices, which the program waits for: for names that the user gave.
    Streams,
}

/// Why a file was not read.
#[derive(Debug)]
pub(crate) enum ReadRefusal {
    /// The operating system reports an error when the file is opened or read.
    System(std::io::Error),
    Kind(&'static str),
    /// The file has more bytes than this limit.
    Large(u64),
    /// The file does not fit into the memory.
    Memory,
    /// Another program wrote the file while it was read.
    Changed,
}

impl fmt::Display for ReadRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System(error) if error.kind() == ErrorKind::NotFound => FileError::not_found().fmt(f),
            Self::System(error) => write!(f, "cannot be read: {}", reason(error)),
            Self::Kind(what) => write!(f, "this is {what}, expected an ordinary file"),
            Self::Large(most) => write!(
                f,
                "larger than {}, the most that is read of it: check that it is the right file",
                size_in_words(*most)
            ),
            Self::Memory => f.write_str("cannot be read: too large for this computer's memory"),
            Self::Changed => {
                f.write_str("another program changed it while it was being read: run again when that is done")
            }
        }
    }
}

impl From<ReadRefusal> for FileError {
    fn from(refusal: ReadRefusal) -> Self {
        Self::new(refusal.to_string())
    }
}

impl From<std::io::Error> for ReadRefusal {
    fn from(error: std::io::Error) -> Self {
        Self::System(error)
    }
}

fn into_io_error(refusal: ReadRefusal) -> std::io::Error {
    match refusal {
        ReadRefusal::System(error) => error,
        refusal => std::io::Error::other(refusal.to_string()),
    }
}

/// A number of bytes in GiB or MiB.
fn size_in_words(bytes: u64) -> String {
    match bytes {
        bytes if bytes >= 1 << 30 => format!("{} GiB", bytes >> 30),
        bytes if bytes >= 1 << 20 => format!("{} MiB", bytes >> 20),
        bytes => format!("{bytes} bytes"),
    }
}

/// The message of the operating system about `error`, with advice if too many files are open.
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
/// The file does not exist, cannot be read, is of a kind that `kinds` excludes, is too large, or changes while it is read.
pub(crate) fn read(path: &Path, kinds: FileKinds) -> Result<(Vec<u8>, Metadata), ReadRefusal> {
    let (file, metadata) = open_for_reading(path, kinds)?;
    if metadata.is_file() {
        return Ok((read_to_length(&file, &metadata)?, metadata));
    }
    let most = if system::is_device(&metadata) { MOST_BYTES_OF_DEVICE } else { MOST_BYTES_OF_FILE };
    Ok((read_to_limit(file, most)?, metadata))
}

/// Reads a whole ordinary file.
pub(crate) fn read_ordinary(path: &Path) -> Result<Vec<u8>, ReadRefusal> {
    read(path, FileKinds::Ordinary).map(|(bytes, _)| bytes)
}

/// Reads the first bytes of an ordinary file, at most `most`.
///
/// # Errors
/// The file does not exist, cannot be read, or is not an ordinary file.
pub(crate) fn read_head(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    let (file, _) = open_for_reading(path, FileKinds::Ordinary).map_err(into_io_error)?;
    let mut head = Vec::with_capacity(most);
    file.take(most as u64).read_to_end(&mut head)?;
    Ok(head)
}

/// Opens an ordinary file to be read piece by piece; also returns its length.
pub(crate) fn open_to_read(path: &Path) -> std::io::Result<(File, u64)> {
    let (file, metadata) = open_for_reading(path, FileKinds::Ordinary).map_err(into_io_error)?;
    Ok((file, metadata.len()))
}

/// Reads standard input.
///
/// # Errors
/// Standard input cannot be read, or has more bytes than the limit.
pub(crate) fn standard_input() -> Result<Vec<u8>, ReadRefusal> {
    let most = if system::standard_input_is_device() { MOST_BYTES_OF_DEVICE } else { MOST_BYTES_OF_FILE };
    read_to_limit(std::io::stdin().lock(), most)
}

/// Opens or creates an ordinary file that only this process may write and shorten; other processes may read it. `None` if another
/// process has opened the file in this way.
pub(crate) fn open_exclusively(path: &Path) -> std::io::Result<Option<File>> {
    let file = system::open_exclusively(path)?;
    if let Some(file) = &file {
        check_kind(&file.metadata()?, FileKinds::Ordinary).map_err(into_io_error)?;
    }
    Ok(file)
}

/// Whether another process has opened a file by [`open_exclusively`].
pub(crate) fn is_open_exclusively(path: &Path) -> std::io::Result<bool> {
    match system::is_open_exclusively(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        taken => taken,
    }
}

/// Opens an ordinary file to lock it: for writing if that is allowed, because locks of network file systems need it, else for reading.
pub(crate) fn open_to_lock(path: &Path) -> std::io::Result<File> {
    let mut options = File::options();
    options.write(true);
    let mut file = system::options_without_waiting(&mut options).open(path);
    // The file may be write-protected. On Windows, it has to be opened for writing to show whether somebody has it open.
    if file.is_err() && cfg!(unix) {
        file = system::options_without_waiting(File::options().read(true)).open(path);
    }
    let file = file?;
    check_kind(&file.metadata()?, FileKinds::Ordinary).map_err(into_io_error)?;
    Ok(file)
}

/// Opens a folder to write its list of files to the disk, which Windows cannot do.
pub(crate) fn open_folder(path: &Path) -> std::io::Result<File> {
    system::options_without_waiting(File::options().read(true)).open(path)
}

/// Creates a file that does not exist yet.
///
/// # Errors
/// A file or folder has this name already, or the folder cannot be written.
pub(crate) fn create_new(path: &Path, options: &mut OpenOptions) -> std::io::Result<File> {
    options.read(true).write(true).create_new(true).open(path)
}

/// Opens a file of one of these kinds to read it.
fn open_for_reading(path: &Path, kinds: FileKinds) -> Result<(File, Metadata), ReadRefusal> {
    let mut options = File::options();
    options.read(true);
    if !(kinds == FileKinds::Streams && system::is_stream(path)) {
        // Also if the name becomes that of a pipe at this moment.
        system::options_without_waiting(&mut options);
    }
    if kinds == FileKinds::Ordinary && system::is_device_name(path) {
        return Err(ReadRefusal::Kind("a device"));
    }
    let kind = || system::name_of_unopenable_kind(path);
    let file = options.open(path).map_err(|error| kind().map_or(error.into(), ReadRefusal::Kind))?;
    let metadata = file.metadata()?;
    check_kind(&metadata, kinds)?;
    Ok((file, metadata))
}

/// Refuses a file of another kind, such as a folder or a pipe.
fn check_kind(metadata: &Metadata, kinds: FileKinds) -> Result<(), ReadRefusal> {
    let is_stream = system::is_pipe(metadata) || system::is_device(metadata);
    if metadata.is_file() || (kinds == FileKinds::Streams && is_stream) {
        return Ok(());
    }
    Err(ReadRefusal::Kind(system::kind_name(metadata)))
}

/// Reads an ordinary file. Refuses it if its length or its time changes while it is read.
fn read_to_length(mut file: &File, metadata: &Metadata) -> Result<Vec<u8>, ReadRefusal> {
    let length = metadata.len();
    if length > MOST_BYTES_OF_FILE {
        return Err(ReadRefusal::Large(MOST_BYTES_OF_FILE));
    }
    let mut bytes = Vec::new();
    let capacity = usize::try_from(length).map_err(|_| ReadRefusal::Memory)?;
    bytes.try_reserve_exact(capacity).map_err(|_| ReadRefusal::Memory)?;
    file.by_ref().take(length + 1).read_to_end(&mut bytes)?;
    let after = file.metadata()?;
    let same_time = after.modified().ok() == metadata.modified().ok();
    if same_time && bytes.len() as u64 == after.len() { Ok(bytes) } else { Err(ReadRefusal::Changed) }
}

/// Reads a stream to its end. Refuses it if it has more than `most` bytes.
fn read_to_limit(stream: impl Read, most: u64) -> Result<Vec<u8>, ReadRefusal> {
    let mut bytes = Vec::new();
    stream.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(ReadRefusal::Large(most)) } else { Ok(bytes) }
}

/// SHA-256 of `bytes` as 64 hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    sha256_of_parts(std::iter::once(bytes))
}

/// SHA-256 of the bytes of `parts`, one after the other, as 64 hexadecimal digits.
pub(crate) fn sha256_of_parts<'p>(parts: impl Iterator<Item = &'p [u8]>) -> String {
    let mut hash = Sha256::new();
    parts.for_each(|part| hash.update(part));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The first half of the SHA-256 of a name, which takes less memory than the name.
pub(crate) type NameDigest = [u8; 16];

/// A short digest of a name, which takes less memory than the name.
pub(crate) fn digest_of_name(name: &OsStr) -> NameDigest {
    let whole: [u8; 32] = Sha256::digest(name.as_encoded_bytes()).into();
    std::array::from_fn(|at| whole[at])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_is_read_to_its_limit_and_no_further() {
        assert_eq!(read_to_limit([7; 4].as_slice(), 4).unwrap(), [7; 4]);
        assert!(matches!(read_to_limit([7; 5].as_slice(), 4), Err(ReadRefusal::Large(4))));
        // One byte more than the limit is read of an endless stream.
        assert!(matches!(read_to_limit(std::io::repeat(0), 1 << 16), Err(ReadRefusal::Large(65536))));
    }

    #[test]
    fn a_file_that_grows_or_shrinks_while_it_is_read_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.osim");
        for after in ["longer than before", "short"] {
            std::fs::write(&path, "at the start").unwrap();
            let (file, metadata) = open_for_reading(&path, FileKinds::Ordinary).unwrap();
            std::fs::write(&path, after).unwrap();
            assert!(matches!(read_to_length(&file, &metadata), Err(ReadRefusal::Changed)), "{after}");
        }
        let (file, metadata) = open_for_reading(&path, FileKinds::Ordinary).unwrap();
        assert_eq!(read_to_length(&file, &metadata).unwrap(), b"short");
    }

    #[test]
    fn limits_are_written_as_in_the_documentation() {
        assert_eq!(
            (size_in_words(MOST_BYTES_OF_FILE), size_in_words(MOST_BYTES_OF_DEVICE)),
            ("2 GiB".to_owned(), "16 MiB".to_owned())
        );
    }
}
