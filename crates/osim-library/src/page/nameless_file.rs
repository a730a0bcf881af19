//! Text that waits on a disk, in a file without a name.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use osim_view::html::DeferredText;

use crate::{LibraryFault, folder_of, reason, resolved};

/// Bytes copied at once.
const CHUNK: usize = 1 << 16;

/// Text that waits in a nameless file until what is before it on the page is known.
pub(crate) struct NamelessFile(BufWriter<File>);

impl NamelessFile {
    /// On the disk that will hold `path`; the system removes the file, whatever happens.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub(crate) fn beside(path: &Path) -> Result<Self, LibraryFault> {
        let target = resolved(path);
        let folder = folder_of(&target);
        let file = tempfile::tempfile_in(folder).map_err(|error| {
            LibraryFault::new(reason(&error)).within(format!("cannot write into {}", folder.display()))
        })?;
        Ok(Self(BufWriter::new(file)))
    }
}

impl DeferredText for NamelessFile {
    fn add(&mut self, text: &str) -> std::io::Result<()> {
        self.0.write_all(text.as_bytes())
    }

    fn pour_into(&mut self, page: &mut dyn Write) -> std::io::Result<()> {
        self.0.flush()?;
        let file = self.0.get_mut();
        file.seek(SeekFrom::Start(0))?;
        let mut chunk = vec![0; CHUNK];
        loop {
            let read = file.read(&mut chunk)?;
            match chunk.get(..read) {
                Some(bytes) if read > 0 => page.write_all(bytes)?,
                _ => return Ok(()),
            }
        }
    }
}
