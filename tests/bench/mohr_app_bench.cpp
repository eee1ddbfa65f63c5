// How many frames a second Mohr's circle draws off screen, by software, while a hand drags: `ninja bench`. Each frame
// goes from the pointer's move to the picture. On a busy machine the processor's time is the fairer number.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "apps/mohr/window/application.h"
#include "ui/context/offscreen.h"

namespace {

constexpr int n_frames = 120;

/// What a frame takes while a handle goes round a circle [ms]: by the clock, and of the processor, all threads
/// together.
struct Cost {
    double clock = 0.0, processor = 0.0;
};

Cost cost(ui::PixelSize size, mohr::Session session, mohr::Handle handle)
{
    const ui::Fonts fonts;
    ui::Offscreen context({.size = size});
    mohr::Application application(context, fonts, std::move(session));
    const auto frame_at = [&](ui::Point at, bool is_down) {
        application.frame({.pointer = at, .is_button_down = {is_down}});
        context.gl().Finish();
    };
    for (int i = 0; i < 3; ++i) frame_at({}, false);
    const ui::Point start = *application.canvas().in_window(handle);
    frame_at(start, false);
    frame_at(start, true);
    const auto began = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    for (int i = 1; i <= n_frames; ++i)
        frame_at(start + 15.0 * ui::Point{std::cos(0.2 * i) - 1.0, std::sin(0.2 * i)}, true);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - began;
    const double processor = 1e3 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
    frame_at(start, false);
    return {took.count() / n_frames, processor / n_frames};
}

mohr::Session session(mohr::Subject subject)
{
    mohr::Session session;
    session.set_subject(subject);
    if (subject != mohr::Subject::Inertia) session.set_criterion(femoop::mohr::Criterion::VonMises);
    return session;
}

void print_row(const char* name, mohr::Session session, mohr::Handle handle)
{
    constexpr ui::PixelSize size{1280, 800};
    const auto [clock, processor] = cost(size, std::move(session), handle);
    std::printf("%-44s %6.1f frames/s  %5.2f ms of the processor\n", name, 1e3 / clock, processor);
    std::fflush(stdout);
}

} // namespace

int main()
{
    using mohr::Handle;
    using mohr::Subject;
    print_row("plane stress with a criterion, face x", session(Subject::PlaneStress), Handle::FaceX);
    print_row("the same, plane turned on the curves", session(Subject::PlaneStress), Handle::Cursor);
    mohr::Session both = session(Subject::PlaneStress);
    both.look.both_rules = true;
    print_row("both rules side by side, face x", std::move(both), Handle::FaceX);
    mohr::Session steps = session(Subject::PlaneStrain);
    steps.show_construction(10);
    print_row("the construction, plane turned", std::move(steps), Handle::Turn);
    print_row("rosette, plane", session(Subject::Rosette), Handle::Plane);
    print_row("fibre of a section", session(Subject::Section), Handle::Fibre);
    print_row("stress in space, normal on the sphere", session(Subject::SpaceStress), Handle::Normal);
    print_row("stress in space, principal value", session(Subject::SpaceStress), Handle::Second);
}
