// Whatever a hand does, the app goes on, the model stays one that can be written, and everything can be undone.
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/window/application.h"
#include "femoop/io/model_file.h"
#include "tests/folder.h"
#include "tests/golden/scene.h"
#include "ui/context/offscreen.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <utility>

using namespace frame;

namespace {

constexpr ui::Size window{900.0, 560.0};

/// A hand without sense: it points, presses, drags, types and turns, and knows no key that leads to a file.
class RandomHand {
public:
    explicit RandomHand(unsigned seed) : engine_(seed) {}

    ui::Input next()
    {
        ui::Input input;
        if (key_held_) input.keys.push_back({*std::exchange(key_held_, std::nullopt), false});
        switch (below(12)) {
        case 0:
        case 1:
        case 2:
        case 3: presses_ = !presses_; break;
        case 4:
        case 5:
        case 6: point(); break;
        case 7:
        case 8: press_key(input); break;
        case 9: input.text = std::string(texts[below(texts.size())]); break;
        case 10: input.wheel = {0.0, static_cast<double>(below(3)) - 1.0}; break;
        default: pointer_ = pointer_ + ui::Point{spread(40.0), spread(40.0)}; break;
        }
        input.pointer = pointer_;
        input.is_button_down[0] = presses_;
        return input;
    }

private:
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_); }
    double spread(double size) { return std::uniform_real_distribution<>(-size, size)(engine_); }

    // Below the menus, since these lead to files; most often in the picture.
    void point()
    {
        const double x = below(4) == 0 ? std::uniform_real_distribution<>(0.0, window.width)(engine_)
                                       : std::uniform_real_distribution<>(0.28, 0.68)(engine_) * window.width;
        pointer_ = {x, std::uniform_real_distribution<>(30.0, window.height)(engine_)};
    }
    void press_key(ui::Input& input)
    {
        const ui::Chord chord = keys[below(keys.size())];
        input.modifiers = chord.modifiers;
        input.keys.push_back({chord.key, true, chord.modifiers});
        key_held_ = chord.key;
    }

    static constexpr std::array<std::string_view, 7> texts{"4", "4<30", "@3,2", "6,4", "1e3", "2*3 kN", "x"};
    static constexpr std::array keys{
        ui::Chord{ui::Key::M, {}},       ui::Chord{ui::Key::M, {}},        ui::Chord{ui::Key::N, {}},
        ui::Chord{ui::Key::S, {}},       ui::Chord{ui::Key::L, {}},        ui::Chord{ui::Key::J, {}},
        ui::Chord{ui::Key::X, {}},       ui::Chord{ui::Key::Q, {}},        ui::Chord{ui::Key::Escape, {}},
        ui::Chord{ui::Key::Enter, {}},   ui::Chord{ui::Key::Delete, {}},   ui::Chord{ui::Key::A, ui::ctrl},
        ui::Chord{ui::Key::Z, ui::ctrl}, ui::Chord{ui::Key::Y, ui::ctrl},  ui::Chord{ui::Key::D, ui::ctrl},
        ui::Chord{ui::Key::M, ui::ctrl}, ui::Chord{ui::Key::R, ui::ctrl},  ui::Chord{ui::Key::I, ui::ctrl},
        ui::Chord{ui::Key::E, ui::ctrl}, ui::Chord{ui::Key::Left, {}},     ui::Chord{ui::Key::Up, {}},
        ui::Chord{ui::Key::H, {}},       ui::Chord{ui::Key::F5, {}},       ui::Chord{ui::Key::D, ui::shift},
        ui::Chord{ui::Key::K, {}},       ui::Chord{ui::Key::N, ui::shift}, ui::Chord{ui::Key::T, {}},
        ui::Chord{ui::Key::F4, {}},
    };

    std::mt19937 engine_;
    ui::Point pointer_{450.0, 280.0};
    bool presses_ = false;
    std::optional<ui::Key> key_held_;
};

std::string faults_of(const femoop::ModelReading& reading)
{
    std::string all;
    for (const femoop::Fault& fault : reading.faults) all += sentence(fault, ui::Catalogue()) + "\n";
    return all;
}

// A structure that grows on and on would take the time of many events.
constexpr std::size_t most_members = 100;

void undo_all(Session& session)
{
    session.cancel();
    while (session.history().can_undo()) session.undo();
    CHECK(session.document() == starting_document());
}

/// CREMONA_RANDOM_EVENTS sets another number.
int n_events()
{
    const char* const number = std::getenv("CREMONA_RANDOM_EVENTS");
    return number != nullptr ? std::atoi(number) : 1500;
}

} // namespace

TEST_SUITE("frame window")
{
    TEST_CASE("A hand without sense breaks nothing: every state can be written and read, and all of it undone")
    {
        const Folder folder;
        const std::filesystem::path home = std::filesystem::current_path();
        std::filesystem::current_path(folder.path());
        const ui::Fonts fonts;
        golden::if_drawn(
            [&] {
                ui::Offscreen context({.size = {static_cast<int>(window.width), static_cast<int>(window.height)}});
                Application application(context, fonts, Session(starting_document()));
                RandomHand tool_controller(20250621U);
                Session& session = application.workspace().session;
                std::uint64_t generation = 0;
                for (int i = 0; i < n_events(); ++i) {
                    CAPTURE(i);
                    application.frame(tool_controller.next());
                    if (std::exchange(generation, session.generation()) == session.generation()) continue;
                    const std::string text = femoop::write_model(session.model());
                    const femoop::ModelReading read = femoop::examine_model(text);
                    CAPTURE(text);
                    CAPTURE(faults_of(read));
                    REQUIRE(femoop::write_model(read.model) == text);
                    if (session.model().members.size() > most_members) undo_all(session);
                }
                undo_all(session);
                return context.pixels();
            },
            golden::this_machine());
        std::filesystem::current_path(home);
    }
}
