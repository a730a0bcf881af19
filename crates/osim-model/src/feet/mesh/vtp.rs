//! Reads VTK's polygonal data (.vtp): points, and polygons for pictures. Arrays may be text, base64 or raw bytes.

use std::borrow::Cow;
use std::io::Read as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use super::surface::{
    MOST_POINTS, MeshFault, MeshSurface, Result, check_point_count, number_triples, shortened,
};
use crate::xml::opensim_text::{trimmed, words};
use crate::xml::{ElementId, SyntaxFault, Tree};

/// The element after which raw bytes may follow. The XML scan must stop there.
const APPENDED_DATA_TAG: &[u8] = b"<AppendedData";

/// The points of all pieces of a .vtp file.
pub(super) fn points(bytes: &[u8]) -> Result<Vec<[f64; 3]>> {
    let mut all = Vec::new();
    for_each_piece(bytes, |_, _, _, points| {
        all.extend(points);
        check_point_count(all.len())
    })?;
    if all.is_empty() { Err(no_points_fault()) } else { Ok(all) }
}

/// The points and polygons of all pieces of a .vtp file. Strips and lines are left out: no known bone has any.
pub(super) fn surface(bytes: &[u8]) -> Result<MeshSurface> {
    let mut all = MeshSurface::default();
    for_each_piece(bytes, |tree, piece, coding, points| {
        let start = all.points.len();
        all.points.extend(points);
        check_point_count(all.points.len())?;
        let Some(polygons) = tree.child(piece, "Polys") else { return Ok(()) };
        let array = |name: &str| {
            let named = |&id: &ElementId| tree.attribute(id, "Name").as_deref() == Some(name);
            tree.children(polygons)
                .find(named)
                .map(|array| whole_numbers_of_array(tree, array, coding))
                .transpose()
        };
        let corners = array("connectivity")?.unwrap_or_default();
        let mut from = 0;
        for end in array("offsets")?.unwrap_or_default() {
            all.add_face(start, corners.get(from..end).unwrap_or_default().iter().copied().map(Some))?;
            from = end;
        }
        Ok(())
    })?;
    if all.points.is_empty() { Err(no_points_fault()) } else { Ok(all) }
}

fn no_points_fault() -> MeshFault {
    MeshFault::NotUnderstood("it has no <Points> in a <Piece> of <PolyData>".into())
}

/// Calls `use_piece` with each piece of the file and the points of the piece.
fn for_each_piece(
    bytes: &[u8],
    mut use_piece: impl FnMut(&Tree, ElementId, &Coding<'_>, Vec<[f64; 3]>) -> Result<()>,
) -> Result<()> {
    let (xml, appended) = split_appended_data(bytes);
    let tree = Tree::scan(xml).map_err(|error| xml_mesh_fault(&error.fault))?;
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
        let points = read_array(&tree, array, &coding)?;
        let count = tree.attribute(piece, "NumberOfPoints").unwrap_or_default();
        if count.parse() != Ok(points.len()) {
            let fault = format!("it has {} points where it says {count:?}", points.len());
            return Err(MeshFault::NotUnderstood(fault));
        }
        use_piece(&tree, piece, &coding, points)?;
    }
    Ok(())
}

