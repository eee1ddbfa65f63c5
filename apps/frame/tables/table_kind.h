#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace frame {

/// The tables of a document and of its results.
enum class TableKind : std::uint8_t {
    Nodes,
    Members,
    Materials,
    Sections,
    NodeLoads,
    DistributedLoads,
    PointLoads,
    EndLoads,
    Temperatures,
    Misfits,
    Settlements,
    Displacements,
    Reactions,
    MemberEnds,
    Extremes,
    Envelope
};
inline constexpr std::array all_table_kinds{
    TableKind::Nodes,     TableKind::Members,          TableKind::Materials,   TableKind::Sections,
    TableKind::NodeLoads, TableKind::DistributedLoads, TableKind::PointLoads,  TableKind::EndLoads,
    TableKind::Misfits,   TableKind::Temperatures,     TableKind::Settlements, TableKind::Displacements,
    TableKind::Reactions, TableKind::MemberEnds,       TableKind::Extremes,    TableKind::Envelope};

constexpr bool is_result(TableKind kind) { return kind >= TableKind::Displacements; }
constexpr bool is_load(TableKind kind) { return kind >= TableKind::NodeLoads && kind <= TableKind::Settlements; }
std::string_view title(TableKind kind); ///< translatable: "Nodes"

} // namespace frame
