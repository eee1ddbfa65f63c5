#include "femoop/result/describe.h"

#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/result/two_cases.h"

using namespace femoop;

TEST_SUITE_BEGIN("result");

TEST_CASE("A beam is described whole: structure, loads, results of every case, line by line")
{
    Model model = two_cases();
    model.combinations.clear();
    model.load_cases.pop_back();
    CHECK(describe(model, analyse(model), english) ==
          "A plane frame: 2 nodes, 1 member.\n"
          "Supports.\n"
          "  node A at (0, 0): pinned; holds ux, uy.\n"
          "  node B at (8, 0): roller; holds uy.\n"
          "Members.\n"
          "  AB from A to B, 8 m between the nodes; section c, material s.\n"
          "Load case P.\n"
          "  on member AB: 30 kN down at 2 m.\n"
          "The structure is statically determinate.\n"
          "Results: Load case P.\n"
          "  no node moves.\n"
          // P a (L^2 - a^2)^1.5 / 9 sqrt(3) L E I at sqrt((L^2 - a^2) / 3) from the farther support
          "  the largest displacement along a member is v = -0.00559017 m, in member AB at x = 3.52786 m.\n"
          "  the support at A gives the structure 22.5 kN up.\n"
          "  the support at B gives the structure 7.5 kN up.\n"
          "  N is zero everywhere.\n"
          "  V is largest with 22.5 kN in member AB at x = 0 m, smallest with -7.5 kN in member AB at x = 2 m.\n"
          "  M is largest with 45 kN·m in member AB at x = 2 m, smallest with 0 kN·m in member AB at x = 0 m.\n");
}

TEST_CASE("Every kind of support, joint and load has words")
{
    const Model model = read_model(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "s", "E": 2e8, "alpha": 1e-5, "density": 7.85}],
      "sections": [{"id": "c", "A": 0.01, "Iz": 2e-4, "h": 0.3}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"},
                {"id": "B", "at": [3, 4], "hinge": true},
                {"id": "C", "at": [9, 4], "support": {"fixed": ["uy"], "angle": 30, "springs": {"ux": 500}}}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c", "start": {"release": ["rz"]}},
                  {"id": "BC", "nodes": ["B", "C"], "material": "s", "section": "c", "foundation": {"y": 90},
                   "end": {"offset": [-0.25, 0]}}],
      "load_cases": [{"id": "G", "self_weight": 1.5,
        "settlements": [{"node": "A", "uy": -0.02}],
        "members": [{"member": "AB", "kind": "distributed", "qy": [-3, -6], "axes": "local", "from": 1, "to": "50%"},
                    {"member": "AB", "kind": "ends", "end_mz": 8},
                    {"member": "BC", "kind": "temperature", "top": 10, "bottom": 30},
                    {"member": "BC", "kind": "misfit", "elongation": -0.004}]}]})");
    const std::string text = describe(model, std::nullopt, english);
    for (const char* sentence :
         {"node C at (9, 4): holds uy; spring of 500 kN/m on ux; turned by 30 degrees.", "Hinges.\n  at B.",
          "AB from A to B, 5 m between the nodes; section c, material s; released at A: rz.",
          "on an elastic foundation of 90 kN/m^2; rigid offset at C.", "self-weight times 1.5.",
          "support A is moved: uy = -0.02 m.",
          "3 kN/m along -y' of the member changing to 6 kN/m along -y' of the member from 1 m to 50%.",
          "on member AB: 8 kN·m counter-clockwise on its second end.",
          "warmed by 10 K at its +y' side and 30 K at its -y' side.", "built 0.004 m too short."})
        CHECK_MESSAGE(text.find(sentence) != std::string::npos, sentence << "\nis not in\n" << text);
}

TEST_CASE("A moment per length is told as one, in the member's own axes too")
{
    const Model model = read_model(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "s", "E": 2e8}], "sections": [{"id": "c", "A": 0.01, "Iz": 2e-4}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [3, 4]}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c"}],
      "load_cases": [{"id": "G", "members": [
        {"member": "AB", "kind": "distributed", "mz": 1.5},
        {"member": "AB", "kind": "distributed", "mz": [-2, -3], "axes": "local"}]}]})");
    const std::string text = describe(model, std::nullopt, english);
    for (const char* sentence :
         {"on member AB: 1.5 kN·m/m counter-clockwise over its whole length.",
          "2 kN·m/m about -z' of the member changing to 3 kN·m/m about -z' of the member over its whole length."})
        CHECK_MESSAGE(text.find(sentence) != std::string::npos, sentence << "\nis not in\n" << text);
}

TEST_SUITE_END();
