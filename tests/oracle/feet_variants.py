"""Models for what the corpus lacks: joints of every class away from 0, functions, constraints, and meshes of every document version."""

MESH = "r_hoof.vtp"
NO_INERTIA = "<mass>1</mass><mass_center>0 0 0</mass_center><inertia>1 1 1 0 0 0</inertia>"
VALUES = (0.3, -0.5, 0.7, 0.1, 0.2, -0.4)


def coordinate(name, value, more=""):
    return f'<Coordinate name="{name}"><default_value>{value}</default_value>{more}</Coordinate>'


def offset(name, body, number):
    """An offset frame, turned about all axes."""
    return (
        f'<PhysicalOffsetFrame name="{name}"><socket_parent>{body}</socket_parent><translation>0.1 {number} -0.2</translation>'
        f"<orientation>{number} 0.2 -0.3</orientation></PhysicalOffsetFrame>"
    )


def joint(kind, values, child, parent="/ground", name="j", inner="", more=""):
    """A joint between two offset frames; its coordinates are `q0`, `q1` and so on, after its name."""
    own = "".join(coordinate(f"{name}q{index}", value, more) for index, value in enumerate(values))
    return (
        f'<{kind} name="{name}"><socket_parent_frame>p</socket_parent_frame><socket_child_frame>c</socket_child_frame>'
        f"<coordinates>{own}</coordinates>{inner}<frames>{offset('p', parent, 0.4)}{offset('c', child, -0.6)}</frames></{kind}>"
    )


def model(joints, bodies=("a", "b"), constraints=""):
    """A document of version 40000."""
    bodies = "".join(f'<Body name="{name}">{NO_INERTIA}</Body>' for name in bodies)
    return (
        f'<OpenSimDocument Version="40000"><Model name="m"><BodySet><objects>{bodies}</objects></BodySet><JointSet><objects>'
        f"{''.join(joints)}</objects></JointSet><ConstraintSet><objects>{constraints}</objects></ConstraintSet></Model>"
        "</OpenSimDocument>"
    )


def custom(functions, values=VALUES):
    """A CustomJoint: its axes take coordinates 0 to 5 in an odd order, each through one of `functions`."""
    names = ("rotation1", "rotation2", "rotation3", "translation1", "translation2", "translation3")
    axes = ("0 0 1", "0.6 0.8 0", "1 2 3", "1 0 0", "0 2 0", "0.1 0.2 0.3")
    order = (2, 0, 1, 5, 3, 4)
    parts = "".join(
        f'<TransformAxis name="{name}"><coordinates>jq{index}</coordinates><axis>{axis}</axis>{function}</TransformAxis>'
        for name, axis, index, function in zip(names, axes, order, functions)
    )
    return joint("CustomJoint", values, "/bodyset/a", inner=f"<SpatialTransform>{parts}</SpatialTransform>")


KNOTS = "<x>-1 0 0.4 1.5 2.5</x><y>0.2 1 -0.3 0.4 2</y>"
LINEAR = "<LinearFunction><coefficients>2 0.05</coefficients></LinearFunction>"
SPLINE = f"<SimmSpline>{KNOTS}</SimmSpline>"
FUNCTIONS = {
    "linear": LINEAR,
    "constant": "<Constant><value>0.7</value></Constant>",
    "polynomial": "<PolynomialFunction><coefficients>3 -2 0.5 0.1</coefficients></PolynomialFunction>",
    "spline": SPLINE,
    "natural": f"<NaturalCubicSpline>{KNOTS}</NaturalCubicSpline>",
    "straight": f"<PiecewiseLinearFunction>{KNOTS}</PiecewiseLinearFunction>",
    "multiplied": f"<MultiplierFunction><function>{SPLINE}</function><scale>0.3</scale></MultiplierFunction>",
}


def coupler(function, more=""):
    """kq0 follows jq0."""
    return (
        f'<CoordinateCouplerConstraint name="c">{more}<coupled_coordinates_function>{function}</coupled_coordinates_function>'
        "<independent_coordinate_names>jq0</independent_coordinate_names><dependent_coordinate_name>kq0"
        "</dependent_coordinate_name><scale_factor>0.5</scale_factor></CoordinateCouplerConstraint>"
    )


