//! The bytes of a file, as text of the same length.

/// A file as UTF-8. Where it is not UTF-8, each offending byte is one `?` in the text, so that an offset means the same place
/// in the text and in the file.
#[derive(Debug, Clone)]
pub(crate) struct FileText {
    text: String,
    /// The bytes as they are, where they are not the text's.
    original: Option<Vec<u8>>,
}

impl FileText {
    /// Takes the bytes over; they are copied only where they are not UTF-8.
    pub(crate) fn new(bytes: Vec<u8>) -> Self {
        match String::from_utf8(bytes) {
            Ok(text) => Self { text, original: None },
            Err(error) => {
                let bytes = error.into_bytes();
                let mut text = String::with_capacity(bytes.len());
                for chunk in bytes.utf8_chunks() {
                    text.push_str(chunk.valid());
                    text.extend(chunk.invalid().iter().map(|_| '?'));
                }
                Self { text, original: Some(bytes) }
            }
        }
    }

    pub(crate) fn as_str(&self) -> &str {
        &self.text
    }

    /// The file, untouched.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.original.as_deref().unwrap_or(self.text.as_bytes())
    }

    /// The file, untouched, without a copy.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.original.unwrap_or(self.text.into_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stray_byte_keeps_all_offsets_and_the_file() {
        let text = FileText::new(b"<a>\x96<b>1</b></a>".to_vec());
        assert_eq!(text.as_str(), "<a>?<b>1</b></a>");
        assert_eq!(text.bytes(), b"<a>\x96<b>1</b></a>");
    }
}
