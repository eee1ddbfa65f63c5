#include "ui/app/dialogs.h"

#include <utility>

namespace ui {

using Purpose = ChosenFile::Purpose;

bool Dialogs::take(Request request, const std::optional<std::filesystem::path>& file)
{
    switch (request) {
    case Request::OpenDialog: open_dialog(Purpose::Open, file); return true;
    case Request::SaveDialog: open_dialog(Purpose::Save, file); return true;
    case Request::ExportDialog: open_dialog(Purpose::Export, file); return true;
    case Request::Palette: palette_.open(); return true;
    case Request::ShortcutList: shows_keys_ = !shows_keys_; return true;
    case Request::Description: shows_description_ = !shows_description_; return true;
    default: return false;
    }
}

// A picture is written beside the document's own file, under its name.
void Dialogs::open_dialog(Purpose purpose, const std::optional<std::filesystem::path>& file)
{
    purpose_ = purpose;
    if (purpose == Purpose::Export) {
        std::filesystem::path picture = file.value_or("picture");
        return path_dialog_.open_export(picture.replace_extension(files_.exports.front()), files_.exports);
    }
    const bool opens = purpose == Purpose::Open;
    path_dialog_.open(opens ? PathDialog::Purpose::Open : PathDialog::Purpose::Save, file.value_or(""),
                      files_.extension, files_.left_out);
}

bool Dialogs::close_topmost() { return std::exchange(shows_keys_, false) || std::exchange(shows_description_, false); }

std::optional<ChosenFile> Dialogs::show_dialog(const Catalogue& tr)
{
    const auto path = path_dialog_.show(tr);
    return path ? std::optional(ChosenFile{purpose_, *path}) : std::nullopt;
}

} // namespace ui
