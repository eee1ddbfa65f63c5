#include "apps/euler/window/stage.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "apps/euler/session/named_part.h"
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

} // namespace

OffscreenStage::Found OffscreenStage::locate(std::string_view place)
{
    if (const auto point = point_in(place)) return application().canvas().in_window(application().session(), *point);
    const auto part = named_part(application().session().shown(), place);
    if (!part) return any_place;
    const auto at = application().canvas().in_window(*part);
    if (!at) return "one that is seen";
    return *at;
}

} // namespace euler
