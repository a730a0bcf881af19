//! Where elements are after an edit that left them as they were.

use std::ops::Range;

use super::tree::{ElementId, PieceKind, Tree};

/// Where the elements of a file are in another one that edits made of it.
#[derive(Debug, Clone, Default)]
pub struct KeptElements {
    /// From which old element on they are how many places later.
    moves: Vec<(usize, u32)>,
}

impl KeptElements {
    /// Where an old element is in the new file.
    #[must_use]
    pub fn place(&self, old: ElementId) -> ElementId {
        let until = self.moves.partition_point(|(from, _)| *from <= old.index());
        let by = until.checked_sub(1).and_then(|last| self.moves.get(last)).map_or(0, |(_, by)| *by);
        old.later(by)
    }
}

impl Tree {
    /// Where the elements of this file are in `new`, which `edits` made of it: as for [`edited`](Self::edited). `None` unless each edit
    /// changed a text, or put in elements without children, both in an element that `may_change`.
    #[must_use]
    pub fn kept_elements(
        &self,
        new: &Self,
        edits: &[(Range<usize>, usize)],
        may_change: impl Fn(ElementId) -> bool,
    ) -> Option<KeptElements> {
        let (mut kept, mut shift, mut by) = (KeptElements::default(), 0_isize, 0);
        for (span, length) in edits {
            let (owner, next) = self.place_of(span)?;
            if !may_change(ElementId::ROOT.later(u32::try_from(owner).ok()?)) {
                return None;
            }
            let start = span.start.checked_add_signed(shift)?;
            let put_in = new.opening_in(&(start..start.checked_add(*length)?));
            let elements = new.stored_elements().get(put_in.clone())?;
            if !elements.iter().zip(put_in).all(|(element, index)| element.subtree_end as usize == index + 1)
            {
                return None;
            }
            if !elements.is_empty() {
                by += u32::try_from(elements.len()).ok()?;
                kept.moves.push((next, by));
            }
            shift += isize::try_from(*length).ok()?.checked_sub_unsigned(span.len())?;
        }
        (self.element_count() + by as usize == new.element_count()).then_some(kept)
    }

    /// The element in whose content `span` is, a part of a text or nothing, and the first element after it.
    fn place_of(&self, span: &Range<usize>) -> Option<(usize, usize)> {
        let pieces = self.stored_pieces();
        let after = pieces.partition_point(|piece| (piece.start as usize) < span.start);
        let starts_here = pieces.get(after).is_some_and(|piece| piece.start as usize == span.start);
        if span.is_empty() && starts_here {
            return self.place_among_elements(after);
        }
        let text = if starts_here { after } else { after.checked_sub(1)? };
        pieces.get(text).filter(|piece| piece.kind == PieceKind::Text)?;
        pieces.get(text + 1).filter(|next| span.end <= next.start as usize)?;
        self.place_among_elements(text + 1)
    }

    /// Numbers of the elements whose start tags begin in `span`.
    fn opening_in(&self, span: &Range<usize>) -> Range<usize> {
        let (pieces, elements) = (self.stored_pieces(), self.stored_elements());
        let [from, to] = [span.start, span.end].map(|at| {
            let piece = pieces.partition_point(|piece| (piece.start as usize) < at);
            elements.partition_point(|element| (element.open as usize) < piece)
        });
        from..to
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "<m><forces><f><a>1</a>\n</f><g/></forces><joints><j>2</j></joints></m>";

    /// The names of old elements with those at their new places.
    fn kept(edits: &[(&str, &str, &str)]) -> Option<Vec<(String, String)>> {
        let tree = Tree::scan(TEXT).unwrap();
        let (mut new, mut places) = (TEXT.to_owned(), Vec::new());
        for (before, gone, text) in edits {
            let at = TEXT.find(&format!("{before}{gone}")).unwrap() + before.len();
            places.push((at..at + gone.len(), text.len()));
        }
        for ((span, _), (_, _, text)) in places.iter().zip(edits).rev() {
            new.replace_range(span.clone(), text);
        }
        let new = Tree::scan(new).unwrap();
        let is_force = |id: ElementId| {
            std::iter::successors(Some(id), |&id| tree.parent(id)).any(|id| tree.name(id) == "forces")
        };
        let kept = tree.kept_elements(&new, &places, is_force)?;
        let named = |id| (tree.name(id).to_owned(), new.name(kept.place(id)).to_owned());
        Some(tree.elements().map(named).collect())
    }

    #[test]
    fn elements_after_new_leaves_are_found_again() {
        let all =
            kept(&[("<a>", "1", "0.25"), ("</a>\n", "", "<b>2</b><c/>\n"), ("</f>", "", "<h/>")]).unwrap();
        assert!(all.iter().all(|(old, new)| old == new) && all.len() == 7, "{all:?}");
        assert!(kept(&[]).is_some());
    }

    #[test]
    fn what_does_more_keeps_nothing() {
        // In a place that may not change, with a child, a tag that changes, a text that is cut by a tag.
        assert!(kept(&[("<j>", "2", "3")]).is_none());
        assert!(kept(&[("</a>\n", "", "<b><c/></b>")]).is_none());
        assert!(kept(&[("<", "g/", "h/")]).is_none());
        assert!(kept(&[("", "1</a>\n", "2</a>")]).is_none());
    }
}
