#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace femoop {

/// Where a value stands in a model file. A chain of steps on the stack that is written out only when a fault needs it;
/// a step refers to the one before, which must outlive it.
///
///   nodes[3].support      a key of an entry
///   members[2] "BC"       an entry that has a name
class Place {
public:
    Place() = default; ///< the file itself
    Place key(std::string_view key) const { return Place(this, key, std::nullopt, {}); }
    Place entry(std::size_t index, std::string_view id = {}) const { return Place(this, {}, index, id); }

    std::string text() const;
    std::string text(std::string_view key) const; ///< of a key inside this place; of this place if `key` is empty

private:
    Place(const Place* outer, std::string_view key, std::optional<std::size_t> index, std::string_view id)
        : outer_(outer), key_(key), id_(id), index_(index)
    {}
    std::string path() const;

    const Place* outer_ = nullptr;
    std::string_view key_, id_;
    std::optional<std::size_t> index_;
};

} // namespace femoop
