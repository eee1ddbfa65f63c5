#pragma once

#include <filesystem>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands on materials and sections as named sets: add, import, condense.
void add_property_commands(CommandTable& table);

/// A material for the selected members, like theirs or steel; it becomes the selection.
void new_material(Session& session);

/// Makes one of equal materials and sections, takes unused ones out, and tells how many.
void condense_properties(Session& session);

/// Brings the materials and sections of a model file that the document has not yet. \returns false, with a notice,
/// where the file cannot be read
bool import_properties(Session& session, const std::filesystem::path& path);

/// The members of a material or section become the selection. \pre the model has it
void select_members_with(Session& session, const Part& property);

/// A copy of a material or section, which becomes the selection. \pre the model has it
void duplicate(Session& session, const Part& property);

/// \returns why the material or section cannot have this name, else renames it. \pre the model has it
std::optional<ui::Phrase> rename(Session& session, const Part& property, const std::string& name);

/// Of a material or section.
const std::string& name_of(const femoop::Model& model, const Part& property);

} // namespace frame
