//! Replaces exact spans of bytes and keeps all other bytes.

use std::ops::Range;

use osim_model::{Fault, FaultKind, Model, Result};

/// Replaces a span of bytes by a text; with an empty span, inserts the text. [`splice`] applies edits to bytes; [`Patch`] does so
/// without a copy.
///
/// ```
/// use osim_patch::{Edit, splice};
///
/// let edit = Edit { span: 8..12, text: "0.05".to_owned() };
/// assert_eq!(splice(b"<radius>0.03</radius>", &[edit])?, b"<radius>0.05</radius>");
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// The bytes of the original file that the edit replaces, from 0.
    pub span: Range<usize>,
    /// New text in the place of the old one.
    pub text: String,
}

/// The new bytes of a file as slices of the original file and of new text: no bytes are copied before they are written.
///
/// ```
/// use osim_patch::{Edit, Patch};
///
/// let bytes = b"<radius>0.03</radius>";
/// let patch = Patch::new(bytes, vec![Edit { span: 8..12, text: "0.05".to_owned() }])?;
/// // Parts of the original and new text by turns; `patch.to_vec()` is all of them.
/// let parts: Vec<&[u8]> = patch.parts().filter(|part| !part.is_empty()).collect();
/// assert_eq!(parts, [&b"<radius>"[..], b"0.05", b"</radius>"]);
/// assert_eq!(patch.to_vec(), b"<radius>0.05</radius>");
///
/// // Two edits of the same byte: nothing is changed.
/// let twice = [8..12, 11..13].map(|span| Edit { span, text: String::new() });
/// assert!(Patch::new(bytes, twice.to_vec()).is_err());
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone)]
pub struct Patch<'b> {
    bytes: &'b [u8],
    /// The edits in the order of the file, without overlaps.
    edits: Vec<Edit>,
}

impl<'b> Patch<'b> {
    /// A patch of `bytes` by all of `edits`. Edits at the same place are applied in the order given.
    ///
    /// # Errors
    /// Two edits overlap, or one reaches past the end ([`FaultKind::OverlappingEdits`]).
    pub fn new(bytes: &'b [u8], mut edits: Vec<Edit>) -> Result<Self> {
        edits.sort_by_key(|edit| edit.span.start);
        let mut at = 0;
        for Edit { span, .. } in &edits {
            if span.start < at || span.end < span.start || span.end > bytes.len() {
                return Err(Fault::new(FaultKind::OverlappingEdits { at: span.start }));
            }
            at = span.end;
        }
        Ok(Self { bytes, edits })
    }

    /// The slices in order: kept bytes and new text alternate.
    pub fn parts(&self) -> impl Iterator<Item = &[u8]> {
        let starts = std::iter::once(0).chain(self.edits.iter().map(|edit| edit.span.end));
        let new = self.edits.iter().map(|edit| (edit.span.start, edit.text.as_bytes()));
        let ends = new.chain(std::iter::once((self.bytes.len(), &b""[..])));
        let parts = starts.zip(ends);
        parts.flat_map(|(start, (end, text))| [self.bytes.get(start..end).unwrap_or_default(), text])
    }

    /// The new bytes as one copy.
    pub fn to_vec(&self) -> Vec<u8> {
        let added: usize = self.edits.iter().map(|edit| edit.text.len()).sum();
        let mut output = Vec::with_capacity(self.bytes.len() + added);
        self.parts().for_each(|part| output.extend_from_slice(part));
        output
    }
}

/// Applies all `edits` to `bytes`, or none of them: see [`Edit`] for an example.
pub fn splice(bytes: &[u8], edits: &[Edit]) -> Result<Vec<u8>> {
    Patch::new(bytes, edits.to_vec()).map(|patch| patch.to_vec())
}

/// `model` read again with `edits` in its main file; an error if any edit fails.
pub(crate) fn model_with_edits(model: &Model, edits: Vec<Edit>) -> Result<Model> {
    let patch = Patch::new(model.document().bytes(), edits)?;
    model.read_again(patch.to_vec(), &[])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn edit(span: Range<usize>, text: &str) -> Edit {
        Edit { span, text: text.to_owned() }
    }

    #[test]
    fn edits_replace_their_spans_and_nothing_else() {
        let edits = [edit(4..5, "Y"), edit(1..2, "XX"), edit(6..6, "end")];
        assert_eq!(splice(b"abcdef", &edits).unwrap(), b"aXXcdYfend");
        assert_eq!(splice(b"ab", &[edit(1..1, "1"), edit(1..1, "2")]).unwrap(), b"a12b");
    }

    #[test]
    fn overlapping_or_outlying_edits_change_nothing() {
        assert!(splice(b"abcdef", &[edit(1..3, ""), edit(2..4, "")]).is_err());
        assert!(splice(b"abc", &[edit(2..9, "")]).is_err());
    }

    proptest! {
        #[test]
        fn without_edits_the_bytes_are_identical(bytes: Vec<u8>) {
            prop_assert_eq!(splice(&bytes, &[]).unwrap(), bytes);
        }

        #[test]
        fn outside_the_spans_the_bytes_are_identical(
            parts in prop::collection::vec((prop::collection::vec(any::<u8>(), 0..9), 0_usize..5, "[a-z]{0,4}"), 0..8),
        ) {
            // Kept bytes and replaced bytes alternate, so the expected result is put together without any splicing.
            let (mut original, mut expected, mut edits) = (Vec::new(), Vec::new(), Vec::new());
            for (kept, replaced, text) in parts {
                original.extend_from_slice(&kept);
                expected.extend_from_slice(&kept);
                let start = original.len();
                original.extend(std::iter::repeat_n(b'?', replaced));
                edits.push(Edit { span: start..original.len(), text: text.clone() });
                expected.extend_from_slice(text.as_bytes());
            }
            prop_assert_eq!(splice(&original, &edits).unwrap(), expected);
        }
    }
}
