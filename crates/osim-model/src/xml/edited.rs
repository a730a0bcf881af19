//! The tree of a file after an edit, without scanning again what stayed.

use std::ops::Range;

use super::plain::scan_plain;
use super::scan::{SyntaxError, pieces_and_elements, refuse_foreign_encodings};
use super::tree::{FileText, PieceKind, StoredElement, StoredPiece, Tree};

/// What a text is wrapped in to be scanned by itself.
const WRAP: (&str, &str) = ("<x>", "</x>");

impl Tree {
    /// The tree of `bytes`, which are this file's with other bytes in some places: `edits` says, by place, which bytes of this
    /// file gave way to how many new ones. The same as [`Tree::scan`] of `bytes`, and faster where something was inserted, or
    /// took the place of text or of `<tag/>`. That `edits` are those that were made is not looked up, but where debug assertions are on.
    ///
    /// ```
    /// use osim_model::xml::Tree;
    ///
    /// let tree = Tree::scan("<objects><a/></objects>").expect("it is well formed");
    /// let edited = tree.edited("<objects><a/><b>1</b></objects>", &[(13..13, 8)]).expect("so is this");
    /// assert_eq!(edited.element_count(), 3);
    /// ```
    ///
    /// # Errors
    /// As [`Tree::scan`].
    pub fn edited(
        &self,
        bytes: impl Into<Vec<u8>>,
        edits: &[(Range<usize>, usize)],
    ) -> Result<Self, SyntaxError> {
        let file = FileText::new(bytes.into());
        let edits = &joined(edits);
        if refuse_foreign_encodings(file.bytes()).is_ok()
            && let Some((pieces, elements)) = Splice::of(self, file.as_str(), edits)
        {
            debug_assert_eq!(
                pieces_and_elements(&file).ok().as_ref(),
                Some(&(pieces.clone(), elements.clone()))
            );
            return Ok(Self::new(file, pieces, elements));
        }
        Self::scan(file.into_bytes())
    }
}

/// The same edits, those without a byte between them as one.
fn joined(edits: &[(Range<usize>, usize)]) -> Vec<(Range<usize>, usize)> {
    let mut joined: Vec<(Range<usize>, usize)> = Vec::with_capacity(edits.len());
    for (span, length) in edits {
        match joined.last_mut().filter(|(last, _)| last.end == span.start) {
            Some((last, sum)) => {
                last.end = span.end;
                *sum = sum.saturating_add(*length);
            }
            None => joined.push((span.clone(), *length)),
        }
    }
    joined
}

/// A new text in place of old bytes.
struct New<'t> {
    /// In the old file: nothing, a whole text between tags, or a whole `<tag/>`.
    span: Range<usize>,
    /// Where it begins in the new file.
    start: usize,
    text: &'t str,
}

/// One text that was inserted, scanned.
struct Inserted {
    /// Pieces of the old tree that give way: none, the text that it was inserted into, or a `<tag/>`.
    replaced: Range<usize>,
    /// Elements of the old tree that give way: none, or that of a `<tag/>`.
    gone: usize,
    /// What takes their place, where it is in the new file.
    pieces: Vec<StoredPiece>,
    /// Its elements; `open` and `close` count in `pieces`, and the parent of an outermost one is `None`.
    elements: Vec<(StoredElement, Option<u32>)>,
    /// The old element that it is in.
    parent: usize,
    /// The first old element after it.
    next: usize,
    /// Bytes that the file has more by it; fewer below 0.
    more: isize,
}

/// Old pieces and elements with what was inserted between them.
struct Splice<'t> {
    old: &'t Tree,
    inserted: Vec<Inserted>,
    /// How much all those before each one, and at the end all together, put in.
    counts: Vec<Count>,
}

