//! Text that waits until what is before it on the page is known.

use std::io::{self, Write};

/// Text that waits: in memory, or in a file that has no name.
pub trait DeferredText {
    /// Adds a piece.
    ///
    /// # Errors
    /// It cannot be kept: the disk is full.
    fn add(&mut self, text: &str) -> io::Result<()>;

    /// Writes everything that was added, in its order.
    ///
    /// # Errors
    /// It cannot be read back, or the page cannot be written.
    fn pour_into(&mut self, page: &mut dyn Write) -> io::Result<()>;
}

/// Text that waits in memory.
#[derive(Debug, Clone, Default)]
pub struct InMemory(String);

impl DeferredText for InMemory {
    fn add(&mut self, text: &str) -> io::Result<()> {
        self.0.push_str(text);
        Ok(())
    }

    fn pour_into(&mut self, page: &mut dyn Write) -> io::Result<()> {
        page.write_all(self.0.as_bytes())
    }
}
