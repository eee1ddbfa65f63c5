#pragma once

#include <cstddef>
#include <functional>
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

/// Cells that come in one list, in rows. \param n_in_row  of each row, counted from 0; at least 1
std::vector<std::vector<Cell>> in_rows(const std::vector<Cell>& cells,
                                       const std::function<std::size_t(std::size_t row)>& n_in_row);

} // namespace topology
