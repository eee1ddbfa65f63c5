// Golden pictures of plane models.
#include <doctest/doctest.h>

#include "tests/apps/plane_view/plate_subject.h"
#include "tests/femoop/plane/result/plane_case.h"
#include "tests/golden/scene.h"

TEST_SUITE_BEGIN("pictures");

namespace {

plane::PlateOptions plate_options(std::initializer_list<std::string_view> words,
                                  ui::ThemeName theme = ui::ThemeName::Light)
{
    plane::PlateOptions options{.show = {}, .theme = theme};
    for (const std::string_view word : words) options.show = options.show | plane::plate_shown(word).value();
    return options;
}

void check_plate(const std::string& name, const PlateSubject& subject, const plane::PlateOptions& options)
{
    golden::check_scene(name, {.size = {900.0, 700.0}, .background = plane::background(options)},
                        [&](ui::Painter& painter) { plane::draw(painter, subject.input(), options); });
}

} // namespace

TEST_CASE("A drawing: its curves, and its regions in the colours of their entries")
{
    check_plate("plate_regions", PlateSubject::example("plate"), plate_options({"geometry", "regions", "labels"}));
}

namespace {

/// Something of every kind: supports, loads, a face that is left empty, an edge that dangles.
const char* const everything_text = R"({"cremona": 1, "title": "Everything at once", "analysis": "plane_strain",
 "units": {"length": "m", "force": "kN"},
 "materials": [{"id": "rock", "E": 7e6, "nu": 0.2, "density": 2.4}, {"id": "clay", "E": 5e4, "nu": 0.35, "density": 1.8, "alpha": 1e-5}],
 "points": [{"id": "A", "at": [0, 0]}, {"id": "B", "at": [12, 0]}, {"id": "C", "at": [12, 5]}, {"id": "D", "at": [7, 8]},
            {"id": "E", "at": [0, 8]}, {"id": "F", "at": [7, 3], "support": {"fixed": ["uy"], "angle": 20, "springs": {"ux": 900}}},
            {"id": "G", "at": [4, 11]}],
 "curves": [
  {"id": "base", "kind": "line", "points": ["A", "B"], "support": "fixed"},
  {"id": "side", "kind": "line", "points": ["B", "C"], "support": {"fixed": ["ux"]}},
  {"id": "slope", "kind": "line", "points": ["C", "D"]},
  {"id": "crest", "kind": "line", "points": ["D", "E"], "divide": {"n": 10, "ratio": 4}},
  {"id": "wall", "kind": "line", "points": ["E", "A"], "support": {"fixed": [], "springs": {"ux": 4000}}, "tie": ["uy"]},
  {"id": "seam", "kind": "line", "points": [[0, 3], "F"]},
  {"id": "seam2", "kind": "line", "points": ["F", [12, 3]]},
  {"id": "cave", "kind": "circle", "center": [9.3, 1.5], "radius": 0.8},
  {"id": "pipe", "kind": "ellipse", "center": [3, 5.6], "axes": [1.4, 0.7], "angle": 30},
  {"id": "crack", "kind": "bezier", "points": ["E", [2, 9], [2, 11], "G"]}],
 "regions": [{"id": "clay", "at": [2, 1], "material": "clay"}, {"id": "rock", "at": [9, 5], "material": "rock"},
             {"id": "cavity", "at": [9.3, 1.5], "hole": true}],
 "load_cases": [
  {"id": "P", "points": [{"point": "D", "fx": 30, "fy": -40}],
   "curves": [{"curve": "crest", "kind": "pressure", "value": [10, 60]},
              {"curve": "crest", "kind": "traction", "qx": 12},
              {"curve": "slope", "kind": "line", "qy": -25},
              {"curve": "cave", "kind": "pressure", "value": {"polynomial": [[45, 0, 0], [-10, 0, 1]]}}],
   "regions": [{"region": "rock", "kind": "body", "by": -24}, {"region": "clay", "kind": "temperature", "rise": {"along": "y", "table": [[0, 12], [3, 20]]}}],
   "settlements": [{"curve": "base", "uy": -0.002}]},
  {"id": "R", "regions": [{"region": "rock", "kind": "rotation", "omega": 4, "about": [7, 3]}], "self_weight": 1}],
 "combinations": [{"id": "U", "factors": {"P": 1.5, "R": 1.2}}]})";

} // namespace

