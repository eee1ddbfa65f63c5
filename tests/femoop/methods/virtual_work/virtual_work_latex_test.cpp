#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"
#include "tests/latex_document.h"

using namespace femoop;
using namespace femoop::virtual_work;

TEST_SUITE("virtual work")
{
    TEST_CASE("For LaTeX a stretch is an integral with its polynomials, numbers and value, and the works are added up")
    {
        constexpr double EI = 20000.0, L = 4.0, q = 12.0;
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed).node("B", L, 0).member("A", "B").uniform("AB", -q);
        static_assert(-6.0 * L * L * L * L / 4.0 == -384.0 && EI == 20000.0); // F f = -6 (L - x)^3
        const VirtualWork work = displacement_by_work(
            made.model, analyse(made.model), CaseId(0),
            {.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::uy});
        const std::string latex = virtual_work_latex(work, made.model, english);
        const auto has = [&](std::string_view part) { return latex.find(part) != std::string::npos; };
        CAPTURE(latex);
        CHECK(latex.starts_with("\\section*{"));
        CHECK(has("\\paragraph{AB, $M$}\n$F = -96 + 48 x - 6 x^2$, \\quad $f = 4 - x$, \\quad "
                  "$F f = -384 + 288 x - 72 x^2 + 6 x^3$, \\quad $EI_{z} = 20000$\n"));
        CHECK(has("\\int_{0}^{4} \\frac{F f}{EI_{z}}\\, dx = \\frac{-384}{20000} = -0.0192\n"));
        CHECK(has("$-0.0192 = -0.0192$"));
        CHECK(fault_of_latex(latex).empty());
    }

    TEST_CASE("For LaTeX a tapered member has its own sentence, without a sign of a table that is not there")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed).node("B", 4, 0).member("A", "B").uniform("AB", -12);
        SectionShape rectangle;
        rectangle.b = 0.3;
        rectangle.h = 0.6;
        made.model.sections[0] = Section{.id = "haunch", .shape = rectangle};
        made.model.members[0].depths = {0.6, 0.3};
        const VirtualWork work = displacement_by_work(
            made.model, analyse(made.model), CaseId(0),
            {.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::uy});
        const std::string latex = virtual_work_latex(work, made.model, english);
        CAPTURE(latex);
        CHECK(fault_of_latex(latex).empty());
        CHECK(latex.find("integrated term by term.") != std::string::npos);
        CHECK(latex.find("(--)") == std::string::npos);
    }

    TEST_CASE("What LaTeX is given of any structure it can set, with springs, settlements, heat and tapers")
    {
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 0; seed < 10; ++seed) {
                CAPTURE(name(kind));
                CAPTURE(seed);
                const Model model = random_structure(kind, seed);
                const Dof dof = kind == AnalysisKind::Grillage ? Dof::uz : Dof::uy;
                const VirtualWork work = displacement_by_work(
                    model, analyse(model), CaseId(0),
                    {.quantity = ExpectedQuantity::Displacement, .node = NodeId(2), .dof = dof});
                CHECK(fault_of_latex(virtual_work_latex(work, model, english)) == "");
            }
    }

    TEST_CASE("A formula that does not close, or a sign that LaTeX does not know, is found")
    {
        CHECK(fault_of_latex("\\begin{tabular}{l} $a$ \\\\ \\{ ã \\end{tabular}") == "");
        for (const char* wrong : {"{", "}", "$a", "\\begin{x}", "\\[ \\left( \\]", "{$}$", "\\begin{x}\\end{y}", "∫"})
            CHECK(fault_of_latex(wrong) != "");
    }
}
