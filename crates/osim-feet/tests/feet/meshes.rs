//! Mesh files in every coding, and those that must be refused.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use osim_feet::mesh_points;

fn fixtures(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/feet").join(folder)
}

fn read(folder: &str, name: &str) -> Result<Vec<[f64; 3]>, String> {
    let bytes = std::fs::read(fixtures(folder).join(name)).unwrap();
    mesh_points(name, &bytes).map_err(|fault| fault.to_string())
}

fn names(folder: &str) -> BTreeSet<String> {
    let files = std::fs::read_dir(fixtures(folder)).unwrap().map(Result::unwrap);
    let files = files.filter(|entry| entry.file_type().unwrap().is_file());
    files.map(|entry| entry.file_name().into_string().unwrap()).collect()
}

/// What `small` of make_feet.py writes: multiples of 2^-10, exact in single precision.
fn small() -> Vec<[f64; 3]> {
    let step = 1.0 / 1024.0;
    let point = |k: i32| [step * f64::from(k), step * f64::from(k * k % 7), -step * f64::from(k * 5 % 11)];
    (0..23).map(point).collect()
}

/// VTK 9.5 reads the same points from each of these files.
#[test]
fn every_coding_gives_the_same_points() {
    let names = names("encodings");
    assert_eq!(names.len(), 14);
    for name in names {
        assert_eq!(read("encodings", &name).unwrap(), small(), "{name}");
    }
}

#[test]
fn broken_meshes_are_refused() {
    let expected = [
        ("cut_off.stl", "the file ends in the middle of its triangles: it was cut off, copy it again"),
        (
            "cut_off.vtp",
            "its XML is broken: <DataArray> is never closed: the file looks truncated, copy it again from where it came",
        ),
        // Distances by hand, from the medians of x, y and z: nine of ten points of the small bone are within 0.0114.
        (
            "far_point.vtp",
            "point 5 is 5 from the middle of the mesh, alone, where nine of ten points are within 0.0114: its numbers are broken, \
             correct them or take it out of the file",
        ),
        ("half_vertex.obj", "the file ends in the middle of a vertex: it was cut off, copy it again"),
        ("huge_block.vtp", "it has more than 2000000 points, reduce it first, for example with MeshLab"),
        ("huge_count.vtp", "the file ends in the middle of its points: it was cut off, copy it again"),
        ("infinite.vtp", "coordinate y of point 5 is inf, expected a number between -1e9 and 1e9"),
        ("line.vtp", "all its points are in one line, expected the surface of a bone"),
        (
            "lz4.vtp",
            "points packed by \"vtkLZ4DataCompressor\" are not read: save it as ASCII, for example with ParaView",
        ),
        ("nan.vtp", "coordinate x of point 5 is NaN, expected a number between -1e9 and 1e9"),
        ("no_points.vtp", "it has no <Points> in a <Piece> of <PolyData>"),
        ("not_vtk.vtp", "it is a <Model>, expected a <VTKFile>"),
        ("offset_beyond.vtp", "the file ends in the middle of its points: it was cut off, copy it again"),
        ("three_points.vtp", "it has 3 different points, expected at least four"),
        ("two_components.vtp", "its points have \"2\" numbers each, expected NumberOfComponents=\"3\""),
        ("word.vtp", "\"zero\" among the points is not a number"),
    ];
    assert_eq!(names("encodings/broken"), expected.iter().map(|(name, _)| (*name).to_owned()).collect());
    for (name, message) in expected {
        assert_eq!(read("encodings/broken", name), Err(message.to_owned()), "{name}");
    }
    assert_eq!(
        mesh_points("bone.ply", b"ply").unwrap_err().to_string(),
        "files of this kind are not read, expected .vtp, .stl or .obj"
    );
}

/// Each file cut off everywhere, and with each byte changed: an answer or a refusal, never a panic.
#[test]
fn damaged_meshes_do_no_harm() {
    for name in names("encodings") {
        let bytes = std::fs::read(fixtures("encodings").join(&name)).unwrap();
        for end in (0..bytes.len()).step_by(7) {
            let _ = mesh_points(&name, &bytes[..end]);
        }
        for at in (0..bytes.len()).step_by(3) {
            for value in [0, b'<', b'9', b'=', 0xff] {
                let mut damaged = bytes.clone();
                damaged[at] = value;
                let _ = mesh_points(&name, &damaged);
            }
        }
    }
}