TEST_CASE("A drawing with something of every kind: supports, loads, an empty face, an edge that dangles")
{
    check_plate("plate_everything", PlateSubject(everything_text),
                plate_options({"geometry", "regions", "supports", "loads", "labels"}));
}

TEST_CASE("A combination on the projector in Portuguese: every load times its factor")
{
    const PlateSubject subject(everything_text);
    plane::PlateOptions options = plate_options({"geometry", "regions", "supports", "loads", "labels"},
                                                ui::ThemeName::Projector);
    options.load_case = subject.model().find_case("U").value();
    options.tr = ui::Catalogue(ui::Language::Portuguese);
    options.numbers.mark = ui::DecimalMark::Comma;
    check_plate("plate_everything_projector", subject, options);
}

TEST_CASE("Supports and loads in print")
{
    const PlateSubject subject(everything_text);
    plane::PlateOptions options = plate_options({"geometry", "regions", "supports", "loads", "labels"},
                                                ui::ThemeName::Print);
    options.load_case = subject.model().find_case("R").value();
    check_plate("plate_everything_print", subject, options);
}

namespace {

PlateSubject cantilever(int n = 12, int m = 3) { return PlateSubject(plane_test::cantilever_text(n, m)); }

/// Two T6 with curved sides, made of two metals.
const char* const curved_text = R"({"cremona": 1, "title": "Two curved elements", "analysis": "plane_stress",
 "units": {"length": "mm", "force": "N"},
 "materials": [{"id": "steel", "E": 205000, "nu": 0.3}, {"id": "lead", "E": 16000, "nu": 0.42}],
 "points": [{"id": "1", "at": [0, 0]}, {"id": "2", "at": [40, 0]}, {"id": "3", "at": [40, 30]}, {"id": "4", "at": [0, 30]},
            {"id": "5", "at": [20, -5]}, {"id": "6", "at": [46, 15]}, {"id": "7", "at": [20, 15]}, {"id": "8", "at": [20, 37]},
            {"id": "9", "at": [0, 15]}],
 "curves": [{"id": "left", "kind": "edges", "points": ["4", "1"], "support": "fixed"},
            {"id": "right", "kind": "edges", "points": ["2", "3"]}],
 "regions": [{"id": "lower", "material": "steel", "thickness": 4}, {"id": "upper", "material": "lead", "thickness": 4}],
 "elements": [{"id": "a", "kind": "T6", "points": ["1", "2", "3", "5", "6", "7"], "region": "lower"},
              {"id": "b", "kind": "T6", "points": ["1", "3", "4", "7", "8", "9"], "region": "upper"}],
 "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qx": 20}]}]})";

} // namespace

TEST_CASE("Bands of bending stress with their legend, extremes, supports and loads")
{
    check_plate("plate_bands", cantilever(), plate_options({"bands:sx", "geometry", "supports", "loads", "labels"}));
}

TEST_CASE("Bands in print are shades of gray")
{
    check_plate("plate_bands_print", cantilever(),
                plate_options({"bands:mises", "mesh", "geometry", "labels"}, ui::ThemeName::Print));
}

TEST_CASE("Lines of equal stress on the projector in Portuguese")
{
    plane::PlateOptions options = plate_options({"contour:s1", "geometry", "supports", "labels"},
                                                ui::ThemeName::Projector);
    options.tr = ui::Catalogue(ui::Language::Portuguese);
    options.numbers.mark = ui::DecimalMark::Comma;
    check_plate("plate_contours_projector", cantilever(), options);
}

TEST_CASE("The deformed shape over the outline at rest, with the stresses where displacements take them")
{
    check_plate("plate_deformed", cantilever(), plate_options({"bands:txy", "mesh", "deformed", "labels"}));
}

TEST_CASE("Curved sides are curves, and values of elements jump from one to the next")
{
    plane::PlateOptions options = plate_options({"bands:sx", "mesh", "geometry", "labels"});
    options.reading = femoop::plane::StressReading::Element;
    check_plate("plate_element_values", PlateSubject(curved_text), options);
}

TEST_CASE("Smoothed stresses jump on the border of two regions all the same")
{
    check_plate("plate_two_metals", PlateSubject(curved_text), plate_options({"bands:sx", "geometry", "labels"}));
}

