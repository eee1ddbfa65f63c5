#include "femoop/solver/trace/front_matrix.h"

#include <algorithm>

#include "femoop/solver/index.h"

namespace femoop {

namespace {

class FrontMatrixBuilder {
public:
    FrontMatrixBuilder(const EliminationWalk& walk, std::size_t front) : walk_(walk), front_(walk.fronts[front])
    {
        for (std::int32_t place = front_.first; place < front_.end; ++place) matrix_.places.push_back(place);
        matrix_.n_eliminated = matrix_.places.size();
        for (const EliminationWalk::Entry& entry : walk.left(front_)) matrix_.places.push_back(entry.row);
        const std::size_t n = matrix_.places.size();
        matrix_.entries.assign(n * (n + 1) / 2, FrontEntry::Made);
        for (const std::int32_t child : walk.children_of(static_cast<std::int32_t>(front))) take_child(child);
        take_columns();
    }
    FrontMatrix take() { return std::move(matrix_); }

private:
    std::size_t row_of(std::int32_t place) const
    {
        return static_cast<std::size_t>(std::ranges::lower_bound(matrix_.places, place) - matrix_.places.begin());
    }
    void set(std::size_t row, std::size_t column, FrontEntry origin)
    {
        matrix_.entries[row * (row + 1) / 2 + column] = origin;
    }

    void take_child(std::int32_t child)
    {
        const auto left = walk_.left(walk_.fronts[at(child)]);
        for (std::size_t i = 0; i < left.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
                set(row_of(left[i].row), row_of(left[j].row), FrontEntry::FromChildren);
    }

    void take_columns()
    {
        for (std::size_t column = 0; column < matrix_.n_eliminated; ++column) {
            set(column, column, FrontEntry::FromK);
            for (const EliminationWalk::Entry& entry : walk_.columns[at(matrix_.places[column])])
                if (!entry.is_fill) set(row_of(entry.row), column, FrontEntry::FromK);
        }
    }

    const EliminationWalk& walk_;
    const EliminationWalk::Front& front_;
    FrontMatrix matrix_;
};

} // namespace

FrontMatrix front_matrix(const EliminationWalk& walk, std::size_t front)
{
    return FrontMatrixBuilder(walk, front).take();
}

} // namespace femoop
