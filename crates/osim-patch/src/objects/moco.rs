//! Spheres and half-spaces that forces of Moco 0.1 to 0.3 keep inside themselves, as objects of the geometry set.

use osim_model::{Fault, FileId, Force, HalfSpace, Model, Sphere};

use crate::insert::Node;
use crate::objects::layout::NewContact;
use crate::objects::names::{Names, refuse_misread};
use crate::objects::rebuilt::{Deed, ObjectChange};
use crate::objects::spelling::{self, Carrier};

/// Objects that are taken out of forces.
#[derive(Default)]
pub(super) struct Inside {
    /// What goes into the geometry set.
    pub(super) geometry: Vec<Node>,
    pub(super) objects: Vec<ObjectChange>,
    /// Half-spaces that are written already: frame, place and angles of each, and its new path.
    planes: Vec<(String, [[u64; 3]; 2], String)>,
}

impl Inside {
    /// The new paths of the sphere and of the half-space that `force` keeps inside itself; forces that press on one plane share it.
    ///
    /// # Errors
    /// A number that cannot be written, a name that OpenSim refuses, or a frame whose offset the first version of the class ignored.
    pub(super) fn take(
        &mut self,
        model: &Model,
        force: &Force,
        (sphere, plane): (&Sphere, &HalfSpace),
        names: &mut Names,
    ) -> Result<(String, String), Fault> {
        refuse_ignored_offset(model, force, sphere, plane).map_err(|fault| fault.of(force.path.clone()))?;
        for frame in [&sphere.frame, &plane.frame_path] {
            refuse_misread(model, frame).map_err(|fault| fault.of(force.path.clone()))?;
        }
        Ok((self.sphere(model, force, sphere, names)?, self.plane(model, force, plane, names)?))
    }

    fn sphere(
        &mut self,
        model: &Model,
        force: &Force,
        sphere: &Sphere,
        names: &mut Names,
    ) -> Result<String, Fault> {
        let mut contact = NewContact::new(force.kind, force.name.clone(), "");
        contact.sphere = names.take(&format!("{}_sphere", force.name))?;
        contact.location_m = sphere.location_m;
        contact.radius_m = sphere.radius_m()?;
        let carrier = Carrier { name: sphere.body.as_deref().unwrap_or("ground"), path: &sphere.frame };
        self.geometry.push(spelling::sphere(model.document().version(), &carrier, &contact)?);
        Ok(self.added("ContactSphere", contact.sphere, sphere.body.clone()))
    }

    fn plane(
        &mut self,
        model: &Model,
        force: &Force,
        plane: &HalfSpace,
        names: &mut Names,
    ) -> Result<String, Fault> {
        let unread =
            || Fault::refused(format!("the place of the half-space of {} cannot be read", force.path));
        let place = [plane.location_m, plane.orientations.first().and_then(|own| own.angles_rad)];
        let [Some(location_m), Some(angles_rad)] = place else { return Err(unread()) };
        let bits = [location_m, angles_rad].map(|values| values.map(f64::to_bits));
        let known = self.planes.iter().find(|(frame, place, _)| (frame, place) == (&plane.frame_path, &bits));
        if let Some((_, _, path)) = known {
            return Ok(path.clone());
        }
        let name = names.take(if plane.on_ground { "floor" } else { "half_space" })?;
        let carrier = Carrier { name: plane.body.as_deref().unwrap_or("ground"), path: &plane.frame_path };
        let version = model.document().version();
        self.geometry.push(spelling::half_space(version, &carrier, &name, [location_m, angles_rad])?);
        let path = self.added("ContactHalfSpace", name, plane.body.clone());
        self.planes.push((plane.frame_path.clone(), bits, path.clone()));
        Ok(path)
    }

    /// The path of a new object of the geometry set.
    fn added(&mut self, class: &'static str, name: String, body: Option<String>) -> String {
        let path = format!("/contactgeometryset/{name}");
        let (deed, parameters) = (Deed::Added, Vec::new());
        self.objects.push(ObjectChange { deed, class, name, path: path.clone(), body, parameters });
        path
    }
}

/// The first version of the class, which had a `derivative_smoothing`, took places of a frame for places of its body.
fn refuse_ignored_offset(
    model: &Model,
    force: &Force,
    sphere: &Sphere,
    plane: &HalfSpace,
) -> Result<(), Fault> {
    let tree = model.file(FileId::MAIN).tree();
    let is_first = tree.child(force.element(), "derivative_smoothing").is_some();
    let is_body = |frame: &str, body: Option<&str>| {
        frame == "/ground"
            || model.bodies().iter().any(|own| own.path == frame && Some(own.name.as_str()) == body)
    };
    let ends = [(&sphere.frame, sphere.body.as_deref()), (&plane.frame_path, plane.body.as_deref())];
    match ends.into_iter().find(|(frame, body)| is_first && !is_body(frame, *body)) {
        None => Ok(()),
        Some((frame, _)) => Err(Fault::refused(format!(
            "{} has a derivative_smoothing, as the first version of its class, which ignored where frame {frame} is on its body: \
             name the body itself in the force, and the place on it that is meant",
            force.path
        ))),
    }
}
