#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/frame/document/companion/companion.h"
#include "femoop/model/fault/fault.h"

namespace frame {

struct Document;

/// The companion file beside a model file: portal.json has portal.view.json, portal.txt has portal.txt.view, so that no
/// two models share one; a link to a model has that of the model. Format 1, one UTF-8 JSON object; the contract is
/// courseware/reference/view-file.md.
std::filesystem::path companion_path(const std::filesystem::path& model_file);
/// The model file beside which a companion file of this name stands; nothing where it is no such name.
std::optional<std::filesystem::path> model_of_companion(const std::filesystem::path& path);
/// Where one with faults is put aside: portal.view.json.old, or the next such name that is free, portal.view.json.old2.
std::filesystem::path free_old_path(const std::filesystem::path& companion);

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

/// Writes the companion file whole or not at all; an empty companion has none, so one that is there goes.
/// \returns what hindered it
std::error_code save_companion_of(const std::filesystem::path& model_file, const Document& document);

} // namespace frame
