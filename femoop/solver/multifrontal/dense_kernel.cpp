// Compiled once for every kind of processor, each time with FEMOOP_KERNEL as the name of what it makes and with Eigen's
// namespace renamed: what is compiled for one processor must not be linked into what runs on all. So nothing of the
// standard library is used here that a compiler might leave as a function.
#include "femoop/solver/multifrontal/dense_kernel.h"

#include <Eigen/Core>

namespace femoop::FEMOOP_KERNEL {

namespace {

using Index = Eigen::Index;
using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr Index block_width = 96; // pivots at a time
constexpr Index small = 24;       // pivots that are eliminated one after the other
constexpr Index tile_side = 192;  // rows of a tile

bool is_usable(double pivot) { return pivot - pivot == 0.0 && pivot != 0.0; } // false for infinite ones and NaN

Index smaller(Index a, Index b) { return a < b ? a : b; }
Index n_tiles(Index n) { return (n + tile_side - 1) / tile_side; }

/// One column after the other; returns how many.
Index eliminate_one_by_one(Matrix A)
{
    for (Index k = 0; k < A.cols(); ++k) {
        const double pivot = A(k, k);
        if (!is_usable(pivot)) return k;
        for (Index j = k + 1; j < A.cols(); ++j)
            A.col(j).tail(A.rows() - j) -= (A(j, k) / pivot) * A.col(k).tail(A.rows() - j);
        A.col(k).tail(A.rows() - k - 1) /= pivot;
    }
    return A.cols();
}

class Elimination {
public:
    Elimination(const DenseFront& front, double* workspace, const TileWorkers& workers)
        : front_(front), workspace_(workspace), workers_(workers)
    {}

    std::int32_t run()
    {
        for (Index k = 0; k < n(); k += block_width) {
            const Index width = smaller(block_width, n() - k);
            const Index done = eliminate_square(k, width);
            if (done < width) return static_cast<std::int32_t>(k + done);
            divide_rows(k, width);
            update_columns(k, width);
        }
        update_rest();
        return front_.n_pivots;
    }

private:
    Index n() const { return front_.n_pivots; }
    Index height() const { return front_.n_rows; }
    Index n_updated() const { return height() - n(); }

    Matrix part(Index row, Index column, Index rows, Index columns) const
    {
        return {front_.panel + row + column * height(), rows, columns, Eigen::OuterStride<>(height())};
    }
    /// L D, where L is known.
    Matrix scaled(Index row, Index column, Index rows, Index columns) const
    {
        return {workspace_ + row + column * height(), rows, columns, Eigen::OuterStride<>(height())};
    }

    template <class Work> void for_each_tile(Index count, Work work) const
    {
        workers_.for_each(
            workers_.self, static_cast<std::int32_t>(count),
            [](void* context, std::int32_t tile) { (*static_cast<Work*>(context))(tile); }, &work);
    }

    /// A block on the diagonal, in halves; returns how many pivots of it.
    Index eliminate_square(Index k, Index width)
    {
        if (width <= small) return eliminate_one_by_one(part(k, k, width, width));
        const Index half = width / 2, rest = width - half;
        const Index done = eliminate_square(k, half);
        if (done < half) return done;
        divide(k, half, k + half, rest);
        part(k + half, k + half, rest, rest).triangularView<Eigen::Lower>() -=
            part(k + half, k, rest, half) * scaled(k + half, k, rest, half).transpose();
        return half + eliminate_square(k + half, rest);
    }

    /// Some rows below eliminated pivots become rows of L.
    void divide(Index k, Index width, Index row, Index n_rows) const
    {
        Matrix L = part(row, k, n_rows, width);
        part(k, k, width, width).triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(L);
        scaled(row, k, n_rows, width) = L;
        for (Index j = k; j < k + width; ++j) L.col(j - k) /= front_.panel[j * (height() + 1)];
    }

    void divide_rows(Index k, Index width) const
    {
        const Index first = k + width, count = height() - first;
        for_each_tile(n_tiles(count), [&](Index tile) {
            const Index row = tile * tile_side;
            divide(k, width, first + row, smaller(tile_side, count - row));
        });
    }

    /// The columns of the panel after a block of pivots, by rows.
    void update_columns(Index k, Index width) const
    {
        const Index first = k + width, count = height() - first, columns = n() - first;
        if (columns == 0) return;
        for_each_tile(n_tiles(count), [&](Index tile) {
            const Index row = tile * tile_side, rows = smaller(tile_side, count - row);
            const Index left = smaller(row, columns); // columns that lie left of the diagonal
            if (left > 0)
                part(first + row, first, rows, left).noalias() -= part(first + row, k, rows, width) *
                                                                  scaled(first, k, left, width).transpose();
            if (left == columns) return;
            const Index corner = smaller(rows, columns - left);
            subtract_lower(part(first + row, first + left, corner, corner), part(first + row, k, corner, width),
                           scaled(first + left, k, corner, width));
            if (corner < rows)
                part(first + row + corner, first + left, rows - corner, corner).noalias() -=
                    part(first + row + corner, k, rows - corner, width) *
                    scaled(first + left, k, corner, width).transpose();
        });
    }

    /// What is left to the parent, tile by tile of the lower triangle.
    void update_rest() const
    {
        const Index m = n_updated(), side = n_tiles(m);
        if (n() == 0) return;
        for_each_tile(side * (side + 1) / 2, [&](Index tile) {
            Index i = 0;
            while (tile > i) tile -= ++i; // tiles 00, 10 11, 20 21 22, ...
            const Index row = i * tile_side, column = tile * tile_side;
            const Index rows = smaller(tile_side, m - row), columns = smaller(tile_side, m - column);
            Matrix target{front_.update + row + column * m, rows, columns, Eigen::OuterStride<>(m)};
            const Matrix L = part(n() + row, 0, rows, n()), LD = scaled(n() + column, 0, columns, n());
            if (row == column) subtract_lower(target, L, LD);
            else target.noalias() -= L * LD.transpose();
        });
    }

    static void subtract_lower(Matrix target, const Matrix& L, const Matrix& LD)
    {
        target.triangularView<Eigen::Lower>() -= L * LD.transpose();
    }

    const DenseFront& front_;
    double* workspace_;
    const TileWorkers& workers_;
};

} // namespace

std::int32_t eliminate(const DenseFront& front, double* workspace, const TileWorkers& workers)
{
    return Elimination(front, workspace, workers).run();
}

} // namespace femoop::FEMOOP_KERNEL
