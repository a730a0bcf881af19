"""Makes the contacts of the sweeps from the walker's model, with the verbs of this project."""

import model
import osim_contact_scale as ocs

SPHERES = 2  # of the foot that stands: they carry the body's weight
INDENTATION = 0.16  # of the stiffest contacts: the limit of the Hertz theory
SOFTEST = 1.2  # dimensionless stiffness (B.3) of the softest: that of the paper's Fig. 1(C)
RESTITUTION = 0.9  # of the ladder's last step
# k̂ is 1.5 / x̂, and the modulus goes with its power 3/2.
SOFTEST_FACTOR = (SOFTEST * INDENTATION / 1.5) ** 1.5
DISSIPATIONS = (0.25, 0.5, 1.0, 2.0, 4.0)  # s/m


def baseline(folder):
    """The walker whose spheres sink in by 0.16 of their radius under body weight, on one foot: what `design` makes of it."""
    plain = model.write(folder / "plain.osim")
    model_path = folder / "walker.osim"
    ocs.design(str(plain), indentation=INDENTATION, spheres=SPHERES).write(str(model_path), force=True)
    return model_path


def grid(folder, stiffnesses=5, dissipations=DISSIPATIONS):
    """Stiffness × dissipation: from k̂ = 1.2 up to the baseline, equally far apart in the logarithm."""
    values = {
        "stiffness": f"x{SOFTEST_FACTOR!r}..x1/{stiffnesses}",
        "dissipation": list(dissipations),
    }
    return ocs.sweep(str(baseline(folder)), grid=values, output_dir=str(folder / "walker.sweep"), resume=True)


def ladder(folder, steps):
    """The steps from soft to stiff contacts: from k̂ = 1.2 and α = 1 s/m to the baseline's stiffness and a restitution of 0.9."""
    return ocs.sweep(
        str(baseline(folder)),
        ladder=steps,
        indentation=INDENTATION,
        restitution=RESTITUTION,
        spheres=SPHERES,
        soft=SOFTEST,
        output_dir=str(folder / "ladder.sweep"),
        resume=True,
    )


def middle(path, output):
    """Writes the contacts of the grid's middle, in the model at this path, to `output`."""
    return ocs.set(str(path), stiffness=f"x{SOFTEST_FACTOR**0.5!r}", dissipation=1.0).write(str(output), force=True)


def sizes(folder, lengths):
    """Walkers of other lengths, with contacts rescaled and left.

    `rescaled` is what `rescale` makes of the contacts of the grid's middle, for the walker's own mass, with `friction`. `left` has radii
    that follow the foot, so that it stands as before; all other numbers are those of the human.

    Returns
    -------
    list of dict
        Rows with `path`, `length` and `contacts`, the human walker first.
    """
    human = folder / "middle.osim"
    middle(baseline(folder), human)
    numbers = ocs.inspect(str(human)).forces.iloc[0]
    rows = [{"path": str(human), "length": 1.0, "contacts": "rescaled"}]
    for length in lengths:
        plain = model.write(folder / f"plain_{length:g}.osim", length)
        same = folder / f"human_contacts_{length:g}.osim"
        ocs.set(str(plain), stiffness=numbers["stiffness"], dissipation=numbers["dissipation"]).write(
            str(same), force=True
        )
        rescaled, unchanged = folder / f"rescaled_{length:g}.osim", folder / f"left_{length:g}.osim"
        mass = model.MASS * length**3
        ocs.rescale(str(same), contacts_mass=model.MASS, target_mass=mass, friction=True).write(
            str(rescaled), force=True
        )
        ocs.set(str(same), radius=model.RADIUS * length).write(str(unchanged), force=True)
        rows += [
            {"path": str(path), "length": length, "contacts": kind}
            for kind, path in (("rescaled", rescaled), ("left", unchanged))
        ]
    return rows
