//! One OpenSim file: its bytes, its elements, its version, its data root and its `<defaults>`.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::OnceLock;

use foldhash::{HashMap, HashMapExt};

use crate::model::{Class, Fault, FaultKind, Property, Result, Value, ValueOrigin};
use crate::xml::opensim_text::{NumberFault, flag, number, trimmed, triple};
use crate::xml::{ElementId, LineIndex, SyntaxError, TextPosition, Tree};

/// Sets of a model that OpenSim also reads from separate files.
const FILE_SETS: &str = "BodySet ComponentSet ConstraintSet ContactGeometrySet ControllerSet ForceSet JointSet \
    MarkerSet ProbeSet";
/// Sets of parameters inside a contact force that OpenSim also reads from separate files.
const PARAMETER_FILE_SETS: [&str; 2] =
    ["HuntCrossleyForce::ContactParametersSet", "ElasticFoundationForce::ContactParametersSet"];

/// An OpenSim document that was scanned, with its bytes.
///
/// ```
/// let text = r#"<OpenSimDocument Version="40000"><Model name="walker"/></OpenSimDocument>"#;
/// let document = osim_model::Document::parse(text)?;
/// assert_eq!(document.version(), 40000);
/// assert_eq!(document.tree().name(document.data_root()), "Model");
/// assert_eq!(document.bytes(), text.as_bytes());
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone)]
pub struct Document {
    tree: Tree,
    version: u32,
    data_root: ElementId,
    defaults: Option<ElementId>,
    /// The first object of each class in `<defaults>`.
    by_class: HashMap<String, DefaultObject>,
    may_include: OnceLock<bool>,
    /// Found when they are first asked for.
    sockets: OnceLock<Vec<ElementId>>,
    /// Finds lines of byte offsets. Built when a line is first asked for.
    lines: OnceLock<LineIndex>,
}

impl Document {
    /// Scans `bytes` and finds the version, the data root and the defaults.
    ///
    /// # Errors
    /// The bytes are not one well-formed XML document or not an OpenSim document. The error has the place.
    pub fn parse(bytes: impl Into<Vec<u8>>) -> Result<Self> {
        let tree = Tree::scan(bytes)?;
        let (version, data_root) =
            version_and_data_root(&tree).map_err(|fault| fault.located(tree.bytes()))?;
        let defaults = tree.child(data_root, "defaults");
        let by_class = defaults.map(|defaults| defaults_by_class(&tree, defaults)).unwrap_or_default();
        Ok(Self {
            tree,
            version,
            data_root,
            defaults,
            by_class,
            may_include: OnceLock::new(),
            sockets: OnceLock::new(),
            lines: OnceLock::new(),
        })
    }

    /// Marks the document as one that includes no other file by `file="…"`.
    pub(crate) fn known_to_include_nothing(self) -> Self {
        Self { may_include: OnceLock::from(false), ..self }
    }

    /// Bytes of the file as it was read.
    pub fn bytes(&self) -> &[u8] {
        self.tree.bytes()
    }

    /// Takes the bytes of the file, without a copy.
    pub fn into_bytes(self) -> Vec<u8> {
        self.tree.into_bytes()
    }

    /// The XML elements of the file, with the bytes of each.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The attribute `Version` of the document, for example 40000.
    pub fn version(&self) -> u32 {
        self.version
    }

    /// The element that contains all objects: `Model`, `ForceSet` or `ContactGeometrySet`.
    pub fn data_root(&self) -> ElementId {
        self.data_root
    }

    /// Whether the document is a whole model, not a set in a separate file.
    pub fn is_model(&self) -> bool {
        self.tree.name(self.data_root()) == "Model"
    }

    pub fn defaults(&self) -> Option<ElementId> {
        self.defaults
    }

    /// The elements outside `<defaults>` whose names begin with `socket_`, in file order.
    pub fn sockets(&self) -> &[ElementId] {
        self.sockets.get_or_init(|| {
            let mut sockets = Vec::new();
            self.tree.walk(self.data_root, |element| {
                let tag = self.tree.name(element);
                sockets.extend(tag.starts_with("socket_").then_some(element));
                tag != "defaults"
            });
            sockets
        })
    }

    /// Line and column (from 1) of the byte `offset` (from 0).
    pub fn position(&self, offset: usize) -> TextPosition {
        self.lines.get_or_init(|| LineIndex::new(self.bytes())).position(self.bytes(), offset)
    }

    /// Line and column of the start tag of `element`.
    pub fn position_of(&self, element: ElementId) -> TextPosition {
        self.position(self.tree.span(element).start)
    }

    /// The effective value of `property` of `object`, from the element `tag`: the object's own element, else `<defaults>`, else the default
    /// of the class.
    pub(crate) fn value(&self, object: ElementId, class: Class, property: Property, tag: &str) -> Value {
        let inherited = || self.inherited_value(object, class, property, tag);
        match self.tree.child(object, tag) {
            Some(element) => self.value_of_element(element, property, || inherited().number),
            None => inherited(),
        }
    }

