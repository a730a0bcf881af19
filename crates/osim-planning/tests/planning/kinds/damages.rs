//! The kinds of damage in `kinds.md` for which the right severity is a matter of judgement, and edits that do no harm.

use super::published::{
    BODY, Edited, FLOOR, FORCES, FRAME, Published, SPHERE, is_any, is_heel, is_left, multiplied_text,
    numbers_text, three_numbers,
};

/// A kind of damage: its name in the list, the codes of the findings about it, and the function that makes it.
pub type DamageKind = (&'static str, &'static str, fn(&Published) -> Edited);

pub const DAMAGES: &[DamageKind] = &[
    (
        "all contacts on one limb named l by typo: right forces name left spheres",
        "sphere-of-other-side sphere-in-two-forces one-side-only left-right-missing left-right-swapped",
        |m| {
            m.edit(FORCES, &["socket_sphere", "geometry"], |_, old| {
                Some(old.replace("_r", "_l").replace("r_", "l_"))
            })
        },
    ),
    (
        "all forces name one sphere",
        "sphere-in-two-forces sphere-of-other-side",
        with_one_sphere_in_all_forces,
    ),
    ("left feet on a second floor 50 mm higher", "floor-step", |m| {
        with_second_floor(m, "<location>0 0.05 0</location>", "0 0 -1.5707963267948966")
    }),
    ("left feet on a second floor tilted 20 deg", "floor-slopes", |m| {
        with_second_floor(m, "<location>0 0 0</location>", "0 0 -1.2217304763960306")
    }),
    ("left feet press on a wall", "floor-upright", |m| {
        with_second_floor(m, "<location>0 0 0</location>", "0 0 0")
    }),
    ("floor 10 mm typed as 10 m", "not-on-floor", |m| m.floor("location", "0 -10 0")),
    ("floor on thick platform frame, sign wrong", "not-on-floor", |m| m.floor("location", "0 0.3 0")),
    ("floor on toes_l", "floor-on-limb", |m| {
        let toes = m.body(&["toes"], "toes_l")?;
        m.edit(FLOOR, FRAME, |_, old| {
            Some(if old.contains('/') { format!("/bodyset/{toes}") } else { toes.clone() })
        })
    }),
    ("floor frame turned in degrees", "floor-upright angle-in-degrees", |m| {
        m.floor("orientation", "0 0 -90")
    }),
    ("floor turned by 45.5 deg", "floor-upright", |m| m.floor("orientation", "0 0 -0.77667151713747666")),
    ("all frictions 0 (ice)", "no-friction", |m| with_friction(m, "0")),
    ("static friction 1e-5 with dynamic 0.8", "dynamic-above-static", |m| {
        m.forces("static_friction", "1e-5")
    }),
    ("static friction negative", "out-of-domain", |m| m.forces("static_friction", "-0.8")),
    ("viscous friction 500", "large-friction", |m| m.forces("viscous_friction", "500")),
    ("viscous friction 5", "large-friction", |m| m.forces("viscous_friction", "5")),
    ("transition velocity 0", "odd-transition-velocity", |m| m.forces("transition_velocity", "0")),
    ("transition velocity 1e-9", "odd-transition-velocity", |m| m.forces("transition_velocity", "1e-9")),
    ("transition velocity negative", "out-of-domain", |m| m.forces("transition_velocity", "-0.2")),
    ("dissipation negative", "out-of-domain", |m| m.forces("dissipation", "-2")),
    ("all dissipation 0", "no-dissipation", |m| m.forces("dissipation", "0")),
    ("dissipation 1e-300", "no-dissipation", |m| m.forces("dissipation", "1e-300")),
    ("dissipation x100", "beyond-hunt-crossley", |m| m.forces_times("dissipation", 100.0)),
    ("one force dissipation x10", "left-right-differ", |m| {
        let first = first_force(m);
        m.edit(FORCES, &["dissipation"], one_of(&first, 10.0))
    }),
    ("dissipation and stiffness swapped", "sunk-in default-stiffness", |m| {
        let text = m.text.replace("dissipation>", "d-i-s>").replace("stiffness>", "dissipation>");
        Some(text.replace("d-i-s>", "stiffness>"))
    }),
    ("columns shifted by one", "sunk-in default-stiffness", |m| {
        Some(with_tags(m, &[&COLUMNS_OF_REPORT[1..], &COLUMNS_OF_REPORT[..1]].concat(), &COLUMNS_OF_REPORT))
    }),
    ("stiffness misspelt", "unknown-name", |m| Some(with_tags(m, &["stiffness"], &["stifness"]))),
    ("thousands with apostrophes", "odd-number", |m| m.forces("stiffness", "1'000'000")),
    ("stiffness lost its exponent", "sunk-in", |m| m.forces("stiffness", "1")),
    ("stiffness in psi (x1/6895)", "sunk-in", |m| m.forces_times("stiffness", 1.0 / 6895.0)),
    ("stiffness of a Kelvin spring (20000 N/m)", "sunk-in", |m| m.forces("stiffness", "20000")),
    (
        "left force with stiffness of one digit too many (both heels)",
        "beyond-hertz left-right-differ known-contacts",
        |m| {
            m.edit(FORCES, &["stiffness"], |name, old| {
                is_heel(name.trim_start_matches("SmoothSphereHalfSpaceForce_"))
                    .then(|| multiplied_text(old, 10.0))?
            })
        },
    ),
    ("hertz and hunt_crossley smoothing swapped", "wide-transition force-before-contact floats", |m| {
        let tags = ["hertz_smoothing", "hunt_crossley_smoothing"];
        m.text.contains("<hertz_smoothing>").then(|| with_tags(m, &tags, &[tags[1], tags[0]]))
    }),
    ("hertz_smoothing 3 not 300", "wide-transition force-before-contact floats", |m| {
        m.smoothing("hertz_smoothing", "3")
    }),
    ("hertz_smoothing 30", "wide-transition force-before-contact floats", |m| {
        m.smoothing("hertz_smoothing", "30")
    }),
    ("hertz_smoothing negative", "out-of-domain", |m| m.smoothing("hertz_smoothing", "-300")),
    ("hunt_crossley_smoothing negative", "out-of-domain", |m| m.smoothing("hunt_crossley_smoothing", "-50")),
    ("cf x1e5 (typed 1)", "floats large-constant-indentation", |m| {
        m.smoothing("constant_contact_force", "1")
    }),
    ("cf 1e-3", "floats large-constant-indentation", |m| m.smoothing("constant_contact_force", "1e-3")),
    ("cf 1e-5 typed 1e5", "floats large-constant-indentation", |m| {
        m.smoothing("constant_contact_force", "1e5")
    }),
    ("cf negative", "out-of-domain", |m| m.smoothing("constant_contact_force", "-1e-5")),
    (
        "all radii are diameters (x2)",
        "odd-radius known-contacts spheres-misplaced unlevel-foot uneven-bottoms not-on-floor beyond-hertz",
        |m| m.radii(is_any, |radius| radius * 2.0),
    ),
    ("all radii x3", "odd-radius", |m| m.radii(is_any, |radius| radius * 3.0)),
    ("heels' radius typed 0.32 (both)", "odd-radius", |m| m.radii(is_heel, |_| 0.32)),
    ("radii in inches", "odd-radius", |m| m.radii(is_any, |radius| radius / 0.0254)),
    ("radii in feet", "odd-radius", |m| m.radii(is_any, |radius| radius / 0.3048)),
    ("radius of a ball 0.11 (copied from soccer)", "odd-radius", |m| m.radii(is_any, |_| 0.11)),
    ("radius 1e-12 for all", "odd-radius", |m| m.radii(is_any, |_| 1e-12)),
    ("one heel sphere typed to 5 kg mass body (radius 0)", "out-of-domain", |m| {
        let heel = m.model.spheres().iter().find(|sphere| is_heel(&sphere.name))?.name.clone();
        m.radii(|name| name == heel, |_| 0.0)
    }),
    ("radius misspelt", "unknown-name", |m| Some(with_tags(m, &["radius"], &["raduis"]))),
    ("left radii 20 % larger", "left-right-differ", |m| m.radii(is_left, |radius| radius * 1.2)),
    (
        "radii of one pair halved",
        "uneven-bottoms unlevel-foot beyond-hertz beyond-hertz-at-two large-constant-indentation wide-transition force-before-contact",
        |m| m.radii(is_heel, |radius| radius / 2.0),
    ),
    ("y and z of all places swapped", "odd-place uneven-bottoms left-right-places spheres-misplaced", |m| {
        m.places(is_any, |[x, y, z]| [x, z, y])
    }),
    ("x of all places with the wrong sign", "odd-place spheres-misplaced left-right-places", |m| {
        m.places(is_any, |[x, y, z]| [-x, y, z])
    }),
    ("heels' place in cm", "odd-place", |m| m.places(is_heel, |place| place.map(|value| value * 100.0))),
    ("heels 0.1 m too high (both)", "uneven-bottoms", |m| m.places(is_heel, |[x, y, z]| [x, y + 0.1, z])),
    ("heels 60 mm too low (both)", "uneven-bottoms", |m| m.places(is_heel, |[x, y, z]| [x, y - 0.06, z])),
    ("heels 80 mm ahead (both)", "spheres-misplaced", |m| m.places(is_heel, |[x, y, z]| [x + 0.08, y, z])),
    ("places of ground, not of the bodies", "odd-place", |m| m.places(is_any, |[x, y, z]| [x, y - 0.93, z])),
    ("toes' spheres put on calcn", "odd-place spheres-misplaced left-right-places uneven-bottoms", |m| {
        m.carriers(|body| body.contains("toes").then(|| m.body(&["calcn"], body))?)
    }),
    ("calcn's spheres put on talus, places kept", "uneven-bottoms spheres-misplaced odd-place", |m| {
        m.carriers(|body| body.contains("calcn").then(|| m.body(&["talus"], body))?)
    }),
    ("all spheres on the tibiae, places kept", "spheres-misplaced", |m| {
        m.carriers(|body| m.body(&["tibia"], body))
    }),
    ("all spheres on the hands", "spheres-misplaced", |m| m.carriers(|body| m.body(&["hand"], body))),
    ("left places not mirrored", "left-right-places spheres-misplaced", |m| {
        // Places in the middle of the foot are their own mirror images.
        m.model.spheres().iter().find(|sphere| is_left(&sphere.name) && sphere.location_m[2] != 0.0)?;
        m.places(is_left, |[x, y, z]| [x, y, -z])
    }),
    ("left places +30 mm sideways (stance too wide)", "left-right-places", |m| {
        m.places(is_left, |[x, y, z]| [x, y, z - 0.03])
    }),
    (
        "location misspelt",
        "crowded-spheres doubled-spheres odd-place spheres-misplaced left-right-places uneven-bottoms",
        |m| m.edit(SPHERE, &["location"], |_, _| Some("0 0 0".to_owned())),
    ),
    ("sphere at 1e6 m", "odd-place", |m| {
        let first = m.model.spheres().first()?.name.clone();
        m.places(|name| name == first, |[_, y, z]| [1e6, y, z])
    }),
    ("spheres on offset frames turned by 90 (degrees typed)", "angle-in-degrees", |m| {
        with_offset_frames(m, "<translation>0 0 0</translation><orientation>0 0 90</orientation>")
    }),
    ("sphere frames moved in mm", "odd-place", |m| {
        with_offset_frames(m, "<translation>0 -10 0</translation><orientation>0 0 0</orientation>")
    }),
    (
        "all toes deleted, both sides",
        "known-contacts left-right-missing one-side-only beyond-hertz sunk-in spheres-misplaced",
        |m| {
            m.without_forces(|name| {
                name.contains("toe") || name.starts_with("s5_") || name.starts_with("s6_")
            })
        },
    ),
    ("feet scaled 1.4, spheres left", "spheres-misplaced spheres-not-compared", |m| {
        let is_foot = |name: &str| is_left_foot(&name.replace("_r", "_l"));
        m.edit(&["Mesh"], &["scale_factors"], |name, old| is_foot(name).then(|| multiplied_text(old, 1.4))?)
    }),
    ("left foot scaled 1.4, spheres left", "spheres-misplaced left-right-places", |m| {
        m.edit(&["Mesh"], &["scale_factors"], |name, old| {
            is_left_foot(name).then(|| multiplied_text(old, 1.4))?
        })
    }),
    ("whole model in cm", "odd-radius odd-place too-stiff", |m| Some(in_centimetres(&m.text))),
    ("torso's mass in grams", "contacts-of-another-mass sunk-in", |m| m.masses(is_torso, |kg| kg * 1000.0)),
    ("torso's mass x10", "contacts-of-another-mass sunk-in", |m| m.masses(is_torso, |kg| kg * 10.0)),
    ("pelvis mass empty", "mass-unknown odd-number not-finite", |m| {
        m.edit(BODY, &["mass"], |name, _| (name == "pelvis").then(String::new))
    }),
    ("torso has mass 0", "massless-body", |m| m.masses(is_torso, |_| 0.0)),
    ("all masses a tenth", "contacts-of-another-mass", |m| m.masses(is_any, |kg| kg / 10.0)),
    ("masses of a child (x0.2)", "contacts-of-another-mass", |m| m.masses(is_any, |kg| kg * 0.2)),
    ("masses of left and right foot mixed up with inertia (calcn 12.5 kg)", "heavy-foot", |m| {
        m.masses(|name| name.contains("calcn"), |_| 12.5)
    }),
    ("calcn_r weighs -1", "mass-unknown out-of-domain", |m| m.masses(|name| name == "calcn_r", |_| -1.0)),
    ("all masses 0", "massless-body mass-unknown", |m| m.masses(is_any, |_| 0.0)),
    ("left forces commented out", "one-side-only", |m| m.without_forces(is_left)),
    ("pelvis_ty in mm", "default-outside-range", |m| m.default("pelvis_ty", |_| 950.0)),
    ("ankle default 10 (degrees)", "default-outside-range", |m| m.default("ankle_angle", |_| 10.0)),
    ("knee default -90 (degrees)", "default-outside-range", |m| m.default("knee_angle", |_| -90.0)),
    ("pelvis_ty with the wrong sign", "not-on-floor", |m| m.default("pelvis_ty", |value| -value)),
    ("False (capital) in appliesForce of the left side", "left-right-off", |m| with_forces_off(m, is_left)),
    ("gravity in ft/s2", "odd-gravity", |m| m.gravity("0 -32.17 0")),
    ("gravity in cm/s2", "gravity-too-large", |m| m.gravity("0 -981 0")),
    ("gravity in g (0 -1 0)", "odd-gravity", |m| m.gravity("0 -1 0")),
    ("gravity one number only", "odd-number", |m| m.gravity("-9.81")),
    ("gravity with commas 0, -9,81, 0", "odd-number", |m| m.gravity("0, -9,81, 0")),
    ("gravity 0 9.81e0 -0 sign lost in v3", "gravity-not-down", |m| m.gravity("0 9.81e0 -0")),
    ("gravity tilted by 60 deg", "gravity-not-down floor-upright", |m| m.gravity("8.4957 -4.905 0")),
    ("gravity 0 -0.00981 0 (km)", "odd-gravity", |m| m.gravity("0 -0.00981 0")),
    ("gravity 0 -98.1 0", "odd-gravity", |m| m.gravity("0 -98.1 0")),
    ("gravity 9.81 with x and y swapped by frame (0 0 9.81)", "gravity-not-down", |m| m.gravity("0 0 9.81")),
];

