#pragma once

#include <string>
#include <variant>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/table.h"

namespace frame {

/// A table of the document, to be read. \pre !is_result(kind)
Table data_table(const femoop::Model& model, TableKind kind, const Manner& manner);

/// Where a block of texts goes: its first cell as it is seen, and the order in which the rows are seen (that of the
/// file when empty). Rows beyond the last are new ones.
struct Target {
    std::size_t row = 0, column = 0;
    std::vector<std::size_t> order{};
};

/// Why a cell was not filled. Rows are counted as they are seen; a column behind the last one means a new row as a
/// whole, which lacks something.
struct CellFault {
    std::size_t row = 0, column = 0;
    std::string reason;
};
/// "row 3, x [m]: ..."; of several the first one with its reason, and where the next ones are. \pre there are some
std::string sentence(const std::vector<CellFault>& faults, const Table& table, const ui::Catalogue& tr);

/// The document with the block in its cells, or everything that hinders it; then the document is the one that was.
struct Filled {
    Document document;
    std::vector<CellFault> faults;
};

/// Puts texts into the cells of a table, as they are typed or pasted: numbers with units or calculations, names, words
/// in the reader's language or in English. A cell whose text is the one it has keeps its value to the last bit; empty
/// lines are left out, as are columns that cannot be changed where others can. New rows get what they lack: a name,
/// the material and section of the last member, the first load case. \pre !is_result(kind)
Filled filled(const Document& document, TableKind kind, const Target& target, const TextBlock& texts,
              const Manner& manner);

/// The texts of a clipboard without the headings that `tsv` wrote above them.
TextBlock read_block(std::string_view tsv, const Table& table, std::size_t first_column);

} // namespace frame
