//! Contacts of one side, on the other side too.

use foldhash::HashSet;
use osim_model::{Anatomy, AnatomyJoint, Fault, Side};

use super::layout::{Layout, NewContact};

impl Layout {
    /// The same contacts and their mirror images in z: names and bodies with `_l` for `_r`, or the other way round. What has no side
    /// in its body's name stays alone.
    ///
    /// # Errors
    /// Contacts on both sides, or on none.
    pub fn mirrored(mut self) -> Result<Self, Fault> {
        let sides: Vec<Side> =
            self.contacts.iter().filter_map(|contact| Side::of_name(&contact.body)).collect();
        let Some(&side) = sides.first() else {
            let text = "no body that carries a contact of the reference has a side in its name (_r or _l): nothing can be mirrored";
            return Err(Fault::refused(text));
        };
        if sides.iter().any(|&other| other != side) {
            return Err(Fault::refused(
                "the reference has contacts on both sides: nothing has to be mirrored",
            ));
        }
        let of_side = self.contacts.iter().filter(|contact| Side::of_name(&contact.body) == Some(side));
        let images = of_side.map(|contact| image(contact, side)).collect::<Result<Vec<_>, _>>()?;
        self.contacts.extend(images);
        Ok(self)
    }

    /// `anatomy` with the bodies of this layout that it lacks: each the mirror image of that of the other side.
    #[must_use]
    pub fn mirrored_anatomy(&self, mut anatomy: Anatomy) -> Anatomy {
        for contact in &self.contacts {
            let other = other_side(&contact.body).filter(|other| anatomy.has_body(other));
            if let Some(other) = other.filter(|_| !anatomy.has_body(&contact.body)) {
                add_image(&mut anatomy, &other, &contact.body);
                // Its names are looked up in an index, which is made with the spheres.
                let spheres = anatomy.spheres.clone();
                anatomy = anatomy.with_spheres(spheres);
            }
        }
        anatomy
    }
}

/// Adds `image`, the mirror image of the body `of` with its meshes and the joints around it.
fn add_image(anatomy: &mut Anatomy, of: &str, image: &str) {
    anatomy.bodies.push(image.to_owned());
    if let Some(meshes) = anatomy.meshes.get(of).cloned() {
        anatomy.meshes.insert(image.to_owned(), meshes);
    }
    let swapped = |name: &str| other_side(name).unwrap_or_else(|| name.to_owned());
    if let Some(offsets) = anatomy.offsets.get(of) {
        let offsets = offsets.iter().map(|(name, &place)| (swapped(name), in_mirror(place))).collect();
        anatomy.offsets.insert(image.to_owned(), offsets);
    }
    let around = |joint: &&AnatomyJoint| joint.child == of || joint.parent == of;
    let images = anatomy.joints.iter().filter(around).filter_map(|joint| {
        let mut joint = joint.clone();
        joint.name = other_side(&joint.name)?;
        joint.parent = swapped(&joint.parent);
        joint.child = swapped(&joint.child);
        joint.in_parent_m = in_mirror(joint.in_parent_m);
        joint.in_child_m = in_mirror(joint.in_child_m);
        Some(joint)
    });
    let known: HashSet<String> = anatomy.joints.iter().map(|joint| joint.name.clone()).collect();
    let images: Vec<AnatomyJoint> = images.filter(|joint| !known.contains(&joint.name)).collect();
    anatomy.joints.extend(images);
}

fn in_mirror([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y, if z == 0.0 { z } else { -z }]
}

fn image(contact: &NewContact, side: Side) -> Result<NewContact, Fault> {
    let body = other_side(&contact.body).ok_or_else(|| {
        Fault::refused(format!(
            "{} says its side otherwise than with _r or _l: what is mirrored is found by these letters",
            contact.body
        ))
    })?;
    let mark = if side == Side::Right { "_l" } else { "_r" };
    let name = |own: &str| other_side(own).unwrap_or_else(|| format!("{own}{mark}"));
    Ok(NewContact {
        force: name(&contact.force),
        sphere: name(&contact.sphere),
        body,
        location_m: in_mirror(contact.location_m),
        ..contact.clone()
    })
}

/// The name with `_l` for `_r`, or the other way round, where these end a word; `None` where it has neither.
fn other_side(name: &str) -> Option<String> {
    let mut letters: Vec<char> = name.chars().collect();
    let mut found = false;
    for at in 1..letters.len() {
        let is_end = letters.get(at + 1).is_none_or(|next| !next.is_alphanumeric());
        let other = match letters.get(at - 1..=at) {
            Some(['_', 'r']) if is_end => 'l',
            Some(['_', 'l']) if is_end => 'r',
            _ => continue,
        };
        if let Some(letter) = letters.get_mut(at) {
            *letter = other;
            found = true;
        }
    }
    found.then(|| letters.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use osim_model::ForceKind;

    use super::*;

    fn contact(force: &str, sphere: &str, body: &str) -> NewContact {
        let mut contact = NewContact::new(ForceKind::HuntCrossley, force, sphere);
        contact.body = body.to_owned();
        contact.location_m = [0.1, -0.2, 0.03];
        contact
    }

    fn layout(contacts: Vec<NewContact>) -> Layout {
        Layout { contacts, ..Layout::default() }
    }

    #[test]
    fn the_image_is_on_the_other_side() {
        let both = layout(vec![contact("f_heel_r", "heel", "calcn_r"), contact("f", "s", "pelvis")])
            .mirrored()
            .unwrap();
        assert_eq!(both.contacts.len(), 3);
        let image = &both.contacts[2];
        assert_eq!(
            (image.force.as_str(), image.sphere.as_str(), image.body.as_str()),
            ("f_heel_l", "heel_l", "calcn_l")
        );
        assert_eq!(image.location_m, [0.1, -0.2, -0.03]);
    }

    #[test]
    fn both_sides_or_none_are_refused() {
        for contacts in
            [vec![contact("f", "s", "pelvis")], vec![contact("f", "s", "a_r"), contact("g", "t", "a_l")]]
        {
            assert!(layout(contacts).mirrored().is_err());
        }
        let camel = layout(vec![contact("f", "s", "RFoot")]).mirrored().unwrap_err();
        assert!(camel.to_string().contains("otherwise than with _r or _l"), "{camel}");
    }

    #[test]
    fn sides_are_words_of_a_name() {
        assert_eq!(other_side("s1_r_a").as_deref(), Some("s1_l_a"));
        assert_eq!(other_side("calcn_l").as_deref(), Some("calcn_r"));
        assert_eq!(
            other_side("/jointset/mtp_r/calcn_r_offset").as_deref(),
            Some("/jointset/mtp_l/calcn_l_offset")
        );
        assert_eq!(other_side("mtp_r parent").as_deref(), Some("mtp_l parent"));
        assert_eq!(other_side("rotor_left"), None);
        assert_eq!(other_side("l"), None);
    }
}
