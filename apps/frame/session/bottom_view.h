#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "apps/frame/document/part.h"
#include "apps/frame/tables/table_kind.h"

namespace frame {

/// What stands in the panel at the bottom of the window.
enum class BottomContent : std::uint8_t {
    Table,
    Member,    ///< the results along the selected member
    Solver,    ///< the front that walks over the structure
    Derivation ///< where a number of the results comes from
};

/// What has a tab of its own there.
constexpr bool is_table_or_member(BottomContent content) { return content <= BottomContent::Member; }

/// A cell that the table's cursor is sent to.
struct WantedCell {
    Part row;
    std::size_t column = 0;
};

/// What the panel at the bottom of the window shows.
struct BottomView {
    bool is_open = false;
    TableKind table = TableKind::Nodes; ///< where it is one
    BottomContent content = BottomContent::Table;
    std::optional<WantedCell> wanted{};   ///< until the panel has gone there
    bool asks_for_keyboard = false;       ///< until the panel has it
    std::optional<BottomContent> under{}; ///< of a derivation: what it was asked of there, and goes back to

    bool shows(BottomContent what) const { return is_open && content == what; }
};

} // namespace frame
