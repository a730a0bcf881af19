//! Makes new elements and inserts them with the indentation of their siblings and the line ends of the file.

use std::ops::Range;

use osim_model::{ElementId, PieceKind, Tree};

use crate::edit::Edit;

/// A new element, which has either a text or children.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct NewElement {
    tag: String,
    name: Option<String>,
    content: ElementContent,
}

/// The content of a new XML element.
#[derive(Debug, Clone, PartialEq, Eq)]
enum ElementContent {
    Text(String),
    Children(Vec<NewElement>),
}

impl NewElement {
    /// `<tag>text</tag>`; `text` is not escaped.
    pub(crate) fn leaf(tag: impl Into<String>, text: impl Into<String>) -> Self {
        Self { tag: tag.into(), name: None, content: ElementContent::Text(text.into()) }
    }

    /// An element with children.
    pub(crate) fn parent(tag: impl Into<String>, children: Vec<Self>) -> Self {
        Self { tag: tag.into(), name: None, content: ElementContent::Children(children) }
    }

    /// An element with a name and children.
    pub(crate) fn object(tag: impl Into<String>, name: &str, children: Vec<Self>) -> Self {
        Self { name: Some(escaped_attribute(name)), ..Self::parent(tag, children) }
    }

    /// The element with `space` (line end and indentation) before it; its children are indented by `unit` more. Without a line
    /// end in `space`, all is on one line.
    pub(crate) fn text(&self, space: &str, unit: &str) -> String {
        let mut text = String::new();
        self.write(&mut text, space, unit);
        text
    }

    /// Writes the element and its children at the end of `text`.
    fn write(&self, text: &mut String, space: &str, unit: &str) {
        text.push_str(space);
        text.push('<');
        text.push_str(&self.tag);
        if let Some(name) = &self.name {
            text.extend([" name=\"", name, "\""]);
        }
        text.push('>');
        match &self.content {
            ElementContent::Text(own) => text.push_str(own),
            ElementContent::Children(children) => {
                let deeper = if space.is_empty() { String::new() } else { format!("{space}{unit}") };
                children.iter().for_each(|child| child.write(text, &deeper, unit));
                text.push_str(space);
            }
        }
        text.extend(["</", &self.tag, ">"]);
    }
}

pub(crate) fn escaped_attribute(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Inserts `nodes` into `parent`, whose children OpenSim writes in `order`.
pub(crate) fn insert(tree: &Tree, parent: ElementId, order: &[&str], nodes: &[NewElement]) -> Vec<Edit> {
    let rank = |tag: &str| order.iter().position(|known| *known == tag);
    let mut nodes: Vec<&NewElement> = nodes.iter().collect();
    nodes.sort_by_key(|node| rank(&node.tag));
    if let Some(layout) = EmptyElement::read(tree, parent) {
        return vec![layout.fill(&nodes)];
    }
    let unit = indentation_unit(tree, parent);
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
            let comment = tree.content(parent).rfind(|piece| piece.kind == PieceKind::Comment);
            let span = comment.map_or_else(|| tree.open_span(parent), |piece| piece.span);
            return (span.end, white_space_before(tree, span.start));
        }
        // Nothing that comes before: put it first.
        let first = tree.open_span(parent).end;
        let next = end_of_leading_text(tree, parent, first);
        (first, white_space_before(tree, next))
    };
    nodes
        .iter()
        .map(|node| {
            let (at, space) = place(&node.tag);
            Edit { span: at..at, text: node.text(&space, unit) }
        })
        .collect()
}

