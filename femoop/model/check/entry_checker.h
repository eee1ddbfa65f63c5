#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/load.h"
#include "femoop/model/property.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// An entry of a list, as faults name it: members[2] "BC". Its words are put together only for a fault.
struct Entry {
    std::string_view list;
    std::optional<std::size_t> index;
    std::string_view id;

    std::string text() const;
};

inline constexpr double furthest_coordinate = 1e100; ///< its square is a number, a stiffness over it not nothing

/// What the checks of all models have in common: how a fault of an entry is written down, what a number must be, and
/// what holds for names, materials and combinations.
class EntryChecker {
protected:
    explicit EntryChecker(const Units& units) : units_(units) {}

    static bool is_lack(FaultKind kind); ///< something that an entry with an unreadable part need not have
    void add(FaultKind kind, const Entry& place, std::vector<std::string> details);
    std::string shown(const Quantity& quantity, Dimension dimension) const; ///< as typed, else with its unit
    bool require_entry(const Entry& place, std::string_view list, std::size_t index, std::size_t n);
    bool require_finite(const Entry& place, std::string_view key, double value);
    void require_within_reach(const Entry& place, std::string_view key, const Quantity& coordinate);
    void require_positive(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension);
    void require_stiffness(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension);
    void require_not_negative(const Entry& place, std::string_view key, const Quantity& value, Dimension dimension);
    void require_distinct(const Entry& place, const std::vector<Component>& components);
    static bool flag(const std::vector<bool>& flags, std::size_t i) { return i < flags.size() && flags[i]; }
    static bool flag(const std::vector<std::vector<bool>>& flags, std::size_t i, std::size_t j)
    {
        return i < flags.size() && flag(flags[i], j);
    }

    void check_names(const std::vector<Entry>& entries); ///< that are unique together
    static bool are_flawless(const std::vector<std::string_view>& names);
    /// Adds the entries of a list; one that could be read has a name.
    template <class Parts>
    void collect_names(std::vector<Entry>& entries, std::string_view list, const Parts& parts,
                       const std::vector<bool>& unreadable);
    template <class Parts> ///< of a list with names of its own
    void check_names(std::string_view list, const Parts& parts, const std::vector<bool>& unreadable);
    template <class Parts> static bool have_flawless_names(const Parts& parts); ///< without looking for faults
    void check_material(const Material& material, const Entry& place);
    /// Terms that name cases by finite factors, and no combination of itself.
    template <class AnyModel> void check_combinations(const AnyModel& model, const std::vector<bool>& unreadable);

    Units units_;
    std::vector<Fault> faults_;
    bool is_partial_ = false; ///< the entry at hand has a part that could not be read
    bool has_repeated_id_ = false;

private:
    void check_circles(const std::vector<Combination>& combinations, std::size_t n_load_cases);
    void add_circle(const std::vector<Combination>& combinations, const std::vector<std::size_t>& path,
                    std::size_t again);
};

template <class Parts>
void EntryChecker::collect_names(std::vector<Entry>& entries, std::string_view list, const Parts& parts,
                                 const std::vector<bool>& unreadable)
{
    for (std::size_t i = 0; i < parts.size(); ++i) {
        entries.push_back({list, i, parts[i].id});
        if (parts[i].id.empty() && !flag(unreadable, i)) add(FaultKind::EmptyId, entries.back(), {});
    }
}

template <class Parts> bool EntryChecker::have_flawless_names(const Parts& parts)
{
    std::vector<std::string_view> names;
    names.reserve(parts.size());
    for (const auto& part : parts) names.emplace_back(part.id);
    return are_flawless(names);
}

template <class Parts>
void EntryChecker::check_names(std::string_view list, const Parts& parts, const std::vector<bool>& unreadable)
{
    if (have_flawless_names(parts)) return;
    std::vector<Entry> entries;
    collect_names(entries, list, parts, unreadable);
    check_names(entries);
}

template <class AnyModel>
void EntryChecker::check_combinations(const AnyModel& model, const std::vector<bool>& unreadable)
{
    for (std::size_t i = 0; i < model.combinations.size(); ++i) {
        is_partial_ = flag(unreadable, i);
        const Combination& combination = model.combinations[i];
        const Entry place{"combinations", i, combination.id};
        for (const Combination::Term& term : combination.terms)
            if (require_entry(place, "cases", term.of.index, model.n_cases()))
                require_finite(place, model.case_name(term.of), term.factor);
    }
    is_partial_ = false;
    check_circles(model.combinations, model.load_cases.size());
}

} // namespace femoop
