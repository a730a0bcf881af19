//! Wavefront files: of their lines, those that begin with `v` and `f`.

use crate::xml::opensim_text::words;

use super::fault::MeshFault;
use super::numbers::{add, number};
use super::surface::Surface;

/// The vertices of an .obj file. A weight or a colour may follow x, y and z, and does not count.
pub(super) fn points(bytes: &[u8]) -> Result<Vec<[f64; 3]>, MeshFault> {
    let text = String::from_utf8_lossy(bytes);
    let mut points = Vec::new();
    for line in text.lines() {
        let mut words = words(line);
        if words.next() != Some("v") {
            continue;
        }
        let mut next = || number(words.next().ok_or(MeshFault::Truncated("a vertex"))?, "the vertices");
        add(&mut points, [next()?, next()?, next()?])?;
    }
    Ok(points)
}

/// Vertices and faces. A face names its corners by their places among the vertices: from 1, or back from the last one before it.
pub(super) fn surface(bytes: &[u8]) -> Result<Surface, MeshFault> {
    let mut surface = Surface { points: points(bytes)?, triangles: Vec::new() };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_the_lines_that_begin_with_v() {
        let text = "# v 9 9 9\r\nmtllib a.mtl\r\nv 1 2 3\r\n  v\t-1e-3 .5 6 1.0 0.2 0.3\r\nvn 0 0 1\r\nvt 1 1\r\nf 1 2 1\r\n";
        assert_eq!(points(text.as_bytes()).unwrap(), [[1.0, 2.0, 3.0], [-1e-3, 0.5, 6.0]]);
        assert_eq!(points(b"v 1 2\nv 1 2 3\n"), Err(MeshFault::Truncated("a vertex")));
        assert!(matches!(points(b"v 1 2 x\n"), Err(MeshFault::NotUnderstood(_))));
    }
}
