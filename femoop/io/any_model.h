#pragma once

#include <filesystem>
#include <string_view>
#include <variant>

#include "femoop/io/model_file.h"
#include "femoop/io/plane/plane_file.h"

namespace femoop {

/// What a model file holds: a structure of members or a plane model, each as it was read. A file that is neither, for
/// instance no JSON at all, counts as a structure of members with its faults.
using AnyReading = std::variant<ModelReading, plane::PlaneReading>;

AnyReading examine_any(std::string_view text);
AnyReading examine_any_file(const std::filesystem::path& path);

} // namespace femoop
