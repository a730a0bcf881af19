//! Prints, for the oracle, where the bones of a model are at the default pose, and its soles.
//!
//! `feet bones MODEL FOLDER` gives a line of JSON for each body: its frame in ground, and its points there.
//! `feet soles MODEL FOLDER BODIES COUNT RADIUS PAD` gives one for each sole.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a helper of tests"
)]

use std::path::Path;

use osim_model::feet::{DefaultPose, MeshFolders, SoleRequest, SoleSphere, bones, soles};
use osim_model::files::{FileError, Files};
use osim_model::{DVec3, Model, Side};

/// Files of a disk.
struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        std::fs::read(path).map_err(|error| FileError::new(error.to_string()))
    }

    fn exists(&self, path: &Path) -> bool {
        path.is_file()
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["bones", path, folder] => print_bones(Path::new(path), folder),
        ["soles", path, folder, bodies, count, radius, pad] => {
            let request = SoleRequest {
                count: count.parse().unwrap(),
                radius_m: radius.parse().unwrap(),
                pad_m: pad.parse().unwrap(),
            };
            print_soles(Path::new(path), folder, &bodies.split(',').collect::<Vec<_>>(), &request);
        }
        _ => panic!("expected: bones MODEL FOLDER, or soles MODEL FOLDER BODIES COUNT RADIUS PAD"),
    }
}

fn read(path: &Path) -> Model {
    Model::parse(std::fs::read(path).unwrap()).unwrap()
}

fn print_bones(path: &Path, folder: &str) {
    let model = read(path);
    let folders = MeshFolders::of_model(path).with_folder(folder);
    let pose = DefaultPose::of(&model);
    for body in model.bodies() {
        let name = &body.name;
        let placement = match pose.placement(name) {
            Ok(placement) => *placement,
            Err(fault) => {
                println!("{{\"body\": {name:?}, \"pose_fault\": {:?}}}", fault.to_string());
                continue;
            }
        };
        let frame = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .map(|point| placement.point(point).to_array());
        let (found, fault) = match bones(&model, &[name], &folders, &Disk) {
            Ok(found) => (found, String::new()),
            Err(fault) => (Vec::new(), fault.to_string()),
        };
        let files: Vec<String> = found.iter().map(|bone| bone.file.to_string_lossy().into_owned()).collect();
        let points =
            found.iter().flat_map(|bone| &bone.points_m).map(|&point| placement.point(point).to_array());
        let points: Vec<[f64; 3]> = points.collect();
        println!(
            "{{\"body\": {name:?}, \"frame\": {frame:?}, \"files\": {files:?}, \"points\": {points:?}, \"fault\": {fault:?}}}"
        );
    }
}

fn print_soles(path: &Path, folder: &str, bodies: &[&str], request: &SoleRequest) {
    let model = read(path);
    let folders = MeshFolders::of_model(path).with_folder(folder);
    let soles = bones(&model, bodies, &folders, &Disk).and_then(|bones| soles(&model, &bones, request));
    let soles = match soles {
        Ok(soles) => soles,
        Err(fault) => {
            println!("{{\"fault\": {:?}}}", fault.to_string());
            return;
        }
    };
    for sole in soles {
        let spheres: Vec<String> = sole.spheres.iter().map(shown).collect();
        println!(
            "{{\"bodies\": {:?}, \"side\": {:?}, \"up\": {:?}, \"height\": {:?}, \"outline\": {:?}, \"spheres\": [{}]}}",
            sole.bodies,
            sole.side.map_or("none", Side::as_str),
            sole.up.to_array(),
            sole.height_m,
            sole.outline_m.iter().map(DVec3::to_array).collect::<Vec<_>>(),
            spheres.join(", ")
        );
    }
}

fn shown(sphere: &SoleSphere) -> String {
    format!(
        "{{\"body\": {:?}, \"centre\": {:?}, \"radius\": {:?}, \"bottom\": {:?}}}",
        sphere.body,
        sphere.centre_m.to_array(),
        sphere.radius_m,
        sphere.bottom_m.to_array()
    )
}
