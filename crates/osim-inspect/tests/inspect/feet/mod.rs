//! Models of feet of 60 kg on a floor, under gravity of 10 m/s²: the weight is 600 N.

/// A sphere on the foot. Its `SmoothSphereHalfSpaceForce` is called `contact_` and the name of the sphere.
#[derive(Clone, Copy)]
pub struct SmoothContact {
    pub name: &'static str,
    /// Radius R, m.
    pub radius: f64,
    /// Composite modulus E₁*, N/m².
    pub stiffness: f64,
    /// Dissipation α, s/m.
    pub dissipation: f64,
    /// `constant_contact_force` cf, m².
    pub constant_contact_force: f64,
    /// `hertz_smoothing` bd, 1/m.
    pub hertz_smoothing: f64,
    /// `hunt_crossley_smoothing` bv, s/m.
    pub hunt_crossley_smoothing: f64,
}

/// A sphere under 600 N that is within every limit: x̂ is 0.0865, under twice the weight 0.137; the restitution (13) is 0.85 at 0.5 m/s;
/// √cf/R is 0.02; the transition width is 0.236 R; a sphere that just touches the floor carries 0.056 of its load.
pub const SOLE: SmoothContact = SmoothContact {
    name: "heel_r",
    radius: 0.05,
    stiffness: 2e7,
    dissipation: 0.3,
    constant_contact_force: 1e-6,
    hertz_smoothing: 250.0,
    hunt_crossley_smoothing: 50.0,
};

/// A sphere of a heel. Each of its figures has another value.
pub const HEEL: SmoothContact = SmoothContact {
    name: "heel_r",
    radius: 0.05,
    stiffness: 3e6,
    dissipation: 0.3,
    constant_contact_force: 1.6e-5,
    hertz_smoothing: 250.0,
    hunt_crossley_smoothing: 0.7,
};
/// A sphere of a toe. Its numbers differ from the numbers of [`HEEL`].
pub const TOE: SmoothContact = SmoothContact {
    name: "toe_r",
    radius: 0.03,
    stiffness: 5e6,
    dissipation: 0.25,
    constant_contact_force: 9e-6,
    hertz_smoothing: 200.0,
    hunt_crossley_smoothing: 60.0,
};

impl SmoothContact {
    fn force_element(&self) -> String {
        format!(
            "<SmoothSphereHalfSpaceForce name=\"contact_{0}\">
<socket_sphere>/contactgeometryset/{0}</socket_sphere>
<socket_half_space>/contactgeometryset/floor</socket_half_space>
<stiffness>{1}</stiffness>
<dissipation>{2}</dissipation>
<constant_contact_force>{3}</constant_contact_force>
<hertz_smoothing>{4}</hertz_smoothing>
<hunt_crossley_smoothing>{5}</hunt_crossley_smoothing>
<static_friction>0.8</static_friction>
</SmoothSphereHalfSpaceForce>\n",
            self.name,
            self.stiffness,
            self.dissipation,
            self.constant_contact_force,
            self.hertz_smoothing,
            self.hunt_crossley_smoothing
        )
    }

    /// The XML of this sphere, after `others` spheres before it, at another place than these.
    fn sphere(&self, others: usize) -> String {
        format!(
            "<ContactSphere name=\"{}\">
<socket_frame>/bodyset/foot_r</socket_frame>
<location>0 0 0.{others}</location>
<radius>{}</radius>
</ContactSphere>\n",
            self.name, self.radius
        )
    }
}

/// The text of a model: a foot that weighs 600 N, with these spheres.
pub fn foot(spheres: &[SmoothContact]) -> String {
    let mut text = String::from(
        "<OpenSimDocument Version=\"40000\">
<Model name=\"one_foot\">
<gravity>0 -10 0</gravity>
<BodySet name=\"bodyset\"><objects>
<Body name=\"foot_r\"><mass>60</mass></Body>
</objects></BodySet>
<ContactGeometrySet name=\"contactgeometryset\"><objects>
<ContactHalfSpace name=\"floor\"><socket_frame>/ground</socket_frame><orientation>0 0 -1.5707963267948966</orientation></ContactHalfSpace>\n",
    );
    spheres.iter().enumerate().for_each(|(others, one)| text.push_str(&one.sphere(others)));
    text.push_str("</objects></ContactGeometrySet>\n<ForceSet name=\"forceset\"><objects>\n");
    spheres.iter().for_each(|one| text.push_str(&one.force_element()));
    text + "</objects></ForceSet>\n</Model>\n</OpenSimDocument>\n"
}