/// The name of an edit that does no harm, and the edit.
pub type HarmlessEdit = (&'static str, fn(&Published) -> Edited);

/// Edits that do no harm. None of them gives a warning.
pub const HARMLESS: &[HarmlessEdit] = &[
    ("a hopper", super::skeleton::hopper),
    ("a one-legged model", super::skeleton::one_legged),
    ("a prosthetic leg with fewer bodies", super::skeleton::prosthesis),
    ("a sole of an exoskeleton under each foot", super::skeleton::with_soles),
    ("friction of another floor", |m| with_friction(m, "0.9")),
    ("all masses 1 % more", |m| m.masses(is_any, |kg| kg * 1.01)),
    ("a sensor of 10 g", |m| m.masses(is_torso, |kg| kg + 0.01)),
    ("radii 2 % larger", |m| m.radii(is_any, |radius| radius * 1.02)),
    ("radii 10 % larger", |m| m.radii(is_any, |radius| radius * 1.1)),
    ("radii of heels 10 % larger", |m| m.radii(is_heel, |radius| radius * 1.1)),
    ("stiffness 3 % less", |m| m.forces_times("stiffness", 0.97)),
    ("stiffness 20 % more", |m| m.forces_times("stiffness", 1.2)),
    ("hands on the floor", super::skeleton::hands_on_the_floor),
    ("knees on the floor", super::skeleton::knees_on_the_floor),
    ("dissipation 10 % less", |m| m.forces_times("dissipation", 0.9)),
    ("places with 0.1 mm", |m| m.places(is_any, |place| place.map(|value| (value * 1e4).round() / 1e4))),
    ("gravity as OpenSim has it", |m| m.gravity("0 -9.80665 0")),
    ("a pelvis that starts higher", |m| m.default("pelvis_ty", |value| value + 0.3)),
    ("hips that are flexed", |m| m.default("hip_flexion", |value| value + 0.2)),
    ("knees that are flexed", |m| {
        let mut knees = m.model.joints().iter().flat_map(|joint| &joint.coordinates);
        // Flexion is positive in some models.
        let is_positive = knees
            .any(|one| one.name.contains("knee_angle") && one.range.is_some_and(|[least, _]| least > -0.3));
        m.default("knee_angle", |value| if is_positive { value + 0.3 } else { value - 0.3 })
    }),
    ("a body that leans", |m| m.default("pelvis_tilt", |value| value - 0.15)),
    ("numbers with exponents", |m| {
        m.edit(FORCES, &["stiffness"], |_, old| Some(format!("{:e}", old.trim().parse::<f64>().ok()?)))
    }),
    ("no meshes", |m| m.edit(BODY, &["attached_geometry"], |_, _| Some(String::new()))),
    ("line breaks and blanks", |m| Some(m.text.replace("><", "> <").replace("\r\n", "\n"))),
    ("without comments", |m| {
        let mut text = m.text.clone();
        while let Some((start, end)) =
            text.find("<!--").and_then(|start| Some((start, start + text[start..].find("-->")? + 3)))
        {
            text.replace_range(start..end, "");
        }
        (text != m.text).then_some(text)
    }),
];

const COLUMNS_OF_REPORT: [&str; 6] = [
    "stiffness",
    "dissipation",
    "static_friction",
    "dynamic_friction",
    "viscous_friction",
    "transition_velocity",
];

/// The text with other tags: each of `old` becomes that of `new` at its position.
fn with_tags(m: &Published, old: &[&str], new: &[&str]) -> String {
    let replaced = |text: String, from: &str, to: &str| {
        text.replace(&format!("<{from}>"), &format!("<{to}>"))
            .replace(&format!("</{from}>"), &format!("</{to}>"))
    };
    let marked = old.iter().fold(m.text.clone(), |text, tag| replaced(text, tag, &format!("{tag}-old")));
    old.iter().zip(new).fold(marked, |text, (old, new)| replaced(text, &format!("{old}-old"), new))
}

/// The text with lengths in centimetres; meshes stay.
fn in_centimetres(text: &str) -> String {
    let tags = ["location", "location_in_parent", "translation", "mass_center", "radius"];
    tags.iter().fold(text.to_owned(), |text, tag| {
        let open = format!("<{tag}>");
        let mut parts = text.split(&open);
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |made, part| {
            let scaled = part
                .split_once('<')
                .and_then(|(numbers, rest)| Some((multiplied_text(numbers, 100.0)?, rest)));
            match scaled {
                Some((numbers, rest)) => format!("{made}{open}{numbers}<{rest}"),
                None => format!("{made}{open}{part}"),
            }
        })
    })
}

