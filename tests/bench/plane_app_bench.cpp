// What one frame of the plane app costs, off screen and drawn by software, while the hand drags the corner of a plate
// with a hole and mesh and bands of a stress go along; and what the bands of a large mesh cost: `ninja bench`.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "apps/plane/view/field_picture.h"
#include "apps/plane/window/application.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "femoop/plane/result/iso_areas.h"
#include "ui/context/offscreen.h"

namespace {

constexpr int n_frames = 300;

double milliseconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// A quarter of a plate of 200 x 200 about a hole of radius 10, pulled to the right, of elements of six nodes.
plane::PlaneModel plate(double size, double size_at_hole)
{
    const std::string at_hole = ", \"size\": " + std::to_string(size_at_hole);
    return femoop::plane::read_plane_model(
        R"({"cremona": 1, "analysis": "plane_stress", "units": {"length": "mm", "force": "N"},
            "mesh": {"element": "T6", "size": )" +
        std::to_string(size) + R"(}, "materials": [{"id": "steel", "E": "200 GPa", "nu": 0.3}],
            "points": [{"id": "O", "at": [0, 0]}, {"id": "A", "at": [10, 0])" +
        at_hole + R"(}, {"id": "B", "at": [200, 0]}, {"id": "C", "at": [200, 200]}, {"id": "D", "at": [0, 200]},
                       {"id": "E", "at": [0, 10])" +
        at_hole + R"(}],
            "curves": [{"id": "bottom", "kind": "line", "points": ["A", "B"], "support": "symmetry"},
                       {"id": "right", "kind": "line", "points": ["B", "C"]},
                       {"id": "top", "kind": "line", "points": ["C", "D"]},
                       {"id": "left", "kind": "line", "points": ["D", "E"], "support": "symmetry"},
                       {"id": "hole", "kind": "arc", "center": "O", "points": ["E", "A"], "turn": "cw"}],
            "regions": [{"id": "plate", "at": [100, 100], "material": "steel", "thickness": 5}],
            "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qx": 100}]}]})");
}

plane::Session session(plane::PlaneModel model)
{
    plane::Session session(plane::Document{.model = std::move(model)});
    session.look.field = femoop::plane::PlaneComponent::Mises;
    return session;
}

void print_drag(ui::PixelSize size, double element, double element_at_hole)
{
    const ui::Fonts fonts;
    ui::Offscreen context({.size = size});
    plane::Application application(context, fonts, session(plate(element, element_at_hole)));
    const auto frame_at = [&](ui::Point at, bool is_down) {
        return milliseconds([&] {
            application.frame({.pointer = at, .is_button_down = {is_down}});
            context.gl().Finish();
        });
    };
    for (int i = 0; i < 3; ++i) application.frame({});
    const std::size_t n_unknowns = application.session().analysed()->results()->statistics().dofs;
    const ui::Point corner = application.canvas().in_window({200.0, 200.0});
    frame_at(corner, false);
    frame_at(corner, true);
    int n_followed = 0;
    double moving = 0.0;
    const plane::Analysed* before = nullptr;
    for (int i = 1; i <= n_frames; ++i) {
        const double angle = 0.1 * i;
        moving += frame_at(corner + 12.0 * ui::Point{std::cos(angle) - 1.5, std::sin(angle)}, true) / n_frames;
        const plane::Analysed* const now = application.session().analysed();
        if (now != nullptr && now != before) ++n_followed;
        before = now;
    }
    std::printf("%6zu unknowns %8.2f ms a frame, %6.1f frames/s; mesh and bands are new in %3.0f %% of them\n",
                n_unknowns, moving, 1000.0 / moving, 100.0 * n_followed / n_frames);
    std::fflush(stdout);
}

/// A square held at its left side and pushed down at its right one, of 2 n x n triangles.
femoop::plane::PlaneModel triangles(std::uint32_t n)
{
    femoop::plane::PlaneModel model;
    model.materials.push_back({.id = "m", .E = 3e7, .nu = 0.2});
    model.regions.push_back({.id = "sheet", .material = femoop::MaterialId(0), .thickness = 0.3});
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i)
            model.points.push_back({.id = std::to_string(model.points.size()), .at = {1.0 * i / n, 1.0 * j / n}});
    const auto at = [n](std::uint32_t i, std::uint32_t j) { return femoop::NodeId(j * (n + 1) + i); };
    const auto add = [&](std::vector<femoop::NodeId> points) {
        model.elements.push_back({.id = std::to_string(model.elements.size()),
                                  .kind = femoop::ShapeKind::T3,
                                  .points = std::move(points),
                                  .region = femoop::plane::RegionId(0)});
    };
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            add({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            add({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    femoop::plane::PlaneCurve left{.id = "left"}, right{.id = "right"};
    left.support.emplace().fixed = femoop::DofSet{femoop::Dof::ux, femoop::Dof::uy};
    for (std::uint32_t j = 0; j <= n; ++j) {
        left.points.push_back(at(0, n - j));
        right.points.push_back(at(n, j));
    }
    model.curves = {left, right};
    femoop::plane::CurveLoad push{.curves = {femoop::plane::CurveId(1)}};
    push.qy = femoop::plane::Field{femoop::Quantity(-100.0)};
    model.load_cases.push_back({.id = "P", .curves = {push}});
    return model;
}

void print_bands(std::uint32_t n)
{
    const femoop::plane::PlaneResults results = femoop::plane::analyse(triangles(n));
    const femoop::plane::PlaneCase result = results[femoop::CaseId(0)];
    result.recover();
    double best = std::numeric_limits<double>::infinity();
    std::size_t n_levels = 0, n_loops = 0;
    for (int run = 0; run < 5; ++run)
        best = std::min(best, milliseconds([&] {
                            const plane::FieldPicture picture = plane::field_picture(
                                {.component = femoop::plane::PlaneComponent::Mises}, result, {}, {});
                            n_levels = picture.levels.size();
                            n_loops = 0;
                            for (const double level : picture.levels)
                                n_loops += femoop::plane::loops_above(picture.field, level).size();
                        }));
    std::printf("%6zu triangles %8.1f ms for the bands of a stress, of %zu levels (wanted 50); loops: %zu\n",
                results.model().elements.size(), best, n_levels, n_loops);
}

} // namespace

int main()
{
    constexpr ui::PixelSize size{1280, 800};
    std::printf("a corner of a plate is dragged, bands follow, window of %d x %d, software renderer\n", size.width,
                size.height);
    print_drag(size, 30.0, 6.0);
    print_drag(size, 9.1, 1.9);
    print_drag(size, 4.4, 1.1);
    print_bands(317);
}
