#pragma once

#include <filesystem>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands on materials and sections as named sets: add, import, condense; and the model's own title.
void add_property_commands(CommandTable& table);

/// A material for the selected members, like theirs or steel; it becomes the selection.
void new_material(Session& session);

/// Makes one of equal materials and sections, takes unused ones out, and tells how many.
void condense_properties(Session& session);

/// Brings the materials and sections of a model file that the document has not yet. \returns false, with a notice,
/// where the file cannot be read
bool import_properties(Session& session, const std::filesystem::path& path);

/// Of the model, each as one step; nothing where it is so already.
void set_title(Session& session, const std::string& title);
void set_notes(Session& session, const std::string& notes);

/// The members of a material or section become the selection. \pre the model has it
void select_members_with(Session& session, const Part& property);

/// A copy of a material, section, load case or combination, which becomes the selection. \pre the model has it
void duplicate(Session& session, const Part& property);

/// \returns why the material, section, load case or combination cannot have this name, else renames it. \pre the model
/// has it
std::optional<ui::Message> rename(Session& session, const Part& property, const std::string& name);

/// Of a material, section, load case or combination.
const std::string& name_of(const femoop::Model& model, const Part& property);

} // namespace frame
