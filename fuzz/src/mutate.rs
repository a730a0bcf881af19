//! Mutations that leave most models well formed: random bytes alone rarely get past the scanner.

use std::ops::Range;

use libfuzzer_sys::fuzzer_mutate;
use osim_model::{Document, ElementId, Tree};

/// Tags that mean something to the reader.
const TAGS: &[&str] = &[
    "Model",
    "defaults",
    "components",
    "objects",
    "BodySet",
    "Body",
    "Ground",
    "PhysicalOffsetFrame",
    "JointSet",
    "PinJoint",
    "WeldJoint",
    "CustomJoint",
    "frames",
    "socket_frame",
    "socket_parent",
    "socket_parent_frame",
    "socket_child_frame",
    "connectors",
    "connectee_name",
    "body_name",
    "parent_body",
    "ContactGeometrySet",
    "ContactSphere",
    "ContactHalfSpace",
    "ContactMesh",
    "ForceSet",
    "HuntCrossleyForce",
    "HuntCrossleyForce::ContactParametersSet",
    "HuntCrossleyForce::ContactParameters",
    "contact_parameters",
    "SmoothSphereHalfSpaceForce",
    "socket_sphere",
    "socket_half_space",
    "contact_sphere_radius",
    "geometry",
    "mass",
    "radius",
    "location",
    "translation",
    "gravity",
    "appliesForce",
    "isDisabled",
    "stiffness",
    "dissipation",
    "static_friction",
    "dynamic_friction",
    "viscous_friction",
    "transition_velocity",
    "constant_contact_force",
    "hertz_smoothing",
    "hunt_crossley_smoothing",
];

/// Texts of leaves: numbers as they are spelled, names and paths that lead somewhere odd.
const TEXTS: &[&str] = &[
    "",
    " ",
    "0",
    "-0",
    "1",
    "62",
    "1e6",
    " 10000.00000000 ",
    "0.80000000000000004",
    "+8e6",
    ".5",
    "5.",
    "1e-320",
    "1e308",
    "1e400",
    "-1",
    "NaN",
    "inf",
    "1,5e6",
    "1 2 3",
    "0 -9.81 0",
    "&#49;e6",
    "1&#46;5",
    "&amp;",
    "&nosuch;",
    "<![CDATA[2e6]]>",
    "<!-- c -->3",
    "1<!-- c -->2",
    "true",
    "false",
    "ground",
    "/ground",
    "/bodyset/calcn_r",
    "../calcn_r",
    "..",
    "/",
    "//",
    "calcn_l",
    "/contactgeometryset/s1_r",
    "\r\n",
    "\u{3b1}\u{2009}",
];

/// Comments and white space that may stand between tags.
const BETWEEN: &[&str] = &[
    "<!-- c -->",
    "<!---->",
    "\r\n",
    "\n\n\t",
    "<![CDATA[ ]]>",
    "<?pi?>",
    "text",
    "<credits>[contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; sizes none; record 0123456789abcdef 01234567 - 1:01234567 1:01234567 0123.-.-.-.-.-.-.-.-; made -)]</credits>",
    "<credits>A; <![CDATA[B]]></credits>",
    "<credits/>",
    "<!-- [contacts made for 62 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; digest 00)] -->",
];

/// Mutates `bytes[..size]`: mostly whole elements and texts, now and then plain bytes.
pub fn mutate(bytes: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut dice = Dice::new(seed);
    if dice.roll(8) != 0
        && let Some(changed) = mutate_document(&bytes[..size], &mut dice)
        && changed.len() <= max_size.min(bytes.len())
    {
        bytes[..changed.len()].copy_from_slice(&changed);
        return changed.len();
    }
    fuzzer_mutate(bytes, size, max_size)
}

fn mutate_document(bytes: &[u8], dice: &mut Dice) -> Option<Vec<u8>> {
    let document = Document::parse(bytes).ok()?;
    let (span, text) = mutation(&document, dice);
    let mut changed = bytes.to_vec();
    changed.splice(span, text);
    Some(changed)
}

/// One replacement of a span by bytes.
fn mutation(document: &Document, dice: &mut Dice) -> (Range<usize>, Vec<u8>) {
    let (bytes, tree) = (document.bytes(), document.tree());
    let elements: Vec<ElementId> = tree.elements().collect();
    let one = *dice.pick(&elements);
    let other = *dice.pick(&elements);
    let content = content(tree, one);
    match dice.roll(9) {
        0 | 1 if tree.children(one).next().is_none() => (content, dice.pick(TEXTS).as_bytes().to_vec()),
        0 | 1 => (attribute_text(bytes, tree.open_span(one), dice), dice.pick(TEXTS).as_bytes().to_vec()),
        // The text of another leaf: names and paths that exist.
        2 if tree.children(one).next().is_none() => (content, bytes[self::content(tree, other)].to_vec()),
        2 => {
            let theirs = attribute_text(bytes, tree.open_span(other), dice);
            (attribute_text(bytes, tree.open_span(one), dice), bytes[theirs].to_vec())
        }
        3 => (tree.span(one), Vec::new()),
        4 => (tree.span(one).end..tree.span(one).end, bytes[tree.span(one)].to_vec()),
        5 => (tree.span(one).start..tree.span(one).start, bytes[tree.span(other)].to_vec()),
        6 => {
            let name = if dice.roll(2) == 0 { tree.name(other) } else { dice.pick(TAGS) };
            (tree.span(one), renamed(bytes, tree, one, name))
        }
        7 => (content.start..content.start, dice.pick(BETWEEN).as_bytes().to_vec()),
        _ => (tree.span(one), bytes[tree.span(other)].to_vec()),
    }
}

/// Between the tags; empty after the tag of `<tag/>`.
fn content(tree: &Tree, id: ElementId) -> Range<usize> {
    let (open, span) = (tree.open_span(id), tree.span(id));
    if tree.is_empty_tag(id) { span.end..span.end } else { open.end..tree.close_span(id).start }
}

/// Between a pair of quotes of a start tag; empty at its end where it has none.
fn attribute_text(bytes: &[u8], tag: Range<usize>, dice: &mut Dice) -> Range<usize> {
    let quotes: Vec<usize> = tag.clone().filter(|&at| matches!(bytes[at], b'"' | b'\'')).collect();
    let pair = dice.roll(quotes.len().max(2) / 2);
    match quotes.get(2 * pair..2 * pair + 2) {
        Some(&[from, to]) => from + 1..to,
        _ => tag.end..tag.end,
    }
}

fn renamed(bytes: &[u8], tree: &Tree, id: ElementId, name: &str) -> Vec<u8> {
    let open = tree.open_span(id);
    let mut text = format!("<{name}").into_bytes();
    text.extend_from_slice(&bytes[open.start + 1 + tree.name(id).len()..tree.span(id).end]);
    if !tree.is_empty_tag(id) {
        text.truncate(text.len() - tree.close_span(id).len());
        text.extend_from_slice(format!("</{name}>").as_bytes());
    }
    text
}

/// Splitmix64.
struct Dice(u64);

impl Dice {
    fn new(seed: u32) -> Self {
        Self(u64::from(seed))
    }

    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed >> 33) as usize) % sides
    }

    fn pick<'p, T>(&mut self, from: &'p [T]) -> &'p T {
        &from[self.roll(from.len())]
    }
}
