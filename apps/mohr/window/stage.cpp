#include "apps/mohr/window/stage.h"

#include <algorithm>
#include <array>
#include <vector>

#include "apps/mohr/window/expectation.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace mohr {

namespace {

struct NamedHandle {
    std::string_view name;
    Handle handle;
};
constexpr std::array handles{
    NamedHandle{"face x", Handle::FaceX},   NamedHandle{"face y", Handle::FaceY},
    NamedHandle{"plane", Handle::Plane},    NamedHandle{"centre", Handle::Centre},
    NamedHandle{"first", Handle::First},    NamedHandle{"second", Handle::Second},
    NamedHandle{"third", Handle::Third},    NamedHandle{"arrow x", Handle::ArrowX},
    NamedHandle{"arrow y", Handle::ArrowY}, NamedHandle{"arrow shear", Handle::ArrowShear},
    NamedHandle{"turn", Handle::Turn},      NamedHandle{"cursor", Handle::Cursor},
    NamedHandle{"normal", Handle::Normal},  NamedHandle{"fibre", Handle::Fibre},
    NamedHandle{"cube x", Handle::CubeX},   NamedHandle{"cube y", Handle::CubeY},
    NamedHandle{"cube z", Handle::CubeZ},   NamedHandle{"cube xy", Handle::CubeXY},
    NamedHandle{"cube yz", Handle::CubeYZ}, NamedHandle{"cube zx", Handle::CubeZX},
};

std::string names_of_places()
{
    std::string names = "a place: ";
    for (const NamedHandle& handle : handles) names += std::string(handle.name) + ", ";
    return names + "circle (50, -40) or pixel 400 300";
}

/// The numbers of a text; nothing where a word is none.
std::optional<std::vector<double>> numbers_of(std::string_view text, std::size_t count)
{
    std::string plain(text);
    std::ranges::replace_if(
        plain, [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
    std::vector<double> numbers;
    for (const std::string& word : ui::words_of(plain))
        if (const auto number = ui::number_typed(word)) numbers.push_back(*number);
    if (numbers.size() != count) return std::nullopt;
    return numbers;
}

std::optional<std::string> in_english(const std::optional<ui::Phrase>& reason)
{
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

std::optional<std::string> told(const Session& session, bool is_done)
{
    return is_done ? std::nullopt : std::optional(ui::Catalogue()(session.notice->sentence));
}

std::string wanted(std::string_view id, std::string_view found, const std::string& what)
{
    return std::string(id) + ": found \"" + std::string(found) + "\", wanted " + what;
}

/// "1 12 MPa": the first number of the state.
std::optional<std::string> set_number(Session& session, std::string_view argument)
{
    const auto words = ui::words_of(argument);
    const auto place = words.empty() ? std::nullopt : ui::number_typed(words.front());
    const auto most = static_cast<double>(session.document().state().size());
    if (!place || *place < 1.0 || *place > most || words.size() < 2)
        return wanted("state.set", argument,
                      "a place from 1 to " + std::to_string(session.document().state().size()) + " and a number");
    const NumberId number{Group::State, static_cast<std::size_t>(*place) - 1};
    return in_english(session.set_number(number, ui::joined(words, 1)));
}

} // namespace

ui::Stage::Sought OffscreenStage::find(std::string_view place)
{
    if (const auto pixel = ui::pixel_place(place)) return *pixel;
    const Canvas& canvas = application().canvas();
    if (place.starts_with("circle ("))
        if (const auto p = numbers_of(place.substr(7), 2)) {
            const ui::Point at = canvas.corner() + canvas.drawn().circle.to_sheet({p->at(0), p->at(1)});
            return ui::PointerPlace{at.x, at.y};
        }
    const auto named = std::ranges::find(handles, place, &NamedHandle::name);
    if (named == handles.end()) return names_of_places();
    const auto at = canvas.in_window(named->handle);
    if (!at) return "one that is drawn";
    return ui::PointerPlace{at->x, at->y};
}

std::optional<std::string> OffscreenStage::run_command(std::string_view id, std::string_view argument)
{
    Session& session = application().desk().session;
    if (id == "file.open" && !argument.empty()) return told(session, session.open(argument));
    if (id == "file.save" && !argument.empty()) return told(session, session.save(argument));
    if (id == "file.export" && !argument.empty()) return in_english(application().export_as(argument));
    if (id == "state.set") return set_number(session, argument);
    if (id == "state.section" && !argument.empty())
        return in_english(session.set_number({Group::Section, 0}, argument));
    if (id == "state.direction") {
        const auto n = numbers_of(argument, 4);
        if (!n || !(n->at(0) == 1.0 || n->at(0) == 2.0 || n->at(0) == 3.0))
            return wanted(id, argument, "1, 2 or 3 and three numbers");
        return in_english(session.set_direction(static_cast<int>(n->at(0)) - 1, {n->at(1), n->at(2), n->at(3)}));
    }
    if (id == "state.principal") {
        const auto n = numbers_of(argument, 3);
        if (n && is_in_space(session.document().subject))
            return in_english(session.set_principal({n->at(0), n->at(1), n->at(2)}));
        return n ? in_english(session.set_principal(n->at(0), n->at(1), n->at(2)))
                 : wanted(id, argument, "two values and an angle");
    }
    if (id == "construction.step") {
        const auto n = numbers_of(argument, 1);
        if (!n || n->front() < 1.0)
            return wanted(id, argument, "a step from 1 to " + std::to_string(session.n_steps()));
        session.show_construction(static_cast<std::size_t>(n->front()));
        return std::nullopt;
    }
    if (id == "exercise.answer") {
        const auto words = ui::words_of(argument);
        const auto place = words.size() == 2 ? ui::number_typed(words.front()) : std::nullopt;
        if (!place || *place < 1.0) return wanted(id, argument, "the question's number and an answer");
        return in_english(session.answer(static_cast<std::size_t>(*place) - 1, words.back()));
    }
    if (id == "plane.turn") {
        const auto n = numbers_of(argument, 1);
        return n ? in_english(session.set_angle(n->front())) : wanted(id, argument, "an angle in degrees");
    }
    if (id == "plane.normal") {
        const auto n = numbers_of(argument, 3);
        return n ? in_english(session.set_normal({n->at(0), n->at(1), n->at(2)}))
                 : wanted(id, argument, "three numbers");
    }
    return ui::run_by_name(application().commands(), id, application().desk());
}

std::optional<std::string> OffscreenStage::expect(std::string_view words) { return why_not(words, application()); }

} // namespace mohr