/// Inserts `nodes` after the last content of `parent`. If the nodes and the white space before each are removed later, the
/// original text is left. `None` if `parent` has no content at all, not even white space: use [`fill`] then.
pub(crate) fn append(tree: &Tree, parent: ElementId, nodes: &[NewElement]) -> Option<Edit> {
    if tree.is_empty_tag(parent) || tree.content(parent).next().is_none() {
        return None;
    }
    let last = tree.content(parent).rfind(|piece| piece.kind != PieceKind::Text || !is_white(piece.text));
    let (at, space) = match last {
        Some(last) => {
            let first = tree.children(parent).last().map_or(last.span.start, |child| tree.span(child).start);
            // White space before what is inserted would be taken for its own.
            let behind = last.span.end - (last.text.len() - last.text.trim_ascii_end().len());
            (behind, white_space_before(tree, first))
        }
        None => {
            let inner = EmptyElement::read(tree, parent).map(|layout| layout.inner).unwrap_or_default();
            (tree.open_span(parent).end, inner)
        }
    };
    let unit = indentation_unit(tree, parent);
    Some(Edit { span: at..at, text: nodes.iter().map(|node| node.text(&space, unit)).collect() })
}

/// Puts `nodes` into `parent`, which has no content.
pub(crate) fn fill(tree: &Tree, parent: ElementId, nodes: &[NewElement]) -> Option<Edit> {
    EmptyElement::read(tree, parent).map(|layout| layout.fill(&nodes.iter().collect::<Vec<_>>()))
}

fn is_white(text: &str) -> bool {
    text.trim_ascii().is_empty()
}

/// The white space by which the children of `parent` are indented more than `parent`; a tab if the file does not show it.
pub(crate) fn indentation_unit(tree: &Tree, parent: ElementId) -> &str {
    let of = |element| indentation_of(tree, tree.span(element).start);
    let child = tree.children(parent).next();
    let by_child = child.and_then(|child| of(child).strip_prefix(of(parent)));
    let by_parent = || of(parent).strip_prefix(of(tree.parent(parent)?));
    by_child
        .filter(|unit| !unit.is_empty())
        .or_else(by_parent)
        .filter(|unit| !unit.is_empty())
        .unwrap_or("\t")
}

/// Blanks and tabs between the start of the line and byte `at`; empty if other text is there.
fn indentation_of(tree: &Tree, at: usize) -> &str {
    let before = tree.slice(0..at);
    before[before.trim_ascii_end().len()..].rsplit('\n').next().unwrap_or_default()
}

/// Inserts `comment` as the first child of `parent`.
pub(crate) fn insert_first_comment(tree: &Tree, parent: ElementId, comment: &str) -> Edit {
    let at = tree.open_span(parent).end;
    let next = end_of_leading_text(tree, parent, at);
    Edit { span: at..at, text: format!("{}{comment}", white_space_before(tree, next)) }
}

/// The end of the text before the first element or comment of `parent`; `start` if there is no such text.
fn end_of_leading_text(tree: &Tree, parent: ElementId, start: usize) -> usize {
    match tree.content(parent).next() {
        Some(piece) if piece.kind == PieceKind::Text => piece.span.end,
        _ => start,
    }
}

/// The edit that removes the bytes `span`, and the line end and indentation before them.
pub(crate) fn removal_edit(tree: &Tree, span: Range<usize>) -> Edit {
    let start = span.start - white_space_before(tree, span.start).len();
    Edit { span: start..span.end, text: String::new() }
}

/// Line end and indentation before byte `at`; empty if other text is on that line.
pub(crate) fn white_space_before(tree: &Tree, at: usize) -> String {
    let before = tree.slice(0..at);
    let space = &before[before.trim_ascii_end().len()..];
    match space.rfind('\n') {
        // One line end only, also with blank lines between elements.
        Some(newline) => {
            let start = if space[..newline].ends_with('\r') { newline - 1 } else { newline };
            space[start..].to_owned()
        }
        None => String::new(),
    }
}

/// An element without content, and the white space for its children.
struct EmptyElement<'t> {
    name: &'t str,
    /// Bytes from the end of the start tag (or from its `/>`) to the end of the element.
    span: Range<usize>,
    /// `>` if a `/>` is replaced, else empty.
    closes_tag: &'static str,
    outer: String,
    inner: String,
    unit: String,
}

