//! VTK's polygonal data: only its points are read.

use osim_xml::opensim_text::{trimmed, words};
use osim_xml::{ElementId, SyntaxFault, Tree};

use super::fault::MeshFault;
use super::numbers::{shortened, triples, within};
use super::vtk_array::{Coding, binary};

/// Where raw bytes may follow, the XML ends for a scanner.
const APPENDED: &[u8] = b"<AppendedData";

/// The points of all pieces of a .vtp file.
pub(super) fn points(bytes: &[u8]) -> Result<Vec<[f64; 3]>, MeshFault> {
    let (xml, appended) = split(bytes);
    let tree = Tree::scan(xml).map_err(|error| broken(&error.fault))?;
    if tree.name(ElementId::ROOT) != "VTKFile" {
        let found = tree.name(ElementId::ROOT);
        return Err(MeshFault::NotUnderstood(format!("it is a <{found}>, expected a <VTKFile>")));
    }
    let coding = Coding::of(&tree, appended);
    let whole = tree.child(ElementId::ROOT, "PolyData");
    let pieces = whole.into_iter().flat_map(|whole| tree.children(whole));
    let mut all: Vec<[f64; 3]> = Vec::new();
    for piece in pieces.filter(|&piece| tree.name(piece) == "Piece") {
        let array = tree.child(piece, "Points").and_then(|points| tree.child(points, "DataArray"));
        let Some(array) = array else { continue };
        let points = of_array(&tree, array, &coding)?;
        let count = tree.attribute(piece, "NumberOfPoints").unwrap_or_default();
        if count.parse() != Ok(points.len()) {
            let fault = format!("it has {} points where it says {count:?}", points.len());
            return Err(MeshFault::NotUnderstood(fault));
        }
        all.extend(points);
        within(all.len())?;
    }
    if all.is_empty() {
        return Err(MeshFault::NotUnderstood("it has no <Points> in a <Piece> of <PolyData>".into()));
    }
    Ok(all)
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
    match &*attribute("format") {
        "ascii" | "" => triples(words(&tree.text_of(array)), "the points"),
        "binary" => {
            let text = tree.text_of(array);
            binary(&coding.of_text(trimmed(&text))?, &attribute("type"), coding)
        }
        "appended" => {
            let offset = attribute("offset").parse();
            let offset = offset.map_err(|_| MeshFault::NotUnderstood("its points have no offset".into()))?;
            binary(&coding.of_appended(offset)?, &attribute("type"), coding)
        }
        other => {
            Err(MeshFault::Unsupported(format!("points in format=\"{}\" are not read", shortened(other))))
        }
    }
}