def poses():
    """Name and text of models without meshes."""
    weld = joint("WeldJoint", (), "/bodyset/b", "/bodyset/a", "w")
    classes = {"PinJoint": 1, "SliderJoint": 1, "UniversalJoint": 2, "GimbalJoint": 3, "BallJoint": 3, "PlanarJoint": 3}
    for kind, count in (classes | {"FreeJoint": 6, "WeldJoint": 0}).items():
        yield kind, model([joint(kind, VALUES[:count], "/bodyset/a"), weld])
    radii = "<radii_x_y_z>0.1 0.2 0.3</radii_x_y_z>"
    yield "EllipsoidJoint", model([joint("EllipsoidJoint", VALUES[:3], "/bodyset/a", inner=radii), weld])
    yield "child_is_ground", model([joint("PinJoint", (0.4,), "/ground", "/bodyset/a"), weld])
    for name, function in FUNCTIONS.items():
        yield f"custom_{name}", model([custom([function] * 6), weld])
    beyond = tuple(8 * value for value in VALUES)
    yield "custom_beyond", model([custom([FUNCTIONS["spline"], FUNCTIONS["straight"]] * 3, beyond), weld])
    for count in (2, 3, 4):
        knots = f"<x>{' '.join(map(str, (-1, 0, 0.4, 1.5)[:count]))}</x><y>{' '.join(map(str, (0.2, 1, -0.3, 0.4)[:count]))}</y>"
        yield f"custom_{count}_knots", model([custom([f"<SimmSpline>{knots}</SimmSpline>"] * 6), weld])
    pins = [joint("PinJoint", (0.1,), "/bodyset/a"), joint("PinJoint", (0.3,), "/bodyset/b", "/bodyset/a", "k")]
    for name, function in FUNCTIONS.items():
        yield f"coupled_{name}", model(pins, constraints=coupler(function))
    yield "coupler_off", model(pins, constraints=coupler(LINEAR, "<isEnforced>false</isEnforced>"))
    locked = "<locked>true</locked><clamped>true</clamped><range>-0.5 0.5</range>"
    yield "locked", model([joint("PinJoint", (0.3,), "/bodyset/a", more=locked), weld])
    prescribed = f"<prescribed>true</prescribed><prescribed_function>{SPLINE}</prescribed_function>"
    yield "prescribed", model([joint("PinJoint", (0.3,), "/bodyset/a", more=prescribed), weld])
    unused = prescribed.replace("true", "false")
    yield "not_prescribed", model([joint("PinJoint", (0.3,), "/bodyset/a", more=unused), weld])


def old_body(visible, version, reverse="false"):
    """A document with a joint in its body."""
    moments = "".join(f"<inertia_{axis}>{value}</inertia_{axis}>" for axis, value in zip(("xx", "yy", "zz", "xy", "xz", "yz"), (1, 1, 1, 0, 0, 0)))
    ground = "".join(f"<inertia_{axis}>0</inertia_{axis}>" for axis in ("xx", "yy", "zz", "xy", "xz", "yz"))
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<OpenSimDocument Version="{version}"><Model name="m"><BodySet><objects>'
        f'<Body name="ground"><mass>0</mass><mass_center>0 0 0</mass_center>{ground}</Body>'
        f'<Body name="a"><mass>1</mass><mass_center>0 0 0</mass_center>{moments}<Joint><PinJoint name="j">'
        "<parent_body>ground</parent_body><location_in_parent>0.123456789 0 0.02</location_in_parent><orientation_in_parent>"
        "0.123456789 -0.23456789 0.98765432</orientation_in_parent><location>0.0123456789 0.0198765432 -0.00123456789</location>"
        "<orientation>-0.2345678912 0.1122334455 0.33221100123</orientation><CoordinateSet><objects>"
        f"{coordinate('jq0', 0.3)}</objects></CoordinateSet><reverse>{reverse}</reverse></PinJoint></Joint>"
        f"{visible}</Body></objects></BodySet></Model></OpenSimDocument>"
    )


def meshes():
    """Name and text of models with meshes."""
    own = "<transform>0.123456789 0.2 0.3 1 2 3</transform><scale_factors>2 3.123456789 4</scale_factors>"
    geometry = "".join(
        f"<DisplayGeometry><geometry_file>{MESH}</geometry_file>{some}</DisplayGeometry>"
        for some in (own, "", "<transform>0 0 0 0 0.5 0</transform>")
    )
    whole = "<scale_factors>1.123456789 1.6 -1.7</scale_factors>"
    moved = "<transform>0.4 0.5 -0.6 -1 -2 5</transform>"
    for name, more in (("", ""), ("_moved", moved)):
        visible = f"<VisibleObject><GeometrySet><objects>{geometry}</objects></GeometrySet>{whole}{more}</VisibleObject>"
        for version in (20303, 30000):
            yield f"set_{version}{name}", old_body(visible, version)
    yield "reversed", old_body("", 30000, "true")
    mesh = f"<Mesh name=\"bone\"><socket_frame>..</socket_frame><mesh_file>{MESH}</mesh_file><scale_factors>1.123456789 -2 0.5</scale_factors></Mesh>"
    for version, tag in ((30505, "geometry"), (30505, "attached_geometry"), (30517, "attached_geometry"), (40000, "attached_geometry"), (40000, "geometry")):
        attached = f"<{tag}>{mesh}</{tag}>"
        body = f'<Body name="a">{attached}{NO_INERTIA}</Body>'
        text = model([joint("PinJoint", (0.3,), "/bodyset/a")], "a").replace(f'<Body name="a">{NO_INERTIA}</Body>', body)
        yield f"{tag}_{version}", text.replace('Version="40000"', f'Version="{version}"')
    # Frames on a body, on a frame of it, and those of joints.
    text = model([joint("PinJoint", (0.3,), "/bodyset/a"), joint("WeldJoint", (), "/bodyset/b", "/bodyset/a", "w")])
    attached = f"<attached_geometry>{mesh}</attached_geometry>"
    text = text.replace("<socket_parent>/bodyset/a</socket_parent>", f"{attached}<socket_parent>/bodyset/a</socket_parent>")
    outer = offset("outer", "..", 0.8).replace("<socket_parent>", f"{attached}<socket_parent>")
    inner = offset("inner", "/bodyset/a/outer", 0.1).replace("<socket_parent>", f"{attached}<socket_parent>")
    yield "frames", text.replace('<Body name="a">', f'<Body name="a"><components>{outer}{inner}</components>')
