#include "ui/files/view_file.h"

#include <string>
#include <string_view>
#include <system_error>

namespace ui {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view view_ending = ".view.json";      // in place of .json
constexpr std::string_view view_ending_of_others = ".view"; // behind a name that ends otherwise

} // namespace

fs::path view_path(const fs::path& model_file)
{
    std::error_code error;
    fs::path path = fs::is_symlink(model_file, error) ? fs::weakly_canonical(model_file, error) : model_file;
    if (path.extension() == ".json") return path.replace_extension(view_ending);
    return path += view_ending_of_others;
}

std::optional<fs::path> model_of_view(const fs::path& path)
{
    const std::string text = path.string();
    if (text.ends_with(view_ending)) return text.substr(0, text.size() - view_ending.size()) + ".json";
    if (text.ends_with(view_ending_of_others)) return text.substr(0, text.size() - view_ending_of_others.size());
    return std::nullopt;
}

fs::path free_old_path(const fs::path& view_file)
{
    std::error_code unknown;
    for (int i = 1;; ++i) {
        fs::path path = view_file;
        path += i == 1 ? ".old" : ".old" + std::to_string(i);
        if (!fs::exists(fs::symlink_status(path, unknown))) return path;
    }
}

} // namespace ui
