// What one frame of the frame app costs, off screen and drawn by software: `ninja bench`. While a number of a plane
// frame of 200 members is dragged, the best of many frames counts; while the hand drags a node, or a section with its
// influence line, their mean.

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "apps/cli/bench_frame.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/frame/document/number.h"
#include "apps/frame/window/application.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"
#include "ui/context/draw_list_renderer.h"
#include "ui/context/offscreen.h"

namespace {

constexpr int n_frames = 60;

double milliseconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double best_frame(const std::function<double(int)>& frame)
{
    double best = frame(0);
    for (int i = 1; i < n_frames; ++i) best = std::min(best, frame(i));
    return best;
}

/// The app on a sheet in memory, with a load that is dragged.
class DraggedFrame {
public:
    DraggedFrame(ui::PixelSize size, cli::FrameSize structure, frame::ShowSet show)
        : context_({.size = size}), application_(context_, fonts_, session(structure, show)), renderer_(context_)
    {
        for (int i = 0; i < 3; ++i) application_.frame({});
    }

    double edit_and_solve(int i)
    {
        const frame::Part load = frame::MemberLoadPlace{0, 0};
        const frame::NumberId number = frame::numbers(application_.session().model(), load).front().id;
        const femoop::Quantity value{-20.0 - 0.1 * (i % 2 + 1)};
        return milliseconds([&] {
            application_.workspace().session.change(
                {ui::translatable("Change"), [&](frame::Document& document) { set_number(document, number, value); },
                 frame::Step::Drag});
        });
    }
    double solve()
    {
        return milliseconds([&] { frame::solve(application_.session().document()); });
    }
    double frame()
    {
        return milliseconds([&] {
            application_.frame({});
            context_.gl().Finish();
        });
    }
    /// Draws the whole of the last frame once more: on another background everything differs.
    double raster()
    {
        background_ = background_ == ui::rgb(0xFFFFFF) ? ui::rgb(0xFEFEFE) : ui::rgb(0xFFFFFF);
        return milliseconds([&] {
            renderer_.render(*ImGui::GetDrawData(), background_);
            context_.gl().Finish();
        });
    }
    /// Milliseconds of a frame, from the pointer's move to the picture, while the last node goes round a circle, and of
    /// one in which the pointer rests.
    struct NodeDrag {
        double moving = 0.0, resting = 0.0;
    };
    NodeDrag drag_node()
    {
        const femoop::NodeId node(application_.session().model().nodes.size() - 1);
        const ui::Point start = *application_.canvas().in_window(frame::shape_of(application_.session().model())[node]);
        const auto frame_at = [&](ui::Point at, bool is_down) {
            return milliseconds([&] {
                application_.frame({.pointer = at, .is_button_down = {is_down}});
                context_.gl().Finish();
            });
        };
        frame_at(start, false);
        frame_at(start, true);
        NodeDrag mean;
        for (int i = 1; i <= n_frames; ++i) {
            const double angle = 0.2 * i;
            const ui::Point at = start + 12.0 * ui::Point{std::cos(angle) - 1.5, std::sin(angle)};
            mean.moving += frame_at(at, true) / n_frames;
            mean.resting += frame_at(at, true) / n_frames;
        }
        return mean;
    }
    /// Milliseconds of a frame while the section of an influence line is dragged along its beam.
    double drag_section()
    {
        const frame::Session& session = application_.session();
        const femoop::MemberId beam = *session.model().find_member("b4/3");
        const double length = femoop::geometry_of(session.model(), session.model()[beam]).length;
        const auto at = [&](double share) {
            return *application_.canvas().in_window(frame::Cut{beam, share * length});
        };
        const auto frame_at = [&](double share, bool is_down) {
            return milliseconds([&] {
                application_.frame({.pointer = at(share), .is_button_down = {is_down}});
                context_.gl().Finish();
            });
        };
        application_.frame({.keys = {{ui::Key::I, true}, {ui::Key::I, false}}});
        for (const bool is_down : {false, true, false, true}) frame_at(0.5, is_down);
        double mean = 0.0;
        for (int i = 1; i <= n_frames; ++i) mean += frame_at(0.5 + 0.4 * std::sin(0.2 * i), true) / n_frames;
        const drawing::InfluencePicture* const line = session.shown_line();
        const bool has_followed = line != nullptr && line->line.effect.at &&
                                  femoop::along(*line->line.effect.at, length) < 0.4 * length; // where the last one is
        return has_followed ? mean : std::nan("");
    }
    int n_triangles() const { return ImGui::GetDrawData()->TotalIdxCount / 3; }

private:
    static frame::Session session(cli::FrameSize structure, frame::ShowSet show)
    {
        frame::Session session({cli::plane_frame(structure)});
        session.view.layout = frame::Layout::Overlay;
        session.view.show = show;
        return session;
    }