TEST_CASE("A fixed range of colours")
{
    plane::PlateOptions options = plate_options({"bands:sx", "geometry", "legend"}, ui::ThemeName::Dark);
    options.range = {-40.0, 60.0};
    check_plate("plate_fixed_range", cantilever(), options);
}

TEST_CASE("Crosses of principal stresses tell tension from compression")
{
    check_plate("plate_principal", cantilever(), plate_options({"principal", "geometry", "supports", "legend"}));
}

TEST_CASE("Principal stress trajectories of a cantilever")
{
    check_plate("plate_trajectories", cantilever(), plate_options({"trajectories", "geometry", "supports", "legend"}));
}

TEST_CASE("Displacements of a cantilever as arrows between its supports and loads")
{
    check_plate("plate_vectors", cantilever(), plate_options({"vectors", "geometry", "supports", "loads", "legend"}));
}

TEST_CASE("Arrows lead from the body at rest to its deformed shape, on the projector in Portuguese")
{
    plane::PlateOptions options = plate_options({"vectors", "deformed", "legend"}, ui::ThemeName::Projector);
    options.tr = ui::Catalogue(ui::Language::Portuguese);
    options.numbers.mark = ui::DecimalMark::Comma;
    check_plate("plate_vectors_deformed", cantilever(), options);
}

TEST_CASE("The error of each element")
{
    check_plate("plate_error", cantilever(6, 2), plate_options({"error", "mesh", "geometry", "labels"}));
}

TEST_CASE("A cut: its stresses beside those of beam theory, with N, V and M")
{
    plane::PlateOptions options = plate_options({"geometry", "regions", "supports", "loads", "labels"});
    options.cuts = {{{5.5, -1.2}, {5.5, 1.2}}};
    check_plate("plate_cut", cantilever(), options);
}

TEST_CASE("A cut and a probe over bands, in Portuguese on the projector")
{
    plane::PlateOptions options = plate_options({"bands:sx", "geometry", "labels"}, ui::ThemeName::Projector);
    options.cuts = {{{2.6, -1.0}, {2.6, 1.0}}};
    options.probes = {{6.0, 0.6}};
    options.tr = ui::Catalogue(ui::Language::Portuguese);
    options.numbers.mark = ui::DecimalMark::Comma;
    check_plate("plate_cut_projector", cantilever(), options);
}

TEST_CASE("States at two places are written beside them")
{
    plane::PlateOptions options = plate_options({"geometry", "regions", "supports", "loads", "labels"});
    options.probes = {{1.3, 0.7}, {8.0, -0.4}};
    check_plate("plate_probes", cantilever(), options);
}

TEST_CASE("What is selected and what the cursor is over lie broad below the curves")
{
    const PlateSubject subject = PlateSubject::example("plate");
    const plane::PlateOptions options = plate_options({"geometry", "regions", "supports", "labels"});
    plane::PlateState state;
    state.selection = {.points = {femoop::NodeId(2)}, .curves = {femoop::plane::CurveId(4)}};
    state.hover = {.faces = {0}};
    golden::check_scene("plate_selection", {.size = {900.0, 700.0}, .background = plane::background(options)},
                        [&](ui::Painter& painter) { plane::draw(painter, subject.input(), options, state); });
}

TEST_CASE("A drawing that is meshed: bands stay within their regions and meet the curves of the drawing")
{
    PlateSubject subject = PlateSubject::example("plate");
    subject.mesh();
    check_plate("plate_meshed", subject, plate_options({"bands:mises", "mesh", "geometry", "supports", "labels"}));
}

TEST_CASE("Trajectories run around a hole")
{
    PlateSubject subject = PlateSubject::example("plate");
    subject.mesh();
    check_plate("plate_hole_trajectories", subject, plate_options({"trajectories", "geometry", "loads", "legend"}));
}

TEST_CASE("A state that would hide much of a small body stands beside it")
{
    PlateSubject subject = PlateSubject::example("plate");
    subject.mesh();
    plane::PlateOptions options = plate_options({"bands:sy", "mesh", "geometry", "labels"}, ui::ThemeName::Projector);
    options.probes = {{10.0, 10.0}};
    options.cuts = {{{30.0, 0.0}, {30.0, 50.0}}};
    golden::check_scene("plate_probe_beside", {.size = {1280.0, 800.0}, .background = plane::background(options)},
                        [&](ui::Painter& painter) { plane::draw(painter, subject.input(), options); });
}
