"""Which models get contacts in these tests, and from where: `CASES` by name; `VARIANTS` are documents that tests write first."""

from dataclasses import dataclass, field
from pathlib import Path

import add_variants
import command
import models

PRESET = command.ROOT / "crates/osim-patch/src/objects/presets/falisse2022.osim"
HUMAN = models.FIXTURES / "table1"
GENERIC = models.FIXTURES / "scale_tool"
ONE_PIECE = {f"toes_{side}": f"calcn_{side}" for side in "rl"}


@dataclass(frozen=True)
class Case:
    """A model, the contacts that it gets, and the options. Contacts of `bare` models are removed first."""

    model: Path
    reference: Path = PRESET
    radius: str = "isometric"
    given: dict = field(default_factory=dict)
    body_map: dict = field(default_factory=dict)
    bare: bool = False

    @property
    def name(self):
        reference = "" if self.reference == PRESET else f"-from-{self.reference.stem}"
        return f"{self.model.stem}{reference}-{self.radius}" + ("-bare" if self.bare else "")

    def options(self, reading):
        """Options of the command; `reading` is the reading of the reference."""
        preset = self.reference == PRESET
        options = ["--from", "falisse2022" if preset else self.reference, "--radius", self.radius]
        options += [] if preset else ["--reference-mass", repr(float.fromhex(reading["mass_sum"]))]
        for body, factors in self.given.items():
            options += ["--body-scale", f"{body}={','.join(map(repr, factors))}"]
        for body, taker in self.body_map.items():
            options += ["--body-map", f"{body}={taker}"]
        return options


def corpus_cases():
    """Cases from the corpus by name: gait2392, Rajagopal, Moco's 3D walking, SCONE's foot of one piece, and everything else without contacts."""
    own = {path.stem: path for path in models.corpus()}
    feet = [path for path in own.values() if b'name="toes_r"' in path.read_bytes()]
    without = [path for path in feet if "without_contacts" in path.name]
    assert len(without) == 8, without
    yield from (Case(path) for path in without)
    yield from (Case(path, radius="follow") for path in without[::3])
    falisse, moco = own["v40000_falisse_2022_human"], own["v40000_moco_2d_gait"]
    gait2392, rajagopal = own["v40000_gait2392_without_contacts"], own["v40000_rajagopal_2016_without_contacts"]
    yield Case(gait2392, radius="0.03")
    for model in (gait2392, rajagopal, own["v40600_moco_3d_walking_model_without_contacts"]):
        yield Case(model, falisse, "follow")
    yield Case(own["v40000_gait10dof18musc_without_contacts"], own["v40000_opencap_lai_arnold_crlf"])
    yield Case(own["v20303_gait2392_without_contacts"], own["v40000_human_12_hunt_crossley"])
    yield Case(own["v30000_gait1018_subject01_without_contacts"], moco)
    yield Case(rajagopal, own["v40000_scone_h0914m"], "follow")
    joined = {f"{body}_{side}": f"calcn_{side}" for body in ("midfoot", "forefoot") for side in "rl"}
    yield Case(rajagopal, own["v40000_dhondt_2024_3seg_human"], body_map=joined)
    for name in ("v40000_scone_h0914m", "v30000_scone_h0914m"):
        yield Case(own[name], body_map=ONE_PIECE, bare=True)


def our_cases():
    """Fixtures: scaled copies, whose joints say each axis; bones of other names, with factors given; one body for each foot."""
    uneven = {"toes_r": [1.1, 0.9, 1.2], "toes_l": [1.1, 0.9, 1.2], "calcn_r": [0.95, 1.05, 1.0], "calcn_l": [0.95, 1.05, 1.0]}
    for version in (30000, 40000):
        yield Case(models.FIXTURES / f"feet/human_{version}.osim", HUMAN / "human_62kg_smooth_sphere.osim")
        yield Case(models.FIXTURES / f"feet/human_{version}.osim", given=uneven, radius="follow")
    pes = {f"pes_{side}": f"toes_{side}" for side in "rl"}
    for version in (30000, 40000):
        toes = {"toes_r": [1.1, 0.8, 1.3], "toes_l": [1.1, 0.8, 1.3]}
        yield Case(models.FIXTURES / f"feet/bird_{version}.osim", HUMAN / "emu_10_spheres_hunt_crossley.osim", given=toes, body_map=pes)
    one_body = {f"{part}_{side}": f"hoof_{side}" for part in ("calcn", "toes") for side in "rl"}
    for version in (30000, 40000):
        hoof = {"hoof_r": [0.4, 0.5, 0.6], "hoof_l": [0.4, 0.5, 0.6]}
        yield Case(models.FIXTURES / f"feet/hoof_{version}.osim", given=hoof, body_map=one_body)
    doubled = {body: [2.0, 2.1, 1.9] for body in uneven}
    for kind in ("smooth_sphere", "hunt_crossley"):
        yield Case(HUMAN / f"human_500kg_{kind}.osim", HUMAN / f"human_62kg_{kind}.osim", given=doubled, bare=True)
    doubled = {f"{foot}_{side}": [2.0, 2.1, 1.9] for foot in ("manus_fore", "pes_hind") for side in "rl"}
    yield Case(HUMAN / "giraffe_hunt_crossley.osim", HUMAN / "horse_hunt_crossley.osim", given=doubled, bare=True)
    for kind in ("smooth", "hunt_crossley"):
        yield Case(GENERIC / f"scaled_{kind}.osim", GENERIC / f"generic_{kind}.osim", "follow", bare=True)


CASES = {case.name: case for case in (*(corpus_cases() if models.CORPUS else ()), *our_cases())}
VARIANTS = add_variants.NAMES
ALL = [*CASES, *VARIANTS]
