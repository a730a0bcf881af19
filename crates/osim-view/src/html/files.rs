//! The files of a model, for the record.

use maud::{Markup, html};

/// A file, for the record.
#[derive(Debug, Clone)]
pub struct NamedDigest {
    /// Its name.
    pub name: String,
    /// The SHA-256 of its bytes; empty if there are no bytes.
    pub sha256: String,
}

/// The files of a change.
#[derive(Debug, Clone, Default)]
pub struct Files {
    /// What was read, the model first.
    pub inputs: Vec<NamedDigest>,
    /// The outcome, in words.
    pub result: String,
    /// What was written.
    pub outputs: Vec<NamedDigest>,
}

/// The files of a change, as a list.
pub(super) fn of_change(files: &Files) -> Markup {
    html! {
        dl {
            (read(&files.inputs))
            dt { "Result" } dd { (files.result) }
            @for file in &files.outputs { dt { "Written" } dd { (digest(file)) } }
        }
    }
}

/// The files that a model was read from, the model first.
pub(super) fn read(files: &[NamedDigest]) -> Markup {
    html! {
        @for (index, file) in files.iter().enumerate() {
            dt { @if index == 0 { "Model" } @else { "With it" } } dd { (digest(file)) }
        }
    }
}

fn digest(NamedDigest { name, sha256 }: &NamedDigest) -> Markup {
    html! { (name) @if !sha256.is_empty() { br; "SHA-256 " code.digest { (sha256) } } }
}
