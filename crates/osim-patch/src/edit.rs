//! Editing by splicing: exact byte spans are replaced, every other byte is copied.

use std::ops::Range;

use crate::error::{Fault, FaultKind};

/// Replace these bytes by this text; an empty span inserts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// Bytes of the original.
    pub span: Range<usize>,
    /// What takes their place.
    pub text: String,
}

/// Applies `edits` to `bytes`, all or nothing. Edits at the same place are applied in the order given.
///
/// # Errors
/// Two edits overlap, or one reaches past the end.
pub fn splice(bytes: &[u8], edits: &[Edit]) -> Result<Vec<u8>, Fault> {
    let mut sorted: Vec<&Edit> = edits.iter().collect();
    sorted.sort_by_key(|edit| edit.span.start);
    let added: usize = edits.iter().map(|edit| edit.text.len()).sum();
    let mut output = Vec::with_capacity(bytes.len() + added);
    let mut at = 0;
    for edit in sorted {
        let kept = bytes.get(at..edit.span.start);
        let (Some(kept), true) = (kept, edit.span.start <= edit.span.end && edit.span.end <= bytes.len())
        else {
            return Err(Fault::new(FaultKind::OverlappingEdits { at: edit.span.start }));
        };
        output.extend_from_slice(kept);
        output.extend_from_slice(edit.text.as_bytes());
        at = edit.span.end;
    }
    output.extend_from_slice(bytes.get(at..).unwrap_or_default());
    Ok(output)
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