impl<'t> EmptyElement<'t> {
    /// The element `parent`, if it has no content.
    fn read(tree: &'t Tree, parent: ElementId) -> Option<Self> {
        if !tree.content(parent).all(|piece| is_white(piece.text)) {
            return None;
        }
        let outer = white_space_before(tree, tree.span(parent).start);
        let unit = indentation_unit(tree, parent).to_owned();
        let inner = if outer.is_empty() { String::new() } else { format!("{outer}{unit}") };
        let (start, closes_tag) = match tree.is_empty_tag(parent) {
            true => (end_of_empty_tag(tree, parent).start, ">"),
            false => (tree.open_span(parent).end, ""),
        };
        let (name, span) = (tree.name(parent), start..tree.span(parent).end);
        Some(Self { name, span, closes_tag, outer, inner, unit })
    }

    /// Puts `nodes` into the element.
    fn fill(&self, nodes: &[&NewElement]) -> Edit {
        let text: String = nodes.iter().map(|node| node.text(&self.inner, &self.unit)).collect();
        let text = format!("{}{text}{}</{}>", self.closes_tag, self.outer, self.name);
        Edit { span: self.span.clone(), text }
    }
}

/// How an element without content was written, so that it can be restored when inserted children are removed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EmptyForm {
    /// An element written as `<objects/>`. White space in the tag other than a single blank stays in the start tag.
    Closed,
    /// An element written as `<objects />`.
    ClosedWithBlank,
    /// An element written as `<objects></objects>`.
    Open,
}

impl EmptyForm {
    /// How `element`, which has no content, is written.
    pub(crate) fn of(tree: &Tree, element: ElementId) -> Self {
        match tree.is_empty_tag(element) {
            false => Self::Open,
            true if end_of_empty_tag(tree, element).len() == " />".len() => Self::ClosedWithBlank,
            true => Self::Closed,
        }
    }

    /// The edit that removes all content of `element`. Its attributes stay.
    pub(crate) fn restored(self, tree: &Tree, element: ElementId) -> Edit {
        let (open, end) = (tree.open_span(element).end, tree.span(element).end);
        match self {
            Self::Open => Edit { span: open..tree.close_span(element).start, text: String::new() },
            Self::Closed => Edit { span: open - ">".len()..end, text: "/>".to_owned() },
            Self::ClosedWithBlank => Edit { span: open - ">".len()..end, text: " />".to_owned() },
        }
    }
}

