#pragma once

#include <string_view>

#include "femoop/plane/model/plane_model.h"

namespace plane {

/// What the window calls the method that a region is meshed by, which files name with a key; translatable. A method that
/// there is not keeps its key.
std::string_view method_word(std::string_view method);
std::string_view formulation_word(femoop::plane::Formulation formulation); ///< of elements; translatable

} // namespace plane