/// The model whose forces all name its first sphere.
fn with_one_sphere_in_all_forces(m: &Published) -> Edited {
    let names: Vec<&str> = m.model.spheres().iter().map(|sphere| sphere.name.as_str()).collect();
    m.edit(FORCES, &["socket_sphere", "geometry"], |_, old| {
        let mut words: Vec<String> = Vec::new();
        for word in old.split_whitespace() {
            let last = word.rsplit('/').next().unwrap_or(word);
            let is_sphere = names.contains(&last);
            let new = if is_sphere { word.replace(last, names[0]) } else { word.to_owned() };
            if !words.contains(&new) {
                words.push(new);
            }
        }
        Some(words.join(" "))
    })
}

/// The model whose spheres are on a new offset frame of their body, with the `place` in it.
fn with_offset_frames(m: &Published, place: &str) -> Edited {
    let tree = m.model.document().tree();
    let on_frames = m.edit(SPHERE, &["socket_frame"], |_, old| Some(format!("{}/offset", old.trim())))?;
    let carriers: Vec<&str> = m.model.spheres().iter().filter_map(|sphere| sphere.body.as_deref()).collect();
    let bodies = tree.elements().filter(|&id| tree.name(id) == "Body");
    let names = bodies
        .filter_map(|id| Some((tree.child(id, "components"), tree.attribute(id, "name")?.into_owned())));
    names.filter(|(_, name)| carriers.contains(&name.as_str())).try_fold(on_frames, |text, (components, name)| {
        let tag = format!("<Body name=\"{name}\">");
        let frame = format!(
            "{tag}<components><PhysicalOffsetFrame name=\"offset\"><socket_parent>..</socket_parent>{place}</PhysicalOffsetFrame></components>"
        );
        components.is_none().then(|| text.replacen(&tag, &frame, 1))
    })
}

