// Outlines that other programs have drawn, as drawings of plane models.
#include "apps/plane/outline/outline.h"

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/outline/dxf_curves.h"
#include "apps/plane/outline/svg_path.h"
#include "tests/text_of.h"
#include "topology/text/line_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

using femoop::plane::DrawnKind;
using femoop::plane::PlaneModel;
using std::numbers::pi;

TEST_SUITE_BEGIN("outlines");

namespace {

constexpr femoop::Units mm{femoop::LengthUnit::mm, femoop::ForceUnit::N};

std::string dxf(const std::string& entities, const std::string& header = "")
{
    return header + "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

std::string svg(const std::string& inside, const std::string& attributes = "")
{
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + inside + "</svg>";
}

PlaneModel drawn(const outline::Outline& found) { return outline::drawing_of(found, mm); }
PlaneModel of_dxf(const std::string& entities) { return drawn(outline::read_dxf(dxf(entities))); }
PlaneModel of_svg(const std::string& inside) { return drawn(outline::read_svg(svg(inside))); }

/// The areas of the faces that the curves of a drawing close, the largest first.
std::vector<double> areas(const PlaneModel& model)
{
    const discretize::Drawing drawing(model);
    std::vector<double> all;
    for (const discretize::DrawnFace& face : drawing.faces()) all.push_back(face.area);
    return all;
}

std::string kinds(const PlaneModel& model)
{
    const std::string letters = "LACEBS"; // line, arc, circle, ellipse, Bezier, spline
    std::string all;
    for (const auto& curve : model.curves) all += letters[static_cast<std::size_t>(curve.shape->kind)];
    return all;
}

std::string refusal(const auto& read)
{
    try {
        read();
    } catch (const topology::LineError& fault) {
        return fault.sentence([](std::string_view text) { return std::string(text); });
    }
    return "none";
}

} // namespace

TEST_CASE("A side that bulges by the tangent of a quarter of its angle is the arc of that angle")
{
    // A square of 2 whose right side bulges by a half turn, and whose upper one is dented by a quarter turn.
    const PlaneModel model = of_dxf("0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n2\n20\n0\n42\n1\n10\n2\n20\n2\n42\n"
                                    "-0.41421356237309503\n10\n0\n20\n2\n");
    CHECK(kinds(model) == "LAAL");
    const double segment = 0.25 * pi * 2.0 - 1.0; // of the circle of radius sqrt 2 above a chord of 2
    CHECK(areas(model).at(0) == doctest::Approx(4.0 + 0.5 * pi - segment).epsilon(1e-12));
}

TEST_CASE("Lines of a file that end within its rounding at the same place close a face")
{
    const PlaneModel model = of_dxf(
        "0\nLINE\n10\n0\n20\n0\n11\n10\n21\n0.000004\n0\nLINE\n10\n9.999997\n20\n0\n11\n5\n21\n8\n"
        "0\nLINE\n10\n5\n20\n8.000003\n11\n0\n21\n0\n");
    CHECK(model.points.size() == 3);
    CHECK(areas(model).at(0) == doctest::Approx(40.0).epsilon(1e-5));
}

TEST_CASE("A block is drawn where it is inserted: moved, turned, stretched, and in rows and columns")
{
    const std::string block =
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nHOLE\n10\n1\n20\n0\n0\nCIRCLE\n10\n1\n20\n0\n40\n1\n0\nENDBLK\n"
        "0\nENDSEC\n";
    const auto with = [&](const std::string& insert) {
        return drawn(outline::read_dxf(dxf("0\nINSERT\n2\nHOLE\n" + insert, block)));
    };
    const PlaneModel stretched = with("10\n7\n20\n3\n41\n3\n42\n2\n50\n30\n");
    REQUIRE(kinds(stretched) == "E");
    const auto& ellipse = *stretched.curves[0].shape;
    CHECK(stretched[*ellipse.center->point].at[0] == doctest::Approx(7.0));
    CHECK(ellipse.axes[0] == doctest::Approx(3.0));
    CHECK(ellipse.axes[1] == doctest::Approx(2.0));
    CHECK(ellipse.angle->value() == doctest::Approx(30.0));
    const PlaneModel many = with("10\n0\n20\n0\n70\n4\n71\n3\n44\n5\n45\n5\n");
    CHECK(kinds(many) == "CCCCCCCCCCCC");
    CHECK(areas(many).at(11) == doctest::Approx(pi));
}

TEST_CASE("What is seen from behind is mirrored, and an arc of it runs the other way round")
{
    const PlaneModel model = of_dxf("0\nARC\n10\n-5\n20\n0\n40\n2\n50\n0\n51\n90\n230\n-1\n");
    REQUIRE(kinds(model) == "A");
    const auto& arc = *model.curves[0].shape;
    CHECK(model[*arc.center->point].at[0] == doctest::Approx(5.0));
    CHECK(model[*arc.places[0].point].at[0] == doctest::Approx(3.0));
    CHECK(arc.is_clockwise == true);
}

TEST_CASE("The cubic pieces of a B-spline are the B-spline")
{
    const std::vector<outline::Place> control{{0, 0}, {1, 4}, {3, 5}, {6, -2}, {8, 3}};
    const std::vector<double> knots{0, 0, 0, 0, 0.3, 1, 1, 1, 1};
    const auto chain = std::get<outline::CubicChain>(outline::bspline(control, knots, 3));
    REQUIRE(chain.places.size() == 7);
    // de Boor at the inner knot, with the shares 0.3 of 0..0.3, 0..1 and 0..1 worked out by hand
    const outline::Place a = 0.0 * control[0] + 1.0 * control[1], b = 0.7 * control[1] + 0.3 * control[2];
    const outline::Place c = 0.7 * control[2] + 0.3 * control[3];
    CHECK((chain.places[1] - a).norm() < 1e-14);
    CHECK((chain.places[2] - b).norm() < 1e-14);
    CHECK((chain.places[3] - (0.7 * b + 0.3 * c)).norm() < 1e-14);
    // three control points and no inner knot: one parabola
    const auto parabola = std::get<outline::CubicChain>(
        outline::bspline({{0, 0}, {1, 2}, {2, 0}}, {0, 0, 0, 1, 1, 1}, 2));
    const auto& p = parabola.places;
    CHECK((0.125 * (p[0] + 3.0 * p[1] + 3.0 * p[2] + p[3]) - outline::Place(1, 1)).norm() < 1e-14);
}

TEST_CASE("Path data are read however they are packed")
{
    CHECK(areas(of_svg("<path d='M0,0h4v3H0z'/>")).at(0) == doctest::Approx(12.0));
    CHECK(areas(of_svg("<path d='m1-1 3 0 0 2-3 0z'/>")).at(0) == doctest::Approx(6.0));
    CHECK(areas(of_svg("<path d='M0 0L.5.5.5 1Z'/>")).at(0) == doctest::Approx(0.125));
    // half of a circle of radius 5 whose flags are not set off from one another
    CHECK(areas(of_svg("<path d='M0 0A5 5 0 0110 0z'/>")).at(0) == doctest::Approx(12.5 * pi));
    // radii that are too small are made as large as the ends need
    CHECK(areas(of_svg("<path d='M0 0A1 1 0 0 1 10 0z'/>")).at(0) == doctest::Approx(12.5 * pi));
    // a parabola of height 5 over 20, then its mirror image
    CHECK(areas(of_svg("<path d='M0 0Q10 10 20 0T40 0'/><path d='M0 0H40'/>")).at(1) == doctest::Approx(200.0 / 3.0));
}

TEST_CASE("Of the four arcs between two places the flags choose one")
{
    const double small = 0.25 * pi * 4.0 - 2.0, large = 4.0 * pi - small; // segments of a circle of radius 2
    const auto area = [](const std::string& flags) {
        return areas(of_svg("<path d='M2 0A2 2 0 " + flags + " 0 2z'/>")).at(0);
    };
    CHECK(area("0 0") == doctest::Approx(small));
    CHECK(area("0 1") == doctest::Approx(small));
    CHECK(area("1 0") == doctest::Approx(large));
    CHECK(area("1 1") == doctest::Approx(large));
}

TEST_CASE("A page that says how large it is is drawn in millimetres, upright")
{
    const outline::Outline found = outline::read_svg(
        svg("<circle cx='20' cy='10' r='4'/>", "width='4in' height='2in' viewBox='0 0 100 50'"));
    CHECK(found.unit == femoop::LengthUnit::mm);
    const PlaneModel model = drawn(found);
    const auto& circle = *model.curves.at(0).shape;
    const double scale = 101.6 / 100.0;
    CHECK(circle.radius->value() == doctest::Approx(4.0 * scale));
    CHECK(model[*circle.center->point].at[0] == doctest::Approx(20.0 * scale));
    CHECK(model[*circle.center->point].at[1] == doctest::Approx(40.0 * scale));
    CHECK(!outline::read_svg(svg("<circle r='4'/>", "width='300' height='200'")).unit);
}

TEST_CASE("Transforms apply from the innermost outwards, and a circle stays one where they keep shapes")
{
    const PlaneModel model = of_svg("<g transform='translate(10 20) scale(2)'><circle cx='1' cy='2' r='3' "
                                    "transform='rotate(90)'/></g>");
    REQUIRE(kinds(model) == "C");
    const auto& circle = *model.curves[0].shape;
    CHECK(circle.radius->value() == doctest::Approx(6.0));
    CHECK(model[*circle.center->point].at[0] == doctest::Approx(6.0));
    CHECK(model[*circle.center->point].at[1] == doctest::Approx(-22.0));
    CHECK(kinds(of_svg("<circle r='3' transform='skewX(20)'/>")) == "E");
}

TEST_CASE("What is used again is drawn again, and what is defined or hidden is not drawn by itself")
{
    CHECK(kinds(of_svg("<defs><circle id='c' r='1'/></defs><use href='#c' x='5'/><use href='#c' x='9'/>"
                       "<g style='display: none'><rect width='3' height='3'/></g>")) == "CC");
    CHECK(kinds(of_svg("<rect width='9' height='6' rx='1'/>")) == "LALALALA");
    CHECK(areas(of_svg("<rect width='9' height='6' rx='1'/>")).at(0) == doctest::Approx(54.0 - 4.0 + pi));
}

TEST_CASE("What is left out is counted by the words of its format")
{
    const outline::Outline found = outline::read_dxf(
        dxf("0\nTEXT\n1\nhello\n0\nHATCH\n0\nTEXT\n0\nCIRCLE\n40\n1\n0\nLINE\n8\nhidden\n11\n5\n",
            "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nhidden\n62\n-7\n0\nENDSEC\n"));
    CHECK(outline::left_out_text(found) == "1 HATCH, 2 TEXT");
    CHECK(found.curves.size() == 1);
}

TEST_CASE("A file that cannot be read is refused with its line and what was wanted")
{
    const auto reading = [](const std::string& text) { return refusal([&] { outline::read_dxf(text); }); };
    CHECK(reading("AutoCAD Binary DXF\r\n") == "it is a binary DXF file; save it as DXF in text (ASCII)");
    CHECK(reading("AC1027\n") == "it is a DWG file; save it as DXF in text (ASCII)");
    CHECK(reading("hello\n").starts_with("line 1: hello: a DXF file has the number of a group here"));
    CHECK(reading("0\nSECTION\n").find("the file ends before its EOF") != std::string::npos);
    CHECK(reading(dxf("0\nCIRCLE\n40\nwide\n")).starts_with("line 8: wide: \"wide\" is no number"));
    CHECK(reading(dxf("0\nCIRCLE\n40\n1e99\n")).find("is no number that a drawing can have") != std::string::npos);
    CHECK(reading(dxf("0\nSPLINE\n71\n3\n10\n0\n20\n0\n10\n1\n20\n1\n")).find("control points") != std::string::npos);
    std::string many;
    for (int i = 0; i < 10'001; ++i) many += "0\nCIRCLE\n10\n" + std::to_string(3 * i) + "\n20\n0\n40\n1\n";
    CHECK(reading(dxf(many)).find("more than 10000 pieces") != std::string::npos);
    const std::string in_itself =
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nINSERT\n2\nB\n0\nINSERT\n2\nB\n0\nENDBLK\n0\nENDSEC\n";
    CHECK(reading(dxf("0\nINSERT\n2\nB\n", in_itself)).find("is inserted in itself") != std::string::npos);

    const auto picture = [](const std::string& inside) { return refusal([&] { outline::read_svg(svg(inside)); }); };
    CHECK(picture("\n<path d='M0 0L5'/>").starts_with("line 2: path: a number is missing"));
    CHECK(picture("<path d='L5 5'/>").find("begin with M") != std::string::npos);
    CHECK(picture("<path d='M0 0R5'/>").find("\"R\" is no command") != std::string::npos);
    CHECK(picture("<rect width='7em' height='2'/>").find("is no number") != std::string::npos);
    CHECK(picture("<g transform='turn(3)'/>").find("is no transform") != std::string::npos);
    CHECK(picture("<g id='a'><use href='#a'/></g>").find("deep in one another") != std::string::npos);
    std::string chain;
    for (int i = 0; i < 60; ++i)
        chain += "<g id='g" + std::to_string(i) + "'><use href='#g" + std::to_string(i + 1) + "'/></g>";
    CHECK(picture(chain + "<g id='g60'/>").find("deep in one another") != std::string::npos);
    CHECK(refusal([] { outline::read_svg("<html/>"); }).find("it is no SVG file") != std::string::npos);
    CHECK(refusal([] { outline::read_svg("<svg><g></svg>"); }).find("no XML") != std::string::npos);
}

TEST_CASE("The bracket of the examples closes as it was drawn, in any unit")
{
    const outline::Outline found = outline::read_dxf(text_of_source("examples/bracket.dxf"));
    CHECK(outline::left_out_text(found) == "1 TEXT");
    const double plate = 120.0 * 40.0 + 40.0 * 70.0 + 0.5 * pi * 400.0 + (400.0 - 0.25 * pi * 400.0);
    const double holes = pi * 100.0 + 2.0 * pi * 36.0;
    CHECK(areas(drawn(found)).at(0) == doctest::Approx(plate - holes).epsilon(1e-9));
    const PlaneModel in_m = outline::drawing_of(found, {femoop::LengthUnit::m, femoop::ForceUnit::kN});
    CHECK(areas(in_m).at(0) == doctest::Approx(1e-6 * (plate - holes)).epsilon(1e-9));
    CHECK(in_m.points[1].at[0] == 0.12); // with one rounding
}
