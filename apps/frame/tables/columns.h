#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "apps/frame/tables/column.h"

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

/// The columns of a table of data; which ones depends on the kind of analysis. \pre !is_result(kind)
std::vector<Column> columns(const femoop::Model& model, TableKind kind);

/// The parts that the table lists, in the order of the file. \pre !is_result(kind)
std::vector<Part> parts_of(const femoop::Model& model, TableKind kind);

/// Columns by what they are about; `columns` chooses among them.
std::vector<Column> node_columns(const femoop::Model& model);
std::vector<Column> member_columns(const femoop::Model& model);
std::vector<Column> material_columns();
std::vector<Column> section_columns();
std::vector<Column> load_columns(const femoop::Model& model, TableKind kind);

/// Names of degrees of freedom as they are typed, "ux rz", of those that are allowed; else the reason.
std::variant<femoop::DofSet, std::string> dofs_of(const Entry& entry, femoop::DofSet allowed);

} // namespace frame
