"""What a result was computed from, as the first table of each page: read from parameters.prm."""

import html
import os
import re

FINITE, HALF = "run", "half-spaces"


def read(folder):
    """All entries of parameters.prm, "Section/Entry" -> text; empty where there is no such file."""
    path = os.path.join(folder, "parameters.prm")
    entries, section = {}, ""
    if not os.path.exists(path):
        return entries
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.strip()
            if words.startswith("subsection "):
                section = words[len("subsection "):].strip() + "/"
            elif words == "end":
                section = ""
            elif words.startswith("set ") and "=" in words:
                name, value = words[len("set "):].split("=", 1)
                entries[section + name.strip()] = value.strip()
    return entries


def title(entries, what):
    """The user's title and what the page is about; the latter alone where there is none."""
    given = entries.get("Title", "")
    return f"{given}: {what}" if given else what[0].upper() + what[1:]


def _profiles(entry):
    wheel, rail = (os.path.basename(entry("Profiles/" + body)) for body in ("Wheel", "Rail"))
    second = os.path.basename(entry("Profiles/Second rail"))
    rails = f"{rail} rail" if second in ("none", "") else f"rails {rail} and {second}"
    text = f"{wheel} wheel on {rails}, inclination {entry('Track/Rail inclination').replace('/', ':')}"
    left = [entry(f"Profiles/{body} left") for body in ("Wheel", "Rail")]
    if entry("Wheelset/Wheels") == "both" and any(name not in ("as right", "") for name in left):
        wheel, rail = (right if name in ("as right", "") else os.path.basename(name) for right, name in zip((wheel, rail), left))
        text += f"; left {wheel} wheel on {rail} rail"
    return text


def _curve(entry):
    """Radius, cant and what tells the load of the outer wheel."""
    cant = entry("Track/Cant")
    text = "radius " + entry("Track/Radius")
    if cant not in ("none", ""):
        text += f", cant {cant}, centre of gravity {entry('Wheelset/Centre of gravity height')} above the rails"
    return text


def _drive(entry):
    if entry("Wheelset/Drive") == "rate":
        return "creepage " + entry("Wheelset/Creepage")
    traction = entry("Wheelset/Traction coefficient")
    try:
        value = float(traction)
    except ValueError:
        return "traction coefficient " + traction
    word = "driving" if value > 0 else "braking" if value < 0 else "rolling freely"
    return f"{word}, traction coefficient {traction}"


def _steel(entry):
    def of(body):
        stress = entry(f"{body} material/Yield stress")
        return "elastic" if stress in ("none", "") else "yields at " + stress
    rail, wheel = of("Rail"), of("Wheel")
    return "rail and wheel " + rail if rail == wheel else f"rail {rail}, wheel {wheel}"


def _irregularities(entries):
    """A row for each irregularity of the running surfaces: what it is, and where."""
    shapes = {"dent": ("Length", "Width", "Depth"), "squat": ("Length", "Width", "Depth"), "weld": ("Length", "Depth"),
              "corrugation": ("Wavelength", "Depth", "Length"), "dipped joint": ("Length", "Depth", "Angle"),
              "flat": ("Length",), "rounded flat": ("Length", "Depth"), "polygon": ("Order", "Depth"),
              "roughness": ("File", "Length"), "file": ("File",)}
    found = []
    for number in range(1, 10):
        section = f"Irregularity {number}/"
        kind = entries.get(section + "Kind", "none")
        if kind == "none":
            continue
        said = [f"{name.lower()} {os.path.basename(entries.get(section + name, ''))}" for name in shapes.get(kind, ())
                if entries.get(section + name, "none") not in ("none", "auto", "whole")]
        place = entries.get(section + "Place", "0 mm")
        found.append((f"irregularity {number}", ", ".join([kind] + said) + f", at {place}"))
    return found


def _support(entry):
    """What the rail stands on."""
    length = "rail " + entry("Track/Rail length")
    kind = entry("Track/Support")
    if kind in ("clamped foot", ""):
        return "foot and ends of the rail clamped, " + length
    text = f"{kind}, one every {entry('Track/Sleeper spacing')}, pads {entry('Track/Pad stiffness')}" \
           f" with loss factor {entry('Track/Pad loss factor')} ({entry('Track/Pad damping')})"
    if kind == "sleepers":
        text += f", first sleeper at {entry('Track/First sleeper')}, mass {entry('Track/Sleeper mass')}"
        if entry("Track/Sleeper mass") != "rigid":
            text += f", ballast {entry('Track/Ballast stiffness')} with loss factor {entry('Track/Ballast loss factor')}"
    return f"{text}; {length}, damped ends {entry('Track/Damped ends')}"