    fn value_of_element(
        &self,
        element: ElementId,
        property: Property,
        fallback: impl FnOnce() -> f64,
    ) -> Value {
        let raw = self.tree.raw_text(element);
        let (number, fault) = match number(&raw) {
            Ok(number) => (number, None),
            Err(NumberFault::Prefix { opensim_reads }) => {
                (opensim_reads, Some(NumberFault::Prefix { opensim_reads }))
            }
            Err(fault) => (fallback(), Some(fault)),
        };
        let span = if raw.span.is_empty() { self.tree.span(element) } else { raw.span };
        let offset = span.start;

        // A blank that is not ASCII looks like one and does not count as one: show it.
        let text =
            if raw.text.is_ascii() { raw.text.into_owned() } else { raw.text.escape_default().to_string() };
        Value { property, number, origin: ValueOrigin::Element, span: Some(span), fault, text, offset }
    }

    /// Where the text of `element` is; the whole element if it has none.
    pub(crate) fn span_of_value(&self, element: ElementId) -> Range<usize> {
        let text = self.tree.raw_text(element).span;
        if text.is_empty() { self.tree.span(element) } else { text }
    }

    fn inherited_value(&self, object: ElementId, class: Class, property: Property, tag: &str) -> Value {
        let offset = self.tree.span(object).start;
        match self.default_property(class.as_str(), tag) {
            Some(element) => Value {
                origin: ValueOrigin::Defaults,
                span: None,
                offset,
                ..self.value_of_element(element, property, || class.default(property))
            },
            None => Value {
                property,
                number: class.default(property),
                origin: ValueOrigin::ClassDefault,
                span: None,
                fault: None,
                text: String::new(),
                offset,
            },
        }
    }

    fn may_include(&self) -> bool {
        *self.may_include.get_or_init(|| may_include(self.bytes()))
    }

    /// The elements whose contents are in another file, with the name of that file as written: `<ForceSet file="x.xml"/>`.
    pub fn included_files(&self) -> Vec<(ElementId, String)> {
        if !self.may_include() {
            return Vec::new();
        }
        let elements = self.tree.elements();
        elements.filter_map(|id| Some((id, self.file_of(id)?.into_owned()))).collect()
    }

    /// The name of the file from which OpenSim reads the contents of the element `id`. OpenSim does so for sets that are a property of
    /// their object (the first of each), and for members of `<components>` and `<frames>`. Elsewhere it ignores `file`.
    pub(crate) fn file_of(&self, id: ElementId) -> Option<Cow<'_, str>> {
        if !self.may_include() {
            return None;
        }
        let file = self.tree.attribute(id, "file").filter(|file| !file.is_empty())?;
        let (parent, tag) = (self.tree.parent(id)?, self.tree.name(id));
        let is_set = match self.tree.name(parent) {
            "components" | "frames" => return Some(file),
            "Model" => FILE_SETS.split(' ').any(|set| set == tag),
            _ => PARAMETER_FILE_SETS.contains(&tag),
        };
        (is_set && self.tree.child(parent, tag) == Some(id)).then_some(file)
    }

    /// The element of the property `tag` of `class` in `<defaults>`, if there is one.
    pub fn default_property(&self, class: &str, tag: &str) -> Option<ElementId> {
        self.by_class.get(class)?.properties.get(tag).copied()
    }

    /// The element of a property: the object's own element, else the element in `<defaults>`.
    pub(crate) fn property_element(&self, object: ElementId, tag: &str) -> Option<ElementId> {
        self.tree.child(object, tag).or_else(|| self.default_property(self.tree.name(object), tag))
    }

    /// The element of a property of the object's class in `<defaults>`, if there is one.
    pub fn inherited_element(&self, object: ElementId, tag: &str) -> Option<ElementId> {
        self.default_property(self.tree.name(object), tag)
    }

    /// The object in `<defaults>` that has the class of `object`, if there is one.
    pub fn defaults_of(&self, object: ElementId) -> Option<ElementId> {
        self.by_class.get(self.tree.name(object)).map(|default| default.element)
    }

    /// The whole text of a list or path.
    ///
    /// # Errors
    /// Another element or comment interrupts the text; OpenSim refuses such a text.
    pub(crate) fn whole_text(&self, element: ElementId) -> Result<Cow<'_, str>> {
        self.tree.whole_text(element).ok_or_else(|| {
            let property = self.tree.name(element).to_owned();
            Fault::at_span(FaultKind::BrokenText { property }, self.tree.span(element))
        })
    }

    /// The flag `tag` of `object` as OpenSim reads it, else the flag in `<defaults>`; `None` if neither is a flag.
    pub fn flag(&self, object: ElementId, tag: &str) -> Result<Option<bool>> {
        self.first_readable(object, tag, |element| Ok(flag(&self.whole_text(element)?)))
    }

    /// The three numbers of `tag`, such as a location, as OpenSim reads them: those of `object`, else those in `<defaults>`; `None` if
    /// neither can be read. The numbers may be infinite or NaN.
    pub fn triple(&self, object: ElementId, tag: &str) -> Option<[f64; 3]> {
        self.whole_triple(object, tag).ok()?
    }

    pub(crate) fn whole_triple(&self, object: ElementId, tag: &str) -> Result<Option<[f64; 3]>> {
        self.first_readable(object, tag, |element| Ok(triple(&self.whole_text(element)?)))
    }

    /// The result of `read` for the property `tag` of `object`; if there is none, for the property in `<defaults>`.
    fn first_readable<T>(
        &self,
        object: ElementId,
        tag: &str,
        read: impl Fn(ElementId) -> Result<Option<T>>,
    ) -> Result<Option<T>> {
        let own_value = self.tree.child(object, tag).map(&read).transpose()?.flatten();
        if own_value.is_some() {
            return Ok(own_value);
        }
        let inherited = self.default_property(self.tree.name(object), tag);
        Ok(inherited.map(read).transpose()?.flatten())
    }
}

