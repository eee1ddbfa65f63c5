#pragma once

#include "femoop/model/fault/fault.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace discretize {

/// Of what faces are made of, held or loaded by, and of what lies beside them: the curves are sound, and so are the faces.
bool is_of_faces(femoop::FaultKind kind);

/// An entry of a list, as the place of a fault begins: curves[2] "hole".at
struct EntryPlace {
    std::string_view list;
    std::size_t index;
};
std::optional<EntryPlace> entry_of(std::string_view place);

} // namespace discretize