/// Separates the XML from the raw bytes that follow the mark `_` in `<AppendedData>`.
fn split_appended_data(bytes: &[u8]) -> (Vec<u8>, Option<&[u8]>) {
    let start = bytes.windows(APPENDED_DATA_TAG.len()).position(|window| window == APPENDED_DATA_TAG);
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

fn xml_mesh_fault(fault: &SyntaxFault) -> MeshFault {
    MeshFault::NotUnderstood(match fault {
        SyntaxFault::NotXml | SyntaxFault::Empty => "it is not XML, expected a <VTKFile>".into(),
        other => format!("its XML is broken: {other}"),
    })
}

fn read_array(tree: &Tree, array: ElementId, coding: &Coding<'_>) -> Result<Vec<[f64; 3]>> {
    let attribute = |key| tree.attribute(array, key).unwrap_or_default();
    let components = attribute("NumberOfComponents");
    if components != "3" {
        let fault = format!("its points have {components:?} numbers each, expected NumberOfComponents=\"3\"");
        return Err(MeshFault::NotUnderstood(fault));
    }
    match array_content(tree, array, coding)? {
        ArrayContent::Text(text) => number_triples(words(&text)),
        ArrayContent::Bytes(bytes) => read_points(&bytes, &attribute("type"), coding),
    }
}

/// The numbers in an array of whole numbers, such as the point indices of polygons.
fn whole_numbers_of_array(tree: &Tree, array: ElementId, coding: &Coding<'_>) -> Result<Vec<usize>> {
    match array_content(tree, array, coding)? {
        ArrayContent::Text(text) => {
            let broken = |word: &str| {
                MeshFault::NotUnderstood(format!("{:?} among the polygons is not a number", shortened(word)))
            };
            words(&text).map(|word| word.parse().map_err(|_| broken(word))).collect()
        }
        ArrayContent::Bytes(bytes) => {
            decode_integers(&bytes, &tree.attribute(array, "type").unwrap_or_default(), coding)
        }
    }
}

/// The content of an array, not decoded yet: text or bytes.
enum ArrayContent<'t> {
    Text(Cow<'t, str>),
    Bytes(Vec<u8>),
}

fn array_content<'t>(tree: &'t Tree, array: ElementId, coding: &Coding<'_>) -> Result<ArrayContent<'t>> {
    let attribute = |key| tree.attribute(array, key).unwrap_or_default();
    match &*attribute("format") {
        "ascii" | "" => Ok(ArrayContent::Text(tree.text_of(array))),
        "binary" => {
            coding.unpacked(&decode_base64(trimmed(&tree.text_of(array)).bytes())?).map(ArrayContent::Bytes)
        }
        "appended" => {
            let offset = attribute("offset").parse();
            let offset = offset.map_err(|_| MeshFault::NotUnderstood("its points have no offset".into()))?;
            coding.decode_appended(offset).map(ArrayContent::Bytes)
        }
        other => {
            Err(MeshFault::Unsupported(format!("points in format=\"{}\" are not read", shortened(other))))
        }
    }
}

// Arrays that are not text: base64 or raw, compressed or not.

/// The name of the only compression in .vtp files that is read.
const ZLIB_COMPRESSOR: &str = "vtkZLibDataCompressor";
/// The largest number of unpacked bytes: those of the largest allowed mesh.
const MOST_UNPACKED_BYTES: usize = MOST_POINTS * 3 * 8;
/// The fault that the points of a mesh end too early.
const POINTS_TRUNCATED: MeshFault = MeshFault::Truncated("its points");

/// How a .vtp file encodes its arrays: byte order, header, compression.
pub(super) struct Coding<'b> {
    big_endian: bool,
    /// Bytes of each number in the header of an array.
    header: usize,
    compressor: Option<String>,
    appended: Option<&'b [u8]>,
    appended_is_text: bool,
}

impl<'b> Coding<'b> {
    /// How the file with this tree encodes its arrays; `appended` are the raw bytes after the XML.
    pub(super) fn of(tree: &Tree, appended: Option<&'b [u8]>) -> Self {
        let file = |key| tree.attribute(ElementId::ROOT, key);
        let data = tree.child(ElementId::ROOT, "AppendedData");
        let encoding = data.and_then(|data| tree.attribute(data, "encoding"));
        Self {
            big_endian: file("byte_order").as_deref() == Some("BigEndian"),
            header: if file("header_type").as_deref() == Some("UInt64") { 8 } else { 4 },
            compressor: file("compressor").map(Into::into).filter(|name: &String| !name.is_empty()),
            appended,
            appended_is_text: encoding.as_deref() != Some("raw"),
        }
    }

    /// Decodes an array in the appended data, at `offset` bytes after the mark.
    fn decode_appended(&self, offset: usize) -> Result<Vec<u8>> {
        let no_data =
            || MeshFault::NotUnderstood("its points are in <AppendedData>, which is not there".into());
        let bytes = self.appended.ok_or_else(no_data)?.get(offset..).ok_or(POINTS_TRUNCATED)?;
        if !self.appended_is_text {
            return self.unpacked(bytes);
        }
        self.unpacked(&decode_base64(bytes.iter().copied().take_while(|&byte| byte != b'<'))?)
    }

    /// The bytes of an array without its header, decompressed if necessary.
    fn unpacked(&self, bytes: &[u8]) -> Result<Vec<u8>> {
        match self.compressor.as_deref() {
            None => {
                let size = self.header_number(bytes, 0)?;
                let end = self.header.checked_add(size).ok_or(POINTS_TRUNCATED)?;
                Ok(bytes.get(self.header..end).ok_or(POINTS_TRUNCATED)?.to_vec())
            }
            Some(ZLIB_COMPRESSOR) => self.inflated(bytes),
            Some(other) => {
                let other = shortened(other);
                Err(MeshFault::Unsupported(format!("points packed by {other:?} are not read")))
            }
        }
    }

