#pragma once

#include "apps/frame/tables/table_kind.h"

namespace frame {

/// What the panel at the bottom of the window shows.
struct BottomView {
    bool is_open = false;
    TableKind table = TableKind::Nodes;
    bool shows_member = false; ///< the results along the selected member instead of a table
};

} // namespace frame
