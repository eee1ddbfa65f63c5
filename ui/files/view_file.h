#pragma once

#include <filesystem>
#include <optional>

namespace ui {

/// The view file beside a model file, which has what belongs to the picture and not to the model: portal.json has
/// portal.view.json, portal.txt has portal.txt.view, so that no two models share one; a link to a model has that of the
/// model.
std::filesystem::path view_path(const std::filesystem::path& model_file);
/// The model file beside which a view file of this name stands; nothing where it is no such name.
std::optional<std::filesystem::path> model_of_view(const std::filesystem::path& path);
/// Where one with faults is put aside: portal.view.json.old, or the next such name that is free, portal.view.json.old2.
std::filesystem::path free_old_path(const std::filesystem::path& view_file);

} // namespace ui
