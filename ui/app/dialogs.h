#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/text/catalogue.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/path_dialog.h"
#include "ui/widgets/shortcut_sheet.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// The files of an app, as its dialogs list them.
struct FileKind {
    std::string extension;            ///< of its documents: ".json"
    std::string left_out{};           ///< ending of those that are no documents: ".view.json"
    std::vector<std::string> exports; ///< endings that it exports with, the first where none is typed: ".png"
};

/// A file that the user chose, and what for.
struct ChosenFile {
    enum class Purpose : std::uint8_t { Open, Save, Export } purpose;
    std::filesystem::path path;
};

/// What every app lays over its picture when it is asked for: the command palette, the dialog of files, the sheet of
/// keys, the document in words.
class Dialogs {
public:
    explicit Dialogs(FileKind files) : files_(std::move(files)) {}

    /// Opens what is asked for; false where the request is for something else. \param file  the open document's: a
    /// picture is written beside it, under its name \param tr  has the name of one of a document without a file
    bool handle_request(Request request, const std::optional<std::filesystem::path>& file, const Catalogue& tr);
    /// The keys belong to what is open.
    bool wants_keys() const { return palette_.is_open() || path_dialog_.is_open(); }
    bool shows_dialog() const { return path_dialog_.is_open(); } ///< of files
    /// What Escape does first: puts away what lies over the picture; false where nothing does.
    bool close_topmost();

    /// A file, in the frame in which it is chosen.
    std::optional<ChosenFile> show_dialog(const Catalogue& tr);
    /// What was chosen cannot be written: asks again, with the reason.
    void refuse(const Message& reason) { path_dialog_.refuse(reason); }
    template <class Workspace> void show_palette_and_keys(const CommandTable<Workspace>& commands, Workspace& workspace)
    {
        const Catalogue tr = workspace.tr(); // a command may change the language
        palette_.show(commands, workspace, tr);
        if (shows_keys_) shortcut_sheet(key_lines(commands, workspace, tr), tr, shows_keys_);
    }
    bool& shows_description() { return shows_description_; }

private:
    void open_dialog(ChosenFile::Purpose purpose, const std::optional<std::filesystem::path>& file);
    void open_export(std::filesystem::path picture);

    FileKind files_;
    CommandPalette palette_;
    PathDialog path_dialog_;
    ChosenFile::Purpose purpose_ = ChosenFile::Purpose::Open; ///< what the dialog is open for
    bool shows_keys_ = false;
    bool shows_description_ = false;
};

} // namespace ui