/// The bytes of `/>` in `<tag/>`, with a single blank before it. Other white space stays in the tag when the element is opened,
/// because the letters of a note cannot record it.
pub(crate) fn end_of_empty_tag(tree: &Tree, element: ElementId) -> Range<usize> {
    let span = tree.span(element);
    let kept = tree.slice(span.clone()).strip_suffix("/>").unwrap_or_default();
    let single = kept.strip_suffix(' ').filter(|rest| rest.trim_ascii_end().len() == rest.len());
    span.start + single.unwrap_or(kept).len()..span.end
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::splice;

    fn foot_node() -> NewElement {
        NewElement::object("ContactSphere", "heel & \"toe\"", vec![NewElement::leaf("radius", "0.03")])
    }

    #[test]
    fn children_are_indented_by_one_unit() {
        assert_eq!(
            foot_node().text("\r\n\t", "\t"),
            "\r\n\t<ContactSphere name=\"heel &amp; &quot;toe&quot;\">\r\n\t\t<radius>0.03</radius>\r\n\t</ContactSphere>"
        );
    }

    #[test]
    fn without_line_ends_an_element_is_on_one_line() {
        assert!(!foot_node().text("", "\t").contains('\n'));
    }

    const ORDER: [&str; 4] = ["a", "b", "c", "d"];

    #[track_caller]
    fn assert_inserted(tags: &[&str], into: &str, expected: &str) {
        let tree = Tree::scan(into).unwrap();
        let elements: Vec<_> = tags.iter().map(|tag| NewElement::leaf(*tag, "1")).collect();
        let parent = tree.children(ElementId::ROOT).next().unwrap_or(ElementId::ROOT);
        let edits = insert(&tree, parent, &ORDER, &elements);
        assert_eq!(String::from_utf8(splice(into.as_bytes(), &edits).unwrap()).unwrap(), expected);
    }

    #[test]
    fn an_element_is_inserted_after_the_last_sibling_before_it_in_order() {
        assert_inserted(
            &["c", "b"],
            "<r>\n\t<x>\n\t\t<a>0</a>\n\t\t<!--about d-->\n\t\t<d>0</d>\n\t</x>\n</r>",
            "<r>\n\t<x>\n\t\t<a>0</a>\n\t\t<b>1</b>\n\t\t<c>1</c>\n\t\t<!--about d-->\n\t\t<d>0</d>\n\t</x>\n</r>",
        );
    }

    #[test]
    fn an_inserted_element_has_the_line_ends_of_the_file() {
        assert_inserted(
            &["b"],
            "<r>\r\n <x>\r\n  <a>0</a>\r\n </x>\r\n</r>",
            "<r>\r\n <x>\r\n  <a>0</a>\r\n  <b>1</b>\r\n </x>\r\n</r>",
        );
    }

    #[test]
    fn an_element_is_inserted_first_where_none_comes_before() {
        assert_inserted(
            &["a"],
            "<r>\n <x>\n  <d>0</d>\n </x>\n</r>",
            "<r>\n <x>\n  <a>1</a>\n  <d>0</d>\n </x>\n</r>",
        );
        assert_inserted(&["a"], "<r><x><d>0</d></x></r>", "<r><x><a>1</a><d>0</d></x></r>");
    }

    #[test]
    fn an_element_is_inserted_into_elements_without_content() {
        assert_inserted(
            &["b", "a"],
            "<r>\n  <x n='1' />\n</r>",
            "<r>\n  <x n='1'>\n    <a>1</a>\n    <b>1</b>\n  </x>\n</r>",
        );
        assert_inserted(&["a"], "<r>\n  <x>\n  </x>\n</r>", "<r>\n  <x>\n    <a>1</a>\n  </x>\n</r>");
        assert_inserted(&["a"], "<r><x/></r>", "<r><x><a>1</a></x></r>");
    }

    #[test]
    fn an_element_is_inserted_after_a_lonely_comment() {
        assert_inserted(
            &["a"],
            "<r>\n <x>\n  <!--all default-->\n </x>\n</r>",
            "<r>\n <x>\n  <!--all default-->\n  <a>1</a>\n </x>\n</r>",
        );
    }

    #[test]
    fn an_empty_element_is_restored_to_its_original_form() {
        for (tag, opened) in [
            ("<a/>", "<a>x</a>"),
            ("<a />", "<a>x</a>"),
            ("<a  />", "<a  >x</a>"),
            ("<a\n/>", "<a\n>x</a>"),
            ("<a b='1' />", "<a b='1'>x</a>"),
            ("<a b='1'></a>", "<a b='1'>x</a>"),
        ] {
            let tree = Tree::scan(tag).unwrap();
            let form = EmptyForm::of(&tree, ElementId::ROOT);
            let mut seen = tag.to_owned();
            match form {
                EmptyForm::Open => seen.insert(tree.open_span(ElementId::ROOT).end, 'x'),
                _ => seen.replace_range(end_of_empty_tag(&tree, ElementId::ROOT), ">x</a>"),
            }
            assert_eq!(seen, opened);
            let Edit { span, text } = form.restored(&Tree::scan(opened).unwrap(), ElementId::ROOT);
            seen.replace_range(span, &text);
            assert_eq!(seen, tag);
        }
    }
}
