//! Arrays that are not text: base64 or raw, compressed or not.

use std::io::Read as _;

use crate::xml::{ElementId, Tree};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;

use super::fault::MeshFault;
use super::numbers::{MOST_POINTS, shortened, within};

const ZLIB: &str = "vtkZLibDataCompressor";
/// Nothing is unpacked to more bytes than the largest mesh has.
const MOST_BYTES: usize = MOST_POINTS * 3 * 8;
const CUT_OFF: MeshFault = MeshFault::Truncated("its points");

/// How a file writes arrays.
pub(super) struct Coding<'b> {
    big_endian: bool,
    /// Bytes of each number of a header.
    header: usize,
    compressor: Option<String>,
    appended: Option<&'b [u8]>,
    appended_is_text: bool,
}

impl<'b> Coding<'b> {
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

    /// The array that is in the file as base64.
    pub(super) fn of_text(&self, text: &str) -> Result<Vec<u8>, MeshFault> {
        self.unpacked(&decoded(text.bytes())?)
    }

    /// The array at `offset` after the mark of the appended data.
    pub(super) fn of_appended(&self, offset: usize) -> Result<Vec<u8>, MeshFault> {
        let no_data =
            || MeshFault::NotUnderstood("its points are in <AppendedData>, which is not there".into());
        let bytes = self.appended.ok_or_else(no_data)?.get(offset..).ok_or(CUT_OFF)?;
        if !self.appended_is_text {
            return self.unpacked(bytes);
        }
        self.unpacked(&decoded(bytes.iter().copied().take_while(|&byte| byte != b'<'))?)
    }

    /// The bytes of an array after its header.
    fn unpacked(&self, bytes: &[u8]) -> Result<Vec<u8>, MeshFault> {
        match self.compressor.as_deref() {
            None => {
                let size = self.header_number(bytes, 0)?;
                let end = self.header.checked_add(size).ok_or(CUT_OFF)?;
                Ok(bytes.get(self.header..end).ok_or(CUT_OFF)?.to_vec())
            }
            Some(ZLIB) => self.inflated(bytes),
            Some(other) => {
                let other = shortened(other);
                Err(MeshFault::Unsupported(format!("points packed by {other:?} are not read")))
            }
        }
    }

    /// Blocks of one size, the last one smaller: the header has their number, both sizes, and the packed size of each.
    fn inflated(&self, bytes: &[u8]) -> Result<Vec<u8>, MeshFault> {
        let [count, full, last] =
            [self.header_number(bytes, 0)?, self.header_number(bytes, 1)?, self.header_number(bytes, 2)?];
        let start =
            count.checked_add(3).and_then(|numbers| numbers.checked_mul(self.header)).ok_or(CUT_OFF)?;
        let mut rest = bytes.get(start..).ok_or(CUT_OFF)?;
        let mut all = Vec::new();
        for block in 0..count {
            let packed = self.header_number(bytes, 3 + block)?;
            let (this, behind) = rest.split_at_checked(packed).ok_or(CUT_OFF)?;
            let size = if block + 1 == count && last > 0 { last } else { full };
            inflate(this, size, &mut all)?;
            rest = behind;
        }
        Ok(all)
    }

    fn header_number(&self, bytes: &[u8], index: usize) -> Result<usize, MeshFault> {
        let start = index.checked_mul(self.header).ok_or(CUT_OFF)?;
        let bytes = bytes.get(start..).and_then(|bytes| bytes.get(..self.header)).ok_or(CUT_OFF)?;
        let add = |value: u64, byte: &u8| value << 8 | u64::from(*byte);
        let value = if self.big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) };
        usize::try_from(value).map_err(|_| CUT_OFF)
    }
}

/// Adds `size` bytes that `packed` holds.
fn inflate(packed: &[u8], size: usize, all: &mut Vec<u8>) -> Result<(), MeshFault> {
    let end = all.len().checked_add(size).filter(|&end| end <= MOST_BYTES);
    let end = end.ok_or(MeshFault::TooManyPoints { most: MOST_POINTS })?;
    // One more shows that there are too many.
    let most = u64::try_from(size).unwrap_or(u64::MAX).saturating_add(1);
    let broken = |why: String| MeshFault::NotUnderstood(format!("its packed points are broken: {why}"));
    ZlibDecoder::new(packed).take(most).read_to_end(all).map_err(|error| broken(error.to_string()))?;
    if all.len() == end { Ok(()) } else { Err(broken("another size than its header says".into())) }
}

/// Base64 with white space, and with padding wherever a piece of it ended.
fn decoded(bytes: impl Iterator<Item = u8>) -> Result<Vec<u8>, MeshFault> {
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

/// Triples of numbers of the type that the array names.
pub(super) fn binary(bytes: &[u8], kind: &str, coding: &Coding<'_>) -> Result<Vec<[f64; 3]>, MeshFault> {
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
    within(values.len() / 3)?;
    Ok(values.as_chunks::<3>().0.to_vec())
}

/// Places among points, of the type that the array names.
pub(super) fn integers_of(bytes: &[u8], kind: &str, coding: &Coding<'_>) -> Result<Vec<usize>, MeshFault> {
    let width = match kind {
        "Int32" | "UInt32" => 4,
        "Int64" | "UInt64" => 8,
        other => {
            let other = shortened(other);
            return Err(MeshFault::Unsupported(format!("polygons of type {other:?} are not read")));
        }
    };
    let add = |value: u64, byte: &u8| value << 8 | u64::from(*byte);
    let value = |bytes: &[u8]| match coding.big_endian {
        true => bytes.iter().fold(0, add),
        false => bytes.iter().rev().fold(0, add),
    };
    // One that is too large names no point.
    Ok(bytes.chunks_exact(width).map(|bytes| usize::try_from(value(bytes)).unwrap_or(usize::MAX)).collect())
}
