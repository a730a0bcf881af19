//! A published model, and edits of its text as people, scripts or tables make them.

use std::path::Path;

use osim_model::{Model, Side};

/// A model of the corpus of published models.
pub struct Published {
    pub name: &'static str,
    pub text: String,
    pub model: Model,
}

/// Classes of objects with the parameters of contacts.
pub const FORCES: &[&str] =
    &["SmoothSphereHalfSpaceForce", "HuntCrossleyForce", "HuntCrossleyForce::ContactParameters"];
pub const SPHERE: &[&str] = &["ContactSphere"];
pub const FLOOR: &[&str] = &["ContactHalfSpace"];
pub const BODY: &[&str] = &["Body"];
/// The names of the property with the frame of a geometry, in documents of version 4 and 3.
pub const FRAME: &[&str] = &["socket_frame", "body_name"];
/// The text after an edit; `None` if the edit does not apply to the model.
pub type Edited = Option<String>;

impl Published {
    pub fn read(folder: &Path, name: &'static str) -> Self {
        let text = std::fs::read_to_string(folder.join(format!("{name}.osim"))).unwrap();
        Self::parse(name, text)
    }

    /// Reads the model `text`.
    pub fn parse(name: &'static str, text: String) -> Self {
        let model = Model::parse(text.as_str()).unwrap();
        Self { name, text, model }
    }

    /// The text with new values of `properties` in objects of some classes. `new` gets the name of the object and the old value.
    pub fn edit(
        &self,
        classes: &[&str],
        properties: &[&str],
        new: impl Fn(&str, &str) -> Option<String>,
    ) -> Edited {
        let tree = self.model.document().tree();
        let mut edits = Vec::new();
        for owner in tree.elements().filter(|&id| classes.contains(&tree.name(id))) {
            let name = tree.attribute(owner, "name").unwrap_or_default();
            if name == "default" {
                continue;
            }
            for property in properties.iter().filter_map(|property| tree.child(owner, property)) {
                let inside = tree.open_span(property).end..tree.close_span(property).start;
                edits.extend(new(&name, &self.text[inside.clone()]).map(|text| (inside, text)));
            }
        }
        (!edits.is_empty()).then(|| {
            edits.into_iter().rev().fold(self.text.clone(), |mut text, (inside, new)| {
                text.replace_range(inside, &new);
                text
            })
        })
    }

    /// The text with the value `new` for a property of all forces, or of their parameters.
    pub fn forces(&self, property: &str, new: &str) -> Edited {
        self.edit(FORCES, &[property], |_, _| Some(new.to_owned()))
    }

    /// The text with the value `new` for a property of forces which is absent in many files, because it has a default.
    pub fn smoothing(&self, property: &str, new: &str) -> Edited {
        let text = self.edit(&["SmoothSphereHalfSpaceForce"], &[property], |_, _| Some(new.to_owned()));
        let end = "</SmoothSphereHalfSpaceForce>";
        let inserted = || {
            self.text
                .contains(end)
                .then(|| self.text.replace(end, &format!("<{property}>{new}</{property}>{end}")))
        };
        text.or_else(inserted)
    }

    /// The text with the numbers of a property of all forces multiplied by `factor`.
    pub fn forces_times(&self, property: &str, factor: f64) -> Edited {
        self.edit(FORCES, &[property], |_, old| multiplied_text(old, factor))
    }

    /// The text with new places of spheres, in the frames of their bodies; `of` chooses the spheres.
    pub fn places(&self, of: impl Fn(&str) -> bool, new: impl Fn([f64; 3]) -> [f64; 3]) -> Edited {
        self.edit(SPHERE, &["location"], |name, old| {
            of(name).then(|| three_numbers(old).map(&new).map(numbers_text))?
        })
    }

    pub fn radii(&self, of: impl Fn(&str) -> bool, new: impl Fn(f64) -> f64) -> Edited {
        self.edit(SPHERE, &["radius"], |name, old| {
            of(name).then(|| Some(new(old.trim().parse().ok()?).to_string()))?
        })
    }

    /// The text with spheres on other bodies. `body` gets the name of the present body and returns the new one.
    pub fn carriers(&self, body: impl Fn(&str) -> Option<String>) -> Edited {
        self.edit(SPHERE, FRAME, |_, old| {
            let old = old.trim();
            let (path, last) = old.rsplit_once('/').map_or(("", old), |(path, last)| (path, last));
            let new = body(last)?;
            Some(if path.is_empty() { new } else { format!("{path}/{new}") })
        })
    }

    pub fn masses(&self, of: impl Fn(&str) -> bool, new: impl Fn(f64) -> f64) -> Edited {
        self.edit(BODY, &["mass"], |name, old| {
            of(name).then(|| Some(new(old.trim().parse().ok()?).to_string()))?
        })
    }

    pub fn gravity(&self, new: &str) -> Edited {
        self.edit(&["Model"], &["gravity"], |_, _| Some(new.to_owned()))
    }

    pub fn floor(&self, property: &str, new: &str) -> Edited {
        self.edit(FLOOR, &[property], |_, _| Some(new.to_owned()))
    }

    /// The text with other default values of the coordinates whose names contain `part`.
    pub fn default(&self, part: &str, new: impl Fn(f64) -> f64) -> Edited {
        self.edit(&["Coordinate"], &["default_value"], |name, old| {
            name.contains(part).then(|| Some(new(old.trim().parse().ok()?).to_string()))?
        })
    }

    /// The text without some forces; `of` chooses them by their names and the names of their spheres.
    pub fn without_forces(&self, of: impl Fn(&str) -> bool) -> Edited {
        let tree = self.model.document().tree();
        let chosen = self.model.forces().iter().filter(|force| {
            let spheres = force.spheres().iter().filter_map(|&id| self.model.sphere(id));
            of(&force.name) || spheres.clone().count() > 0 && spheres.clone().all(|sphere| of(&sphere.name))
        });
        let spans: Vec<_> = chosen.map(|force| tree.span(force.element)).collect();
        (!spans.is_empty()).then(|| {
            spans.into_iter().rev().fold(self.text.clone(), |mut text, span| {
                text.replace_range(span, "");
                text
            })
        })
    }

    /// The name of a body of the model that contains one of `parts`, on the same side as the body `like`.
    pub fn body(&self, parts: &[&str], like: &str) -> Option<String> {
        let side = Side::of_name(like);
        let names = self.model.bodies().iter().map(|body| body.name.clone());
        names
            .filter(|name| Side::of_name(name) == side)
            .find(|name| parts.iter().any(|part| name.contains(part)))
    }
}

pub fn is_left(name: &str) -> bool {
    Side::of_name(name) == Some(Side::Left)
}

pub fn is_heel(name: &str) -> bool {
    name.starts_with("s1_") || name.contains("heel")
}

pub fn is_any(_: &str) -> bool {
    true
}

pub fn three_numbers(old: &str) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = old.split_whitespace().map(|word| word.parse().ok()).collect();
    numbers?.try_into().ok()
}

pub fn numbers_text(numbers: [f64; 3]) -> String {
    numbers.map(|number| number.to_string()).join(" ")
}

pub fn multiplied_text(old: &str, factor: f64) -> Option<String> {
    let numbers: Option<Vec<f64>> = old.split_whitespace().map(|word| word.parse().ok()).collect();
    Some(numbers?.iter().map(|number| (number * factor).to_string()).collect::<Vec<_>>().join(" "))
}
