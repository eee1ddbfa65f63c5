#pragma once

#include <algorithm>
#include <string>

#include "femoop/edit/naming.h"

namespace plane {

/// A name that no entry of a list has: the wanted one, or the next with a number at its end.
template <class Entries> std::string fresh_id(const Entries& entries, const std::string& wanted)
{
    return femoop::fresh_name(wanted, [&](const std::string& name) {
        return std::ranges::any_of(entries, [&](const auto& entry) { return entry.id == name; });
    });
}

} // namespace plane
