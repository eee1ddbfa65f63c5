#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/place.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/quantity.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// The keys of one kind of object: those that it needs come first.
template <std::size_t N> struct Keys {
    std::array<std::string_view, N> names;
    std::size_t n_needed = 0;
};

/// What a quantity becomes that is missing or cannot be read: `check` says no more of it.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Turns JSON values into what a model holds, and writes down everything that is wrong on the way.
/// Every reading function takes the place of the object around the value and returns nothing for an absent value
/// (no fault) and for a wrong one (a fault); a quantity that cannot be read is there, but no number (`no_number`).
class ValueReader {
public:
    /// What a list of names is asked for: the keys' own values, in the order of `keys`; absent ones are absent.
    /// Faults: unknown keys and needed keys that are missing.
    template <std::size_t N> std::array<JsonValue, N> fields(JsonValue object, const Keys<N>& keys, const Place& place)
    {
        std::array<JsonValue, N> found;
        if (!object.is(JsonKind::Object)) {
            not_an_object(object, place);
            return found;
        }
        for (const JsonValue value : object) {
            std::size_t i = 0;
            while (i < N && keys.names[i] != value.key()) ++i;
            if (i < N) found[i] = value;
            else unknown_key(value, {keys.names.begin(), keys.names.end()}, place);
        }
        for (std::size_t i = 0; i < keys.n_needed; ++i)
            if (!found[i].is_present()) missing_key(keys.names[i], place);
        return found;
    }

    std::optional<std::string> text(JsonValue value, const Place& place);
    std::string id(JsonValue value, const Place& place); ///< "" when it cannot be read, and a fault if it is ""
    std::optional<double> number(JsonValue value, const Place& place);
    bool boolean(JsonValue value, const Place& place); ///< false when absent
    std::optional<Quantity> quantity(JsonValue value, Dimension dimension, const Place& place,
                                     AngleUnit angle = AngleUnit::Radians);
    /// The index of a text in `choices`.
    template <std::size_t N>
    std::optional<std::size_t> choice(JsonValue value, const std::array<std::string_view, N>& choices,
                                      const Place& place)
    {
        return choice(value, std::vector<std::string_view>(choices.begin(), choices.end()), place);
    }
    std::optional<std::size_t> choice(JsonValue value, const std::vector<std::string_view>& choices,
                                      const Place& place);

    /// A fault: what was found at the place is none of the choices.
    void unknown_choice(std::string place, std::string found, const std::vector<std::string_view>& choices);

    bool is_object(JsonValue value, const Place& place); ///< and a fault if it is present but not an object
    bool is_list(JsonValue value, const Place& place);

    /// What a value should have been: in words, and as the file writes it.
    struct Wanted {
        std::string_view words, example;
    };
    void wrong_type(JsonValue value, const Wanted& wanted, const Place& place);
    void not_an_object(JsonValue value, const Place& own_place); ///< a fault if it is present
    void unknown_key(JsonValue value, const std::vector<std::string_view>& known, const Place& place);
    void missing_key(std::string_view key, const Place& place);
    /// One that follows itself, as of a key that is given twice, is noted once.
    void add(Fault fault)
    {
        if (faults_.empty() || faults_.back() != fault) faults_.push_back(std::move(fault));
    }

    const Units& units() const { return units_; }
    void set_units(const Units& units) { units_ = units; }
    /// A value that cannot be understood because of a fault that is noted already.
    void excuse() { ++n_excused_; }
    std::size_t n_troubles() const { return faults_.size() + n_excused_; }
    std::vector<Fault> collect_faults() { return std::move(faults_); }

private:
    Units units_;
    std::vector<Fault> faults_;
    std::size_t n_excused_ = 0;
};

} // namespace femoop
