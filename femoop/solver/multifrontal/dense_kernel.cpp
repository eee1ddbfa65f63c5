// Compiled once for every kind of processor, each time with FEMOOP_KERNEL as the name of what it makes and with Eigen's
// namespace renamed: what is compiled for one processor must not be linked into what runs on all. So nothing of the
// standard library is used here that a compiler might leave as a function.
#include "femoop/solver/multifrontal/dense_kernel.h"

#include <Eigen/Core>

namespace femoop::FEMOOP_KERNEL {

namespace {

using Index = Eigen::Index;
using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr Index block_width = 96;         // pivots at a time
constexpr Index small = 24;               // pivots that are eliminated one after the other
constexpr Index tile_side = 192;          // rows of a tile
constexpr Index most_rows_of_small = 250; // of a front whose columns are eliminated one by one

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

double size(double x) { return x < 0.0 ? -x : x; }

void exchange(double& a, double& b)
{
    const double kept = a;
    a = b;
    b = kept;
}

/// Two pivots that are eliminated together: D = [a b; b c], b not zero.
struct Pair {
    double a, b, c;

    bool is_usable() const { return FEMOOP_KERNEL::is_usable(b) && FEMOOP_KERNEL::is_usable(spread()); }
    /// (x y) D^-1.
    void divide(double& x, double& y) const
    {
        const double first = (c / b * x - y) / (b * spread());
        y = (a / b * y - x) / (b * spread());
        x = first;
    }

private:
    double spread() const { return (a / b) * (c / b) - 1.0; } // det D / b^2
};

/// L D L' of a square, lower triangle, where pivots have any sign: next comes the row, or the two together, that lets
/// the rest grow little.
///
/// Source  [BunchKaufman1977]; rows outside the square have no say
class PivotedSquare {
public:
    PivotedSquare(const Matrix& A, std::int32_t* order, double* coupling) : A_(A), order_(order), coupling_(coupling) {}

    /// Returns how many pivots.
    Index run()
    {
        for (Index i = 0; i < n();) {
            const Index chosen = choose(i);
            if (chosen == 0) return i;
            if (chosen == 1) eliminate_one(i);
            else eliminate_two(i);
            i += chosen;
        }
        return n();
    }

private:
    Index n() const { return A_.rows(); }
    double entry(Index i, Index j) const { return i < j ? A_(j, i) : A_(i, j); }

    /// The row of the largest entry of row i beside its diagonal, among rows from .. n - 1; i itself where all are
    /// zero.
    Index largest_beside(Index i, Index from) const
    {
        Index row = i;
        double largest = 0.0;
        for (Index j = from; j < n(); ++j)
            if (j != i && size(entry(i, j)) > largest) {
                largest = size(entry(i, j));
                row = j;
            }
        return row;
    }

    /// How many pivots come next, 1 or 2, exchanged to i and i + 1; 0 if there are none.
    Index choose(Index i)
    {
        constexpr double alpha = 0.6403882032022076; // (1 + sqrt 17) / 8 bounds the growth best
        const Index r = largest_beside(i, i + 1);
        const double beside = r == i ? 0.0 : size(A_(r, i));
        const double growth_of_r = r == i ? 0.0 : size(entry(r, largest_beside(r, i)));
        const bool stays = size(A_(i, i)) >= alpha * beside || size(A_(i, i)) * growth_of_r >= alpha * beside * beside;
        if (stays) return is_usable(A_(i, i)) ? 1 : 0;
        if (size(A_(r, r)) >= alpha * growth_of_r) {
            exchange_rows(i, r);
            return is_usable(A_(i, i)) ? 1 : 0;
        }
        exchange_rows(i + 1, r);
        return pair(i).is_usable() ? 2 : 0;
    }
    Pair pair(Index i) const { return {A_(i, i), A_(i + 1, i), A_(i + 1, i + 1)}; }

    /// Rows and columns p < q of the symmetric matrix, and of L before them.
    void exchange_rows(Index p, Index q)
    {
        if (p == q) return;
        for (Index j = 0; j < p; ++j) exchange(A_(p, j), A_(q, j));
        exchange(A_(p, p), A_(q, q));
        for (Index j = p + 1; j < q; ++j) exchange(A_(j, p), A_(q, j));
        for (Index j = q + 1; j < n(); ++j) exchange(A_(j, p), A_(j, q));
        const std::int32_t kept = order_[p];
        order_[p] = order_[q];
        order_[q] = kept;
    }

    void eliminate_one(Index i)
    {
        coupling_[i] = 0.0;
        const double pivot = A_(i, i);
        for (Index j = i + 1; j < n(); ++j) A_.col(j).tail(n() - j) -= (A_(j, i) / pivot) * A_.col(i).tail(n() - j);
        A_.col(i).tail(n() - i - 1) /= pivot;
    }

