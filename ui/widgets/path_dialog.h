#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/files/ending.h"
#include "ui/text/catalogue.h"

struct ImGuiInputTextCallbackData;

namespace ui {

/// Asks for a file's path: typed, or picked from the folder's list. A path is completed by its extension. What cannot
/// be is told in the dialog, which stays open and keeps the keyboard.
class PathDialog {
public:
    enum class Purpose : std::uint8_t { Open, Save, Export };

    /// Lists the files with this extension, but for those whose names end in `left_out` where that is not empty.
    void open(Purpose purpose, const std::filesystem::path& start, std::string extension, std::string left_out = {});
    /// Lists the files with any of these endings, to open one. \pre there is an ending
    void open_any(const std::filesystem::path& start, std::vector<std::string> endings);
    /// Offers the endings that something can be exported with, the first one where none is typed.
    void open_export(const std::filesystem::path& start, std::vector<std::string> endings);
    bool is_open() const { return is_open_; }
    Purpose purpose() const { return purpose_; }

    /// The path, in the frame in which it is confirmed. Saving over another file asks first.
    std::optional<std::filesystem::path> show(const Catalogue& tr);
    /// What was confirmed last cannot be done: asks again, with the reason.
    void refuse(const Message& reason);

private:
    struct Entry {
        std::string name;
        bool is_folder;
    };

    void open_listing(Purpose purpose, const std::filesystem::path& start, std::vector<std::string> endings);
    bool is_listed(const std::filesystem::path& file) const;
    void enter(const std::filesystem::path& folder);
    std::vector<std::string> wanted_endings() const;
    std::optional<std::filesystem::path> confirm();
    bool show_list();
    void show_endings();
    bool show_field(const Catalogue& tr);
    bool is_opening() const { return purpose_ == Purpose::Open; }
    std::string stem_of(const std::string& name) const;
    void take_name(const std::string& name);
    void take_ending(const std::string& ending);
    static int mark(ImGuiInputTextCallbackData* data);

    bool is_open_ = false;
    bool is_fresh_ = false;
    bool wants_keyboard_ = false;
    std::optional<std::size_t> n_marked_{}; ///< letters from the first that are marked once the field has the keyboard
    bool must_confirm_overwrite_ = false;
    std::optional<Message> refusal_{};
    Purpose purpose_ = Purpose::Open;
    std::string extension_, left_out_;
    std::vector<std::string> endings_; ///< where more than one is listed
    std::filesystem::path start_;      ///< the path that the dialog began with: saving over it needs no question
    std::filesystem::path folder_;
    std::string typed_; ///< relative to the folder, or absolute
    std::vector<Entry> entries_;
};

} // namespace ui
