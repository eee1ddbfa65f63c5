#pragma once

#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/tables/column.h"
#include "apps/frame/tables/table_kind.h"

namespace frame {

/// The columns of a table of data; which ones depends on the kind of analysis. \pre !is_result(kind)
std::vector<Column> columns(const femoop::Model& model, TableKind kind);

/// The parts that the table lists, in the order of the file. \pre !is_result(kind)
std::vector<Part> parts_of(const femoop::Model& model, TableKind kind);

/// Columns by what they are about; `columns` chooses among them.
std::vector<Column> node_columns(const femoop::Model& model);
std::vector<Column> member_columns(const femoop::Model& model);
std::vector<Column> joint_columns(const femoop::Model& model);
std::vector<Column> load_case_columns();
std::vector<Column> combination_columns(const femoop::Model& model);
std::vector<Column> material_columns();
std::vector<Column> section_columns();
std::vector<Column> load_columns(const femoop::Model& model, TableKind kind);

/// What a member's end is free to do: a column of two tables.
Column release_column(std::string_view heading, MemberEndName end);

/// Names of degrees of freedom as they are typed, "ux rz", of those that are allowed; else the reason.
std::variant<femoop::DofSet, std::string> dofs_of(const CellText& entry, femoop::DofSet allowed);

} // namespace frame