    void eliminate_two(Index i)
    {
        const Pair D = pair(i);
        coupling_[i] = D.b;
        coupling_[i + 1] = 0.0;
        A_(i + 1, i) = 0.0;
        for (Index j = i + 2; j < n(); ++j) {
            double x = A_(j, i), y = A_(j, i + 1);
            D.divide(x, y);
            A_.col(j).tail(n() - j) -= x * A_.col(i).tail(n() - j) + y * A_.col(i + 1).tail(n() - j);
            A_(j, i) = x;
            A_(j, i + 1) = y;
        }
    }

    Matrix A_;
    std::int32_t* order_;
    double* coupling_;
};

class Elimination {
public:
    Elimination(const DenseFront& front, double* workspace, const TileWorkers& workers)
        : front_(front), workspace_(workspace), workers_(workers)
    {}

    std::int32_t run()
    {
        const bool is_small = n() <= block_width && height() <= most_rows_of_small && !exchanges();
        const Index most = is_small ? small : block_width;
        for (Index k = 0; k < n(); k += most) {
            const Index width = smaller(most, n() - k);
            const Index done = is_small ? eliminate_columns(k, width) : eliminate_and_divide(k, width);
            if (done < width) return static_cast<std::int32_t>(k + done);
            update_columns(k, width);
        }
        update_rest();
        return front_.n_pivots;
    }

private:
    Index n() const { return front_.n_pivots; }
    Index height() const { return front_.n_rows; }
    Index n_updated() const { return height() - n(); }
    bool exchanges() const { return front_.order != nullptr; }

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

    Index eliminate_and_divide(Index k, Index width)
    {
        const Index done = exchanges() ? eliminate_exchanging(k, width) : eliminate_square(k, width);
        if (done == width) divide_rows(k, width);
        return done;
    }

