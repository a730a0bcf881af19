//! Where an absent element goes, with the indentation of its siblings and the line ends of the file.

use std::ops::Range;

use osim_model::{ElementId, PieceKind, Tree};

use crate::edit::Edit;

/// Inserts `<tag>text</tag>` for each of `elements` into `parent`, whose children OpenSim writes in `order`.
pub(crate) fn insert(
    tree: &Tree,
    parent: ElementId,
    order: &[&str],
    elements: &[(&str, String)],
) -> Vec<Edit> {
    let rank = |tag: &str| order.iter().position(|known| *known == tag);
    let mut elements: Vec<_> = elements.iter().collect();
    elements.sort_by_key(|(tag, _)| rank(tag));
    if let Some(layout) = Layout::of_empty(tree, parent) {
        return vec![layout.fill(&elements)];
    }
    let children: Vec<ElementId> = tree.children(parent).collect();
    let place = |tag: &str| -> (usize, String) {
        let wanted = rank(tag);
        let before =
            children.iter().rfind(|&&child| rank(tree.name(child)).is_some_and(|r| Some(r) < wanted));
        if let Some(&before) = before {
            return (tree.span(before).end, white_space_before(tree, tree.span(before).start));
        }
        if children.is_empty() {
            // Only comments in it: OpenSim's "All properties of this object have their default values."
            let comment = comments(tree, parent).next_back();
            let span = comment.unwrap_or_else(|| tree.open_span(parent));
            return (span.end, white_space_before(tree, span.start));
        }
        // Nothing that comes before: put it first.
        let first = tree.open_span(parent).end;
        let next = behind_text(tree, parent, first);
        (first, white_space_before(tree, next))
    };
    elements
        .iter()
        .map(|(tag, text)| {
            let (at, space) = place(tag);
            Edit { span: at..at, text: format!("{space}<{tag}>{text}</{tag}>") }
        })
        .collect()
}

/// Inserts `comment` as the first child of `parent`.
pub(crate) fn insert_first(tree: &Tree, parent: ElementId, comment: &str) -> Edit {
    let at = tree.open_span(parent).end;
    let next = behind_text(tree, parent, at);
    Edit { span: at..at, text: format!("{}{comment}", white_space_before(tree, next)) }
}

/// Where the text ends with which the contents of `parent` begin; `start` where they begin with something else.
fn behind_text(tree: &Tree, parent: ElementId, start: usize) -> usize {
    match tree.content(parent).next() {
        Some(piece) if piece.kind == PieceKind::Text => piece.span.end,
        _ => start,
    }
}

/// `span` and the line end and indentation before it.
pub(crate) fn with_white_space_before(tree: &Tree, span: Range<usize>) -> Range<usize> {
    span.start - white_space_before(tree, span.start).len()..span.end
}

/// Line end and indentation before byte `at`; empty where something else stands on that line.
fn white_space_before(tree: &Tree, at: usize) -> String {
    let before = tree.slice(0..at);
    let space = &before[before.trim_ascii_end().len()..];
    match space.rfind('\n') {
        // One line end only, also where blank lines stand between elements.
        Some(newline) => {
            let start = if space[..newline].ends_with('\r') { newline - 1 } else { newline };
            space[start..].to_owned()
        }
        None => String::new(),
    }
}

/// White space without its line end.
fn indentation(space: &str) -> &str {
    space.rsplit('\n').next().unwrap_or_default()
}

fn comments(tree: &Tree, parent: ElementId) -> impl DoubleEndedIterator<Item = Range<usize>> + '_ {
    tree.content(parent).filter(|piece| piece.kind == PieceKind::Comment).map(|piece| piece.span)
}

/// An element without content, and the white space that its children get.
struct Layout<'t> {
    name: &'t str,
    /// From the end of the start tag (or its `/>`) to the end of the element.
    span: Range<usize>,
    /// `>` where a `/>` is taken away, else nothing.
    closes_tag: &'static str,
    outer: String,
    inner: String,
}

