//! How large bodies are: their centres of mass, radii of gyration and joints.

use crate::xml::opensim_text;
use foldhash::{HashMap, HashMapExt};

use crate::model::components::{ComponentId, Components};
use crate::model::typed_model::Model;

/// Where the mass of a body is, and its joints.
#[derive(Debug, Clone, Default)]
pub(crate) struct BodyShape {
    /// Its centre of mass, m.
    pub centre_m: [f64; 3],
    /// The root mean square of the distance of its mass from that centre, m: √(½ trace(I)/m). `None` where mass or inertia is not
    /// above 0.
    pub gyration_m: Option<f64>,
    /// Its joints, also those to ground, m.
    pub joints_m: Vec<[f64; 3]>,
}

impl Model {
    /// The shapes of all bodies, by name.
    pub(crate) fn body_shapes(&self) -> &HashMap<String, BodyShape> {
        self.of_bodies(BodyShape::all)
    }
}

impl BodyShape {
    fn all(model: &Model) -> HashMap<String, Self> {
        let components = model.components();
        let mut shapes: HashMap<String, Self> = HashMap::new();
        for (id, _) in components.tree.iter().filter(|(id, _)| components.tag(*id) == "Body") {
            shapes.entry(components.name(id).into_owned()).or_insert_with(|| of_body(components, id));
        }
        for (body, place_m) in model.body_facts.joints.ends(components) {
            if let Some(shape) = shapes.get_mut(body) {
                shape.joints_m.push(place_m);
            }
        }
        shapes
    }
}

fn of_body(components: &Components, body: ComponentId) -> BodyShape {
    let centre_m = components.doc(body).triple(components.element(body), "mass_center").unwrap_or_default();
    let gyration_m = number(components, body, "mass")
        .zip(trace(components, body))
        .map(|(mass, trace)| (trace / 2.0 / mass).sqrt());
    let gyration_m = gyration_m.filter(|radius| radius.is_finite() && *radius > 0.0);
    BodyShape { centre_m, gyration_m, joints_m: Vec::new() }
}

/// Ixx + Iyy + Izz, which documents before version 4 have in elements of their own.
pub(crate) fn trace(components: &Components, body: ComponentId) -> Option<f64> {
    let moments = match numbers(components, body, "inertia").as_deref() {
        Some([xx, yy, zz, ..]) => [Some(*xx), Some(*yy), Some(*zz)],
        _ => ["inertia_xx", "inertia_yy", "inertia_zz"].map(|tag| number(components, body, tag)),
    };
    moments.into_iter().sum()
}

fn number(components: &Components, body: ComponentId, tag: &str) -> Option<f64> {
    numbers(components, body, tag)?.first().copied()
}

fn numbers(components: &Components, body: ComponentId, tag: &str) -> Option<Vec<f64>> {
    let tree = components.doc(body).tree();
    opensim_text::numbers(&tree.text_of(tree.child(components.element(body), tag)?))
}
