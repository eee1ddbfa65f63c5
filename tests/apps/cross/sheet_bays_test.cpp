// The spans of a beam's sheet, which need not be to scale.
#include <doctest/doctest.h>

#include "apps/cross/document/file.h"
#include "apps/cross/view/scene.h"
#include "apps/cross/view/sheet_bays.h"
#include "apps/cross/view/sheet_picture.h"

using namespace cross;

namespace {

constexpr ui::Size window{660.0, 760.0};

/// Member ends without room on the sheet of a beam of three spans, in a window of usual size.
std::size_t n_without_room(double last_span, const Look& look)
{
    Document document = read_document_file("examples/three_spans.json");
    const auto last = document.model.find_node("D");
    document.model.nodes[last->index].at[0] = femoop::Quantity(14.0 + last_span);
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    ui::Painter painter(window, fonts);
    const drawing::StructureShape shape = drawing::shape_of(document.model);
    const ui::Theme theme = look.full_theme();
    const Scene scene{document, solution, nullptr, 1.0, {}, look};
    const BayScale bays = sheet_bays(painter, panels_for(shape, window, theme).sheet, scene);
    return draw_sheet(painter, panels_for(shape, window, theme, {.bays = bays}).sheet, scene).n_left_out;
}

} // namespace

TEST_CASE("Bays fill the breadth, the long ones giving to the short ones what those need")
{
    const std::vector<double> given = breadths({8.0, 6.0, 1.0}, {3.0, 3.0, 3.0}, 15.0);
    CHECK(given[2] == doctest::Approx(3.0));
    CHECK(given[0] + given[1] + given[2] == doctest::Approx(15.0));
    CHECK(given[0] / given[1] == doctest::Approx(8.0 / 6.0));
}

TEST_CASE("Bays that have what they need stay to scale")
{
    const std::vector<double> given = breadths({8.0, 6.0, 4.0}, {3.0, 3.0, 3.0}, 18.0);
    CHECK(given[0] == doctest::Approx(8.0));
    CHECK(given[1] == doctest::Approx(6.0));
    CHECK(given[2] == doctest::Approx(4.0));
}

TEST_CASE("A place is found again from where it is drawn")
{
    const BayScale bays({0.0, 8.0, 9.0}, {0.0, 5.0, 9.0});
    for (const double place : {-1.0, 0.0, 3.3, 8.0, 8.7, 9.0, 11.0}) {
        CAPTURE(place);
        CHECK(bays.inverse(bays(place)) == doctest::Approx(place));
    }
    CHECK(bays(8.0) == doctest::Approx(5.0));
    CHECK(bays(-1.0) == doctest::Approx(-1.0));
}

TEST_CASE("Spans that are too many share the breadth by their needs whatever their lengths")
{
    Panel sheet;
    sheet.camera = ui::PlaneCamera({0.0, 0.0}, 10.0);
    const std::vector<Bay> bays{{0.0, 10.0, 2}, {10.0, 10.5, 2}, {10.5, 12.0, 2}};
    const BayScale scale = bay_scale_for(bays, sheet, {});
    CHECK(scale(10.0) == doctest::Approx(4.0));
    CHECK(scale(10.5) == doctest::Approx(8.0));
    CHECK(scale(12.0) == doctest::Approx(12.0));
}

TEST_CASE("Columns of a short span stand beside their member ends, in a window as on the projector")
{
    Look projector;
    projector.size = 1.5;
    for (const double last_span : {6.0, 1.83, 0.4, 0.05}) {
        CAPTURE(last_span);
        CHECK(n_without_room(last_span, {}) == 0);
        CHECK(n_without_room(last_span, projector) == 0);
    }
}