    /// A few columns down to the last row, each once those before it are known; returns how many pivots.
    Index eliminate_columns(Index k, Index width) const
    {
        for (Index j = k; j < k + width; ++j) {
            const Index m = height() - j;
            auto column = part(j, j, m, 1).col(0);
            const auto L = [&](Index i) { return front_.panel[j + i * height()]; };
            const auto LD = [&](Index i) { return scaled(j, i, m, 1).col(0); };
            Index i = k;
            for (; i + 4 <= j; i += 4)
                column -= L(i) * LD(i) + L(i + 1) * LD(i + 1) + L(i + 2) * LD(i + 2) + L(i + 3) * LD(i + 3);
            for (; i < j; ++i) column -= L(i) * LD(i);
            const double pivot = column[0];
            if (!is_usable(pivot)) return j - k;
            LD(j) = column;
            column.tail(m - 1) /= pivot;
        }
        return width;
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

    /// The same with pivots exchanged within the block, in the rows of L before it too.
    Index eliminate_exchanging(Index k, Index width)
    {
        for (Index i = k; i < k + width; ++i) front_.order[i] = static_cast<std::int32_t>(i);
        const Index done = PivotedSquare(part(k, k, width, width), front_.order + k, front_.coupling + k).run();
        Matrix before = part(k, 0, width, k), kept = scaled(k, 0, width, k);
        kept = before;
        for (Index i = 0; i < width; ++i) before.row(i) = kept.row(front_.order[k + i] - k);
        return done;
    }

    /// Some rows below eliminated pivots become rows of L.
    void divide(Index k, Index width, Index row, Index n_rows) const
    {
        Matrix L = part(row, k, n_rows, width), LD = scaled(row, k, n_rows, width);
        if (exchanges()) {
            LD = L;
            for (Index i = 0; i < width; ++i) L.col(i) = LD.col(front_.order[k + i] - k);
        }
        part(k, k, width, width).triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(L);
        LD = L;
        for (Index j = 0; j < width; ++j) {
            const double* const d = front_.panel + (k + j) * (height() + 1);
            if (!exchanges() || front_.coupling[k + j] == 0.0) {
                L.col(j) /= *d;
                continue;
            }
            const Pair D{*d, front_.coupling[k + j], d[height() + 1]};
            for (Index i = 0; i < n_rows; ++i) D.divide(L(i, j), L(i, j + 1));
            ++j;
        }
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

/// Rows of a child that follow one another in the parent too: most do, since separators come whole.
class Runs {
public:
    explicit Runs(const ChildUpdate& child)
    {
        for (Index i = 0; i < child.n; ++i) {
            if (i > 0 && child.places[i] == child.places[i - 1] + 1) continue;
            if (n_ == most || n_ * worth_length > child.n) {
                n_ = most + 1;
                return;
            }
            first_[n_++] = i;
        }
        first_[n_] = child.n;
    }
    bool are_long() const { return n_ <= most; }
    Index first(Index run) const { return first_[run]; }

private:
    static constexpr Index most = 100;
    static constexpr Index worth_length = 6;
    Index first_[most + 1] = {};
    Index n_ = 0;
};

} // namespace

void add_update(const DenseFront& front, const ChildUpdate& child, std::int32_t begin, std::int32_t end)
{
    const Runs runs(child);
    Index run = 0;
    for (Index j = 0; j < child.n && child.places[j] < end; ++j) {
        const Index u = child.places[j] - front.n_pivots, height = front.n_rows;
        if (child.places[j] < begin) continue;
        double* const column = u < 0 ? front.panel + child.places[j] * height
                                     : front.update + u * (height - front.n_pivots) - front.n_pivots;
        const double* const given = child.entries + j * child.n;
        if (!runs.are_long()) {
            for (Index i = j; i < child.n; ++i) column[child.places[i]] += given[i];
            continue;
        }
        while (runs.first(run + 1) <= j) ++run;
        for (Index i = j, r = run; i < child.n; ++r) {
            const Index last = runs.first(r + 1);
            Eigen::Map<Eigen::VectorXd>(column + child.places[i],
                                        last - i) += Eigen::Map<const Eigen::VectorXd>(given + i, last - i);
            i = last;
        }
    }
}

std::int32_t eliminate(const DenseFront& front, double* workspace, const TileWorkers& workers)
{
    return Elimination(front, workspace, workers).run();
}

namespace {

constexpr Index at_once = 4; // columns of L, while x is in registers

using Vector = Eigen::Map<Eigen::VectorXd>;
using Column = Eigen::Map<const Eigen::VectorXd>;

/// The products of columns of L with x, from row `first` on; eight numbers at a time, so that each is summed alike
/// wherever it stands.
struct Products {
    Products(const FrontColumns& L, Index column, Index first, const double* x)
    {
        using Eight = Eigen::Array<double, 8, 1>;
        const double* const a = L.panel + column * L.n_rows;
        const double *const b = a + L.n_rows, *const c = b + L.n_rows, *const d = c + L.n_rows;
        const auto eight = [](const double* from) { return Eigen::Map<const Eight>(from); };
        Eight p = Eight::Zero(), q = Eight::Zero(), r = Eight::Zero(), s = Eight::Zero();
        Index i = first;
        for (; i + 8 <= L.n_rows; i += 8) {
            const Eight here = eight(x + i);
            p += eight(a + i) * here;
            q += eight(b + i) * here;
            r += eight(c + i) * here;
            s += eight(d + i) * here;
        }
        of[0] = p.sum();
        of[1] = q.sum();
        of[2] = r.sum();
        of[3] = s.sum();
        for (; i < L.n_rows; ++i) {
            of[0] += a[i] * x[i];
            of[1] += b[i] * x[i];
            of[2] += c[i] * x[i];
            of[3] += d[i] * x[i];
        }
    }
    double of[at_once];
};

} // namespace

void solve_forward(const FrontColumns& L, double* x)
{
    const Index height = L.n_rows;
    const auto column = [&](Index j) { return L.panel + j * height; };
    const auto below = [&](Index j, Index row) { return Column(column(j) + row, height - row); };
    Index j = 0;
    for (; j + at_once <= L.n_pivots; j += at_once) {
        for (Index i = 1; i < at_once; ++i)
            for (Index k = 0; k < i; ++k) x[j + i] -= column(j + k)[j + i] * x[j + k];
        const Index rest = j + at_once;
        Vector(x + rest, height - rest) -= x[j] * below(j, rest) + x[j + 1] * below(j + 1, rest) +
                                           x[j + 2] * below(j + 2, rest) + x[j + 3] * below(j + 3, rest);
    }
    for (; j < L.n_pivots; ++j) Vector(x + j + 1, height - j - 1) -= x[j] * below(j, j + 1);
}

void solve_backward(const FrontColumns& L, double* x)
{
    const Index height = L.n_rows, in_fours = L.n_pivots - L.n_pivots % at_once;
    const auto column = [&](Index j) { return L.panel + j * height; };
    for (Index j = L.n_pivots; j-- > in_fours;)
        x[j] -= Column(column(j) + j + 1, height - j - 1).dot(Column(x + j + 1, height - j - 1));
    for (Index j = in_fours; j > 0;) {
        j -= at_once;
        const Products known(L, j, j + at_once, x);
        for (Index i = at_once; i-- > 0;) {
            x[j + i] -= known.of[i];
            for (Index k = i + 1; k < at_once; ++k) x[j + i] -= column(j + i)[j + k] * x[j + k];
        }
    }
}

} // namespace femoop::FEMOOP_KERNEL
