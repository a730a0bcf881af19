//! Elements without content: how they were written, so that they are so again once what was put into them is out.

use std::ops::Range;

use osim_model::{ElementId, Tree};

use crate::edit::Edit;

/// How an element without content was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// `<objects/>`; any white space in it but a single blank stays in its start tag.
    Closed,
    /// `<objects />`
    ClosedWithBlank,
    /// `<objects></objects>`
    Open,
}

impl Form {
    /// That of `element`, which has no content.
    pub(crate) fn of(tree: &Tree, element: ElementId) -> Self {
        match tree.is_empty_tag(element) {
            false => Self::Open,
            true if end_of_empty_tag(tree, element).len() == " />".len() => Self::ClosedWithBlank,
            true => Self::Closed,
        }
    }

    /// The edit that takes out all that is in `element`. Its attributes stay.
    pub(crate) fn restored(self, tree: &Tree, element: ElementId) -> Edit {
        let (open, end) = (tree.open_span(element).end, tree.span(element).end);
        match self {
            Self::Open => Edit { span: open..tree.close_span(element).start, text: String::new() },
            Self::Closed => Edit { span: open - ">".len()..end, text: "/>".to_owned() },
            Self::ClosedWithBlank => Edit { span: open - ">".len()..end, text: " />".to_owned() },
        }
    }
}

/// Where `/>` is in `<tag/>`, with a single blank before it. Other white space is kept in the tag when it is opened, because no
/// letter of a note says what it was.
pub(crate) fn end_of_empty_tag(tree: &Tree, element: ElementId) -> Range<usize> {
    let span = tree.span(element);
    let kept = tree.slice(span.clone()).strip_suffix("/>").unwrap_or_default();
    let single = kept.strip_suffix(' ').filter(|rest| rest.trim_ascii_end().len() == rest.len());
    span.start + single.unwrap_or(kept).len()..span.end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_element_that_was_opened_is_as_it_was() {
        for (tag, opened) in [
            ("<a/>", "<a>x</a>"),
            ("<a />", "<a>x</a>"),
            ("<a  />", "<a  >x</a>"),
            ("<a\n/>", "<a\n>x</a>"),
            ("<a b='1' />", "<a b='1'>x</a>"),
            ("<a b='1'></a>", "<a b='1'>x</a>"),
        ] {
            let tree = Tree::scan(tag).unwrap();
            let form = Form::of(&tree, ElementId::ROOT);
            let mut seen = tag.to_owned();
            match form {
                Form::Open => seen.insert(tree.open_span(ElementId::ROOT).end, 'x'),
                _ => seen.replace_range(end_of_empty_tag(&tree, ElementId::ROOT), ">x</a>"),
            }
            assert_eq!(seen, opened);
            let Edit { span, text } = form.restored(&Tree::scan(opened).unwrap(), ElementId::ROOT);
            seen.replace_range(span, &text);
            assert_eq!(seen, tag);
        }
    }
}