    ui::Fonts fonts_;
    ui::Offscreen context_;
    frame::Application application_;
    ui::DrawListRenderer renderer_;
    ui::Color background_{};
};

double empty_frame(ui::PixelSize size)
{
    const ui::Fonts fonts;
    ui::Offscreen context({.size = size});
    ui::ImGuiSession gui(context, fonts, ui::Theme(ui::ThemeName::Light));
    return best_frame([&](int) {
        return milliseconds([&] {
            gui.begin_frame({});
            gui.end_frame();
            context.gl().Finish();
        });
    });
}

void print_row(const char* name, ui::PixelSize size, frame::ShowSet show)
{
    DraggedFrame dragged(size, {.bays = 12, .storeys = 8}, show);
    double edit = 1e9, solve = 1e9, frame = 1e9, raster = 1e9;
    for (int i = 0; i < n_frames; ++i) {
        edit = std::min(edit, dragged.edit_and_solve(i));
        solve = std::min(solve, dragged.solve());
        frame = std::min(frame, dragged.frame());
        raster = std::min({raster, dragged.raster(), dragged.raster()});
    }
    std::printf("%-28s %5.2f %6.2f %7.2f | %6.2f   %6.2f of %d triangles\n", name, edit - solve, solve, frame,
                edit + frame, raster, dragged.n_triangles());
    std::fflush(stdout);
}

void print_drag(ui::PixelSize size, cli::FrameSize structure, frame::ShowSet show)
{
    DraggedFrame dragged(size, structure, show);
    const auto [moving, resting] = dragged.drag_node();
    double raster = 0.0;
    for (int i = 0; i < n_frames; ++i) raster += dragged.raster() / n_frames;
    std::printf("%5zu members %8.2f %8.2f   %6.1f frames/s   %6.2f of %d triangles\n",
                (2 * structure.bays + 1) * structure.storeys, resting, moving, 1000.0 / moving, raster,
                dragged.n_triangles());
    std::fflush(stdout);
}

void print_section_drag(ui::PixelSize size, cli::FrameSize structure, frame::ShowSet show)
{
    DraggedFrame dragged(size, structure, show);
    const double moving = dragged.drag_section();
    std::printf("%5zu members          %8.2f   %6.1f frames/s\n", (2 * structure.bays + 1) * structure.storeys, moving,
                1000.0 / moving);
    std::fflush(stdout);
}

double first_frame(ui::PixelSize size, frame::ShowSet show)
{
    return milliseconds([&] { DraggedFrame(size, {.bays = 1, .storeys = 1}, show); });
}

} // namespace

int main()
{
    constexpr ui::PixelSize size{1280, 800};
    constexpr frame::ShowSet by_default = frame::shown_by_default | frame::ShowSet{frame::Show::M};
    std::printf("a number of a frame of 200 members is dragged, window of %d x %d, software renderer [ms]\n"
                "shown                         edit  solve   frame |  total   raster of the whole\n",
                size.width, size.height);
    print_row("bare", size, {});
    print_row("loads, reactions, M, labels", size, by_default);
    print_row("N, V, M, deformed, all else", size,
              by_default |
                  frame::ShowSet{frame::Show::N, frame::Show::V, frame::Show::Deformed, frame::Show::Dimensions});
    std::printf("%-28s %30.2f\n", "(an empty window)", empty_frame(size));
    std::printf("a node is dragged, moments follow [ms]\n"
                "               resting   moving                   raster of the whole\n");
    print_drag(size, {.bays = 7, .storeys = 4}, by_default);
    print_drag(size, {.bays = 12, .storeys = 40}, by_default);
    std::printf("a section is dragged, its influence line follows [ms]\n");
    print_section_drag(size, {.bays = 7, .storeys = 4}, by_default);
    std::printf("from the start to the third frame %.0f ms\n", first_frame(size, by_default));
}
