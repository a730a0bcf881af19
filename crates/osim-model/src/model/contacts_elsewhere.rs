//! Contacts of classes that are not Hertz's, if they share spheres with those that are.

use foldhash::{HashMap, HashMapExt};

use crate::model::typed_model::Model;
use crate::xml::opensim_text;

const ELASTIC_FOUNDATION_PARAMETERS: &str = "ElasticFoundationForce::ContactParameters";

impl Model {
    /// For each sphere name, the forces of other contact classes whose geometry lists it.
    #[must_use]
    pub fn users_of_other_classes(&self) -> HashMap<String, Vec<String>> {
        let components = self.components();
        let mut users: HashMap<String, Vec<String>> = HashMap::new();
        let foundations =
            components.tree.iter().filter(|(id, _)| components.tag(*id) == ELASTIC_FOUNDATION_PARAMETERS);
        for (id, _) in foundations {
            let tree = components.doc(id).tree();
            let Some(geometry) = tree.child(components.element(id), "geometry") else { continue };
            let mut at = components.tree.get(id).and_then(|object| object.parent);
            while let Some(force) = at.filter(|&force| components.tag(force) != "ElasticFoundationForce") {
                at = components.tree.get(force).and_then(|object| object.parent);
            }
            let Some(force) = at else { continue };
            for name in opensim_text::list(&tree.text_of(geometry)) {
                let last = name.rsplit('/').next().unwrap_or(name);
                users.entry(last.to_owned()).or_default().push(components.name(force).into_owned());
            }
        }
        users
    }
}
