#include "femoop/model/check/checker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

std::string Entry::text() const
{
    std::string text(list);
    if (index) text += '[' + std::to_string(*index) + ']';
    return id.empty() ? text : text + " \"" + std::string(id) + '"';
}

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
    check_combinations();
    check_moving_loads();
    check_expected();
    is_partial_ = false;
    if (thoroughness == Thoroughness::Errors) return std::move(faults_);
    if (!is_incomplete_) check_use();
    check_coincident_nodes();
    check_crossings();
    return std::move(faults_);
}

bool Checker::is_lack(FaultKind kind)
{
    switch (kind) {
    case FaultKind::DanglingReference:
    case FaultKind::NotFinite:
    case FaultKind::EmptyLoad:
    case FaultKind::ShapeSizeMissing:
    case FaultKind::MemberWithoutMaterial:
    case FaultKind::MemberWithoutSection:
    case FaultKind::ExpectedWithoutCase:
    case FaultKind::ExpectedKeyMissing: return true;
    default: return false;
    }
}

void Checker::add(FaultKind kind, const Entry& place, std::vector<std::string> details)
{
    if (is_partial_ && is_lack(kind)) return;
    details.insert(details.begin(), place.text());
    faults_.push_back({kind, std::move(details)});
}

std::string Checker::shown(const Quantity& quantity, Dimension dimension) const
{
    return quantity.has_text() ? std::string(quantity.text())
                               : quantity_text(quantity.value(), dimension, model_.units);
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

bool Checker::require_entry(const Entry& place, std::string_view list, std::size_t index, std::size_t n)
{
    if (index < n) return true;
    add(FaultKind::DanglingReference, place, {std::string(list), std::to_string(index), std::to_string(n)});
    return false;
}

bool Checker::require_finite(const Entry& place, std::string_view key, double value)
{
    if (std::isfinite(value)) return true;
    add(FaultKind::NotFinite, place, {std::string(key), number_text(value)});
    return false;
}

namespace {

constexpr double furthest = 1e100; // the square of a length is a number still, a stiffness over it is not nothing

} // namespace

bool Checker::is_within_reach(NodeId id) const
{
    const auto& at = model_[id].at;
    return std::all_of(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(n_coordinates(model_.analysis)),
                       [](const Quantity& x) { return std::abs(x.value()) <= furthest; });
}

void Checker::require_within_reach(const Entry& place, std::string_view key, const Quantity& coordinate)
{
    if (require_finite(place, key, coordinate) && std::abs(coordinate.value()) > furthest)
        add(FaultKind::OutOfReach, place,
            {std::string(key), shown(coordinate, dimension::length), shown(Quantity(furthest), dimension::length)});
}

void Checker::require_positive(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension)
{
    if (require_finite(place, key, value) && value <= 0.0)
        add(FaultKind::NotPositive, place, {std::string(key), shown(value, dimension)});
}

void Checker::require_stiffness(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension)
{
    if (value.value() == 0.0) add(FaultKind::ZeroStiffness, place, {std::string(key), shown(value, dimension)});
    else require_positive(place, key, value, dimension);
}

void Checker::require_not_negative(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension)
{
    if (require_finite(place, key, value) && value < 0.0)
        add(FaultKind::Negative, place, {std::string(key), shown(value, dimension)});
}

void Checker::require_distinct(const Entry& place, const std::vector<Component>& components)
{
    DofSet seen;
    for (const Component& component : components) {
        if (seen.contains(component.dof)) add(FaultKind::RepeatedComponent, place, {std::string(name(component.dof))});
        seen.insert(component.dof);
    }
}

} // namespace femoop
