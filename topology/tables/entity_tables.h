#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "topology/halfedge/solid.h"

namespace topology {

/// One link of an entity, as a table prints it: `H = 2`.
struct TableCell {
    std::string_view label;     ///< "H", "LOUT"
    std::size_t number = 0;     ///< of the entity that it leads to, counting from 1; 0 for none
    std::optional<Entity> link; ///< that entity; none for none, and for solids
    bool is_changed = false;    ///< by the step that two tables are compared over

    friend bool operator==(const TableCell&, const TableCell&) = default;
};

/// How an entity came out of the step that two tables are compared over.
enum class RowMark : std::uint8_t { Same, Changed, Created, Killed };

struct TableRow {
    std::string_view label;       ///< "V"
    std::size_t number = 0;       ///< of the entity
    std::optional<Entity> entity; ///< none of a solid, and of the row that says that there is no edge
    std::vector<TableCell> cells;
    RowMark mark = RowMark::Same;

    friend bool operator==(const TableRow&, const TableRow&) = default;
};

enum class TableKind : std::uint8_t { Vertices, HalfEdges, Edges, Loops, Faces, Solids };
inline constexpr std::size_t n_table_kinds = 6;

/// The tables of the half-edge structure, a row for each entity that lives.
struct EntityTables {
    std::array<std::vector<TableRow>, n_table_kinds> rows;

    std::vector<TableRow>& operator[](TableKind kind) { return rows[static_cast<std::size_t>(kind)]; }
    const std::vector<TableRow>& operator[](TableKind kind) const { return rows[static_cast<std::size_t>(kind)]; }
};

/// Where a solid stands among the others of a model: its number and those beside it, 0 for none.
struct SolidPlace {
    std::size_t number = 1, older = 0, newer = 0;
};
/// Of a solid that lives, by its place in a list of solids such as the runner's.
template <class Solids> SolidPlace place_among_living(const Solids& solids, std::size_t solid)
{
    SolidPlace place{.number = solid + 1};
    for (std::size_t i = 0; i < solids.size(); ++i) {
        if (!solids[i].is_alive()) continue;
        if (i < solid) place.older = i + 1;
        if (i > solid && place.newer == 0) place.newer = i + 1;
    }
    return place;
}

/// The rows of one solid's tables, each made when it is asked for: a solid may have a million.
///
/// Numbers count from 1 in the order of making, 0 means none. The last two cells of a row are N, the next older entity
/// of the list, and P, the next newer one; of a half-edge they are next and prev, of a loop they stay within its face.
/// H1 is an edge's plus half, H2 its minus half. LOUT is 0 while the face's outer loop bounds nothing: while both sides
/// of each of its edges lie in it. LOOPS, V, F and E name the oldest of the list. Where there is no edge, a row says
/// so.
///
/// Source   [MarthaPereira], the half-edge structure
class EntityRows {
public:
    EntityRows() = default; ///< of no solid: no rows
    /// The solid must outlive the rows.
    explicit EntityRows(const Solid& solid, const SolidPlace& place = {});

    std::size_t size(TableKind kind) const;
    /// \pre row < size(kind), likewise below. Rows ascend by number.
    std::size_t number(TableKind kind, std::size_t row) const;
    using Numbers = std::array<std::size_t, 5>;
    Numbers numbers(TableKind kind, std::size_t row) const; ///< of the cells; 0 beyond the last
    TableRow operator()(TableKind kind, std::size_t row) const;

private:
    std::uint32_t index(TableKind kind, std::size_t row) const { return living_[static_cast<std::size_t>(kind)][row]; }
    Numbers loop(LoopId l) const;
    Numbers face(FaceId f, std::size_t row) const;
    Numbers solid() const;
    /// N and P: the numbers of the rows beside it.
    std::size_t before(TableKind kind, std::size_t row) const { return row == 0 ? 0 : number(kind, row - 1); }
    std::size_t after(TableKind kind, std::size_t row) const
    {
        return row + 1 < size(kind) ? number(kind, row + 1) : 0;
    }

    const Solid* solid_ = nullptr;
    SolidPlace place_;
    std::array<std::vector<std::uint32_t>, 5> living_; ///< by kind, oldest first
    std::vector<std::vector<LoopId>> loops_of_;        ///< by face, oldest first
    std::vector<bool> is_bounding_;                    ///< by loop: does another loop lie beyond some edge of it?
};

/// All rows.
EntityTables entity_tables(const Solid& solid, const SolidPlace& place = {});

} // namespace topology
