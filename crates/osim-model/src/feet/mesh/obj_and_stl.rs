//! Reads Wavefront files (.obj: the lines that begin with `v` and `f`) and stereolithography files (.stl: text or binary).

use super::surface::{MeshFault, MeshSurface, Result, add, check_point_count, parse_number};
use crate::xml::opensim_text::words;

/// The vertices of an .obj file. Numbers after x, y and z (a weight or a colour) are ignored.
pub(super) fn obj_points(bytes: &[u8]) -> Result<Vec<[f64; 3]>> {
    let text = String::from_utf8_lossy(bytes);
    let mut points = Vec::new();
    for line in text.lines() {
        let mut words = words(line);
        if words.next() != Some("v") {
            continue;
        }
        let mut next = || parse_number(words.next().ok_or(MeshFault::Truncated("a vertex"))?, "the vertices");
        add(&mut points, [next()?, next()?, next()?])?;
    }
    Ok(points)
}

/// The vertices and faces of an .obj file. A face gives the numbers of its corners: from 1, or below 0 counted back from the last vertex
/// before the face.
pub(super) fn obj_surface(bytes: &[u8]) -> Result<MeshSurface> {
    let mut surface = MeshSurface { points: obj_points(bytes)?, triangles: Vec::new() };
    let text = String::from_utf8_lossy(bytes);
    let mut before = 0_usize;
    for line in text.lines() {
        let mut words = words(line);
        match words.next() {
            Some("v") => before += 1,
            Some("f") => {
                let place = |word: &str| {
                    let number: isize = word.split('/').next()?.parse().ok()?;
                    match number {
                        0 => None,
                        1.. => number.unsigned_abs().checked_sub(1),
                        _ => before.checked_add_signed(number),
                    }
                };
                surface.add_face(0, words.map(place))?;
            }
            _ => {}
        }
    }
    Ok(surface)
}

// Stereolithography files, in text or binary.

/// A binary STL file has this many bytes before its triangles: a title and the number of triangles.
const STL_HEADER_BYTES: usize = 84;
/// Bytes of the title at the beginning of a binary STL file.
const STL_TITLE_BYTES: usize = 80;
/// Bytes of one triangle: a normal and three corners in single precision, then two more bytes.
const STL_TRIANGLE_BYTES: usize = 50;
/// Bytes of the normal at the beginning of a triangle.
const STL_NORMAL_BYTES: usize = 12;

/// The corners of all triangles of an STL file, three points for each triangle.
pub(super) fn stl_points(bytes: &[u8]) -> Result<Vec<[f64; 3]>> {
    // Many binary files begin with "solid" too: the size decides.
    let count = bytes
        .get(STL_TITLE_BYTES..STL_HEADER_BYTES)
        .and_then(|count| Some(u32::from_le_bytes(count.try_into().ok()?)));
    let size = count.and_then(|count| {
        STL_HEADER_BYTES.checked_add(usize::try_from(count).ok()?.checked_mul(STL_TRIANGLE_BYTES)?)
    });
    let is_text = bytes.trim_ascii_start().starts_with(b"solid")
        && bytes.iter().take(4 * STL_HEADER_BYTES).all(|&byte| byte.is_ascii() && byte != 0);
    if is_text && size != Some(bytes.len()) {
        return text_stl_points(&String::from_utf8_lossy(bytes));
    }
    match size.and_then(|size| bytes.get(STL_HEADER_BYTES..size)) {
        Some(triangles) => binary_stl_points(triangles),
        None if count.is_none() => {
            Err(MeshFault::NotUnderstood("it is neither a text that begins with \"solid\" nor binary".into()))
        }
        None => Err(MeshFault::Truncated("its triangles")),
    }
}

