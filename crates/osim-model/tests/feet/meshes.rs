//! Tests of mesh files in every encoding, and of files that must be refused.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use osim_model::feet::{mesh_points, mesh_surface};

fn folder_of_fixtures(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/feet").join(folder)
}

fn points_of_mesh(folder: &str, name: &str) -> Result<Vec<[f64; 3]>, String> {
    let bytes = std::fs::read(folder_of_fixtures(folder).join(name)).unwrap();
    mesh_points(name, &bytes).map_err(|fault| fault.to_string())
}

fn names_of_files(folder: &str) -> BTreeSet<String> {
    let files = std::fs::read_dir(folder_of_fixtures(folder)).unwrap().map(Result::unwrap);
    let files = files.filter(|entry| entry.file_type().unwrap().is_file());
    files.map(|entry| entry.file_name().into_string().unwrap()).collect()
}

/// The points that the function `small` of make_feet.py writes: multiples of 2^-10, exact in single precision.
fn expected_points() -> Vec<[f64; 3]> {
    let step = 1.0 / 1024.0;
    let point = |k: i32| [step * f64::from(k), step * f64::from(k * k % 7), -step * f64::from(k * 5 % 11)];
    (0..23).map(point).collect()
}

/// VTK 9.5 reads the same points from each of the tested files.
#[test]
fn files_in_every_encoding_give_the_same_points() {
    let names = names_of_files("encodings");
    assert_eq!(names.len(), 14);
    for name in names {
        assert_eq!(points_of_mesh("encodings", &name).unwrap(), expected_points(), "{name}");
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
    assert_eq!(
        names_of_files("encodings/broken"),
        expected.iter().map(|(name, _)| (*name).to_owned()).collect()
    );
    for (name, message) in expected {
        assert_eq!(points_of_mesh("encodings/broken", name), Err(message.to_owned()), "{name}");
    }
    assert_eq!(
        mesh_points("bone.ply", b"ply").unwrap_err().to_string(),
        "files of this kind are not read, expected .vtp, .stl or .obj"
    );
}

/// Each file is cut off at every byte, and each byte is changed: the result is an answer or an error, never a panic.
#[test]
fn damaged_mesh_files_cause_no_panic() {
    for name in names_of_files("encodings") {
        let bytes = std::fs::read(folder_of_fixtures("encodings").join(&name)).unwrap();
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

/// The corners of each triangle, sorted, so that the order of the points does not matter.
fn corners_of_triangles(name: &str, bytes: &[u8]) -> Vec<[[f64; 3]; 3]> {
    let surface = mesh_surface(name, bytes).unwrap();
    surface.triangles.iter().map(|triangle| triangle.map(|at| surface.points[at as usize])).collect()
}

/// A tube of 96 points has 188 triangles, as make_feet.py counts in the file.
#[test]
fn the_triangles_of_a_bone_are_those_of_its_file() {
    for (name, triangles) in [("r_human_foot.vtp", 188), ("l_human_foot.vtp", 188)] {
        let bytes = std::fs::read(folder_of_fixtures("Geometry").join(name)).unwrap();
        let surface = mesh_surface(name, &bytes).unwrap();
        assert_eq!((surface.points.len(), surface.triangles.len()), (96, triangles), "{name}");
        // A closed surface: each edge is one of two triangles.
        let mut edges = std::collections::HashMap::new();
        for [a, b, c] in surface.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((from.min(to), from.max(to))).or_insert(0) += 1;
            }
        }
        assert!(edges.values().all(|&count| count == 2), "{name}");
    }
}

#[test]
fn text_obj_and_stl_have_the_same_triangles() {
    let of = |name: &str| {
        corners_of_triangles(name, &std::fs::read(folder_of_fixtures("encodings").join(name)).unwrap())
    };
    let expected = of("ascii.vtp");
    assert_eq!(expected.len(), 21);
    for name in ["bone.obj", "ascii.stl", "binary.stl"] {
        assert_eq!(of(name), expected, "{name}");
    }
}

#[test]
fn polygons_are_read_in_every_type_of_number() {
    let points = "0 0 0 1 0 0 1 1 0 0 1 0";
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let expected = vec![[square[0], square[1], square[2]], [square[0], square[2], square[3]]];
    for (order, kind) in
        [("LittleEndian", "Int32"), ("BigEndian", "Int32"), ("LittleEndian", "Int64"), ("BigEndian", "Int64")]
    {
        let array = |name: &str, numbers: &[i64]| {
            let bytes: Vec<u8> =
                numbers.iter().flat_map(|&number| number_bytes(number, order, kind)).collect();
            let mut all = number_bytes(i64::try_from(bytes.len()).unwrap(), order, "Int32");
            all.extend(bytes);
            format!(
                "<DataArray type='{kind}' Name='{name}' format='binary'>{}</DataArray>",
                STANDARD.encode(all)
            )
        };
        let text = format!(
            "<VTKFile type='PolyData' byte_order='{order}'><PolyData><Piece NumberOfPoints='4'><Points><DataArray \
             type='Float32' NumberOfComponents='3' format='ascii'>{points}</DataArray></Points><Polys>{}{}</Polys></Piece>\
             </PolyData></VTKFile>",
            array("connectivity", &[0, 1, 2, 3]),
            array("offsets", &[4])
        );
        assert_eq!(corners_of_triangles("a.vtp", text.as_bytes()), expected, "{order} {kind}");
    }
}

fn number_bytes(number: i64, order: &str, kind: &str) -> Vec<u8> {
    let mut bytes = number.to_le_bytes()[..if kind == "Int32" { 4 } else { 8 }].to_vec();
    if order == "BigEndian" {
        bytes.reverse();
    }
    bytes
}
