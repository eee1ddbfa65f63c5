#include "ui/app/dialogs.h"

#include <utility>

namespace ui {

using Purpose = ChosenFile::Purpose;

bool Dialogs::handle_request(Request request, const std::optional<std::filesystem::path>& file, const Catalogue& tr)
{
    switch (request) {
    case Request::OpenDialog: open_dialog(Purpose::Open, file); return true;
    case Request::SaveDialog: open_dialog(Purpose::Save, file); return true;
    case Request::ExportDialog: open_export(file.value_or(tr("picture"))); return true;
    case Request::Palette: palette_.open(); return true;
    case Request::ShortcutList: shows_keys_ = !shows_keys_; return true;
    case Request::Description: shows_description_ = !shows_description_; return true;
    default: return false;
    }
}

void Dialogs::open_export(std::filesystem::path picture)
{
    purpose_ = Purpose::Export;
    path_dialog_.open_export(picture.replace_extension(files_.exports.front()), files_.exports);
}

void Dialogs::open_dialog(Purpose purpose, const std::optional<std::filesystem::path>& file)
{
    purpose_ = purpose;
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
