"""The published schema says what the reader says: it accepts every model of the project and refuses what is wrong."""
import copy
import json
import pathlib
import sys
import unittest

from jsonschema import Draft202012Validator

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "courseware/reference/model.schema.json").read_text(encoding="utf-8"))
VALIDATOR = Draft202012Validator(SCHEMA)
PLANE_SCHEMA = json.loads((ROOT / "courseware/reference/plane.schema.json").read_text(encoding="utf-8"))
PLANE_ANALYSES = PLANE_SCHEMA["properties"]["analysis"]["enum"]

SOUND = {
    "cremona": 1,
    "analysis": "frame2d",
    "units": {"length": "m", "force": "kN"},
    "materials": [{"id": "m", "E": "205 GPa"}],
    "sections": [{"id": "s", "A": 0.012, "Iz": 2e-4}],
    "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0]}],
    "members": [{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}],
    "load_cases": [{"id": "G", "members": [{"member": "AB", "kind": "distributed", "qy": -5}]}],
    "expected": [{"quantity": "displacement", "node": "B", "component": "uy", "value": -1}],
}

# A path into SOUND, and what makes it bad there; None takes the key away.
BAD = [
    (["cremona"], 2),
    (["cremona"], None),
    (["analysis"], "frame"),
    (["units"], None),
    (["units", "length"], "yard"),
    (["units", "force"], None),
    (["nodes", 0, "suport"], "fixed"),
    (["nodes", 0, "id"], ""),
    (["nodes", 0, "id"], 1),
    (["nodes", 0, "id"], "A\tB"),
    (["nodes", 0, "at"], [0, 0, 0]),
    (["nodes", 0, "at"], [0]),
    (["nodes", 0, "at"], ["left", 0]),
    (["nodes", 0, "support"], "pinned"),
    (["nodes", 0, "support"], {"fixed": ["vx"]}),
    (["nodes", 0, "support"], {"fixed": ["ux", "uy", "ux"]}),
    (["nodes", 0, "support"], {"springs": {"ux": 0}}),
    (["nodes", 0, "hinge"], "yes"),
    (["materials", 0, "E"], None),
    (["materials", 0, "E"], "205 bar"),
    (["materials", 0, "E"], "205"),
    (["materials", 0, "E"], 0),
    (["materials", 0, "E"], "-205 GPa"),
    (["materials", 0, "nu"], "0.3 m"),
    (["materials", 0, "nu"], -1),
    (["materials", 0, "nu"], 0.6),
    (["materials", 0, "G"], 0),
    (["materials", 0, "density"], -1),
    (["materials", 0, "fy"], -1),
    (["sections", 0, "A"], 0),
    (["nodes", 1, "mass"], {"ux": -1}),
    (["expected", 0, "component"], None),
    (["expected", 0, "member"], "AB"),
    (["expected", 0], {"quantity": "section_force", "member": "AB", "component": "M", "value": 1}),
    (["expected", 0], {"quantity": "extreme", "member": "AB", "component": "M", "value": 1}),
    (["expected", 0], {"quantity": "reaction", "node": "A", "component": "ux", "value": 1}),
    (["sections", 0, "shape"], "triangle"),
    (["sections", 0, "b"], 0.2),
    (["sections", 0, "shape"], "box"),
    (["sections"], [{"id": "s", "shape": "circle", "d": 0.2, "tw": 0.01}]),
    (["sections"], [{"id": "s", "shape": "circle", "d": 0.2, "profile": "IPE 300"}]),
    (["members", 0, "nodes"], ["A"]),
    (["members", 0, "material"], None),
    (["members", 0, "section"], None),
    (["members", 0, "theory"], "bernoulli"),
    (["members", 0, "foundation"], {"z": 5}),
    (["members", 0, "foundation"], {"y": 0}),
    (["members", 0, "up"], [0, 1]),
    (["members", 0, "start"], {"release": "rz"}),
    (["members", 0, "start"], {"release": ["rz", "rz"]}),
    (["load_cases", 0, "id"], None),
    (["load_cases", 0, "self_weight"], "1"),
    (["load_cases", 0, "members", 0, "kind"], "distribute"),
    (["load_cases", 0, "members", 0, "qy"], [-1, -2, -3]),
    (["load_cases", 0, "members", 0, "from"], "half%"),
    (["load_cases", 0, "members", 0, "at"], 1),
    (["load_cases", 0, "members", 0, "axes"], "member"),
    (["combinations"], [{"id": "U", "factors": {"G": "1.35"}}]),
    (["expected", 0, "value"], None),
    (["expected", 0, "quantity"], "deflection"),
    (["expected", 0, "which"], 0),
    (["expected", 0, "rtol"], -1),
    (["author"], "nobody"),
]


def changed(path, value, sound=SOUND):
    model = copy.deepcopy(sound)
    place = model
    for step in path[:-1]:
        place = place[step]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return model


