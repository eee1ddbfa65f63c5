#include "femoop/model/check/entry_checker.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "femoop/model/check/name_table.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

constexpr double least_factor = 1e-100; ///< nobody means less, and a product of three has lost its digits

bool is_control_character(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }

} // namespace

std::string Entry::text() const
{
    std::string text(list);
    if (index) text += '[' + std::to_string(*index) + ']';
    return id.empty() ? text : text + " \"" + std::string(id) + '"';
}

bool EntryChecker::is_lack(FaultKind kind)
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

void EntryChecker::add(FaultKind kind, const Entry& place, std::vector<std::string> details)
{
    if (is_partial_ && is_lack(kind)) return;
    details.insert(details.begin(), place.text());
    faults_.push_back({kind, std::move(details)});
}

std::string EntryChecker::shown(const Quantity& quantity, Dimension dimension) const
{
    return quantity.has_text() ? std::string(quantity.text()) : quantity_text(quantity.value(), dimension, units_);
}

bool EntryChecker::require_entry(const Entry& place, std::string_view list, std::size_t index, std::size_t n)
{
    if (index < n) return true;
    add(FaultKind::DanglingReference, place, {std::string(list), std::to_string(index), std::to_string(n)});
    return false;
}

bool EntryChecker::require_finite(const Entry& place, std::string_view key, double value)
{
    if (std::isfinite(value)) return true;
    add(FaultKind::NotFinite, place, {std::string(key), number_text(value)});
    return false;
}

void EntryChecker::require_within_reach(const Entry& place, std::string_view key, const Quantity& coordinate)
{
    if (require_finite(place, key, coordinate) && std::abs(coordinate.value()) > furthest_coordinate)
        add(FaultKind::OutOfReach, place,
            {std::string(key), shown(coordinate, dimension::length),
             shown(Quantity(furthest_coordinate), dimension::length)});
}

void EntryChecker::require_positive(const Entry& place, std::string_view key, const Quantity& value,
                                    Dimension dimension)
{
    if (!require_finite(place, key, value)) return;
    if (value <= 0.0) add(FaultKind::NotPositive, place, {std::string(key), shown(value, dimension)});
    else if (value < least_factor)
        faults_.push_back(
            {FaultKind::QuantityTooLarge, {place.text() + ", " + std::string(key), shown(value, dimension)}});
}

void EntryChecker::require_stiffness(const Entry& place, std::string_view key, const Quantity& value,
                                     Dimension dimension)
{
    if (value.value() == 0.0) add(FaultKind::ZeroStiffness, place, {std::string(key), shown(value, dimension)});
    else require_positive(place, key, value, dimension);
}

void EntryChecker::require_not_negative(const Entry& place, std::string_view key, const Quantity& value,
                                        Dimension dimension)
{
    if (require_finite(place, key, value) && value < 0.0)
        add(FaultKind::Negative, place, {std::string(key), shown(value, dimension)});
}

void EntryChecker::require_distinct(const Entry& place, const std::vector<Component>& components)
{
    DofSet seen;
    for (const Component& component : components) {
        if (seen.contains(component.dof)) add(FaultKind::RepeatedComponent, place, {std::string(name(component.dof))});
        seen.insert(component.dof);
    }
}

bool EntryChecker::are_flawless(const std::vector<std::string_view>& names)
{
    const auto is_flawed = [](std::string_view name) {
        return name.empty() || std::ranges::any_of(name, is_control_character);
    };
    return std::ranges::none_of(names, is_flawed) && repeated_names(names).empty();
}

void EntryChecker::check_names(const std::vector<Entry>& entries)
{
    std::vector<std::string_view> names;
    names.reserve(entries.size());
    for (const Entry& entry : entries) names.push_back(entry.id);
    for (const Entry& entry : entries)
        if (std::any_of(entry.id.begin(), entry.id.end(), is_control_character))
            add(FaultKind::ControlCharacterInId, entry, {});
    for (const auto& [index, first] : repeated_names(names)) {
        if (names[index].empty()) continue;
        has_repeated_id_ = true;
        add(FaultKind::RepeatedId, entries[index], {Entry{entries[first].list, entries[first].index, {}}.text()});
    }
}

void EntryChecker::check_material(const Material& material, const Entry& place)
{
    require_positive(place, "E", material.E, dimension::stress);
    if (material.G) require_positive(place, "G", *material.G, dimension::stress);
    if (material.alpha) require_finite(place, "alpha", *material.alpha);
    if (material.density) require_not_negative(place, "density", *material.density, dimension::density);
    if (material.fy) require_positive(place, "fy", *material.fy, dimension::stress);
    if (!material.nu || !require_finite(place, "nu", *material.nu)) return;
    if (*material.nu <= -1.0 || *material.nu > 0.5)
        add(FaultKind::PoissonOutOfRange, place, {shown(*material.nu, dimension::none)});
}

// Depth-first with a stack of our own: a chain of combinations may be as long as the file.
void EntryChecker::check_circles(const std::vector<Combination>& combinations, std::size_t n_load_cases)
{
    enum class State : std::uint8_t { New, Open, Done };
    std::vector<State> states(combinations.size(), State::New);
    std::vector<std::size_t> next_term(combinations.size(), 0);
    for (std::size_t first = 0; first < states.size(); ++first) {
        std::vector<std::size_t> path;
        const auto enter = [&](std::size_t i) {
            states[i] = State::Open;
            path.push_back(i);
        };
        if (states[first] == State::New) enter(first);
        while (!path.empty()) {
            const std::size_t current = path.back();
            const auto& terms = combinations[current].terms;
            if (next_term[current] == terms.size()) {
                states[current] = State::Done;
                path.pop_back();
                continue;
            }
            const std::size_t of = terms[next_term[current]++].of.index;
            if (of < n_load_cases || of - n_load_cases >= combinations.size()) continue;
            const std::size_t next = of - n_load_cases;
            if (states[next] == State::New) enter(next);
            else if (states[next] == State::Open) add_circle(combinations, path, next);
        }
    }
}

void EntryChecker::add_circle(const std::vector<Combination>& combinations, const std::vector<std::size_t>& path,
                              std::size_t again)
{
    std::string circle;
    for (auto step = std::find(path.begin(), path.end(), again); step != path.end(); ++step)
        circle += combinations[*step].id + " -> ";
    const std::string& id = combinations[again].id;
    add(FaultKind::CombinationCircle, {"combinations", again, id}, {circle + id});
}

} // namespace femoop
