//! Elements that are to be written.

/// An element with its text or its children.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Node {
    tag: String,
    name: Option<String>,
    content: Content,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Content {
    Text(String),
    Children(Vec<Node>),
}

impl Node {
    /// `<tag>text</tag>`; the text is written as it is.
    pub(crate) fn leaf(tag: impl Into<String>, text: impl Into<String>) -> Self {
        Self { tag: tag.into(), name: None, content: Content::Text(text.into()) }
    }

    /// An element with children.
    pub(crate) fn parent(tag: impl Into<String>, children: Vec<Self>) -> Self {
        Self { tag: tag.into(), name: None, content: Content::Children(children) }
    }

    /// An object with a name and children.
    pub(crate) fn object(tag: impl Into<String>, name: &str, children: Vec<Self>) -> Self {
        Self { name: Some(escaped(name)), ..Self::parent(tag, children) }
    }

    pub(crate) fn tag(&self) -> &str {
        &self.tag
    }

    /// The element with `space` (line end and indentation) before it; its children are indented by `unit` more. Without a line
    /// end in `space`, all is on one line.
    pub(crate) fn text(&self, space: &str, unit: &str) -> String {
        let mut text = String::new();
        self.write(&mut text, space, unit);
        text
    }

    fn write(&self, text: &mut String, space: &str, unit: &str) {
        text.push_str(space);
        text.push('<');
        text.push_str(&self.tag);
        if let Some(name) = &self.name {
            text.extend([" name=\"", name, "\""]);
        }
        text.push('>');
        match &self.content {
            Content::Text(own) => text.push_str(own),
            Content::Children(children) => {
                let deeper = if space.is_empty() { String::new() } else { format!("{space}{unit}") };
                children.iter().for_each(|child| child.write(text, &deeper, unit));
                text.push_str(space);
            }
        }
        text.extend(["</", &self.tag, ">"]);
    }
}

/// A name as the value of an attribute.
pub(crate) fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn foot() -> Node {
        Node::object("ContactSphere", "heel & \"toe\"", vec![Node::leaf("radius", "0.03")])
    }

    #[test]
    fn children_stand_one_step_further_in() {
        assert_eq!(
            foot().text("\r\n\t", "\t"),
            "\r\n\t<ContactSphere name=\"heel &amp; &quot;toe&quot;\">\r\n\t\t<radius>0.03</radius>\r\n\t</ContactSphere>"
        );
    }

    #[test]
    fn without_line_ends_all_is_one_line() {
        assert!(!foot().text("", "\t").contains('\n'));
    }
}