impl<'t> Layout<'t> {
    fn of_empty(tree: &'t Tree, parent: ElementId) -> Option<Self> {
        let nothing = tree.content(parent).all(|piece| piece.text.trim_ascii().is_empty());
        if !nothing {
            return None;
        }
        let outer = white_space_before(tree, tree.span(parent).start);
        let above = tree.parent(parent).map(|above| white_space_before(tree, tree.span(above).start));
        let unit = indentation(&outer)
            .strip_prefix(indentation(above.as_deref().unwrap_or_default()))
            .filter(|unit| !unit.is_empty())
            .unwrap_or("\t");
        let inner = if outer.is_empty() { String::new() } else { format!("{outer}{unit}") };
        let tag = tree.slice(tree.open_span(parent));
        let open = tree.open_span(parent);
        let (start, closes_tag) = if tree.is_empty_tag(parent) {
            let kept = tag.strip_suffix("/>").unwrap_or(tag).trim_ascii_end();
            (open.start + kept.len(), ">")
        } else {
            (open.end, "")
        };
        Some(Self { name: tree.name(parent), span: start..tree.span(parent).end, closes_tag, outer, inner })
    }

    fn fill(&self, elements: &[&(&str, String)]) -> Edit {
        let mut text = String::new();
        for (tag, value) in elements {
            text.push_str(&format!("{}<{tag}>{value}</{tag}>", self.inner));
        }
        Edit {
            span: self.span.clone(),
            text: format!("{}{text}{}</{}>", self.closes_tag, self.outer, self.name),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::splice;

    const ORDER: [&str; 4] = ["a", "b", "c", "d"];

    #[track_caller]
    fn inserting(tags: &[&str], into: &str, gives: &str) {
        let tree = Tree::scan(into).unwrap();
        let elements: Vec<_> = tags.iter().map(|tag| (*tag, "1".to_owned())).collect();
        let parent = tree.children(ElementId::ROOT).next().unwrap_or(ElementId::ROOT);
        let edits = insert(&tree, parent, &ORDER, &elements);
        assert_eq!(String::from_utf8(splice(into.as_bytes(), &edits).unwrap()).unwrap(), gives);
    }

    #[test]
    fn after_the_last_sibling_that_comes_before() {
        inserting(
            &["c", "b"],
            "<r>\n\t<x>\n\t\t<a>0</a>\n\t\t<!--about d-->\n\t\t<d>0</d>\n\t</x>\n</r>",
            "<r>\n\t<x>\n\t\t<a>0</a>\n\t\t<b>1</b>\n\t\t<c>1</c>\n\t\t<!--about d-->\n\t\t<d>0</d>\n\t</x>\n</r>",
        );
    }

    #[test]
    fn with_the_line_ends_of_the_file() {
        inserting(
            &["b"],
            "<r>\r\n <x>\r\n  <a>0</a>\r\n </x>\r\n</r>",
            "<r>\r\n <x>\r\n  <a>0</a>\r\n  <b>1</b>\r\n </x>\r\n</r>",
        );
    }

    #[test]
    fn first_where_nothing_comes_before() {
        inserting(
            &["a"],
            "<r>\n <x>\n  <d>0</d>\n </x>\n</r>",
            "<r>\n <x>\n  <a>1</a>\n  <d>0</d>\n </x>\n</r>",
        );
        inserting(&["a"], "<r><x><d>0</d></x></r>", "<r><x><a>1</a><d>0</d></x></r>");
    }

    #[test]
    fn into_elements_without_content() {
        inserting(
            &["b", "a"],
            "<r>\n  <x n='1' />\n</r>",
            "<r>\n  <x n='1'>\n    <a>1</a>\n    <b>1</b>\n  </x>\n</r>",
        );
        inserting(&["a"], "<r>\n  <x>\n  </x>\n</r>", "<r>\n  <x>\n    <a>1</a>\n  </x>\n</r>");
        inserting(&["a"], "<r><x/></r>", "<r><x><a>1</a></x></r>");
    }

    #[test]
    fn after_a_lonely_comment() {
        inserting(
            &["a"],
            "<r>\n <x>\n  <!--all default-->\n </x>\n</r>",
            "<r>\n <x>\n  <!--all default-->\n  <a>1</a>\n </x>\n</r>",
        );
    }
}
