#include "topology/meshing/row_mesher.h"

#include <utility>

namespace topology {

RowMesher::RowMesher(std::vector<FlatPoint> nodes, std::vector<std::vector<Cell>> rows)
    : nodes_(std::move(nodes)), rows_(std::move(rows))
{}

RowMesher::Step RowMesher::next()
{
    if (n_laid_ == rows_.size()) return last_ = Step::Done;
    ++n_laid_;
    return last_ = Step::Row;
}

CellMesh RowMesher::mesh() const
{
    CellMesh mesh{nodes_, {}};
    for (std::size_t i = 0; i < n_laid_; ++i) mesh.cells.insert(mesh.cells.end(), rows_[i].begin(), rows_[i].end());
    return mesh;
}

MeshMarks RowMesher::marks() const
{
    MeshMarks marks;
    if (last_ != Step::Row) return marks;
    for (const Cell& cell : rows_[n_laid_ - 1]) {
        marks.cells.emplace_back();
        for (const CellNode node : cell.nodes()) marks.cells.back().push_back(nodes_[node]);
    }
    return marks;
}

std::vector<std::vector<Cell>> in_rows(const std::vector<Cell>& cells,
                                       const std::function<std::size_t(std::size_t row)>& n_in_row)
{
    std::vector<std::vector<Cell>> rows;
    for (const Cell& cell : cells) {
        if (rows.empty() || rows.back().size() == n_in_row(rows.size() - 1)) rows.emplace_back();
        rows.back().push_back(cell);
    }
    return rows;
}

} // namespace topology
