//! Test helpers that read like sentences: `given(model).rescaled_to(64.0).produces(model)`.

use osim_model::{
    Companion, DissipationBy, Document, Fault, FileId, MassRequest, Model, Pattern, Property, PropertySet,
    RadiusRule, Selection,
};
use osim_patch::{NumberChange, Plan, Reference, Rescale, Transfer, rescale, transfer};

/// Bytes of a file of `fixtures/`.
#[track_caller]
pub(crate) fn fixture(name: &str) -> Vec<u8> {
    let path = format!("{}/../../fixtures/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("fixtures/{name}: {error}"))
}

/// Names of all files in a folder of `fixtures/`, sorted.
pub(crate) fn fixtures(folder: &str) -> Vec<String> {
    let path = format!("{}/../../fixtures/{folder}", env!("CARGO_MANIFEST_DIR"));
    let mut names: Vec<String> = std::fs::read_dir(path)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        // What README's first command writes beside its model is no fixture.
        .filter(|name| name.ends_with(".osim") && !name.ends_with(".scaled.osim"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    names.sort();
    assert!(!names.is_empty(), "fixtures/{folder} is empty");
    names
}

/// The text of a model of one foot of 1 kg, with the given forces and the given radius of its sphere `heel_r`.
///
/// Tests rescale it to 64 kg: lengths grow by exactly 4, so that every new number is easy to compute.
pub(crate) fn foot(forces: &str, radius: &str) -> String {
    format!(
        r#"<OpenSimDocument Version="40000">
	<Model name="foot">
		<BodySet name="bodyset">
			<objects>
				<Body name="calcn_r">
					<mass>1</mass>
				</Body>
			</objects>
		</BodySet>
		<JointSet name="jointset">
			<objects>
				<FreeJoint name="ground_calcn_r">
					<socket_parent_frame>/ground</socket_parent_frame>
					<socket_child_frame>/bodyset/calcn_r</socket_child_frame>
				</FreeJoint>
			</objects>
		</JointSet>
		<ForceSet name="forceset">
			<objects>
				{forces}
			</objects>
		</ForceSet>
		<ContactGeometrySet name="contactgeometryset">
			<objects>
				<ContactHalfSpace name="floor">
					<socket_frame>/ground</socket_frame>
				</ContactHalfSpace>
				<ContactSphere name="heel_r">
					<socket_frame>/bodyset/calcn_r</socket_frame>
					<radius>{radius}</radius>
				</ContactSphere>
			</objects>
		</ContactGeometrySet>
	</Model>
</OpenSimDocument>
"#
    )
}

/// The text of a `SmoothSphereHalfSpaceForce` on `heel_r` with the given lines of `properties`.
pub(crate) fn smooth(properties: &str) -> String {
    let lines: String = properties.lines().map(|line| format!("\n\t\t\t\t\t{}", line.trim_start())).collect();
    format!(
        "<SmoothSphereHalfSpaceForce name=\"contact\">\n\
         \t\t\t\t\t<socket_sphere>/contactgeometryset/heel_r</socket_sphere>\n\
         \t\t\t\t\t<socket_half_space>/contactgeometryset/floor</socket_half_space>{lines}\n\
         \t\t\t\t</SmoothSphereHalfSpaceForce>"
    )
}

/// The text of a `HuntCrossleyForce` with one `ContactParameters` for each of `sets`.
pub(crate) fn hunt_crossley(sets: &[&str]) -> String {
    let sets: String = sets
        .iter()
        .map(|set| {
            format!("<HuntCrossleyForce::ContactParameters>{set}</HuntCrossleyForce::ContactParameters>")
        })
        .collect();
    format!(
        "<HuntCrossleyForce name=\"contact\">\
         <HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>{sets}</objects>\
         </HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>"
    )
}

/// A model, the files beside it, and the options of a change.
pub(crate) struct Given {
    bytes: Vec<u8>,
    parts: Vec<Vec<u8>>,
    radius: Option<RadiusRule>,
    only: Vec<Property>,
    keep: Vec<Property>,
    friction: bool,
    by: DissipationBy,
    gravity: Option<f64>,
    selection: Selection,
    masses: MassRequest,
    note: bool,
}

/// A test sentence about the model with the given bytes.
pub(crate) fn given(bytes: impl Into<Vec<u8>>) -> Given {
    Given {
        bytes: bytes.into(),
        parts: vec![],
        radius: None,
        only: vec![],
        keep: vec![],
        friction: false,
        by: DissipationBy::Radius,
        gravity: None,
        selection: Selection::default(),
        masses: MassRequest::default(),
        note: false,
    }
}

/// A test sentence about the fixture `name`.
#[track_caller]
pub(crate) fn given_fixture(name: &str) -> Given {
    given(fixture(name))
}

fn patterns(pattern: &str) -> Vec<Pattern> {
    vec![pattern.parse().unwrap()]
}

impl Given {
    /// Adds a file of a set or a model that belongs to the model.
    pub(crate) fn with_companion(mut self, bytes: impl Into<Vec<u8>>) -> Self {
        self.parts.push(bytes.into());
        self
    }

    pub(crate) fn radius(mut self, rule: RadiusRule) -> Self {
        self.radius = Some(rule);
        self
    }

    pub(crate) fn changing_only(mut self, properties: &[Property]) -> Self {
        self.only = properties.to_vec();
        self
    }

    pub(crate) fn leaving(mut self, properties: &[Property]) -> Self {
        self.keep = properties.to_vec();
        self
    }

    pub(crate) fn with_friction(mut self) -> Self {
        self.friction = true;
        self
    }

    pub(crate) fn dissipation_by_mass(mut self) -> Self {
        self.by = DissipationBy::Mass;
        self
    }

    pub(crate) fn at_gravity(mut self, gravity_m_s2: f64) -> Self {
        self.gravity = Some(gravity_m_s2);
        self
    }

    pub(crate) fn selecting(mut self, glob: &str) -> Self {
        self.selection.select = patterns(glob);
        self
    }

    pub(crate) fn excluding(mut self, glob: &str) -> Self {
        self.selection.exclude = patterns(glob);
        self
    }

    pub(crate) fn standing_for(mut self, contacts_mass_kg: f64) -> Self {
        self.masses.contacts_mass_kg = Some(contacts_mass_kg);
        self
    }

    pub(crate) fn weighing(mut self, model_kg: f64) -> Self {
        self.masses.model_kg = Some(model_kg);
        self
    }

    /// Keeps the note in the output; the default is an output without a note.
    pub(crate) fn with_note(mut self) -> Self {
        self.note = true;
        self
    }

    fn properties(&self) -> PropertySet {
        let all = PropertySet::default();
        let all = if self.friction { all.with_friction() } else { all };
        all.restricted(&self.only, &self.keep)
    }

    /// Reads the model of the given file.
    pub(crate) fn read(&self) -> Result<Model, Fault> {
        let document = Document::parse(self.bytes.as_slice())?;
        let beside = |bytes: &Vec<u8>| {
            Ok(Companion { document: Document::parse(bytes.as_slice())?, included_by: None })
        };
        Model::read_with(document, self.parts.iter().map(beside).collect::<Result<_, Fault>>()?)
    }

    fn outcome(self, plan: impl FnOnce(&Model, &Self) -> Result<Plan, Fault>) -> Outcome {
        let patched = || {
            let model = self.read()?;
            let mut plan = plan(&model, &self)?;
            if !self.note {
                plan.drop_note();
            }
            let beside = model.companions().map(|(file, _)| file);
            let files = std::iter::once(FileId::MAIN).chain(beside);
            let files = files.map(|file| plan.patched(&model, file)).collect::<Result<Vec<_>, _>>()?;
            Ok((plan, files))
        };
        let result = patched();
        Outcome { before: self.bytes, result }
    }

    /// The result of rescaling the contacts of the model to `target_mass_kg`.
    pub(crate) fn rescaled_to(self, target_mass_kg: f64) -> Outcome {
        self.outcome(|model, given| {
            let selected = given.selection.apply(model)?;
            let (contacts_mass, findings) = given.masses.contacts_mass(model)?;
            let mut wanted = Rescale::new(target_mass_kg, contacts_mass);
            wanted.radius = given.radius.unwrap_or(RadiusRule::Isometric);
            wanted.properties = given.properties();
            wanted.dissipation_by = given.by;
            wanted.target_gravity_m_s2 = given.gravity;
            let mut plan = rescale(model, &selected, &wanted)?;
            plan.findings.extend(findings);
            Ok(plan)
        })
    }

    /// The result of a transfer of the contacts of the preset `name`, with `sphere_count` spheres that share the weight.
    pub(crate) fn taking_preset(self, name: &str, sphere_count: f64) -> Outcome {
        let preset = contact_scaling::preset(name).unwrap();
        self.outcome(|model, given| {
            let mass = given.masses.model_mass(model)?;
            let mut wanted = Transfer::new(Reference::from(&preset), mass, sphere_count);
            wanted.radius = given.radius.unwrap_or(RadiusRule::Keep);
            wanted.properties = given.properties();
            wanted.dissipation_by = given.by;
            wanted.target_gravity_m_s2 = given.gravity;
            transfer(model, &given.selection.apply(model)?, &wanted)
        })
    }
}

/// Result of a change: the model after it, or the fault.
pub(crate) struct Outcome {
    pub(crate) before: Vec<u8>,
    pub(crate) result: Result<(Plan, Vec<Vec<u8>>), Fault>,
}

impl Outcome {
    #[track_caller]
    pub(crate) fn plan(&self) -> &Plan {
        match &self.result {
            Ok((plan, _)) => plan,
            Err(fault) => panic!("refused: {fault}"),
        }
    }

    /// The bytes of the main file after the plan was applied.
    #[track_caller]
    pub(crate) fn bytes(&self) -> &[u8] {
        self.file(0)
    }

    /// The bytes of the file with the index `file` after the patch.
    #[track_caller]
    pub(crate) fn file(&self, file: usize) -> &[u8] {
        match &self.result {
            Ok((_, files)) => &files[file],
            Err(fault) => panic!("refused: {fault}"),
        }
    }

    /// Asserts that the output is `expected`, byte for byte.
    #[track_caller]
    pub(crate) fn produces(&self, expected: impl AsRef<[u8]>) -> &Self {
        let (seen, expected) = (self.bytes(), expected.as_ref());
        assert!(
            seen == expected,
            "expected:\n{}\nseen:\n{}",
            String::from_utf8_lossy(expected),
            String::from_utf8_lossy(seen)
        );
        self
    }

    /// Asserts that the output is the input, byte for byte.
    #[track_caller]
    pub(crate) fn changes_nothing(&self) -> &Self {
        self.produces(&self.before)
    }

    /// Asserts that only `lines` differ between input and output: `("old line", "new line")`, in file order, without
    /// indentation.
    #[track_caller]
    pub(crate) fn changes_only(&self, lines: &[(&str, &str)]) -> &Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let (before, after) = (text(&self.before), text(self.bytes()));
        assert_eq!(before.lines().count(), after.lines().count(), "lines were inserted:\n{after}");
        let changed: Vec<_> = before
            .lines()
            .zip(after.lines())
            .filter(|(old, new)| old != new)
            .map(|(old, new)| (old.trim(), new.trim()))
            .collect();
        assert_eq!(changed, lines);
        self
    }

    /// All planned changes of `property`.
    pub(crate) fn changes_of(&self, property: Property) -> Vec<&NumberChange> {
        self.plan().changes.iter().filter(|change| change.property == property).collect()
    }

    /// Asserts that there are `count` changes of `property`, and that each has the new value `to`.
    #[track_caller]
    pub(crate) fn sets(&self, property: Property, count: usize, to: f64) -> &Self {
        let changes = self.changes_of(property);
        assert_eq!(changes.len(), count, "{property}: {changes:?}");
        for change in changes {
            assert_close(change.to, to, &change.path);
        }
        self
    }

    /// Asserts that a finding has the code `code`.
    #[track_caller]
    pub(crate) fn has_finding(&self, code: &str) -> &Self {
        let codes: Vec<_> = self.plan().findings.iter().map(|finding| finding.code().as_str()).collect();
        assert!(codes.contains(&code), "no finding {code} among {codes:?}");
        self
    }

    /// Asserts that the change is refused with the code `code` and a message that contains all of `words`.
    #[track_caller]
    pub(crate) fn is_refused(&self, code: &str, words: &[&str]) -> &Fault {
        let Err(fault) = &self.result else { panic!("not refused: {:?}", self.plan().changes) };
        let text = fault.to_string();
        assert_eq!(fault.code(), code, "{text}");
        for word in words {
            assert!(text.contains(word), "'{word}' is not in: {text}");
        }
        fault
    }
}

/// Largest relative difference of a computed number from one computed by hand: the rounding of a double.
pub(crate) const TIGHT_TOLERANCE: f64 = 1e-14;

#[track_caller]
pub(crate) fn assert_close(seen: f64, expected: f64, what: &str) {
    assert!(
        (seen - expected).abs() <= TIGHT_TOLERANCE * expected.abs(),
        "{what}: {seen:?}, expected {expected:?}"
    );
}
