// The results along one member: what the formulas say, and how the diagrams look.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "apps/drawing/member/expression_lines.h"
#include "apps/drawing/member/member_results.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace drawing;
using femoop::MemberComponent;
using femoop::MemberId;

namespace {

/// Draws the results along a member and compares them.
void check_picture(const std::string& name, const femoop::Model& model, MemberId member, const DrawOptions& options,
                   std::optional<double> cursor)
{
    const femoop::Results results = femoop::analyse(model);
    const MemberResultsSubject subject{model, results, options, member, cursor};
    golden::check_scene(name, {.size = {1260.0, least_height(subject)}, .background = background(options)},
                        [&](ui::Painter& painter) { draw_member_results(painter, subject); });
}

std::vector<ExpressionLine> formulas(const femoop::Model& model, MemberComponent component, const DrawOptions& options)
{
    const femoop::Results results = femoop::analyse(model);
    const femoop::Curve curve = results[options.load_case].curve(MemberId(0));
    return expression_lines(curve, component, display_units(model, options), 1e-9);
}

} // namespace

TEST_SUITE("frame: results along a member")
{
    constexpr double L = 7.0, q = 12.0; // m, kN/m

    TEST_CASE("The formulas of a simple beam are q L / 2 - q x and q L x / 2 - q x^2 / 2, in the units and marks shown")
    {
        const femoop::Model model = view_test::simple_beam(L, q);
        DrawOptions options;
        CHECK(formulas(model, MemberComponent::Vy, options).front().formula == "42 − 12 x");
        CHECK(formulas(model, MemberComponent::Mz, options).front().formula == "42 x − 6 x²");
        options.units = ui::UnitSystem::Si; // N, N·m
        options.numbers.mark = ui::DecimalMark::Comma;
        CHECK(formulas(model, MemberComponent::Vy, options).front().formula == "4,2·10⁴ − 1,2·10⁴ x");
        options.units = ui::UnitSystem::KnCm; // x in cm: 42 kN x, -6e-4 kN/cm² x² ... times cm
        CHECK(formulas(model, MemberComponent::Mz, options).front().formula == "42 x − 0,06 x²");
    }

    TEST_CASE("A place of the sheet is a section between the ends, and nothing beside the diagrams")
    {
        const femoop::Model model = view_test::simple_beam(L, q);
        const femoop::Results results = femoop::analyse(model);
        const DrawOptions options;
        const MemberResultsSubject subject{model, results, options, MemberId(0)};
        const ui::Size sheet{1000.0, 300.0};
        CHECK(!section_at(subject, sheet, {20.0, 100.0}));
        CHECK(!section_at(subject, sheet, {900.0, 100.0}));
        const double a = section_at(subject, sheet, {200.0, 100.0}).value();
        const double b = section_at(subject, sheet, {300.0, 100.0}).value();
        CHECK(a > 0.0);
        CHECK(b > a);
        CHECK(b < L);
    }

    TEST_CASE("A beam of a portal with a cursor")
    {
        check_picture("member_portal", view_test::example("portal"), MemberId(1), {}, 2.4);
    }

    TEST_CASE("A beam with loads of every kind, on the projector in Portuguese")
    {
        DrawOptions options{.theme = ui::ThemeName::Projector, .tr = ui::Catalogue(ui::Language::Portuguese)};
        options.numbers.mark = ui::DecimalMark::Comma;
        check_picture("member_every_load", view_test::model("every_load"), MemberId(1), options, std::nullopt);
    }

    TEST_CASE("A member in space: two shears, torsion, two moments, two deflections")
    {
        const DrawOptions options{.theme = ui::ThemeName::Dark};
        check_picture("member_space", view_test::example("bent_cantilever"), MemberId(0), options, 1.0);
    }

    TEST_CASE("A bar of a truss shows its force and its deflection")
    {
        check_picture("member_truss", view_test::example("pratt_truss"), MemberId(2), {}, std::nullopt);
    }

    TEST_CASE("A beam on an elastic foundation: the series are cut with dots")
    {
        check_picture("member_foundation", view_test::example("beam_on_ground"), MemberId(0), {}, 1.5);
    }
}
