#include "femoop/model/check/checker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

std::vector<Fault> Checker::run(Thoroughness thoroughness)
{
    if (unreadable_.header) return {};
    has_member_.assign(model_.nodes.size(), false);
    check_ids();
    check_materials();
    check_sections();
    check_nodes();
    check_members();
    check_load_cases();
    check_combinations(model_, unreadable_.combinations);
    check_moving_loads();
    check_expected();
    is_partial_ = false;
    if (thoroughness == Thoroughness::Errors) return std::move(faults_);
    if (!is_incomplete_) check_use();
    check_coincident_nodes();
    check_crossings();
    return std::move(faults_);
}

std::string Checker::shown(Point point) const
{
    const auto rounded = [](double x) { // twelve digits find any place again
        std::array<char, 32> digits{};
        const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x,
                                                std::chars_format::general, 12);
        std::from_chars(digits.data(), end, x);
        return number_text(x);
    };
    std::string text = "(" + rounded(point[0]) + ", " + rounded(point[1]);
    if (is_3d(model_.analysis)) text += ", " + rounded(point[2]);
    return text + ") " + std::string(name(model_.units.length));
}

bool Checker::is_within_reach(NodeId id) const
{
    const auto& at = model_[id].at;
    return std::all_of(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(n_coordinates(model_.analysis)),
                       [](const Quantity& x) { return std::abs(x.value()) <= furthest_coordinate; });
}

} // namespace femoop
