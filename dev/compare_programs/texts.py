"""Small files of cases: manifests, presets and measurements, good and wrong ones."""

import math

LAB = """# Presets of the lab
[[preset]]
name = "lab_heel"
source = "pendulum tests, mean of eight heels"
mass_kg = 70
spheres = 4
radius_m = 0.03
gravity_m_s2 = 9.81
stiffness = 1.5e6
dissipation = 1.0
"""
SMOOTH_LAB = LAB.replace("lab_heel", "lab_toe") + (
    "constant_contact_force = 1e-5\nhertz_smoothing = 300\nhunt_crossley_smoothing = 50\n"
)

PRESETS = {
    "smooth.toml": SMOOTH_LAB,
    "both.toml": LAB + SMOOTH_LAB,
    "misspelt.toml": LAB.replace("stiffness =", "stifness ="),
    "words.toml": LAB.replace("mass_kg = 70", 'mass_kg = "70 kg"'),
    "taken.toml": LAB.replace("lab_heel", "falisse2022"),
    "twice.toml": LAB + "\n" + LAB,
    "decimal.toml": LAB.replace("1.5e6", "1,5e6"),
    "short.toml": LAB.replace("mass_kg = 70\n", ""),
    "minus.toml": LAB.replace("mass_kg = 70", "mass_kg = -70"),
    "nothing.toml": LAB.replace("spheres = 4", "spheres = 0"),
    "part.toml": LAB + "hertz_smoothing = 300\n",
    "table.toml": LAB.replace("[[preset]]", "[preset]"),
    "plural.toml": LAB.replace("[[preset]]", "[[presets]]"),
    "nan.toml": LAB.replace("1.5e6", "nan"),
    "empty.toml": "",
    "unnamed.toml": LAB.replace('"lab_heel"', '""'),
}

ROWS = "model,target-mass,from,spheres,radius,friction,verb,set,output\n"
VERBS = "model,verb,target-mass,set,indentation,select,output\n"

