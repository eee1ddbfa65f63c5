#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/frame/document/companion/companion.h"
#include "femoop/model/fault/fault.h"

namespace frame {

struct Document;

// A companion is kept in the view file beside its model file (ui/files/view_file.h). Format 1, one UTF-8 JSON object; the
// contract is courseware/reference/view-file.md.

/// What could be understood of a companion's text, and what could not, each fault with its place.
struct CompanionReading {
    Companion companion;
    std::vector<femoop::Fault> faults;
};
CompanionReading read_companion(std::string_view text, const femoop::Model& model);
/// Of the file beside this model file; an empty companion where there is none.
CompanionReading read_companion_of(const std::filesystem::path& model_file, const femoop::Model& model);

/// One dimension line a line, quantities in the units of its model; reading it back gives the same companion.
std::string write_companion(const Companion& companion, const femoop::Model& model);

/// Writes the view file whole or not at all; an empty companion has none, so one that is there goes.
/// \returns what hindered it
std::error_code save_companion_of(const std::filesystem::path& model_file, const Document& document);

} // namespace frame
