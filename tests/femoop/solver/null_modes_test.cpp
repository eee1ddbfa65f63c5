#include "femoop/solver/null_modes.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <numbers>
#include <vector>

#include "tests/femoop/solver/random_system.h"
#include "tests/samples.h"

using namespace femoop;
using femoop_test::RandomSystem;

namespace {

struct Bar {
    std::int32_t from, to;
    double stiffness;
};

/// Springs between points that move along one line.
SparseMatrix springs(std::int32_t n, const std::vector<Bar>& bars)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int32_t i = 0; i < n; ++i) entries.emplace_back(i, i, 0.0);
    for (const Bar& bar : bars) {
        entries.emplace_back(bar.from, bar.from, bar.stiffness);
        entries.emplace_back(bar.to, bar.to, bar.stiffness);
        entries.emplace_back(std::max(bar.from, bar.to), std::min(bar.from, bar.to), -bar.stiffness);
    }
    SparseMatrix K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

/// A plane truss: points, bars of unit axial rigidity, nothing supported. Unknowns x and y of each point.
SparseMatrix truss(const std::vector<Eigen::Vector2d>& points, const std::vector<std::pair<int, int>>& bars)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [a, b] : bars) {
        const Eigen::Vector2d along = points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)];
        Eigen::Vector4d g;
        g << -along.normalized(), along.normalized();
        const int rows[] = {2 * a, 2 * a + 1, 2 * b, 2 * b + 1};
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                if (rows[i] >= rows[j]) entries.emplace_back(rows[i], rows[j], g[i] * g[j] / along.norm());
    }
    const auto n = static_cast<Eigen::Index>(2 * points.size());
    SparseMatrix K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

/// Pin-jointed squares without diagonals, turned by an angle.
SparseMatrix squares(int n, double angle)
{
    std::vector<Eigen::Vector2d> points;
    std::vector<std::pair<int, int>> bars;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            points.push_back(Eigen::Rotation2Dd(angle) * Eigen::Vector2d(1.3 * x, 0.9 * y));
            if (x + 1 < n) bars.emplace_back(y * n + x, y * n + x + 1);
            if (y + 1 < n) bars.emplace_back(y * n + x, (y + 1) * n + x);
        }
    return truss(points, bars);
}

double strain(const SparseMatrix& K, const Eigen::VectorXd& mode)
{
    return (K.selfadjointView<Eigen::Lower>() * mode).cwiseAbs().maxCoeff() / K.diagonal().maxCoeff();
}

Eigen::Index rank(const Eigen::MatrixXd& columns)
{
    return Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(columns).rank();
}

} // namespace

TEST_CASE("A chain of springs that nothing holds moves as a whole")
{
    const NullModes null = null_modes(springs(5, {{0, 1, 3.0}, {1, 2, 0.7}, {2, 3, 1e4}, {3, 4, 2.0}}));
    REQUIRE(null.modes.cols() == 1);
    CHECK((null.modes.col(0) - Eigen::VectorXd::Ones(5)).cwiseAbs().maxCoeff() < 1e-9);
    CHECK(std::isinf(null.condition));
    CHECK(null.is_complete);
}

TEST_CASE("The smallest eigenvalue above zero of n equal springs in a ring is 1 - cos(2 pi / n), diagonal 1")
{
    constexpr std::int32_t n = 24;
    std::vector<Bar> ring;
    for (std::int32_t i = 0; i < n; ++i) ring.push_back({i, (i + 1) % n, 4.5});
    const NullModes null = null_modes(springs(n, ring));
    CHECK(null.modes.cols() == 1);
    CHECK(null.smallest_eigenvalue == doctest::Approx(1.0 - std::cos(2.0 * std::numbers::pi / n)).epsilon(0.01));
}

TEST_CASE("Each loose part is a mode of its own, which moves nothing else")
{
    // Four parts, the second one held; unknown 8 stands alone without stiffness.
    const SparseMatrix K = springs(9, {{0, 3, 2.0}, {3, 5, 7.0}, {1, 4, 3.0}, {4, 4, 0.6}, {2, 6, 1e3}, {6, 7, 5e-4}});
    const NullModes null = null_modes(K);
    REQUIRE(null.modes.cols() == 3);
    const std::vector<std::vector<Eigen::Index>> parts = {{0, 3, 5}, {2, 6, 7}, {8}};
    for (const std::vector<Eigen::Index>& part : parts) {
        Eigen::VectorXd expected = Eigen::VectorXd::Zero(9);
        for (const Eigen::Index i : part) expected[i] = 1.0;
        bool is_found = false;
        for (const auto& mode : null.modes.colwise())
            is_found = is_found || (mode - expected).cwiseAbs().maxCoeff() < 1e-9;
        CHECK(is_found);
    }
}

TEST_CASE("A matrix of nothing but zeros leaves every unknown free")
{
    const NullModes null = null_modes(springs(4, {}));
    CHECK(null.modes.cols() == 4);
    CHECK(rank(null.modes) == 4);
    CHECK(null.smallest_eigenvalue == 0.0);
}

