//! VTK's polygonal data: its points, and its polygons where they are to be seen.

use std::borrow::Cow;

use crate::xml::opensim_text::{trimmed, words};
use crate::xml::{ElementId, SyntaxFault, Tree};

use super::fault::MeshFault;
use super::numbers::{shortened, triples, within};
use super::surface::Surface;
use super::vtk_array::{Coding, binary, integers_of};

/// Where raw bytes may follow, the XML ends for a scanner.
const APPENDED: &[u8] = b"<AppendedData";

/// The points of all pieces of a .vtp file.
pub(super) fn points(bytes: &[u8]) -> Result<Vec<[f64; 3]>, MeshFault> {
    let mut all = Vec::new();
    each_piece(bytes, |_, _, _, points| {
        all.extend(points);
        within(all.len())
    })?;
    if all.is_empty() { Err(no_points()) } else { Ok(all) }
}

/// The points and polygons of all pieces. Strips and lines are left out: no bone that was seen has any.
pub(super) fn surface(bytes: &[u8]) -> Result<Surface, MeshFault> {
    let mut all = Surface::default();
    each_piece(bytes, |tree, piece, coding, points| {
        let start = all.points.len();
        all.points.extend(points);
        within(all.points.len())?;
        let Some(polygons) = tree.child(piece, "Polys") else { return Ok(()) };
        let array = |name: &str| {
            let named = |&id: &ElementId| tree.attribute(id, "Name").as_deref() == Some(name);
            tree.children(polygons).find(named).map(|array| integers(tree, array, coding)).transpose()
        };
        let corners = array("connectivity")?.unwrap_or_default();
        let mut from = 0;
        for end in array("offsets")?.unwrap_or_default() {
            all.add_face(start, corners.get(from..end).unwrap_or_default().iter().copied().map(Some))?;
            from = end;
        }
        Ok(())
    })?;
    if all.points.is_empty() { Err(no_points()) } else { Ok(all) }
}

fn no_points() -> MeshFault {
    MeshFault::NotUnderstood("it has no <Points> in a <Piece> of <PolyData>".into())
}

/// Calls `take` with each piece and its points.
fn each_piece(
    bytes: &[u8],
    mut take: impl FnMut(&Tree, ElementId, &Coding<'_>, Vec<[f64; 3]>) -> Result<(), MeshFault>,
) -> Result<(), MeshFault> {
    let (xml, appended) = split(bytes);
    let tree = Tree::scan(xml).map_err(|error| broken(&error.fault))?;
    if tree.name(ElementId::ROOT) != "VTKFile" {
        let found = tree.name(ElementId::ROOT);
        return Err(MeshFault::NotUnderstood(format!("it is a <{found}>, expected a <VTKFile>")));
    }
    let coding = Coding::of(&tree, appended);
    let whole = tree.child(ElementId::ROOT, "PolyData");
    let pieces = whole.into_iter().flat_map(|whole| tree.children(whole));
    for piece in pieces.filter(|&piece| tree.name(piece) == "Piece") {
        let array = tree.child(piece, "Points").and_then(|points| tree.child(points, "DataArray"));
        let Some(array) = array else { continue };
        let points = of_array(&tree, array, &coding)?;
        let count = tree.attribute(piece, "NumberOfPoints").unwrap_or_default();
        if count.parse() != Ok(points.len()) {
            let fault = format!("it has {} points where it says {count:?}", points.len());
            return Err(MeshFault::NotUnderstood(fault));
        }
        take(&tree, piece, &coding, points)?;
    }
    Ok(())
}

/// The XML alone, and the appended bytes after their mark.
fn split(bytes: &[u8]) -> (Vec<u8>, Option<&[u8]>) {
    let start = bytes.windows(APPENDED.len()).position(|window| window == APPENDED);
    let mark = start.and_then(|start| {
        let open = start + bytes.get(start..)?.iter().position(|&byte| byte == b'>')? + 1;
        let mark = open + bytes.get(open..)?.iter().position(|byte| !byte.is_ascii_whitespace())?;
        (bytes.get(mark) == Some(&b'_')).then_some((open, mark + 1))
    });
    match mark {
        Some((open, data)) => {
            let mut xml = bytes.get(..open).unwrap_or_default().to_vec();
            xml.extend(b"</AppendedData></VTKFile>");
            (xml, bytes.get(data..))
        }
        None => (bytes.to_vec(), None),
    }
}

fn broken(fault: &SyntaxFault) -> MeshFault {
    MeshFault::NotUnderstood(match fault {
        SyntaxFault::NotXml | SyntaxFault::Empty => "it is not XML, expected a <VTKFile>".into(),
        other => format!("its XML is broken: {other}"),
    })
}

fn of_array(tree: &Tree, array: ElementId, coding: &Coding<'_>) -> Result<Vec<[f64; 3]>, MeshFault> {
    let attribute = |key| tree.attribute(array, key).unwrap_or_default();
    let components = attribute("NumberOfComponents");
    if components != "3" {
        let fault = format!("its points have {components:?} numbers each, expected NumberOfComponents=\"3\"");
        return Err(MeshFault::NotUnderstood(fault));
    }
    match content(tree, array, coding)? {
        Content::Text(text) => triples(words(&text), "the points"),
        Content::Bytes(bytes) => binary(&bytes, &attribute("type"), coding),
    }
}

/// The places among points that an array lists.
fn integers(tree: &Tree, array: ElementId, coding: &Coding<'_>) -> Result<Vec<usize>, MeshFault> {
    match content(tree, array, coding)? {
        Content::Text(text) => {
            let broken = |word: &str| {
                MeshFault::NotUnderstood(format!("{:?} among the polygons is not a number", shortened(word)))
            };
            words(&text).map(|word| word.parse().map_err(|_| broken(word))).collect()
        }
        Content::Bytes(bytes) => {
            integers_of(&bytes, &tree.attribute(array, "type").unwrap_or_default(), coding)
        }
    }
}

/// What an array holds, as the file has it.
enum Content<'t> {
    Text(Cow<'t, str>),
    Bytes(Vec<u8>),
}

fn content<'t>(tree: &'t Tree, array: ElementId, coding: &Coding<'_>) -> Result<Content<'t>, MeshFault> {
    let attribute = |key| tree.attribute(array, key).unwrap_or_default();
    match &*attribute("format") {
        "ascii" | "" => Ok(Content::Text(tree.text_of(array))),
        "binary" => coding.of_text(trimmed(&tree.text_of(array))).map(Content::Bytes),
        "appended" => {
            let offset = attribute("offset").parse();
            let offset = offset.map_err(|_| MeshFault::NotUnderstood("its points have no offset".into()))?;
            coding.of_appended(offset).map(Content::Bytes)
        }
        other => {
            Err(MeshFault::Unsupported(format!("points in format=\"{}\" are not read", shortened(other))))
        }
    }
}
