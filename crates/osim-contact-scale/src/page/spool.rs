//! Text that waits in a nameless file until what stands before it on the page is known.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use anyhow::{Context, Result};

use crate::paths::{folder_of, resolved};
use crate::write::Prepared;

/// Bytes copied at once.
const CHUNK: usize = 1 << 16;

pub(super) struct Spool {
    file: BufWriter<File>,
}

impl Spool {
    /// On the disk that will hold `path`; the system removes the file, whatever happens.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub(super) fn beside(path: &Path) -> Result<Self> {
        let target = resolved(path);
        let folder = folder_of(&target);
        let file = tempfile::tempfile_in(folder)
            .with_context(|| format!("cannot write into {}", folder.display()))?;
        Ok(Self { file: BufWriter::new(file) })
    }

    /// # Errors
    /// The disk is full.
    pub(super) fn add(&mut self, text: &str) -> Result<()> {
        self.file.write_all(text.as_bytes()).context("cannot write the report")
    }

    /// Everything that was added, in its order.
    ///
    /// # Errors
    /// The disk is full.
    pub(super) fn pour_into(&mut self, page: &mut Prepared) -> Result<()> {
        self.file.flush().context("cannot write the report")?;
        let file = self.file.get_mut();
        file.seek(SeekFrom::Start(0)).context("cannot write the report")?;
        let mut chunk = vec![0; CHUNK];
        loop {
            let read = file.read(&mut chunk).context("cannot write the report")?;
            match chunk.get(..read) {
                Some(bytes) if read > 0 => page.add(bytes)?,
                _ => return Ok(()),
            }
        }
    }
}
