// A class of pupils at once: random gestures, numbers and commands in the real window of Mohr's circle, off screen.
#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "apps/mohr/document/file.h"
#include "apps/mohr/window/application.h"
#include "apps/mohr/window/stage.h"
#include "femoop/methods/dice.h"
#include "tests/golden/scene.h"
#include "tests/scenarios/script_files.h"
#include "ui/context/offscreen.h"
#include "ui/paint/surface/golden_text.h"

using namespace mohr;

namespace {

constexpr std::array<const char*, 24> numbers{"0",      "1e-90 MPa", "1e90 MPa", "-1e99 MPa", "3 kPa", "1e-3 MPa",
                                              "7 ksi",  "-7 MPa",    "50",       "nan",       "inf",   "1e400",
                                              "abc",    "1e99",      "2*35",     "17,4 ksi",  "-0",    "5 kN",
                                              "12 MPa", "100 MPa",   "1e-95",    "0.1+",      "(((",   "1/0"};
constexpr std::array<double, 10> values{0.0, 1e99, -5.0, 1e-99, 30.0, 7.0, -1e12, 1.0, 1e-9, 1e200};
constexpr std::array<double, 6> angles{0.0, 45.0, -90.0, 1e9, 30.000001, 180.0};

/// A hand that knows no mercy.
class Hand {
public:
    Hand(Application& application, std::uint32_t seed) : application_(application), dice_(seed) {}

    void act()
    {
        const int what = static_cast<int>(dice_.roll(0, 9));
        Session& session = application_.workspace().session;
        if (what <= 2) drag();
        else if (what <= 5) run_any_command();
        else if (what <= 7) type_number();
        else if (what == 8) set_directly(session);
        else if (session.practice())
            session.answer(static_cast<std::size_t>(dice_.roll(0, 12)), std::to_string(dice_.pick(values)));
        frame({}, false);
    }
    std::string last() const { return last_; }

private:
    void frame(std::optional<ui::Point> at, bool is_down)
    {
        application_.frame({.pointer = at, .is_button_down = {is_down}, .modifiers = {.shift = dice_.sign() > 0.0}});
    }

    /// A handle that is drawn, or any place, is pulled anywhere.
    void drag()
    {
        const auto& places = application_.canvas().drawn().places;
        ui::Point from{dice_.roll(0, 1280), dice_.roll(30, 780)};
        if (!places.empty() && dice_.roll(0, 3) > 0.0)
            from = application_.canvas().corner() +
                   places[static_cast<std::size_t>(dice_.roll(0, static_cast<int>(places.size()) - 1))].at;
        const ui::Point to{dice_.roll(-50, 1330), dice_.roll(-50, 850)};
        last_ = "drag from " + std::to_string(from.x) + " " + std::to_string(from.y);
        frame(from, false);
        frame(from, true);
        frame(0.5 * (from + to), true);
        frame(to, true);
        frame(to, false);
    }

    void run_any_command()
    {
        const auto& all = application_.commands().all();
        const auto& command = all[static_cast<std::size_t>(dice_.roll(0, static_cast<int>(all.size()) - 1))];
        const bool leaves = command.id.starts_with("file.") || command.id.starts_with("help.");
        if (leaves) return;
        last_ = command.id;
        Workspace& workspace = application_.workspace();
        run(command, workspace);
        if (const auto then = std::exchange(workspace.after_exercise, {})) then(workspace); // the question is answered
    }

    void type_number()
    {
        Session& session = application_.workspace().session;
        const auto group = static_cast<Group>(static_cast<int>(dice_.roll(0, 2)));
        const std::size_t n = group == Group::State        ? session.document().state().size()
                              : group == Group::Elasticity ? 2
                                                           : n_strengths;
        const NumberId number{group, static_cast<std::size_t>(dice_.roll(0, static_cast<int>(n) - 1))};
        const std::string text = dice_.pick(numbers);
        last_ = "type " + text;
        session.set_number(number, text);
    }

    void set_directly(Session& session)
    {
        const double a = dice_.pick(values), b = dice_.pick(values), c = dice_.pick(values);
        last_ = "set " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c);
        if (!is_in_space(session.document().subject)) {
            session.set_angle(dice_.pick(angles));
            session.set_principal(a, b, dice_.pick(angles));
            return;
        }
        session.set_normal({a, b, c});
        session.set_direction(static_cast<int>(dice_.roll(0, 2)), {c, a, b});
        session.set_principal({a, b, c});
    }

    Application& application_;
    femoop::Dice dice_;
    std::string last_;
};

/// Words that are no numbers for people.
bool has_no_number(const std::string& text)
{
    return text.find("nan") != std::string::npos || text.find("inf\"") != std::string::npos ||
           text.find("−0\"") != std::string::npos;
}

void play(std::uint32_t seed, int n_acts, ui::PixelSize size)
{
    const Workplace workplace;
    golden::if_drawn(
        [&] {
            const ui::Fonts fonts;
            ui::Offscreen context({.size = size});
            Application application(context, fonts, Session());
            Hand hand(application, seed);
            for (int i = 0; i < n_acts; ++i) {
                hand.act();
                CAPTURE(seed);
                CAPTURE(i);
                CAPTURE(hand.last());
                CAPTURE(file_text(application.session().document()));
                const auto& picture = application.canvas().picture();
                if (!picture) continue;
                CHECK(picture->n_refused() == 0);
                const std::string text = ui::golden_text(*picture);
                CAPTURE(text);
                CHECK_FALSE(has_no_number(text));
            }
            Session& session = application.workspace().session;
            session.settle();
            session.end_exercise(); // else it keeps its state
            while (session.history().can_undo()) session.undo();
            CHECK(session.document() == textbook_state());
            return context.pixels();
        },
        golden::this_machine());
}

} // namespace

TEST_CASE("Random gestures and numbers and commands never spoil the picture and are all undone")
{
    const char* const many = std::getenv("CREMONA_SEEDS");
    const int n_seeds = many == nullptr ? 4 : std::atoi(many);
    for (int seed = 1; seed <= n_seeds; ++seed)
        play(static_cast<std::uint32_t>(seed), 150, seed % 2 == 0 ? ui::PixelSize{800, 600} : ui::PixelSize{1280, 800});
}