MANIFESTS = {
    "masses.csv": "model,target-mass\nhuman.osim,5\nmouse.osim,70\nmodel.osim,500\n",
    "outputs.csv": "model,target-mass,output\nhuman.osim,5,a.osim\nhuman.osim,500,b.osim\n",
    "case.csv": "model,target-mass,output\nhuman.osim,5,mouse_.osim\nhuman.osim,500,Mouse_.osim\n",
    "verbs.csv": VERBS
    + "human.osim,,5,,,,rescale.osim\n"
    + "human.osim,,,stiffness=x2 dissipation=1,,,set.osim\n"
    + "human.osim,design,,,0.16,,design.osim\n"
    + "human.osim,set,,stiffness=x2,,contact_s1_r;contact_s2_*,some.osim\n",
    "wrong.csv": ROWS
    + "human.osim,1190,,,,,,,good_.osim\n"
    + "human.osim,1190kg,,,,,,,a.osim\n"
    + 'human.osim,"0,0209",,,,,,,b.osim\n'
    + "nowhere.osim,5,,,,,,,c.osim\n"
    + "human.osim,,,,,,,,d.osim\n"
    + "human.osim,5,,2,,,,,e.osim\n"
    + "human.osim,5,,,wide,,,,f.osim\n"
    + "human.osim,5,,,,maybe,,,g.osim\n"
    + "human.osim,,nobody2020,,,,,,h.osim\n"
    + "human.osim,,,,,,scale,,i.osim\n"
    + "human.osim,,,,,,,stifness=2,j.osim\n"
    + ",5,,,,,,,k.osim\n"
    + "human.osim,5,,,,,,,-\n",
    "many_wrong.csv": "model,target-mass\n" + "".join(f"human.osim,{n}kg\n" for n in range(1, 31)),
    "sep_rows.csv": "sep=;\nmodel;target-mass\nhuman.osim;5\n",
    "unlike.csv": "model,zzzzqqqq,target-mass\nhuman.osim,1,5\n",
    "verb_inspect.csv": "model,verb\nhuman.osim,inspect\n",
    "level_alone.csv": "model,target-mass,level-axis,no-backup\nhuman.osim,5,z,yes\n",
    "misspelt.csv": "model,targt-mass\nhuman.osim,5\n",
    "file.csv": "file,target-mass\nhuman.osim,5\n",
    "no_model.csv": "#file,target-mass\nhuman.osim,5\n",
    "model_twice.csv": "model,model\nhuman.osim,5\n",
    "dry.csv": "model,target-mass,dry-run\nhuman.osim,5,yes\n",
    "short.csv": "model,target-mass\nhuman.osim\n",
    "no_rows.csv": "model,target-mass\n",
    "blank_rows.csv": "model,target-mass\n,\nhuman.osim,5\n,\n",
    "empty.csv": "",
    "failing.csv": "model,target-mass\ntruncated.osim,5\nhuman.osim,5\n",
    "own_name.csv": "model,target-mass,output\nhuman.osim,5,own_name.csv\n",
    "folder_row.csv": "model,target-mass\nlib,5\n",
    "stdin_row.csv": "model,target-mass\n-,5\n",
    "semicolons.csv": "model;target-mass;radius\nhuman.osim;0,0209;0,04\nmouse.osim;62;\n",
    "tabs.csv": "model\ttarget-mass\tradius\nhuman.osim\t37,8\t0,04\n",
    "windows.csv": "\ufeffmodel;target-mass\r\nhuman.osim;62,5\r\n",
    "thousands.csv": "model;target-mass\nhuman.osim;1,190\n",
    "thousands_tabs.csv": "model\ttarget-mass\nhuman.osim\t1,190\n",
    "points.csv": "model;target-mass\nhuman.osim;1.190\n",
    "points_tabs.csv": "model\ttarget-mass\tradius\nhuman.osim\t1.190\t0,04\n",
    "points_alone.csv": "model\ttarget-mass\nhuman.osim\t1.190\n",
    "points_long.csv": "model;target-mass\nhuman.osim;1.1900\n",
    "whole.csv": "model;target-mass\nhuman.osim;1190\n",
    "too_many.csv": "model,target-mass\nhuman.osim,0,0209\n",
    "too_many_semicolons.csv": "model;target-mass;select\nhuman.osim;62;*_r;*_l\n",
    "quoted.csv": 'model,target-mass,select,"#why ""so"""\n"human.osim",500,"*_r;*_l","two\nlines"\n',
    "in_place_twice.csv": (
        "model,set,in-place,from,output\nhuman.osim,stiffness=x2,yes,,\nhuman.osim,stiffness=x3,,,b.osim\n"
    ),
    "in_place_read.csv": (
        "model,set,in-place,from,output\nhuman.osim,stiffness=x2,yes,,\nother.osim,,,human.osim,b.osim\n"
    ),
    "both_outputs.csv": "model,target-mass,output,output-dir\nhuman.osim,5,a.osim,out\n",
    "output_in_place.csv": "model,target-mass,output,in-place\nhuman.osim,5,a.osim,yes\n",
    "notes.csv": "model,target-mass,output,no-note\nhuman.osim,5,,\nmouse.osim,500,big/b.osim,yes\n",
    "flags.csv": "model,target-mass,friction,skip-disabled,level\nhuman.osim,500,TRUE,x,0\nmouse.osim,1,no,,1\n",
    "transfers.csv": (
        "model,from,spheres,stance-limbs,reference-spheres,presets\n"
        "mouse.osim,human.osim,,2,6,\nhorse.osim,falisse2022,10,,,\nemu.osim,lab_heel,,,,both.toml\n"
    ),
    "follow.csv": (
        "model,from,follow-bodies,body-scale-file,level,output\n"
        "scaled.osim,generic.osim,yes,applied.xml,yes,a.osim\n"
        "scaled_hunt.osim,generic_hunt.osim,yes,,,b.osim\n"
    ),
    "sets.csv": (
        "model,geometry,--model,target-mass,output,geometry-output\n"
        "forces.xml,geometry.xml,bones.osim,492,f.xml,g.xml\n"
    ),
    "contradicting.csv": "model,target-mass,from,set\nhuman.osim,5,falisse2022,\nhuman.osim,5,,stiffness=2\n",
    "designs.csv": (
        "model,verb,indentation,restitution,spheres,mass\nhuman.osim,design,0.16,0.9,,\nmodel.osim,Design,,0.8,2,70\n"
    ),
    "seven.csv": (
        "model,from,mass,spheres,radius,output\n"
        "hunt.osim,falisse2022,62,6,0.032,a.osim\nrat.osim,falisse2022,0.0209,2,0.002,b.osim\n"
        "emu2.osim,falisse2022,37.80,2,0.030,c.osim\nhorse.osim,falisse2022,545,10,0.015,d.osim\n"
    ),
}