impl<'t> Splice<'t> {
    /// The pieces and elements of the new `text`; `None` where that takes a whole scan.
    fn of(
        old: &'t Tree,
        text: &str,
        edits: &[(Range<usize>, usize)],
    ) -> Option<(Vec<StoredPiece>, Vec<StoredElement>)> {
        let mut splice = Self { old, inserted: Vec::new(), counts: vec![Count::default()] };
        let mut shift: isize = 0;
        for (span, length) in edits {
            let new = splice.new_text(text, (span, *length), span.start.checked_add_signed(shift)?)?;
            let inserted = splice.inserted(&new)?;
            // Each has its own pieces to give way, in order.
            if splice.inserted.last().is_some_and(|last| {
                last.replaced.end > inserted.replaced.start || last.replaced == inserted.replaced
            }) {
                return None;
            }
            shift += inserted.more;
            let before = splice.counts.last().copied().unwrap_or_default();
            splice.counts.push(before.with(&inserted));
            splice.inserted.push(inserted);
        }
        let is_whole = old.text().len().checked_add_signed(shift) == Some(text.len());
        is_whole.then(|| (splice.pieces(), splice.elements()))
    }

    /// What an edit put into `text`, from `start` on. A part of `<tag/>` or of a text gave way with the whole of it.
    fn new_text<'n>(
        &self,
        text: &'n str,
        (span, length): (&Range<usize>, usize),
        start: usize,
    ) -> Option<New<'n>> {
        let from = |start: usize, length| text.get(start..start.checked_add(length)?);
        if span.is_empty() {
            let text = from(start, length).filter(|text| !text.is_empty())?;
            return Some(New { span: span.clone(), start, text });
        }
        let old = self.old.stored_pieces();
        let at = old.partition_point(|piece| piece.start as usize <= span.start).checked_sub(1)?;
        let piece = old.get(at)?;
        if !matches!(piece.kind, PieceKind::Empty | PieceKind::Text) {
            return None;
        }
        let (begin, to) = (piece.start as usize, old.get(at + 1)?.start as usize);
        let (before, after) = (span.start - begin, to.checked_sub(span.end)?);
        let start = start.checked_sub(before)?;
        let length = before.checked_add(length)?.checked_add(after)?;
        Some(New { span: begin..to, start, text: from(start, length)? })
    }

    /// A new text, scanned, with its place among the old pieces and elements.
    fn inserted(&self, new: &New<'_>) -> Option<Inserted> {
        let &New { ref span, start, text } = new;
        let (old, at) = (self.old.stored_pieces(), span.start);
        let (pieces, elements) = scan_plain(&[WRAP.0, text, WRAP.1].concat(), 0)?;
        let inside = pieces.get(1..pieces.len().checked_sub(1)?)?;
        let more = isize::try_from(text.len()).ok()?.checked_sub_unsigned(span.len())?;
        // The piece that begins at `at` or is the first after it.
        let after = old.partition_point(|piece| (piece.start as usize) < at);
        if let Some(border) = self.after_text(span) {
            // Words for words: all pieces stay.
            let is_text = inside.len() == 1 && inside.iter().all(|piece| piece.kind == PieceKind::Text);
            let (parent, next) = self.old.place_among_elements(border).filter(|_| is_text)?;
            let (pieces, elements, replaced) = (Vec::new(), Vec::new(), border..border);
            return Some(Inserted { replaced, gone: 0, pieces, elements, parent, next, more });
        }
        let gone = usize::from(!span.is_empty());
        // A tag gives way to elements, and to nothing beside them.
        let is_tag = |piece: Option<&StoredPiece>| piece.is_some_and(|piece| piece.kind != PieceKind::Text);
        if gone > 0 && !(is_tag(inside.first()) && is_tag(inside.last()) && elements.len() > 1) {
            return None;
        }
        let is_text = |index: usize| old.get(index).is_some_and(|piece| piece.kind == PieceKind::Text);
        let is_between = old.get(after).is_some_and(|piece| piece.start as usize == at);
        let before = after.checked_sub(1)?;
        if !is_between && !is_text(before) {
            return None;
        }
        // Text beside text is one piece.
        let joins_before =
            is_text(before) && inside.first().is_some_and(|piece| piece.kind == PieceKind::Text);
        let joins_after = inside.last().is_some_and(|piece| piece.kind == PieceKind::Text);
        let mut own_pieces = Vec::with_capacity(inside.len() + 2);
        let replaced = match is_between {
            true => after..after + gone.max(usize::from(joins_after && is_text(after))),
            false => {
                let old_start = start.checked_sub(at - old.get(before)?.start as usize)?;
                own_pieces.push(StoredPiece { start: u32::try_from(old_start).ok()?, kind: PieceKind::Text });
                before..after
            }
        };
        let lead = own_pieces.len();
        let dropped = usize::from(joins_before);
        for piece in inside.iter().skip(dropped) {
            let start = start + piece.start as usize - WRAP.0.len();
            own_pieces.push(StoredPiece { start: u32::try_from(start).ok()?, kind: piece.kind });
        }
        if !is_between && !joins_after {
            own_pieces
                .push(StoredPiece { start: u32::try_from(start + text.len()).ok()?, kind: PieceKind::Text });
        }
        let place = |piece: u32| u32::try_from((piece as usize + lead).checked_sub(1 + dropped)?).ok();
        let mut own = Vec::with_capacity(elements.len());
        for element in elements.get(1..)? {
            let (open, close) = (place(element.open)?, place(element.close)?);
            let subtree_end = element.subtree_end.checked_sub(1)?;
            own.push((StoredElement { open, close, subtree_end, ..*element }, element.parent.checked_sub(1)));
        }
        let (parent, next) = self.old.place_among_elements(replaced.end)?;
        Some(Inserted { replaced, gone, pieces: own_pieces, elements: own, parent, next, more })
    }

    /// The piece after the text that `span` is; `None` if it is nothing, or a tag.
    fn after_text(&self, span: &Range<usize>) -> Option<usize> {
        let old = self.old.stored_pieces();
        let after = old.partition_point(|piece| (piece.start as usize) <= span.start);
        let text = old.get(after.checked_sub(1)?).filter(|piece| piece.kind == PieceKind::Text);
        text.filter(|_| !span.is_empty()).map(|_| after)
    }

    fn pieces(&self) -> Vec<StoredPiece> {
        let old = self.old.stored_pieces();
        let more: usize = self.inserted.iter().map(|inserted| inserted.pieces.len()).sum();
        let mut pieces = Vec::with_capacity(old.len() + more);
        let (mut from, mut shift) = (0, 0_isize);
        let kept = |range: Range<usize>, shift: isize| {
            let kept = old.get(range).unwrap_or_default().iter();
            // Where all of them are in a file is known: none leaves it.
            let shift = small_shift(shift);
            kept.map(move |piece| StoredPiece { start: piece.start.wrapping_add_signed(shift), ..*piece })
        };
        for inserted in &self.inserted {
            pieces.extend(kept(from..inserted.replaced.start, shift));
            pieces.extend(&inserted.pieces);
            from = inserted.replaced.end;
            shift += inserted.more;
        }
        pieces.extend(kept(from..old.len(), shift));
        pieces
    }

    fn elements(&self) -> Vec<StoredElement> {
        let old = self.old.stored_elements();
        if self.inserted.iter().all(|inserted| inserted.replaced.is_empty() && inserted.pieces.is_empty()) {
            return old.to_vec();
        }
        let more: usize = self.inserted.iter().map(|inserted| inserted.elements.len()).sum();
        let mut elements = Vec::with_capacity(old.len() + more);
        let mut from = 0;
        for (index, inserted) in self.inserted.iter().enumerate() {
            self.extend_kept(&mut elements, from..inserted.next - inserted.gone, index);
            from = inserted.next;
            let first = small(elements.len());
            let tag = old.get(inserted.parent).map_or(0, |parent| parent.open);
            let parent = small(inserted.parent) + self.before(tag).elements;
            let pieces = small(inserted.replaced.start) + self.count_before(index).pieces;
            elements.extend(inserted.elements.iter().map(|(element, above)| StoredElement {
                open: pieces + element.open,
                close: pieces + element.close,
                parent: above.map_or(parent, |above| first + above),
                subtree_end: first + element.subtree_end,
                name_len: element.name_len,
            }));
        }
        self.extend_kept(&mut elements, from..old.len(), self.inserted.len());
        elements
    }

    /// Old elements, counted again: those between what was inserted before the one at `index`, and this.
    fn extend_kept(&self, elements: &mut Vec<StoredElement>, range: Range<usize>, index: usize) {
        let old = self.old.stored_elements();
        let here = self.count_before(index);
        let until = self.inserted.get(index).map_or(usize::MAX, |next| next.replaced.end);
        let from = range.start;
        elements.extend(old.get(range).unwrap_or_default().iter().map(|element| {
            // Most elements hold nothing that is new.
            let close = if (element.close as usize) < until { here } else { self.before(element.close) };
            let parent = match old.get(element.parent as usize) {
                Some(parent) if (element.parent as usize) < from => self.before(parent.open),
                _ => here,
            };
            StoredElement {
                open: element.open + here.pieces,
                close: element.close + close.pieces,
                parent: element.parent + parent.elements,
                // What is inserted before its end tag is in it.
                subtree_end: element.subtree_end + close.elements,
                name_len: element.name_len,
            }
        }));
    }

    /// How much was inserted before the old piece `piece`, a tag.
    fn before(&self, piece: u32) -> Count {
        let until = self.inserted.partition_point(|inserted| inserted.replaced.end <= piece as usize);
        self.count_before(until)
    }

    /// How much those before the one at `index` put in.
    fn count_before(&self, index: usize) -> Count {
        self.counts.get(index).copied().unwrap_or_default()
    }
}