TEST_CASE("A spring of 1e-9 that holds a chain is nearly singular and not singular")
{
    const double soft = 1e-9;
    const SparseMatrix K = springs(
        4, {{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}, {0, 0, 0.5 * soft}}); // twice on the diagonal
    const NullModes null = null_modes(K);
    CHECK_FALSE(null.is_singular());
    // Scaled mass of the rigid motion: diagonal entries 1 2 2 1.
    CHECK(null.smallest_eigenvalue == doctest::Approx(soft / 6.0).epsilon(0.01));
    CHECK(null.condition > 1e9);
    CHECK(null.condition < 1e11);
    CHECK((null.softest - Eigen::VectorXd::Ones(4)).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("A chain on a spring of 1e-12 stays told apart from one on none, among stiffnesses from 1e-6 to 1e6")
{
    for (const double unit : {1e-6, 1.0, 1e6}) {
        CAPTURE(unit);
        const std::vector<Bar> loose = {{0, 1, unit}, {1, 2, 5.0 * unit}, {2, 3, 0.3 * unit}};
        std::vector<Bar> held = loose;
        held.push_back({3, 3, 1e-12 * unit});
        CHECK(null_modes(springs(4, loose)).modes.cols() == 1);
        CHECK(null_modes(springs(4, held)).modes.cols() == 0);
    }
}

TEST_CASE("30 x 30 pin-jointed squares without diagonals move in 60 ways, whatever their angle")
{
    // Each of the 30 rows slides along itself and so does each column: 60 motions, and those of the whole are among
    // them (turning is 30 rows sliding each by its height and 30 columns each by its distance).
    for (const double angle : {0.0, 0.4, std::numbers::pi / 2.0}) {
        CAPTURE(angle);
        const SparseMatrix K = squares(30, angle);
        const NullModes null = null_modes(K);
        REQUIRE(null.modes.cols() == 60);
        CHECK(rank(null.modes) == 60);
        double worst = 0.0;
        for (const auto& mode : null.modes.colwise()) worst = std::max(worst, strain(K, mode));
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("Rows of pin-jointed squares slide one by one: a mode for each row and each column")
{
    const NullModes null = null_modes(squares(12, 0.0));
    REQUIRE(null.modes.cols() == 24);
    for (const auto& mode : null.modes.colwise()) {
        CHECK((mode.array() != 0.0).count() == 12);
        CHECK(mode.sum() == doctest::Approx(12.0));
    }
}

TEST_CASE("Several hundred loose bars make three modes each")
{
    std::vector<Eigen::Vector2d> points;
    std::vector<std::pair<int, int>> bars;
    constexpr int n = samples(150, 50);
    for (int i = 0; i < n; ++i) {
        points.emplace_back(3.0 * i, 0.1 * i);
        points.emplace_back(3.0 * i + 1.0, 0.1 * i + std::sin(i));
        bars.emplace_back(2 * i, 2 * i + 1);
    }
    const SparseMatrix K = truss(points, bars);
    const NullModes null = null_modes(K);
    REQUIRE(null.modes.cols() == 3 * n);
    CHECK(rank(null.modes) == 3 * n);
    for (const auto& mode : null.modes.colwise()) { // no mode moves two bars
        Eigen::Index first = 0;
        mode.cwiseAbs().maxCoeff(&first);
        CHECK(mode.segment(first / 4 * 4, 4).squaredNorm() == doctest::Approx(mode.squaredNorm()));
    }
}

TEST_CASE("A soft bar beside a loose one: the loose motion is found, the soft one is the smallest eigenvalue")
{
    const double soft = 1e-10;
    const SparseMatrix K = springs(4, {{0, 1, 1.0}, {2, 3, 1.0}, {2, 2, 0.5 * soft}});
    const NullModes null = null_modes(K);
    REQUIRE(null.modes.cols() == 1);
    CHECK((null.modes.col(0) - Eigen::Vector4d(1.0, 1.0, 0.0, 0.0)).cwiseAbs().maxCoeff() < 1e-6);
    CHECK(null.smallest_eigenvalue == doctest::Approx(0.5 * soft).epsilon(0.01));
}

TEST_CASE("The condition estimate lies between a third of the true condition and all of it")
{
    for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        const RandomSystem system(seed, 40, 70, Ordering::MinimumDegree);
        const Eigen::VectorXd s = system.dense.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd scaled = s.asDiagonal() * system.dense * s.asDiagonal();
        const auto norm_1 = [](const Eigen::MatrixXd& A) { return A.cwiseAbs().colwise().sum().maxCoeff(); };
        const double condition = norm_1(scaled) * norm_1(scaled.inverse());
        const auto solver = make_solver(SolverKind::Ldlt);
        solver->analyse(system.pattern);
        solver->factorize(system.K);
        const double estimate = condition_estimate(*solver, system.K);
        CHECK(estimate <= condition * (1.0 + 1e-9));
        CHECK(estimate >= condition / 3.0);
    }
}
