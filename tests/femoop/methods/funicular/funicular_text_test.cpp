#include "femoop/io/funicular/funicular_text.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/io/model_file.h"
#include "tests/latex_document.h"

using namespace femoop;
using namespace femoop::funicular;

TEST_SUITE("funicular")
{
    TEST_CASE("A funicular is told with how its thrust comes of the rise, and what is read at a place")
    {
        const Model model = read_model_file("examples/three_hinged_arch.json");
        const Discretisation structure = discretise(model);
        const Chain chain = chain_of(structure, members_across(structure));
        const SimpleSpan span(0.0, 24.0, vertical_loads(model, structure, chain, CaseId(1))); // 100 at x = 6
        const Funicular funicular{span, {0.0, 0.0}, 50.0};
        const std::vector<std::string> lines = funicular_lines(funicular, chain, model, english);
        REQUIRE(lines.size() == 2);
        CHECK(lines[0] == "thrust H = M0 / f = 300 / 6 = 50 kN, M0 and f at the hinge, x = 12 m; the "
                          "line of thrust of the arch");
        CHECK(lines[1] == "reactions of the simple beam: 75 kN at A, 25 kN at I");
        CHECK(reading_line(funicular, chain, 6.0, model, english) ==
              "at x = 6 m: M0 = H η = 50 · 9 = 450 kN·m; as line of thrust M = H e = 50 · 4.5 = "
              "225 kN·m");
        const std::string cable = funicular_lines({span, {0.0, 0.0}, -90.0}, chain, model, english).front();
        CHECK(cable == "pull: H = M0 / f = 450 / (−5) = −90 kN, M0 largest at x = 6 m");
    }

    TEST_CASE("The thrust is told of the rise that was given: of a point, of the hinge, and of neither the largest")
    {
        const Model model = read_model_file("examples/three_hinged_arch.json");
        const Discretisation structure = discretise(model);
        const Chain chain = chain_of(structure, members_across(structure));
        const SimpleSpan span(0.0, 24.0, vertical_loads(model, structure, chain, CaseId(1))); // 100 at x = 6
        const auto told = [&](const Funicular& funicular) {
            return funicular_lines(funicular, chain, model, english).front();
        };
        // over the closing line through (0, 1.5) and (24, -0.5): at x = 18 that is at 0, and M0 = 25 * 6
        CHECK(told({span, {1.5, -0.5}, 150.0 / 3.0, 18.0}) ==
              "thrust H = M0 / f = 150 / 3 = 50 kN, M0 and f at the point it is led through, x = 18 m");
        CHECK(
            told({span, {0.0, 0.0}, 50.0, 12.0}).starts_with("thrust H = M0 / f = 300 / 6 = 50 kN, M0 and f at the h"));
        CHECK(told({span, {0.0, 0.0}, -60.0, 18.0}) ==
              "pull: H = M0 / f = 150 / (−2.5) = −60 kN, M0 and f at the point it is led through, x = 18 m");
        CHECK(told({span, {0.0, 0.0}, 45.0}) == "thrust H = M0 / f = 450 / 10 = 45 kN, M0 largest at x = 6 m");
    }

    TEST_CASE("Over members on an elastic foundation it says that this is left out")
    {
        Model model = read_model_file("examples/three_hinged_arch.json");
        const Discretisation structure = discretise(model);
        const Chain chain = chain_of(structure, members_across(structure));
        const SimpleSpan span(0.0, 24.0, vertical_loads(model, structure, chain, CaseId(1)));
        for (const std::size_t link : {2, 3}) model.members[link].foundation = Quantity(5000.0);
        const std::vector<std::string> lines = funicular_lines({span, {0.0, 0.0}, 50.0}, chain, model, english);
        REQUIRE(lines.size() == 3);
        CHECK(lines[2] ==
              "left out: the elastic foundation under CD and DE; with it the beam's reactions and M are others");
    }

    TEST_CASE("In words it has the ordinates at the nodes, and the moments off the axis there")
    {
        const Model model = read_model_file("examples/three_hinged_arch.json");
        const Discretisation structure = discretise(model);
        const Chain chain = chain_of(structure, members_across(structure));
        const SimpleSpan span(0.0, 24.0, vertical_loads(model, structure, chain, CaseId(1)));
        const std::string text = funicular_text({span, {0.0, 0.0}, 50.0}, chain, model, english);
        CHECK(text.starts_with("Funicular over AB, BC, CD, DE, EF, FG, GH and HI from A to I\n"));
        std::istringstream lines(text.substr(text.find("  B ")));
        std::string name;
        double x = 0.0, M0 = 0.0, eta = 0.0, e = 0.0, M = 0.0;
        lines >> name >> x >> M0 >> eta >> e >> M;
        CHECK(x == 3.0);
        CHECK(M0 == doctest::Approx(75.0 * 3.0));
        CHECK(eta == doctest::Approx(75.0 * 3.0 / 50.0));
        CHECK(e == doctest::Approx(4.5 - 2.625));
        CHECK(M == doctest::Approx(50.0 * (4.5 - 2.625)));
    }

    TEST_CASE("The force polygon is told with its pole, and side and ray are parallel; for LaTeX likewise")
    {
        const Model model = read_model_file("examples/three_hinged_arch.json");
        const Discretisation structure = discretise(model);
        const Chain chain = chain_of(structure, members_across(structure));
        const SimpleSpan span(0.0, 24.0, vertical_loads(model, structure, chain, CaseId(1))); // 100 at x = 6
        const Funicular funicular{span, {0.0, 0.0}, 50.0};
        const std::string text = funicular_text(funicular, chain, model, english);
        CHECK(text.find(
                  "\nforce polygon: load line from 0 to −100 kN; pole O at height −75 kN, 50 kN to its left; the ray "
                  "parallel to the closing line ends at −75 kN\n") != std::string::npos);
        std::istringstream rows(text.substr(text.find('\n', text.find("  corner"))));
        double n0 = 0.0, x0 = 0.0, y0 = 0.0, ray = 0.0, n1 = 0.0, x1 = 0.0, y1 = 0.0, P = 0.0;
        rows >> n0 >> x0 >> y0 >> ray >> n1 >> x1 >> y1 >> P;
        CHECK(P == 100.0);
        CHECK((y1 - y0) / (x1 - x0) == doctest::Approx((ray + 75.0) / 50.0)); // from O to the load line at x = 0

        const std::string latex = funicular_latex(funicular, chain, model, english);
        const auto has = [&](std::string_view part) { return latex.find(part) != std::string::npos; };
        CHECK(latex.starts_with("\\section*{Funicular over AB, BC, CD, DE, EF, FG, GH and HI from A to I}\n"));
        CHECK(has("thrust H = M0 / f = 300 / 6 = 50 kN"));
        CHECK(has("pole O at height \\ensuremath{-}75 kN, 50 kN to its left"));
        CHECK(has("\n1 & 6 & 9 & 100 & \\ensuremath{-}100 \\\\\n"));
        CHECK(fault_of_latex(latex) == "");
        const std::string pull = funicular_text({span, {0.0, 0.0}, -90.0}, chain, model, english);
        CHECK(pull.find("90 kN to its right") != std::string::npos);
    }

    TEST_CASE("A refusal names the load, and what to do")
    {
        const Model model = read_model_file("examples/three_hinged_arch.json");
        const Refusal pushed{
            .kind = RefusalKind::NotVertical, .members = {MemberId(2)}, .value = -7.5, .is_distributed = true};
        CHECK(sentence(pushed, model, english) ==
              "the load on member CD has a horizontal part of −7.5 kN/m, and a funicular carries vertical loads alone; "
              "show another load case, or turn the load");
    }
}