/// How many more there are.
#[derive(Clone, Copy, Default)]
struct Count {
    pieces: u32,
    elements: u32,
}

impl Count {
    fn with(self, one: &Inserted) -> Self {
        // Text that gives way goes on in what takes its place, and a tag gives way to elements: there are never fewer.
        Self {
            pieces: self.pieces + small(one.pieces.len().saturating_sub(one.replaced.len())),
            elements: self.elements + small(one.elements.len().saturating_sub(one.gone)),
        }
    }
}

/// A shift, of which the last 32 bits say where in a file something comes to be.
#[expect(clippy::cast_possible_truncation, reason = "files over 4 GiB were refused")]
fn small_shift(shift: isize) -> i32 {
    shift as i32
}

#[expect(clippy::cast_possible_truncation, reason = "files over 4 GiB were refused")]
fn small(count: usize) -> u32 {
    count as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both trees, where one is spliced: what is inserted, whether that was possible, and that both are equal.
    #[track_caller]
    fn spliced(text: &str, insertions: &[(usize, &str)]) -> bool {
        let changes: Vec<_> = insertions.iter().map(|(at, text)| (*at..*at, *text)).collect();
        replaced(text, &changes)
    }

    /// The same where bytes give way.
    #[track_caller]
    fn replaced(text: &str, changes: &[(Range<usize>, &str)]) -> bool {
        let tree = Tree::scan(text).unwrap();
        let mut new = text.to_owned();
        for (span, inserted) in changes.iter().rev() {
            new.replace_range(span.clone(), inserted);
        }
        let edits: Vec<_> = changes.iter().map(|(span, text)| (span.clone(), text.len())).collect();
        let found = Splice::of(&tree, &new, &edits);
        let scanned = Tree::scan(new.as_str());
        match (&found, &scanned) {
            (Some((pieces, elements)), Ok(scanned)) => {
                assert_eq!(
                    (pieces.as_slice(), elements.as_slice()),
                    (scanned.stored_pieces(), scanned.stored_elements()),
                    "{new}"
                );
            }
            (Some(_), Err(_)) => panic!("{new} is not well formed"),
            (None, _) => {}
        }
        assert_eq!(tree.edited(new.as_str(), &edits).is_ok(), scanned.is_ok(), "{new}");
        found.is_some()
    }

    const TEXT: &str = "\u{feff}<?xml version='1.0'?>\n<a><b x='1'>\n <c>é</c>\n</b><!-- c --><d/><e></e>text<f> 1 </f></a>\n";
    const TEXTS: [&str; 6] =
        ["<n/>", "\n\t<n><m>2</m></n>", "words", "<n>1</n>\n", " <n/> <o y='2'/> ", "<!-- n -->"];

    #[test]
    fn what_is_inserted_anywhere_is_found_as_by_a_scan() {
        let mut count = 0;
        let places: Vec<usize> = (0..=TEXT.len()).filter(|&at| TEXT.is_char_boundary(at)).collect();
        for &at in &places {
            for text in TEXTS {
                count += usize::from(spliced(TEXT, &[(at, text)]));
                for &other in places.iter().filter(|&&other| other >= at) {
                    count += usize::from(spliced(TEXT, &[(at, text), (other, "\n<p><q/></p>")]));
                }
            }
        }
        assert!(count > 1000, "{count}");
    }

    #[test]
    fn what_takes_the_place_of_anything_is_found_as_by_a_scan() {
        let mut count = 0;
        let places: Vec<usize> = (0..=TEXT.len()).filter(|&at| TEXT.is_char_boundary(at)).collect();
        let last = TEXT.find("/f>").unwrap() - 3;
        for &at in &places {
            for &end in places.iter().filter(|&&end| end >= at) {
                for text in ["", "<n/>", "words", "]]>", "a < b", "<d/>"] {
                    count += usize::from(replaced(TEXT, &[(at..end, text)]));
                    if end < last {
                        count += usize::from(replaced(TEXT, &[(at..end, text), (last..last + 1, "23")]));
                    }
                }
            }
        }
        assert!(count > 200, "{count}");
    }

    #[test]
    fn numbers_that_give_way_to_numbers_take_no_scan() {
        let text = "<s><a>0.032</a>\n<b> 1 2 3 </b><t/><c>5</c></s>";
        let at = |number: &str| text.find(number).unwrap();
        let of = |number: &str| at(number)..at(number) + number.len();
        let (shorter, last) = ((of("0.032"), "1"), (of("5"), "6"));
        assert!(replaced(text, &[shorter.clone(), (of("1 2 3"), "0.12345 7 8"), last.clone()]));
        // Beside a new element, too.
        assert!(replaced(text, &[shorter, (at("<t/>")..at("<t/>"), "<n>1</n>"), last]));
    }

    #[test]
    fn the_usual_insertions_take_no_scan() {
        let text = "<s><objects>\n <a/>\n</objects><t/></s>";
        let end = text.find("\n</objects>").unwrap();
        assert!(spliced(text, &[(end, "\n <b><c>1</c></b>")]));
        assert!(spliced(text, &[(end + 1, " <b/>\n"), (text.len() - 4, "<u/>")]));
    }

    #[test]
    fn an_empty_tag_gives_way_to_elements() {
        let text = "<a><b>\n <objects /><c/></b><objects/></a>";
        let tree = Tree::scan(text).unwrap();
        let new = "<a><b>\n <objects><d/><e>1</e></objects><c/></b><objects n='1'>2</objects>\n<f/></a>";
        let first = text.find("<objects />").unwrap();
        let second = text.find("/></a>").unwrap();
        let last = text.len() - "</a>".len();
        let edits = [
            (first..first + 11, "<objects><d/><e>1</e></objects>".len()),
            (second..second + 2, " n='1'>2</objects>".len()),
            (last..last, "\n<f/>".len()),
        ];
        let (pieces, elements) = Splice::of(&tree, new, &edits).unwrap();
        let scanned = Tree::scan(new).unwrap();
        assert_eq!(
            (pieces.as_slice(), elements.as_slice()),
            (scanned.stored_pieces(), scanned.stored_elements())
        );
        // Words, nothing, or words beside an element: a whole scan.
        for words in ["words", "", "<d/>words"] {
            let new = text.replace("<objects />", words);
            let edits = [(first..first + 11, words.len())];
            assert!(Splice::of(&tree, &new, &edits).is_none());
            assert_eq!(tree.edited(new.as_str(), &edits).unwrap().bytes(), new.as_bytes());
        }
    }

    #[test]
    fn what_is_not_well_formed_stays_refused() {
        for text in ["<n>", "</a>", "<n></m>", "a < b", "<n x='1' x='2'/>", "&", "]]>"] {
            spliced(TEXT, &[(TEXT.find("<d/>").unwrap(), text)]);
        }
        let tree = Tree::scan("<a>12</a>").unwrap();
        // Something gave way, or the edit is wrongly described: a whole scan.
        assert_eq!(tree.edited("<a>3</a>", &[(3..5, 1)]).unwrap().bytes(), b"<a>3</a>");
        assert_eq!(tree.edited("<a>123</a>", &[(5..5, 9)]).unwrap().bytes(), b"<a>123</a>");
        assert_eq!(tree.edited("<a>12</a>", &[(5..5, usize::MAX)]).unwrap().bytes(), b"<a>12</a>");
        assert!(tree.edited("<a>12\0</a>", &[(5..5, 1)]).is_err());
    }
}