UNITS = (1.0, 1.0, 1.0, 1.0)


def measured(units: tuple[float, ...] = UNITS, between: str = ",", decimal: str = ".", loss: float = 0.8) -> str:
    """Time, indentation, speed and force of a pad that is pressed in and let go."""
    half = math.pi / 0.2
    lines = [between.join(("time", "indentation", "speed", "force"))]
    for step in range(41):
        time = 0.005 * step
        depth = 0.0002 + 0.0045 * math.sin(half * time) ** 2
        speed = 0.0045 * half * math.sin(2.0 * half * time)
        elastic = 6.0 * 4.0 / 3.0 * math.sqrt(0.032) * 4e5 * max(depth - 0.0005, 0.0) ** 1.5
        row = (time, depth, speed, elastic * (1.0 + 1.5 * loss * speed))
        cells = (f"{value / unit:.9g}".replace(".", decimal) for value, unit in zip(row, units, strict=True))
        lines.append(between.join(cells))
    return "\n".join(lines) + "\n"


MEASUREMENTS = {
    "curve.csv": measured(),
    "curve_eu.csv": "\ufeff" + measured((1e-3, 1e-3, 1e-3, 1e3), ";", ",").replace("\n", "\r\n"),
    "curve_tabs.csv": measured(between="\t"),
    "curve_comma_tabs.csv": measured(between="\t", decimal=","),
    "curve_micro.csv": measured((1.0, 1e-6, 1.0, 1e-3)),
    "curve_ms.csv": measured((1e-3, 1.0, 1.0, 1.0)),
    "curve_fast.csv": measured(loss=20.0),
    "sep.csv": "sep=,\nindentation,force\n0.001,1\n0.002,3\n0.003,6\n",
    "column_twice.csv": "indentation,force,force\n0.001,1,1\n0.002,3,3\n0.003,6,6\n",
    "fit_huge.csv": "indentation,force\n1e300,1e300\n2e300,3e300\n3e300,6e300\n",
    "fit_word.csv": "indentation,force\n0.001,1\n0.002,abc\n",
    "fit_blank.csv": "indentation,force\n0.001,1\n0.002,\n",
    "fit_short.csv": "indentation,force\n0.001,1\n0.002\n",
    "fit_nan.csv": "indentation,force\n0.001,nan\n",
    "fit_comma.csv": 'indentation,force\n"0,001",1\n',
    "fit_thousands.csv": "indentation;force\n1.000,5;1\n",
    "fit_units.csv": "indentation,force\nm,N\n0.001,1\n",
    "fit_names.csv": "depth,load\n0.001,1\n",
    "fit_empty.csv": "",
    "fit_one.csv": "indentation,force\n0.001,1\n",
    "fit_minus.csv": "indentation,force\n0.001,2\n0.002,-4\n0.003,-9\n",
    "fit_time.csv": "time,indentation,force\n0,0.001,1\n1,0.002,3\n1,0.003,5\n2,0.003,5\n",
    "fit_same.csv": "speed,indentation,force\n1,0.001,1\n1,0.002,3\n1,0.003,5\n1,0.004,8\n",
    "fit_zeros.csv": "indentation,force\n0,0\n0,0\n0,0\n",
}

TEXTS = {**PRESETS, "lab2.toml": LAB, **MANIFESTS, **MEASUREMENTS}
