//! Why a workspace cannot be read.

use std::io;
use std::path::PathBuf;

/// Why a workspace cannot be read, or a rule cannot be asked.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file or folder that cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// Which one.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A source file that is not Rust.
    #[error("{file}:{line}: {message}")]
    Syntax {
        /// Which one.
        file: String,
        /// Where in it.
        line: usize,
        /// What the parser says.
        message: String,
    },
    /// A `Cargo.toml` that cannot be understood.
    #[error("{}: {message}", path.display())]
    Manifest {
        /// Which one.
        path: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// A list of words that cannot be understood.
    #[error("{}: {message}", path.display())]
    Words {
        /// Which one.
        path: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// A `mod x;` without a file.
    #[error("{file}:{line}: no file for the module {name}")]
    NoFile {
        /// The file that declares the module.
        file: String,
        /// Where in it.
        line: usize,
        /// The module.
        name: String,
    },
    /// A rule speaks of a crate that is not in the workspace: it would hold nothing, and nobody would see it.
    #[error("no crate {0} in the workspace, though a rule speaks of it")]
    NoCrate(String),
}