    /// Decompresses an array. Its header has the number of blocks, the size of a full block and of the last block, and the packed size of
    /// each block.
    fn inflated(&self, bytes: &[u8]) -> Result<Vec<u8>> {
        let [count, full, last] =
            [self.header_number(bytes, 0)?, self.header_number(bytes, 1)?, self.header_number(bytes, 2)?];
        let start = count
            .checked_add(3)
            .and_then(|numbers| numbers.checked_mul(self.header))
            .ok_or(POINTS_TRUNCATED)?;
        let mut rest = bytes.get(start..).ok_or(POINTS_TRUNCATED)?;
        let mut all = Vec::new();
        for block in 0..count {
            let packed = self.header_number(bytes, 3 + block)?;
            let (this, behind) = rest.split_at_checked(packed).ok_or(POINTS_TRUNCATED)?;
            let size = if block + 1 == count && last > 0 { last } else { full };
            inflate(this, size, &mut all)?;
            rest = behind;
        }
        Ok(all)
    }

    fn header_number(&self, bytes: &[u8], index: usize) -> Result<usize> {
        let start = index.checked_mul(self.header).ok_or(POINTS_TRUNCATED)?;
        let bytes = bytes.get(start..).and_then(|bytes| bytes.get(..self.header)).ok_or(POINTS_TRUNCATED)?;
        usize::try_from(self.integer(bytes)).map_err(|_| POINTS_TRUNCATED)
    }

    fn integer(&self, bytes: &[u8]) -> u64 {
        let add = |value: u64, byte: &u8| value << 8 | u64::from(*byte);
        if self.big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) }
    }
}

/// Decompresses `packed`, which gives `size` bytes, and appends these to `all`.
fn inflate(packed: &[u8], size: usize, all: &mut Vec<u8>) -> Result<()> {
    let end = all.len().checked_add(size).filter(|&end| end <= MOST_UNPACKED_BYTES);
    let end = end.ok_or(MeshFault::TooManyPoints { most: MOST_POINTS })?;
    // One more shows that there are too many.
    let most = u64::try_from(size).unwrap_or(u64::MAX).saturating_add(1);
    let broken = |why: String| MeshFault::NotUnderstood(format!("its packed points are broken: {why}"));
    ZlibDecoder::new(packed).take(most).read_to_end(all).map_err(|error| broken(error.to_string()))?;
    if all.len() == end { Ok(()) } else { Err(broken("another size than its header says".into())) }
}

/// Decodes base64. White space is skipped, and padding may stand at the end of each part.
fn decode_base64(bytes: impl Iterator<Item = u8>) -> Result<Vec<u8>> {
    let text: Vec<u8> = bytes.filter(|byte| !byte.is_ascii_whitespace()).collect();
    let broken = || MeshFault::NotUnderstood("its points are not valid base64".into());
    let mut all = Vec::new();
    let mut rest = text.as_slice();
    while !rest.is_empty() {
        let length = rest.iter().position(|&byte| byte == b'=').unwrap_or(rest.len());
        // Padding fills groups of four.
        let end = length.div_ceil(4).saturating_mul(4).max(4).min(rest.len());
        let (piece, behind) = rest.split_at(end);
        STANDARD.decode_vec(piece, &mut all).map_err(|_| broken())?;
        rest = behind;
    }
    Ok(all)
}

/// Turns decoded bytes into points of three numbers each. `kind` is the number type that the array declares.
pub(super) fn read_points(bytes: &[u8], kind: &str, coding: &Coding<'_>) -> Result<Vec<[f64; 3]>> {
    let values: Vec<f64> = match kind {
        "Float32" => {
            let read = if coding.big_endian { f32::from_be_bytes } else { f32::from_le_bytes };
            bytes.as_chunks::<4>().0.iter().map(|bytes| read(*bytes).into()).collect()
        }
        "Float64" => {
            let read = if coding.big_endian { f64::from_be_bytes } else { f64::from_le_bytes };
            bytes.as_chunks::<8>().0.iter().map(|bytes| read(*bytes)).collect()
        }
        other => {
            let other = shortened(other);
            return Err(MeshFault::Unsupported(format!("points of type {other:?} are not read")));
        }
    };
    check_point_count(values.len() / 3)?;
    Ok(values.as_chunks::<3>().0.to_vec())
}

/// Decodes an array of whole numbers. `kind` is the number type that the array declares.
fn decode_integers(bytes: &[u8], kind: &str, coding: &Coding<'_>) -> Result<Vec<usize>> {
    let width = match kind {
        "Int32" | "UInt32" => 4,
        "Int64" | "UInt64" => 8,
        other => {
            let other = shortened(other);
            return Err(MeshFault::Unsupported(format!("polygons of type {other:?} are not read")));
        }
    };
    // One that is too large names no point.
    // One that is too large names no point.
    // One that is too large names no point.
    let integers = bytes.chunks_exact(width).map(|bytes| coding.integer(bytes));
    Ok(integers.map(|value| usize::try_from(value).unwrap_or(usize::MAX)).collect())
}