fn binary_stl_points(triangles: &[u8]) -> Result<Vec<[f64; 3]>> {
    check_point_count(triangles.len() / STL_TRIANGLE_BYTES)?;
    let mut points = Vec::new();
    for triangle in triangles.chunks_exact(STL_TRIANGLE_BYTES) {
        let corners = triangle.get(STL_NORMAL_BYTES..STL_TRIANGLE_BYTES - 2).unwrap_or_default();
        let values = corners.as_chunks::<4>().0.iter().map(|bytes| f64::from(f32::from_le_bytes(*bytes)));
        let values: Vec<f64> = values.collect();
        points.extend(values.as_chunks::<3>().0);
    }
    Ok(points)
}

fn text_stl_points(text: &str) -> Result<Vec<[f64; 3]>> {
    if !text.contains("endsolid") {
        return Err(MeshFault::Truncated("its triangles"));
    }
    let mut points = Vec::new();
    let mut words = words(text);
    while let Some(word) = words.next() {
        if word.eq_ignore_ascii_case("vertex") {
            let mut next =
                || parse_number(words.next().ok_or(MeshFault::Truncated("a vertex"))?, "the vertices");
            points.push([next()?, next()?, next()?]);
            check_point_count(points.len() / 3)?;
        }
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_the_lines_that_begin_with_v() {
        let text = "# v 9 9 9\r\nmtllib a.mtl\r\nv 1 2 3\r\n  v\t-1e-3 .5 6 1.0 0.2 0.3\r\nvn 0 0 1\r\nvt 1 1\r\nf 1 2 1\r\n";
        assert_eq!(obj_points(text.as_bytes()).unwrap(), [[1.0, 2.0, 3.0], [-1e-3, 0.5, 6.0]]);
        assert_eq!(obj_points(b"v 1 2\nv 1 2 3\n"), Err(MeshFault::Truncated("a vertex")));
        assert!(matches!(obj_points(b"v 1 2 x\n"), Err(MeshFault::NotUnderstood(_))));
    }

    fn binary_stl(title: &[u8], count: u32, triangles: &[[f32; 9]]) -> Vec<u8> {
        let mut bytes = title.to_vec();
        bytes.resize(STL_TITLE_BYTES, 0);
        bytes.extend(count.to_le_bytes());
        for triangle in triangles {
            bytes.extend([0; STL_NORMAL_BYTES]);
            bytes.extend(triangle.iter().flat_map(|value| value.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    #[test]
    fn the_file_size_tells_binary_stl_from_text() {
        let triangle = [0.5, 0.0, 0.0, 1.0, 0.25, 0.0, 0.0, 1.0, -2.0];
        let expected = [[0.5, 0.0, 0.0], [1.0, 0.25, 0.0], [0.0, 1.0, -2.0]];
        assert_eq!(stl_points(&binary_stl(b"exported", 1, &[triangle])).unwrap(), expected);
        assert_eq!(stl_points(&binary_stl(b"solid exported", 1, &[triangle])).unwrap(), expected);
        let text = "solid toe\n facet normal 0 0 1\n  outer loop\n   vertex 5e-1 0 0\n   vertex 1 .25 0\n   vertex 0 1 -2\n  \
                endloop\n endfacet\nendsolid toe\n";
        assert_eq!(stl_points(text.as_bytes()).unwrap(), expected);
    }

    #[test]
    fn a_wrong_triangle_count_of_an_stl_file_is_detected() {
        let triangle = [0.0; 9];
        assert_eq!(
            stl_points(&binary_stl(b"x", u32::MAX, &[triangle])),
            Err(MeshFault::Truncated("its triangles"))
        );
        assert_eq!(stl_points(&binary_stl(b"x", 2, &[triangle])), Err(MeshFault::Truncated("its triangles")));
        assert!(matches!(stl_points(b"binary"), Err(MeshFault::NotUnderstood(_))));
        assert_eq!(stl_points(b"solid x vertex 1 2 3"), Err(MeshFault::Truncated("its triangles")));
        assert!(matches!(stl_points(b"solid x vertex 1 2 endsolid"), Err(MeshFault::NotUnderstood(_))));
    }
}
