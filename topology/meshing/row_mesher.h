#pragma once

#include <cstddef>
#include <vector>

#include "topology/meshing/mesher.h"

namespace topology {

/// Cells of a map, laid one row after the other: of a region that is mapped, swept or trilateral.
class RowMesher : public Mesher {
public:
    /// \param rows  of cells
    RowMesher(std::vector<FlatPoint> nodes, std::vector<std::vector<Cell>> rows);

    Step next() override;
    CellMesh mesh() const override;
    MeshMarks marks() const override;

private:
    std::vector<FlatPoint> nodes_;
    std::vector<std::vector<Cell>> rows_;
    std::size_t n_laid_ = 0;
    Step last_ = Step::Done;
};

/// Cells in rows of equally many, for those that come in one list.
std::vector<std::vector<Cell>> in_rows(const std::vector<Cell>& cells, std::size_t n_in_row);

} // namespace topology
