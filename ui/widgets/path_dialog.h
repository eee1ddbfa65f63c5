#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/text/catalogue.h"

namespace ui {

/// Asks for a file's path: typed, or picked from the folder's list. A path is completed by its extension.
class PathDialog {
public:
    enum class Purpose : std::uint8_t { Open, Save };

    /// Lists the files with this extension, but for those whose names end in `left_out` where that is not empty.
    void open(Purpose purpose, const std::filesystem::path& start, std::string extension, std::string left_out = {});
    bool is_open() const { return is_open_; }
    Purpose purpose() const { return purpose_; }

    /// The path, in the frame in which it is confirmed. Saving over another file asks first.
    std::optional<std::filesystem::path> show(const Catalogue& tr);

private:
    struct Entry {
        std::string name;
        bool is_folder;
    };

    bool is_listed(const std::filesystem::path& file) const;
    void enter(const std::filesystem::path& folder);
    std::optional<std::filesystem::path> confirm();
    bool show_list();

    bool is_open_ = false;
    bool is_fresh_ = false;
    bool must_confirm_overwrite_ = false;
    Purpose purpose_ = Purpose::Open;
    std::string extension_, left_out_;
    std::filesystem::path start_; ///< the path that the dialog began with: saving over it needs no question
    std::filesystem::path folder_;
    std::string typed_; ///< relative to the folder, or absolute
    std::vector<Entry> entries_;
};

} // namespace ui
