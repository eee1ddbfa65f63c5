#include "apps/euler/window/stage.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "apps/euler/session/named_part.h"
#include "apps/euler/window/expectation.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace euler {

namespace {

constexpr const char* any_place = "a place: vertex v1, edge v1 v2, half-edge v1 v2, face f1, (2, 0) or pixel 400 300";

// "(2, 0)" or "(2, 0, 1)"
std::optional<topology::Point> point_in(std::string_view text)
{
    if (text.size() < 5 || text.front() != '(' || text.back() != ')') return std::nullopt;
    std::string plain(text.substr(1, text.size() - 2));
    std::ranges::replace(plain, ',', ' ');
    std::vector<double> numbers;
    for (const std::string& word : ui::words_of(plain)) numbers.push_back(ui::number_typed(word).value_or(0.0));
    if (numbers.size() < 2 || numbers.size() > 3) return std::nullopt;
    return topology::Point{numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0};
}

std::optional<std::string> in_english(const std::optional<ui::Phrase>& reason)
{
    return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
}

std::optional<std::string> told(const Session& session, bool is_done)
{
    return is_done ? std::nullopt : std::optional(ui::Catalogue()(session.notice->sentence));
}

std::optional<std::string> go_to(Session& session, std::string_view argument)
{
    const auto place = ui::number_typed(argument);
    const auto most = static_cast<double>(session.n_steps());
    if (!place || *place < 0.0 || *place > most)
        return "step.go_to: found \"" + std::string(argument) + "\", wanted a step from 0 to " +
               std::to_string(session.n_steps());
    session.go_to(static_cast<std::size_t>(*place));
    return std::nullopt;
}

} // namespace

ui::Stage::Sought OffscreenStage::find(std::string_view place)
{
    if (const auto pixel = ui::pixel_place(place)) return *pixel;
    if (const auto point = point_in(place)) {
        const ui::Point at = application().canvas().in_window(application().session(), *point);
        return ui::PointerPlace{at.x, at.y};
    }
    const auto part = named_part(application().session().shown(), place);
    if (!part) return any_place;
    const auto at = application().canvas().in_window(*part);
    if (!at) return "one that is seen";
    return ui::PointerPlace{at->x, at->y};
}

std::optional<std::string> OffscreenStage::run_command(std::string_view id, std::string_view argument)
{
    Desk& desk = application().desk();
    if (id == "file.open" && !argument.empty()) return told(desk.session, desk.session.open(argument));
    if (id == "file.save" && !argument.empty()) return told(desk.session, desk.session.save(argument));
    if (id == "file.export" && !argument.empty()) return in_english(application().export_as(argument));
    if (id == "step.go_to") return go_to(desk.session, argument);
    if (id == "step.apply") return in_english(desk.session.apply(argument));
    if (id == "challenge.answer") return in_english(desk.session.answer(argument));
    if (id == "operator.choose") return in_english(desk.session.choose_typed(argument));
    return ui::run_by_name(application().commands(), id, desk);
}

std::optional<std::string> OffscreenStage::expect(std::string_view words) { return why_not(words, application()); }

} // namespace euler
