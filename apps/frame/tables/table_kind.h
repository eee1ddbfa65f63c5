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
    Joints,
    LoadCases,
    Combinations,
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
    Envelope,
    ReactionEnvelope
};
inline constexpr std::array all_table_kinds{
    TableKind::Nodes,        TableKind::Members,         TableKind::Joints,
    TableKind::Materials,    TableKind::Sections,        TableKind::LoadCases,
    TableKind::Combinations, TableKind::NodeLoads,       TableKind::DistributedLoads,
    TableKind::PointLoads,   TableKind::EndLoads,        TableKind::Misfits,
    TableKind::Temperatures, TableKind::Settlements,     TableKind::Displacements,
    TableKind::Reactions,    TableKind::MemberEnds,      TableKind::Extremes,
    TableKind::Envelope,     TableKind::ReactionEnvelope};

constexpr bool is_result(TableKind kind) { return kind >= TableKind::Displacements; }
constexpr bool is_envelope(TableKind kind) { return kind >= TableKind::Envelope; } ///< of several cases
constexpr bool is_load(TableKind kind) { return kind >= TableKind::NodeLoads && kind <= TableKind::Settlements; }
/// Rows can be added: those of results and of the ends of members come with others.
constexpr bool can_grow(TableKind kind) { return !is_result(kind) && kind != TableKind::Joints; }
std::string_view title(TableKind kind); ///< translatable: "Nodes"

} // namespace frame
