// What one frame of the stepper's picture costs, off screen and drawn by software: `ninja bench`. A solid of 2 000
// faces turns; of each part of a frame the median over many frames counts. The
// processor's time, of all threads and as a mean, tells more where others are at work too.

#include "apps/euler/view/draw/draw.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/bench/median.h"
#include "topology/modeling/primitives.h"
#include "topology/script/script_runner.h"
#include "ui/context/draw_list_renderer.h"
#include "ui/context/draw_list_surface.h"
#include "ui/context/offscreen.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::median;

constexpr int n_frames = 61;
constexpr ui::PixelSize size{1280, 800};
constexpr ui::Size sheet{1280.0, 800.0};

double milliseconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Turns pictures into pixels, as a window does frame after frame.
class Screen {
public:
    Screen() : context_({.size = size}), renderer_(context_), atlas_(fonts_), list_(&shared_)
    {
        shared_.InitialFlags = ImDrawListFlags_AllowVtxOffset;
        shared_.ClipRectFullscreen = {0.0F, 0.0F, 1280.0F, 800.0F};
    }

    const ui::Fonts& fonts() const { return fonts_; }

    void triangulate(const ui::Picture& picture)
    {
        list_._ResetForNewFrame();
        list_.PushClipRectFullScreen();
        ui::DrawListSurface surface(list_, atlas_, {.origin = {}, .scale = 1.0});
        picture.draw_on(surface);
    }
    void raster()
    {
        ImDrawList* lists = &list_;
        ImDrawData data;
        data.Valid = true;
        data.CmdLists = &lists;
        data.CmdListsCount = 1;
        data.DisplaySize = {1280.0F, 800.0F};
        data.FramebufferScale = {1.0F, 1.0F};
        background_ = background_ == ui::rgb(0xFFFFFF) ? ui::rgb(0xFEFEFE) : ui::rgb(0xFFFFFF); // draws all of it
        renderer_.render(data, background_);
        context_.gl().Finish();
    }
    int n_triangles() const { return list_.IdxBuffer.Size / 3; }

private:
    ui::Fonts fonts_;
    ui::Offscreen context_;
    ui::DrawListRenderer renderer_;
    ui::Color background_{};
    ui::GlyphAtlas atlas_;
    ImDrawListSharedData shared_;
    ImDrawList list_;
};

topology::NamedSolid torus(int n_around, int n_tube)
{
    topology::NamedSolid made;
    topology::EulerOperator op(made.solid, made.journal);
    topology::add_torus(op, {.radius = 3.0, .tube = 1.2}, n_around, n_tube);
    return made;
}

void print_row(Screen& screen, const char* name, const topology::NamedSolid& made, const euler::Look& look)
{
    const std::vector<euler::Subject> subjects{{&made.solid, &made.names}};
    ui::OrbitCamera camera = euler::fitted({}, subjects, look, sheet);
    std::vector<double> shape, draw, triangles, raster, total;
    const std::clock_t before = std::clock();
    for (int i = 0; i < n_frames; ++i) {
        camera.orbit({4.0, 1.0}, {});
        euler::Shapes shapes;
        ui::Picture picture(sheet);
        shape.push_back(milliseconds([&] { shapes = euler::solid_shapes(subjects, camera, look); }));
        draw.push_back(milliseconds([&] { picture = euler::picture(shapes, subjects, look, sheet, screen.fonts()); }));
        triangles.push_back(milliseconds([&] { screen.triangulate(picture); }));
        raster.push_back(milliseconds([&] { screen.raster(); }));
        total.push_back(shape.back() + draw.back() + triangles.back() + raster.back());
    }
    const double cpu = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / n_frames;
    std::printf("%-34s %6.2f %8.2f %10.2f %7.2f | %6.2f %6.2f   %d triangles\n", name, median(shape), median(draw),
                median(triangles), median(raster), median(total), cpu, screen.n_triangles());
    std::fflush(stdout);
}

} // namespace

int main()
{
    using topology::EntityKind;
    Screen screen;
    std::printf("a torus turns, sheet of 1280 x 800, software renderer [ms, medians]\n"
                "%-34s %6s %8s %10s %7s |  total    cpu\n",
                "", "shapes", "picture", "triangles", "raster");
    for (const auto& [n_around, n_tube] :
         {std::pair{10, 10}, {15, 10}, {20, 10}, {20, 15}, {25, 20}, {35, 20}, {40, 25}, {50, 30}, {50, 40}}) {
        const std::string name = std::to_string(n_around * n_tube) + " faces";
        print_row(screen, name.c_str(), torus(n_around, n_tube), {});
    }
    print_row(
        screen, "2 000 faces, every kind of name", torus(50, 40),
        {.names = {EntityKind::Vertex, EntityKind::Edge, EntityKind::HalfEdge, EntityKind::Loop, EntityKind::Face}});
    print_row(screen, "2 000 faces, exploded", torus(50, 40), {.explosion = 0.5});
}