def rows(entries, summary=None, of=FINITE):
    """Label and text of what matters; empty where parameters.prm is not there."""
    if not entries:
        return []

    def entry(name):
        """As it was given; of computed numbers, as those of a wheelset, four digits."""
        return re.sub(r"-?\d+\.\d{7,}", lambda found: f"{float(found[0]):.4g}", entries.get(name, ""))

    load = (summary or {}).get("wheel_load_N") or (summary or {}).get("vertical_force_N")
    given = entry("Half-space/Undeformed distance") not in ("profiles", "") and of == HALF
    found = [("surfaces", "distance " + entry("Half-space/Undeformed distance"))] if given else \
        [("wheel and rail", _profiles(entry))]
    if load:
        found.append(("wheel load", f"{1e-3 * load:.2f} kN"))
    found.append(("speed", entry("Wheelset/Velocity")))
    motion = entry("Wheelset/Motion")
    if motion not in ("none", ""):
        found.append(("motion", "follows " + os.path.basename(motion)))
    elif entry("Wheelset/Pose") == "equilibrium":
        found.append(("wheelset", "lateral shift and yaw from equilibrium"))
    elif not given:
        found.append(("wheelset", f"lateral shift {entry('Wheelset/Lateral shift')}, yaw {entry('Wheelset/Yaw')}"))
    if entry("Track/Radius") not in ("straight", "") and of == HALF:
        found.append(("curve", _curve(entry)))
    found += [("drive", _drive(entry)), ("friction", entry("Contact/Friction coefficient"))] + _irregularities(entries)
    if of == FINITE:
        found += [("steel", _steel(entry)), ("support", _support(entry)), ("cells", entry("Mesh/Solution cell size")),
                  ("rolling distance", entry("Run/Rolling distance"))]
    else:
        found.append(("bodies", "half-spaces" if entry("Half-space/Bodies") == "half-spaces" or given else
                      "true ones, the elasticity of this wheel and this rail"))
        found.append(("elements", entry("Half-space/Element size")))
    return [(label, text) for label, text in found if text]


def wear_rows(entries):
    """Of the command wear: the scene's, and what its profiles wear under."""
    if not entries:
        return []

    def entry(name):
        return entries.get("Wear/" + name, "")

    mix = os.path.basename(entry("Mix"))
    found = [row for row in rows(entries, of=HALF) if mix == "none" or row[0] in ("wheel and rail", "friction", "bodies", "elements")]
    both = entry("Worn") == "both"
    found += [("traffic", "the scene alone" if mix == "none" else mix),
              ("wheels", "both of the wheelset" if entries.get("Wheelset/Wheels") == "both" else "one"),
              ("worn", "rail and wheel" if both else entry("Worn")),
              ("distance of the wheel", entry("Distance")) if entry("Worn") == "wheel" else ("gross load", entry("Gross load"))]
    if both:
        found.append(("wheels that share the rail", f"{entry('Wheels')} on {entry('Line length')}"))
    coefficient = entry("Archard coefficient")
    found += [("Archard coefficient", "over slip velocity and pressure" if coefficient == "map" else coefficient),
              ("hardness", entry("Hardness")), ("smoothing length", entry("Smoothing length"))]
    return [(label, text) for label, text in found if text]


def track_rows(entries, summary):
    """Of the command receptance: what is struck, where, and what the rail stands on."""
    rail = summary["body"] == "rail"
    found = [("struck", f"{summary['body']}, {summary['direction']}")]
    if not rail:
        return found + [("wheel", os.path.basename(entries.get("Profiles/Wheel", "")))]
    found += [("at", f"{1e3 * summary['at_m']:.0f} mm along the track"),
              ("rail", os.path.basename(entries.get("Profiles/Rail", ""))),
              ("support", _support(lambda name: entries.get(name, "")))]
    return [(label, text) for label, text in found if text]


def material_rows(entries):
    """Of the command material: the steel and what it goes through."""
    body = entries.get("Material test/Body", "")
    if not body:
        return []
    steel = body.capitalize() + " material/"
    law = entries.get(steel + "Law", "")
    names = ["Young's modulus", "Poisson's ratio", "Yield stress"]
    if law == "bilinear":
        names += ["Tangent modulus", "Hardening"]
    if law == "Chaboche":
        names += ["Isotropic saturation", "Isotropic rate", "Kinematic moduli", "Kinematic rates"]
    found = [("steel", f"of the {body}, {law}")] + [(name, entries.get(steel + name, "")) for name in names]
    path = entries.get("Material test/File", "none")
    if path != "none":
        found.append(("path", os.path.basename(path)))
    else:
        found += [(name.lower(), entries.get("Material test/" + name, "none")) for name in ("Axial", "Shear")]
    found.append(("cycles", entries.get("Material test/Cycles", "")))
    return [(label, text) for label, text in found if text not in ("", "none")]


def table(found):
    """Them as a table of a page."""
    lines = [f"<tr><td>{html.escape(label)}</td><td>{html.escape(text)}</td></tr>" for label, text in found]
    return "<table>" + "\n".join(lines) + "</table>" if lines else ""