class Schema(unittest.TestCase):
    def test_it_is_a_schema_of_2020_12(self):
        Draft202012Validator.check_schema(SCHEMA)

    def test_it_accepts_every_example_and_every_case(self):
        files = sorted((ROOT / "examples").glob("*.json")) + sorted((ROOT / "tests/cases").rglob("*.json"))
        files.append(ROOT / "tests/femoop/io/everything.json")
        self.assertGreater(len(files), 50)
        for file in files:
            with self.subTest(file=file.name):
                model = json.loads(file.read_text(encoding="utf-8"))
                if model["analysis"] not in PLANE_ANALYSES:
                    VALIDATOR.validate(model)

    def test_it_accepts_the_sound_model(self):
        VALIDATOR.validate(SOUND)

    def test_it_refuses_each_bad_one(self):
        for path, value in BAD:
            with self.subTest(path=path, value=value):
                self.assertFalse(VALIDATOR.is_valid(changed(path, value)))

    def test_every_key_that_it_knows_is_used_in_the_file_that_says_everything(self):
        said = set()

        def collect(value):
            if isinstance(value, dict):
                said.update(value)
                for inner in value.values():
                    collect(inner)
            elif isinstance(value, list):
                for inner in value:
                    collect(inner)

        collect(json.loads((ROOT / "tests/femoop/io/everything.json").read_text(encoding="utf-8")))
        known = {key for part in [SCHEMA, *SCHEMA["$defs"].values()] for key in part.get("properties", {})}
        in_space = {"uz", "rx", "ry", "fz", "mx", "my", "qz", "up"}
        ends = {key for key in known if key.startswith(("start_", "end_"))}
        sizes = {"b", "bf", "tf", "tw"}
        self.assertEqual(known - said - in_space - ends - sizes - {"influence"}, set())


PLANE_SOUND = {
    "cremona": 1,
    "analysis": "plane_stress",
    "units": {"length": "mm", "force": "N"},
    "materials": [{"id": "m", "E": "71 GPa"}],
    "points": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [0, 2]}],
    "curves": [{"id": "c", "kind": "edges", "points": ["A", "B"], "support": "symmetry"}],
    "regions": [{"id": "r", "material": "m", "thickness": 2}],
    "elements": [{"id": "1", "kind": "T3", "points": ["A", "B", "C"], "region": "r"}],
    "load_cases": [{"id": "P", "curves": [{"curve": "c", "kind": "traction", "qx": [1, 2]}]}],
    "expected": [{"quantity": "displacement", "point": "B", "component": "ux", "value": 1}],
}

PLANE_BAD = [
    (["analysis"], "frame2d"),
    (["elements"], None),
    (["elements"], []),
    (["materials", 0, "G"], 3),
    (["points", 0, "at"], [1]),
    (["points", 0, "support"], "symmetry"),
    (["curves", 0, "kind"], "line"),
    (["curves", 0, "tie"], ["rz"]),
    (["regions", 0, "material"], None),
    (["elements", 0, "kind"], "T4"),
    (["load_cases", 0, "curves", 0, "qx"], [1, 2, 3]),
    (["load_cases", 0, "curves", 0, "qx"], {"polynomial": [[1, 0, 13]]}),
    (["load_cases", 0, "curves", 0, "kind"], "pressure"),
    (["load_cases", 0, "settlements"], [{"point": "A", "curve": "c", "ux": 1}]),
    (["expected", 0, "quantity"], "section_force"),
    (["expected", 0, "read"], "mean"),
]


DRAWN_SOUND = {
    "cremona": 1,
    "analysis": "plane_stress",
    "units": {"length": "mm", "force": "N"},
    "points": [{"id": "A", "at": [0, 0]}],
    "curves": [
        {"id": "l", "kind": "line", "points": ["A", [3, 0]], "divide": [{"n": 2, "ratio": 3}]},
        {"id": "c", "kind": "circle", "center": "A", "radius": 1},
    ],
    "regions": [{"id": "r", "at": [0.1, 0.1], "hole": True}],
}

DRAWN_BAD = [
    (["curves", 0, "kind"], "edges"),
    (["curves", 0, "kind"], "polyline"),
    (["curves", 0, "points"], ["A"]),
    (["curves", 0, "points", 1], [3]),
    (["curves", 0, "divide"], 0),
    (["curves", 0, "center"], "A"),
    (["curves", 1, "radius"], 0),
    (["curves", 1, "center"], None),
    (["regions", 0, "at"], [1]),
    (["regions", 0, "hole"], "yes"),
]


class PlaneSchema(unittest.TestCase):
    validator = Draft202012Validator(PLANE_SCHEMA)

    def test_it_is_a_schema_of_2020_12(self):
        Draft202012Validator.check_schema(PLANE_SCHEMA)

    def test_it_accepts_every_case_and_the_file_that_says_everything(self):
        files = [*(ROOT / "tests/cases/plane").glob("*.json"), *(ROOT / "tests/cases/regions").glob("*.json")]
        files += [ROOT / f"tests/femoop/plane/everything_{what}.json" for what in ("plane", "drawn")]
        files.append(ROOT / "examples/plate.json")
        self.assertGreater(len(files), 10)
        for file in files:
            with self.subTest(file=file.name):
                self.validator.validate(json.loads(file.read_text(encoding="utf-8")))

    def test_it_refuses_each_bad_one(self):
        self.validator.validate(PLANE_SOUND)
        for path, value in PLANE_BAD:
            with self.subTest(path=path, value=value):
                self.assertFalse(self.validator.is_valid(changed(path, value, PLANE_SOUND)))
        self.validator.validate(DRAWN_SOUND)
        for path, value in DRAWN_BAD:
            with self.subTest(path=path, value=value):
                self.assertFalse(self.validator.is_valid(changed(path, value, DRAWN_SOUND)))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
