#pragma once

#include <string_view>

#include "ui/workspace/standard_commands.h"

namespace ui::standard {

/// What the menu of files says of an app's own documents.
struct FileWords {
    std::string_view exported;  ///< "Export picture…"
    std::string_view described; ///< "Sheet in words"
};

/// The menu of files of an app of one document (document_workspace.h), whose session knows `new_document()`.
template <class Workspace> void add_file_commands(CommandTable<Workspace>& table, const FileWords& words)
{
    add_new<Workspace>(table, [](Workspace& workspace) {
        workspace.leave_document([](Workspace& left) { left.session.new_document(); });
    });
    add_open<Workspace>(table, [](Workspace& workspace) { workspace.leave_document(asks(Request::OpenDialog)); });
    add_save(table);
    add_export(table, words.exported);
    add_copy_and_describe(table, words.described);
    add_quit(table);
}

} // namespace ui::standard
