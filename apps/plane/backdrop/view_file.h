#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "apps/plane/backdrop/backdrop.h"
#include "femoop/model/fault/fault.h"

namespace plane {

// The view file beside the file of a drawing (ui/files/view_file.h) keeps the backdrop. Format 1, one UTF-8 JSON object;
// the contract is courseware/reference/view-file.md.

/// What could be understood of a view file, and what could not, each fault with its place. An image that cannot be read
/// is a fault too, and then there is no backdrop.
struct ViewReading {
    std::optional<Backdrop> backdrop{};
    std::vector<femoop::Fault> faults{};
};
/// \param folder  that paths in it count from: its own
ViewReading read_view(std::string_view text, const std::filesystem::path& folder);
/// Of the file beside this model file; an empty one where there is none.
ViewReading read_view_of(const std::filesystem::path& model_file);

/// The image by its path from the folder of the model file.
std::string view_text(const Backdrop& backdrop, const std::filesystem::path& model_file);

/// Writes the view file whole or not at all; without a backdrop there is none, so one that is there goes.
/// \returns what hindered it
std::error_code write_view_of(const std::filesystem::path& model_file, const std::optional<Backdrop>& backdrop);

/// What stands beside a model file once it is saved.
struct SavedView {
    std::error_code hindrance{};                      ///< then the file is as it was
    std::optional<std::filesystem::path> put_aside{}; ///< the name that one with faults has now
};
/// The same with care for a view file that has faults: it stays where there is no backdrop, for its image may only be
/// elsewhere today, and else is put aside.
SavedView save_view_of(const std::filesystem::path& model_file, const std::optional<Backdrop>& backdrop);

/// The PNG or JPEG image of a file; nothing where it cannot be read, and why.
struct ImageReading {
    std::shared_ptr<const ui::Photo> photo{};
    std::optional<femoop::Fault> fault{};
};
ImageReading read_image(const std::filesystem::path& file);

} // namespace plane
