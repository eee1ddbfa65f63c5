#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "apps/euler/session/commands.h"
#include "topology/tables/compared_tables.h"
#include "topology/tables/winged_edge.h"

namespace euler {

/// The tables of the half-edge structure before and after the step that is looked at, side by side: what it made is
/// green, what it killed red, each cell that it changed lit up. A table that the step changes comes forward: the one
/// that was asked for last, else the first. A number leads to its entity, which it selects.
class TablesPanel {
public:
    void show(Workspace& workspace);

private:
    void follow(Workspace& workspace);
    void bring_changed_forward(Workspace& workspace) const;
    void show_tabs(Workspace& workspace) const;
    void show_table(Session& session, topology::TableKind kind);
    void headings(const Session& session, const topology::TableRow& like) const;

    /// A table beside others.
    struct TablePlace {
        const char* id;
        float width;
        std::optional<std::size_t> wanted_row{}; ///< is brought into sight
    };
    void show_broken(Session& session, topology::TableKind kind);
    void show_winged(Session& session);
    using MakeRow = std::function<topology::TableRow(std::size_t)>;
    /// \pre n_cells > 0 where there are rows
    void lone_table(Session& session, std::size_t n_rows, std::size_t n_cells, const MakeRow& row,
                    const TablePlace& place) const;

    topology::ComparedTables tables_;
    topology::WingedTables winged_;
    topology::EntityRows broken_; ///< of a structure with a wrong pointer, alone; no rows where none is to be mended
    std::size_t solid_ = 0;
    std::uint64_t generation_ = 0;            ///< that the tables belong to
    std::optional<topology::TableKind> seen_; ///< last
    bool is_over_ = false;                    ///< a challenge, when the tables were seen last
    bool is_new_ = false;                     ///< the first row that the step changed is to be brought into sight
};

} // namespace euler
