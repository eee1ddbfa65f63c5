#pragma once

#include <filesystem>
#include <string>

#include "apps/frame/session/commands.h"

namespace frame {

/// The documents of a workspace, each in a tab; one of them is on the workspace, the others on its shelf.

std::size_t n_tabs(const Workspace& workspace);
const Session& tab(const Workspace& workspace, std::size_t place); ///< \pre place < n_tabs
/// What its tab is called; where several would be called the same, by the folders of their files, and by numbers those
/// that have none.
std::string tab_name(const Workspace& workspace, std::size_t place);
/// Brings another tab's document to the workspace; language, theme and what is shown stay.
void show_tab(Workspace& workspace, std::size_t place);
/// Puts the session in a tab of its own and shows it; takes the place of a document that nobody has touched.
void add_tab(Workspace& workspace, Session session);
/// Takes the document off the workspace, saved or not; where it was the last one, an empty one comes.
void close_tab(Workspace& workspace);
/// The same, but the window asks first where it is not saved.
void leave_tab(Workspace& workspace);

/// What is shown where another kind of structure comes: N of a truss where M was shown of a frame, and the other way.
ShowSet suited(ShowSet show, bool is_truss);

/// An empty sheet in a tab of its own.
void new_document(Workspace& workspace, femoop::AnalysisKind kind = femoop::AnalysisKind::Frame2d);
/// Shows the file's document, in a tab of its own, or in the one where it is open already. Where it has an error the
/// open document stays as it is and its `notice` says why; false then.
bool open_file(Workspace& workspace, const std::filesystem::path& path,
               Session::Purpose purpose = Session::Purpose::Work);
/// Units that a person chose are that person's, whatever is opened, as language and digits are: a document that comes
/// under them says so.
void tell_units(Session& session);

} // namespace frame