fn is_torso(name: &str) -> bool {
    name.contains("torso")
}

fn is_left_foot(mesh: &str) -> bool {
    ["calcn_l", "calc_l", "toes_l", "talus_l", "forefoot_l", "midfoot_l", "metatarsi_l"]
        .iter()
        .any(|body| mesh.starts_with(body))
}

fn with_friction(m: &Published, both: &str) -> Edited {
    m.edit(FORCES, &["static_friction", "dynamic_friction", "viscous_friction"], |_, _| Some(both.to_owned()))
}

fn first_force(m: &Published) -> String {
    m.model.forces().first().map(|force| force.name.clone()).unwrap_or_default()
}

fn one_of(name: &str, factor: f64) -> impl Fn(&str, &str) -> Option<String> {
    move |own, old| (own == name).then(|| multiplied_text(old, factor))?
}

/// The model with a second floor, on which the left spheres press.
fn with_second_floor(m: &Published, location: &str, orientation: &str) -> Edited {
    let tree = m.model.document().tree();
    let floor = tree.elements().find(|&id| tree.name(id) == "ContactHalfSpace")?;
    let name = tree.attribute(floor, "name")?.into_owned();
    let frame = FRAME.iter().find_map(|tag| Some((tag, tree.child(floor, tag)?)))?;
    let frame = format!("<{0}>{1}</{0}>", frame.0, tree.text_of(frame.1));
    let extra = format!(
        "<ContactHalfSpace name=\"second_floor\">{frame}{location}<orientation>{orientation}</orientation></ContactHalfSpace>"
    );
    let left = m.edit(
        &["SmoothSphereHalfSpaceForce", "HuntCrossleyForce::ContactParameters"],
        &["geometry"],
        |_, old| {
            let spheres: Vec<&str> = old.split_whitespace().filter(|one| *one != name).collect();
            spheres
                .iter()
                .all(|sphere| is_left(sphere))
                .then(|| format!("second_floor {}", spheres.join(" ")))
        },
    );
    let left = left.or_else(|| {
        m.edit(&["SmoothSphereHalfSpaceForce"], &["socket_half_space"], |force, old| {
            is_left(force).then(|| old.replace(&name, "second_floor"))
        })
    })?;
    let piece = m.text.get(tree.span(floor))?;
    Some(left.replacen(piece, &format!("{piece}{extra}"), 1))
}

/// The model with forces switched off; `of` chooses them by their spheres.
fn with_forces_off(m: &Published, of: impl Fn(&str) -> bool) -> Edited {
    let tree = m.model.document().tree();
    let chosen = m.model.forces().iter().filter(|force| {
        let mut spheres = force.spheres().iter().filter_map(|&id| m.model.sphere(id));
        spheres.any(|sphere| of(&sphere.name))
    });
    let mut text = m.text.clone();
    let is_old = m.text.contains("<isDisabled>");
    for force in chosen.collect::<Vec<_>>().into_iter().rev() {
        let element = force.element;
        let own = ["appliesForce", "isDisabled"].iter().find_map(|tag| tree.child(element, tag));
        match own {
            Some(own) => text.replace_range(
                tree.open_span(own).end..tree.close_span(own).start,
                if is_old { "true" } else { "false" },
            ),
            None => text.insert_str(tree.open_span(element).end, "<appliesForce>false</appliesForce>"),
        }
    }
    (text != m.text).then_some(text)
}

#[test]
fn places_are_written_and_read() {
    assert_eq!(three_numbers(&numbers_text([0.1, -0.2, 3.0])), Some([0.1, -0.2, 3.0]));
}
