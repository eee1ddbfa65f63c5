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
    void check_material(const Material& material, const Entry& place);
    void check_circles(const std::vector<Combination>& combinations, std::size_t n_load_cases);

    Units units_;
    std::vector<Fault> faults_;
    bool is_partial_ = false; ///< the entry at hand has a part that could not be read
    bool has_repeated_id_ = false;

private:
    void add_circle(const std::vector<Combination>& combinations, const std::vector<std::size_t>& path,
                    std::size_t again);
};

} // namespace femoop
