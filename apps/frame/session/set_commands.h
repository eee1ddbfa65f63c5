#pragma once

#include <optional>
#include <span>
#include <string>

#include "apps/frame/document/named_sets.h"
#include "apps/frame/session/commands.h"

namespace frame {

/// The commands on supports and loads under names.
void add_set_commands(CommandTable& table);

/// Why the parts cannot be kept under a name: they are no support or load, or several that differ.
std::optional<ui::Message> why_not_keep(const Session& session, std::span<const Part> parts);
/// Keeps their support or load under a name. \pre why_not_keep gives no reason
void keep_under_name(Session& session, std::span<const Part> parts);

/// The parts that the set suits get it, loads in the case that is shown.
void give(Session& session, NamedSetPlace set, std::span<const Part> parts);
/// The supports or loads become the set. \pre they are of its kind
void assign(Session& session, NamedSetPlace set, std::span<const Part> parts);
/// The set becomes what the parts are, and so does everything that has it. \pre why_not_keep gives no reason
void replace(Session& session, NamedSetPlace set, std::span<const Part> parts);
/// Whoever has the set becomes the selection.
void select_users(Session& session, NamedSetPlace set);
/// \returns why the set cannot have this name, else renames it
std::optional<ui::Message> rename(Session& session, NamedSetPlace set, const std::string& name);
/// The name goes, its users stay as they are.
void erase(Session& session, NamedSetPlace set);

} // namespace frame
