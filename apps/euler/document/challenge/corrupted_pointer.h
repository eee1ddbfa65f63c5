#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "topology/halfedge/check/corrupted_solid.h"
#include "topology/tables/entity_tables.h"
#include "ui/text/message.h"

namespace euler {

/// "Fix the broken pointer." One cell of the tables was bent, so that the structure is not sound. The picture is drawn
/// of the sound solid; the tables shown are those of the broken one, and nothing but them may be asked of it.
struct CorruptedPointer {
    topology::Solid sound, broken;
    topology::CorruptedLink bent; ///< what was done
    topology::TableKind table = topology::TableKind::HalfEdges;
    ui::Message message; ///< the checker's, hidden until it is asked for
    ui::Message where;   ///< a second hint: the table in which it stands
};
CorruptedPointer broken_pointer(std::uint32_t seed);

/// Is the structure sound when this link is set? That may be another way than back.
bool is_mended(const CorruptedPointer& broken, const topology::CorruptedLink& set);

/// The link that a cell of a table shows, by the table and the cell's label; none of a list's N and P, which no link is
/// behind, and of what the tables find out by themselves.
std::optional<topology::LinkKind> link_of(topology::TableKind table, std::string_view label);

/// What a cell should hold, as it is typed: "H 3 N 4" sets the N of half-edge 3 to 4. \returns the link, or why it is
/// none
std::variant<topology::CorruptedLink, ui::Message> link_typed(const CorruptedPointer& broken, std::string_view words);
/// What one types to undo what was done.
std::string way_back(const CorruptedPointer& broken);

} // namespace euler