/// An object in `<defaults>`, with the first element of each of its properties. Kept, because every object of its class uses them.
#[derive(Debug, Clone)]
struct DefaultObject {
    element: ElementId,
    properties: HashMap<String, ElementId>,
}

fn defaults_by_class(tree: &Tree, defaults: ElementId) -> HashMap<String, DefaultObject> {
    let mut by_class = HashMap::new();
    for element in tree.children(defaults) {
        by_class.entry(tree.name(element).to_owned()).or_insert_with(|| {
            let mut properties = HashMap::new();
            for property in tree.children(element) {
                properties.entry(tree.name(property).to_owned()).or_insert(property);
            }
            DefaultObject { element, properties }
        });
    }
    by_class
}

impl From<SyntaxError> for Fault {
    fn from(error: SyntaxError) -> Self {
        let bytes = error.bytes();
        Self::at(FaultKind::Syntax(error.fault.clone()), error.offset).located(bytes)
    }
}

fn version_and_data_root(tree: &Tree) -> Result<(u32, ElementId)> {
    let root = ElementId::ROOT;
    if tree.name(root) != "OpenSimDocument" {
        let kind = FaultKind::NotOpenSim { root: tree.name(root).to_owned() };
        return Err(Fault::at_span(kind, tree.open_span(root)));
    }
    let version_text = trimmed(&tree.attribute(root, "Version").unwrap_or_default()).to_owned();
    let Ok(version) = version_text.parse::<u32>() else {
        return Err(Fault::at_span(FaultKind::NoVersion { found: version_text }, tree.open_span(root)));
    };
    match tree.children(root).next() {
        Some(data_root) => Ok((version, data_root)),
        None => {
            let kind = FaultKind::WrongDataRoot { tag: "(nothing)".to_owned() };
            Err(Fault::at_span(kind, tree.open_span(root)))
        }
    }
}

/// Whether `bytes` may contain `file="…"`: a quick test, which is never `false` if they do.
///
/// Most models include no file; the test spares them a scan.
pub(crate) fn may_include(bytes: &[u8]) -> bool {
    memchr::memchr_iter(b'=', bytes).any(|at| {
        let name = bytes.get(..at).unwrap_or_default().trim_ascii_end();
        name.strip_suffix(b"file").and_then(<[u8]>::last).is_some_and(u8::is_ascii_whitespace)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "<OpenSimDocument Version='40000'><Model name='m'><defaults><ContactSphere name='default'>\
    <radius>0.5</radius></ContactSphere></defaults><ContactSphere name='own'><radius> 0.1 </radius>\
    <radius>0.2</radius></ContactSphere><ContactSphere name='none'/></Model></OpenSimDocument>";

    #[test]
    fn the_first_element_counts_then_defaults_then_the_class() {
        let document = Document::parse(TEXT).unwrap();
        let spheres: Vec<_> = document.tree().children(document.data_root()).skip(1).collect();
        let radius = |id| document.value(id, Class::ContactSphere, Property::Radius, "radius");
        assert_eq!((radius(spheres[0]).number, radius(spheres[0]).origin), (0.1, ValueOrigin::Element));
        assert_eq!(&TEXT[radius(spheres[0]).span.unwrap()], "0.1");
        assert_eq!((radius(spheres[1]).number, radius(spheres[1]).origin), (0.5, ValueOrigin::Defaults));
        assert_eq!(radius(spheres[1]).span, None);
    }

    #[test]
    fn other_documents_are_named_for_what_they_are() {
        for (text, code) in [
            ("<html/>", "not-opensim"),
            ("<OpenSimDocument><Model/></OpenSimDocument>", "not-opensim"),
            ("<OpenSimDocument Version='x'><Model/></OpenSimDocument>", "not-opensim"),
            ("<OpenSimDocument Version='40000'/>", "not-opensim"),
        ] {
            assert_eq!(Document::parse(text.as_bytes()).unwrap_err().code(), code);
        }
    }
}
