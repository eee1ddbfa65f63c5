#pragma once

#include <filesystem>

#include "apps/frame/session/commands.h"

namespace frame {

/// The documents of a desk, each in a tab; one of them is on the desk, the others on its shelf.

std::size_t n_tabs(const Desk& desk);
const Session& tab(const Desk& desk, std::size_t place); ///< \pre place < n_tabs
/// Brings another tab's document to the desk; language, theme and what is shown stay.
void show_tab(Desk& desk, std::size_t place);
/// Puts the session in a tab of its own and shows it; takes the place of a document that nobody has touched.
void add_tab(Desk& desk, Session session);
/// Takes the document off the desk, saved or not; where it was the last one, an empty one comes.
void close_tab(Desk& desk);

/// What is shown where another kind of structure comes: N of a truss where M was shown of a frame, and the other way.
ShowSet suited(ShowSet show, bool is_truss);

/// An empty sheet in a tab of its own.
void new_document(Desk& desk, femoop::AnalysisKind kind = femoop::AnalysisKind::Frame2d);
/// Shows the file's document, in a tab of its own, or in the one where it is open already. Where it has an error the
/// open document stays as it is and its `notice` says why; false then.
bool open_file(Desk& desk, const std::filesystem::path& path, Session::Purpose purpose = Session::Purpose::Work);
/// Saves under this name (Session::save), unless it is that of the file of another tab; false, with a notice, then.
bool save_as(Desk& desk, const std::filesystem::path& path);

} // namespace frame
