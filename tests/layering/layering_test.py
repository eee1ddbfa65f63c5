"""The folder rules: who may include whom, and what every folder must list.

Run by CTest. `check(tree)` returns every broken rule as a sentence; the tests plant one fault of each kind and see it
reported, then check the repository itself.
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = ("topology", "femoop", "ui", "apps", "examples", "tests")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
STANDARD = re.compile(r"[a-z_0-9]+$")  # <vector>, <cmath>: no slash and no ".h"

EIGEN = re.compile(r"Eigen/")
JSON = re.compile(r"nlohmann/")
SPARSE = re.compile(r"(suitesparse/)?(cholmod|SuiteSparse_config|cblas|metis)")
FONTS_AND_IMAGES = re.compile(r"cairo|ft2build|freetype/|fontconfig/|png\.h$|turbojpeg\.h$")
WINDOW = re.compile(r"(imgui|imstb_|GLFW/|GL/|EGL/|GLES)")
OPTIONS = re.compile(r"CLI/")
SYSTEM = re.compile(r"(dlfcn|fcntl|spawn|unistd|windows)\.h$|sys/")
XML = re.compile(r"pugixml\.hpp$")
BROWSER = re.compile(r"emscripten(\.h$|/)|stb/")  # a page's own, and the pictures that Cairo reads elsewhere

# The folders of femoop, each with those that it may know besides itself: from the model up to the analyses, no circles.
# What no line names may know all of femoop: hand methods and files, which stand above.
MODEL, NUMBERS, ALGEBRA = "femoop/model/", "femoop/solver/", "femoop/algebra/"
GEOMETRY, SECTION = "femoop/geometry/", "femoop/section/"
ELEMENT = ["femoop/element/", "femoop/shape/", "femoop/rule/", "femoop/material/"]
LOAD, DISCRETISATION, RESULT = "femoop/load/", "femoop/discretisation/", "femoop/result/"
HALVES = "femoop/tabular/halves.h"  # who writes a number rounds its last digit alike
FEMOOP = {
    "model": [MODEL, HALVES],
    "model/check": [MODEL, SECTION, GEOMETRY, LOAD, *ELEMENT],
    "section": [MODEL],
    "geometry": [MODEL],
    "algebra": [],
    "solver": [ALGEBRA],
    "shape": [],
    "rule": ["femoop/shape/"],
    "material": [],
    "element": [MODEL, GEOMETRY, NUMBERS, ALGEBRA, *ELEMENT],
    "load": [MODEL, GEOMETRY, *ELEMENT],
    "discretisation": [MODEL, SECTION, GEOMETRY, LOAD, NUMBERS, *ELEMENT],
    "result": [MODEL, GEOMETRY, LOAD, NUMBERS, DISCRETISATION, *ELEMENT],
    "analysis": [MODEL, GEOMETRY, LOAD, NUMBERS, ALGEBRA, DISCRETISATION, RESULT, *ELEMENT],
    "edit": [MODEL, SECTION, GEOMETRY, LOAD],
    "typical": [MODEL],
}

UI_BASE = ["ui/history/", "ui/command/", "ui/text/", "ui/scenario/"]

# The longest folder that matches a file names its rule: what it may include besides the standard library.
ALLOWED = {
    "femoop/tabular": ["femoop/tabular/"],  # tables and whole files alone: ui knows them too
    "femoop/files": ["femoop/files/", SYSTEM],
    "topology": ["topology/"],
    "femoop": ["femoop/", EIGEN],
    "femoop/io": ["femoop/", EIGEN, JSON, SYSTEM],
    **{f"femoop/{folder}": [f"femoop/{folder}/", *below, EIGEN] for folder, below in FEMOOP.items()},
    "femoop/solver": [NUMBERS, ALGEBRA, EIGEN, SPARSE, SYSTEM, BROWSER],
    "ui": ["ui/", "femoop/tabular/", "femoop/files/", WINDOW, FONTS_AND_IMAGES, SYSTEM],
    "ui/context/web": ["ui/", WINDOW, BROWSER],
    "ui/app": ["ui/", "femoop/files/", WINDOW, OPTIONS],
    "ui/paint": ["ui/paint/", "femoop/files/", FONTS_AND_IMAGES],
    "ui/paint/web": ["ui/paint/", BROWSER],
    "ui/canvas": ["ui/canvas/", "ui/paint/"],
    "ui/history": UI_BASE,
    "ui/command": UI_BASE,
    "ui/text": [*UI_BASE, HALVES],
    "ui/text/web": [*UI_BASE, BROWSER],
    "ui/scenario": UI_BASE,
    "ui/files": [*UI_BASE, "ui/files/", "femoop/files/", SYSTEM],
    "ui/workbench": [*UI_BASE, "ui/files/", "ui/workbench/", "femoop/files/"],
    "examples": ["femoop/", "topology/", EIGEN],
    "tests": ["topology/", "femoop/", "ui/", "apps/", "tests/", re.compile(r"")],
}
# Structures are drawn in one way by all apps; the drawing knows no app.
DRAWING = "apps/drawing/"
DRAWING_ALLOWED = [DRAWING, "femoop/", *UI_BASE, "ui/paint/", "ui/canvas/", EIGEN]
DRAWING_VALUES = re.compile(r"apps/drawing/(\w+)\.h$")  # what a picture shows: sets, parts, dimension lines
APP_ALLOWED = ["topology/", "femoop/", "ui/", DRAWING, EIGEN, SYSTEM]
VERSION = "apps/version.h"  # written by the build, for programs alone
VIEW_FILE = "ui/files/view_file.h"  # where what belongs to a picture stands
IN_BACKGROUND = "ui/files/in_background.h"  # a thread, which a document may wait for
APP_DOCUMENT_ALLOWED = ["topology/", "femoop/", *UI_BASE, VIEW_FILE, IN_BACKGROUND, DRAWING_VALUES, EIGEN]  # tests drive it without a screen
APP_VIEW_ALLOWED = [*APP_DOCUMENT_ALLOWED, DRAWING, "ui/paint/", "ui/canvas/"]  # draws through the Painter only
CLI_ALLOWED = [*APP_ALLOWED, "apps/", OPTIONS, JSON]
BORROWED = {
    "cross": ["apps/frame/document/"],  # structures are edited in one way only
    "frame": ["apps/cross/document/", "apps/mohr/document/"],  # it hands documents of theirs over
    "plane": ["apps/mohr/view/"],  # Mohr's circle is drawn in one way only
}
# What is wrong with a structure is said in one way in every picture too.
VIEW_BORROWED = {"cross": ["apps/frame/document/fault/"], "plane": ["apps/plane/backdrop/", "apps/plane/discretize/", "apps/mohr/view/"]}
APP_WINDOW_PART = re.compile(r"window/|panels?[/_.]|main\.cpp$")


def rule(path):
    """What the file at `path` may include."""
    if path.startswith("apps/"):
        app = path.split("/")[1]
        if app == "drawing":
            return DRAWING_ALLOWED
        if app == "cli":
            return CLI_ALLOWED
        if app == "core":  # what commands do, as a module of a page
            return [*CLI_ALLOWED, "apps/core/", BROWSER]
        inside = path.removeprefix(f"apps/{app}/")
        if inside.startswith("document"):
            return [*APP_DOCUMENT_ALLOWED, *(f"apps/{app}/{part}" for part in ("document", "backdrop", "discretize", "outline"))]
        if inside.startswith("outline"):  # reads files of other programs
            return ["topology/", "femoop/", EIGEN, XML, f"apps/{app}/outline"]
        if inside.startswith("backdrop"):  # images of photographs, and where they are kept
            return ["topology/", "femoop/", *UI_BASE, "ui/files/", "ui/paint/image.h", "ui/paint/photo_file.h", f"apps/{app}/backdrop"]
        if inside.startswith("view"):
            own = [f"apps/{app}/document", f"apps/{app}/predict", f"apps/{app}/view"]
            return [*APP_VIEW_ALLOWED, *own, *VIEW_BORROWED.get(app, [])]
        if inside.startswith("predict"):  # judges what was drawn, whoever draws it
            return ["femoop/", EIGEN, f"apps/{app}/predict"]
        own = [*APP_ALLOWED, f"apps/{app}/", *BORROWED.get(app, [])]
        return [*own, WINDOW, OPTIONS, VERSION] if APP_WINDOW_PART.match(inside) else own
    folder = path
    while folder not in ALLOWED:
        folder = folder.rpartition("/")[0]
    return ALLOWED[folder]


def is_allowed(path, bracket, header):
    if bracket == "<" and STANDARD.match(header):
        return True
    return any(header.startswith(r) if isinstance(r, str) else r.match(header) for r in rule(path))


def broken_includes(path, text):
    for bracket, header in INCLUDE.findall(text):
        if bracket == '"' and "/" not in header:
            yield f'{path}: includes "{header}"; include by full path from the top'
        elif not is_allowed(path, bracket, header):
            yield f"{path}: includes {header}, which its folder may not know"


def listed_files(cmake):
    """The source files that a CMakeLists.txt names."""
    text = re.sub(r"#.*", "", cmake)
    return set(re.findall(r"[\w./-]+\.(?:cpp|h)\b", text)) | {
        name + ".cpp" for name in re.findall(r"cremona_example\((\w+)", text)}


def public_headers(cmake):
    text = re.sub(r"#.*", "", cmake)
    listed = re.findall(r"PUBLIC\s+FILE_SET\s+HEADERS\s+FILES((?:\s+[\w./-]+\.h)+)", text)
    return set(" ".join(listed).split())


def broken_lists(tree):
    """Sources are listed, never globbed: each stands in the list of its folder or of one above. A public header is
    installed, and with it all that it includes."""
    listed, public = set(), set()
    for path, text in tree.items():
        if path.endswith("CMakeLists.txt"):
            folder = path.removesuffix("CMakeLists.txt")
            listed |= {folder + name for name in listed_files(text)}
            public |= {folder + name for name in public_headers(text)}
    for path in tree:
        if path.endswith(".cpp") and path not in listed:
            yield f"{path}: no CMakeLists.txt lists it"
    models = tree.get("examples/CMakeLists.txt", "")
    for path in tree:
        if re.match(r"examples/\w+\.json$", path) and not re.search(rf"\b{pathlib.Path(path).stem}\b", models):
            yield f"{path}: no test of examples/CMakeLists.txt names it"
    for path in public & set(tree):
        for _, header in INCLUDE.findall(tree[path]):
            if JSON.match(header):
                yield f"{path}: a public header includes nlohmann-json"
            elif header in tree and header not in public:
                yield f"{path}: a public header includes {header}, which is not installed"


def forgotten_folders(tree):
    """A folder with a list of its own is added by the list of a folder above."""
    for path in tree:
        folders = path.split("/")[:-1]
        above = [(tree.get("/".join([*folders[:i], "CMakeLists.txt"])), "/".join(folders[i:])) for i in range(len(folders))]
        lists = [(text, name) for text, name in above if text is not None]
        if path.endswith("/CMakeLists.txt") and lists and not any(
                re.search(rf"add_subdirectory\({re.escape(name)}[\s)]", text) for text, name in lists):
            yield f"{path}: no CMakeLists.txt above adds its folder"


def broken_references(path, text):
    """The repository stands alone."""
    outside = "../" + "shared"
    if outside in text:
        yield f"{path}: names {outside}, which is not in the repository"


def check(tree):
    """Every broken rule of `tree`, a dict from path to text."""
    faults = [*broken_lists(tree), *forgotten_folders(tree)]
    for path, text in tree.items():
        faults += broken_references(path, text)
        if path.endswith((".cpp", ".h")) and path.split("/")[0] in CODE:
            faults += broken_includes(path, text)
    return sorted(faults)


def repository():
    ends = (".cpp", ".h", ".txt", ".cmake", ".md", ".py", ".json", ".bash", ".po")
    tree = {}
    for path in ROOT.rglob("*"):
        name = path.relative_to(ROOT).as_posix()
        if name.startswith(("build/", ".git/")) or not path.is_file():
            continue
        if name.endswith(ends) or name in ("run", "test", ".ci/run"):
            tree[name] = path.read_text(encoding="utf-8", errors="replace")
    return tree


class Rules(unittest.TestCase):
    def faults(self, path, line):
        folder, _, name = path.rpartition("/")
        return check({path: line + "\n", f"{folder}/CMakeLists.txt": f"target_sources(x PRIVATE {name})"})

    def assert_refused(self, path, line):
        self.assertEqual(len(self.faults(path, line)), 1, f"{path} may {line}")

    def assert_allowed(self, path, line):
        self.assertEqual(self.faults(path, line), [])

    def test_the_libraries_know_neither_each_other_nor_ui_nor_the_apps(self):
        for header in ("topology/halfedge/ids.h", "ui/paint/painter.h", "apps/frame/document.h"):
            self.assert_refused("femoop/model/model.h", f'#include "{header}"')
        for header in ("femoop/model/model.h", "ui/paint/painter.h", "apps/frame/document.h"):
            self.assert_refused("topology/halfedge/ids.h", f'#include "{header}"')
        self.assert_refused("topology/geometry/vector.h", "#include <Eigen/Core>")
        for path in ("femoop/io/results/tables.cpp", "ui/report/html.cpp", "apps/mohr/session/report.cpp"):
            self.assert_allowed(path, '#include "femoop/tabular/table.h"')
        for path in ("femoop/io/model_file.cpp", "ui/paint/surface/write_file.cpp", "apps/mohr/session/export.cpp"):
            self.assert_allowed(path, '#include "femoop/files/whole_file.h"')
        for header in ("femoop/model/model.h", "ui/text/catalogue.h", "topology/halfedge/ids.h"):
            self.assert_refused("femoop/tabular/table.h", f'#include "{header}"')
            self.assert_refused("femoop/files/whole_file.h", f'#include "{header}"')
        self.assert_allowed("femoop/model/model.h", "#include <Eigen/Core>")

    def test_ui_knows_no_mechanics_and_ui_base_the_standard_library_alone(self):
        self.assert_refused("ui/canvas/view.h", '#include "femoop/model/model.h"')
        self.assert_refused("ui/history/history.h", "#include <imgui.h>")
        self.assert_refused("ui/text/catalogue.cpp", '#include "ui/paint/painter.h"')
        self.assert_refused("ui/canvas/camera.cpp", "#include <imgui.h>")
        self.assert_allowed("ui/widgets/number_field.cpp", "#include <imgui.h>")
        self.assert_refused("ui/widgets/number_field.cpp", "#include <CLI/CLI.hpp>")
        self.assert_allowed("ui/app/app_options.cpp", "#include <CLI/CLI.hpp>")

    def test_window_headers_stay_in_ui_and_in_an_apps_window_panels_and_main(self):
        for header in ("imgui.h", "GLFW/glfw3.h", "GL/gl.h"):
            self.assert_refused("apps/frame/document.h", f"#include <{header}>")
            self.assert_refused("ui/paint/painter.h", f"#include <{header}>")
            self.assert_refused("femoop/io/read.cpp", f"#include <{header}>")
            self.assert_refused("apps/frame/view/loads.cpp", f"#include <{header}>")
            self.assert_allowed("apps/frame/window/loads_panel.cpp", f"#include <{header}>")
            self.assert_allowed("apps/frame/main.cpp", f"#include <{header}>")

    def test_an_apps_document_knows_of_ui_only_what_needs_no_screen_and_its_view_draws_through_the_painter(self):
        self.assert_refused("apps/frame/document/document.h", '#include "ui/paint/painter.h"')
        self.assert_refused("apps/frame/document/document.h", '#include "apps/frame/view/kept_view.h"')
        self.assert_allowed("apps/frame/document/document.h", '#include "ui/history/history.h"')
        self.assert_refused("apps/frame/view/kept_view.cpp", '#include "ui/context/context.h"')
        self.assert_allowed("apps/frame/view/kept_view.cpp", '#include "ui/paint/painter.h"')

    def test_what_judges_a_sketched_diagram_knows_the_mechanics_alone(self):
        self.assert_refused("apps/frame/predict/score.cpp", '#include "ui/text/message.h"')
        self.assert_refused("apps/frame/predict/score.cpp", '#include "apps/frame/view/kept_view.h"')
        self.assert_allowed("apps/frame/predict/score.cpp", '#include "femoop/result/curve.h"')
        self.assert_allowed("apps/frame/view/kept_view.cpp", '#include "apps/frame/predict/prediction.h"')

    def test_json_stays_in_io_and_out_of_public_headers(self):
        self.assert_refused("femoop/model/model.cpp", "#include <nlohmann/json.hpp>")
        self.assert_allowed("femoop/io/read.cpp", "#include <nlohmann/json.hpp>")
        public = {"femoop/io/read.h": "#include <nlohmann/json.hpp>",
                  "femoop/io/CMakeLists.txt": "target_sources(femoop PUBLIC FILE_SET HEADERS FILES read.h)"}
        self.assertEqual(check(public), ["femoop/io/read.h: a public header includes nlohmann-json"])

    def test_the_folders_of_femoop_know_those_below_them_alone(self):
        self.assert_refused("femoop/element/member_element.h", '#include "femoop/result/results.h"')
        self.assert_refused("femoop/element/element.h", '#include "femoop/analysis/control.h"')
        self.assert_refused("femoop/shape/shape.h", '#include "femoop/rule/integration_rule.h"')
        self.assert_refused("femoop/material/linear_elastic.h", '#include "femoop/model/property.h"')
        self.assert_allowed("femoop/rule/integration_rule.h", '#include "femoop/shape/natural_point.h"')
        self.assert_refused("femoop/result/results.h", '#include "femoop/analysis/linear_static.h"')
        self.assert_refused("femoop/result/results.cpp", '#include "femoop/io/verify.h"')
        self.assert_refused("femoop/model/model.h", '#include "femoop/section/section_properties.h"')
        self.assert_allowed("femoop/model/check/check.cpp", '#include "femoop/section/section_properties.h"')
        self.assert_allowed("femoop/analysis/linear_static.h", '#include "femoop/result/results.h"')
        self.assert_allowed("femoop/io/verify.cpp", '#include "femoop/result/results.h"')

    def test_cholmod_and_metis_stay_in_the_solver(self):
        self.assert_refused("femoop/analysis/linear_static.cpp", "#include <cholmod.h>")
        self.assert_allowed("femoop/solver/cholmod_solver.cpp", "#include <suitesparse/cholmod.h>")
        self.assert_allowed("femoop/solver/metis_ordering.cpp", "#include <metis.h>")

    def test_the_drawing_of_structures_knows_no_app_and_every_app_may_draw_with_it(self):
        for header in ("apps/frame/document/part.h", "apps/cross/view/scene.h", "ui/context/context.h", "topology/halfedge/ids.h"):
            self.assert_refused("apps/drawing/sheet/subject.h", f'#include "{header}"')
        self.assert_allowed("apps/drawing/sheet/subject.h", '#include "ui/paint/painter.h"')
        for path in ("apps/frame/view/solver.cpp", "apps/cross/view/draw.cpp", "apps/frame/window/canvas.cpp"):
            self.assert_allowed(path, '#include "apps/drawing/sketch/scene.h"')
        self.assert_allowed("apps/frame/document/document.h", '#include "apps/drawing/show.h"')
        self.assert_refused("apps/frame/document/document.h", '#include "apps/drawing/sketch/scene.h"')
        self.assert_refused("apps/cross/view/draw.cpp", '#include "apps/frame/view/kept_view.h"')

    def test_an_app_does_not_know_another_app(self):
        self.assert_refused("apps/cross/document.h", '#include "apps/frame/document.h"')
        self.assert_allowed("apps/cli/render.cpp", '#include "apps/frame/view/kept_view.h"')

    def test_headers_are_included_by_full_path_and_every_file_is_listed(self):
        self.assert_refused("femoop/model/model.cpp", '#include "model.h"')
        self.assertEqual(check({"femoop/a.cpp": "", "femoop/CMakeLists.txt": "target_sources(femoop PRIVATE b.cpp)"}),
                         ["femoop/a.cpp: no CMakeLists.txt lists it"])

    def test_every_folder_with_a_list_is_added_by_one_above(self):
        tree = {"tests/CMakeLists.txt": "add_subdirectory(apps)", "tests/apps/CMakeLists.txt": "",
                "tests/apps/mohr/CMakeLists.txt": ""}
        self.assertEqual(check(tree), ["tests/apps/mohr/CMakeLists.txt: no CMakeLists.txt above adds its folder"])
        tree["tests/apps/CMakeLists.txt"] = "add_subdirectory(mohr)"
        self.assertEqual(check(tree), [])

    def test_every_model_file_of_the_examples_is_tested(self):
        self.assertEqual(check({"examples/arch.json": "{}", "examples/CMakeLists.txt": "foreach(model IN ITEMS beam)"}),
                         ["examples/arch.json: no test of examples/CMakeLists.txt names it"])

    def test_what_a_public_header_includes_is_installed_too(self):
        tree = {"femoop/model/a.h": '#include "femoop/model/b.h"', "femoop/model/b.h": "",
                "femoop/model/CMakeLists.txt": "target_sources(femoop PUBLIC FILE_SET HEADERS FILES a.h)"}
        self.assertEqual(check(tree), ["femoop/model/a.h: a public header includes femoop/model/b.h, which is not installed"])
        tree["femoop/model/CMakeLists.txt"] = "target_sources(femoop PUBLIC FILE_SET HEADERS FILES a.h b.h)"
        self.assertEqual(check(tree), [])

    def test_the_repository_names_nothing_outside_itself(self):
        self.assert_refused("femoop/model/dof.cpp", "// as in ../" + "shared/spec")

    def test_the_repository_keeps_the_rules(self):
        tree = repository()
        self.assertGreater(sum(path.endswith(".cpp") for path in tree), 10)
        faults = check(tree)
        self.assertEqual(faults, [], "\n" + "\n".join(faults))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
