#pragma once

#include <filesystem>
#include <string_view>

#include "ui/desk/standard_commands.h"

namespace ui::standard {

/// What the menu of files says of an app's own documents.
struct FileWords {
    std::string_view exported;  ///< "Export picture…"
    std::string_view described; ///< "Sheet in words"
};

/// The menu of files of an app of one document (document_desk.h), whose session knows `begin_anew()`.
template <class Desk> void add_file_commands(CommandTable<Desk>& table, const FileWords& words)
{
    add_new<Desk>(table, [](Desk& desk) { desk.leave_document([](Desk& left) { left.session.begin_anew(); }); });
    add_open<Desk>(
        table, [](Desk& desk) { desk.leave_document(asks(Request::OpenDialog)); },
        [](Desk& desk, const std::filesystem::path& path) { return desk.session.open(path); });
    add_save(table, [](Desk& desk, const std::filesystem::path& path) { return desk.session.save(path); });
    add_export(table, words.exported);
    add_copy_and_describe(table, words.described);
    add_quit<Desk>(table, [](Desk& desk) { desk.leave_document(asks(Request::Quit)); });
}

} // namespace ui::standard
