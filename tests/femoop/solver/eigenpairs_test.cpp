#include "femoop/solver/eigenpairs.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "tests/femoop/solver/random_system.h"

using namespace femoop;
using femoop_test::RandomSystem;

namespace {

Eigenpairs lowest(const SparseMatrix& K, const SparseMatrix& M, std::size_t wanted)
{
    const std::unique_ptr<SymmetricSolver> solver = make_solver(SolverKind::Ldlt);
    solver->analyse(K);
    return lowest_eigenpairs(K, M, wanted, *solver);
}

SparseMatrix diagonal(const std::vector<double>& values)
{
    SparseMatrix D(static_cast<Eigen::Index>(values.size()), static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
        D.insert(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = values[i];
    D.makeCompressed();
    return D;
}

/// Equal masses between equal springs of stiffness 1, one ahead of the first: the last is free.
SparseMatrix chain(std::int32_t n, bool is_held = true)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int32_t i = 0; i < n; ++i) {
        entries.emplace_back(i, i, (i > 0 || is_held ? 1.0 : 0.0) + (i + 1 < n ? 1.0 : 0.0));
        if (i > 0) entries.emplace_back(i, i - 1, -1.0);
    }
    SparseMatrix K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

} // namespace

TEST_CASE("A chain of masses swings as its sines say")
{
    constexpr int n = 300;
    const Eigenpairs found = lowest(chain(n), diagonal(std::vector<double>(n, 1.0)), 12);
    REQUIRE(found.values.size() == 12);
    CHECK(found.is_counted);
    for (int k = 0; k < 12; ++k) {
        const double sine = std::sin((2 * k + 1) * std::numbers::pi / (2.0 * (2 * n + 1)));
        CHECK(found.values[k] == doctest::Approx(4.0 * sine * sine).epsilon(1e-9));
    }
}

TEST_CASE("A chain that nothing holds moves as one, and then swings")
{
    constexpr int n = 50;
    const Eigenpairs found = lowest(chain(n, false), diagonal(std::vector<double>(n, 2.0)), 3);
    REQUIRE(found.values.size() == 3);
    CHECK(std::abs(found.values[0]) < 100.0 * found.rounding);
    const Eigen::VectorXd moved = found.vectors.col(0) / found.vectors(0, 0);
    CHECK((moved.array() - 1.0).abs().maxCoeff() < 1e-8);
    const double sine = std::sin(std::numbers::pi / (2.0 * n));
    CHECK(found.values[1] == doctest::Approx(2.0 * sine * sine).epsilon(1e-9));
}

TEST_CASE("Every one of many equal eigenvalues is found")
{
    std::vector<double> values(40, 3.0);
    for (std::size_t i = 0; i < 9; ++i) values[4 * i] = 1.0;
    const Eigenpairs found = lowest(diagonal(values), diagonal(std::vector<double>(40, 1.0)), 7);
    CHECK(found.is_counted);
    REQUIRE(found.values.size() == 9); // those that have the value of the seventh too
    CHECK((found.values.array() - 1.0).abs().maxCoeff() < 1e-12);
}

TEST_CASE("There are as many eigenpairs as unknowns that have mass")
{
    std::vector<double> masses(30, 0.0);
    masses[3] = masses[17] = masses[29] = 1.5;
    const Eigenpairs found = lowest(chain(30), diagonal(masses), 10);
    REQUIRE(found.values.size() == 3);
    // Springs in a row to a mass alone add their flexibilities.
    Eigen::Matrix3d flexibility;
    flexibility << 4.0, 4.0, 4.0, 4.0, 18.0, 18.0, 4.0, 18.0, 30.0;
    const Eigen::Vector3d expected = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(1.5 * flexibility).eigenvalues();
    for (int i = 0; i < 3; ++i) CHECK(found.values[i] == doctest::Approx(1.0 / expected[2 - i]).epsilon(1e-10));
}

TEST_CASE("Eigenpairs of random systems are those of dense matrices, square to one another over the mass")
{
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const RandomSystem stiffness(seed, 60, 110, Ordering::MinimumDegree);
        const Eigen::Index n = stiffness.K.rows();
        std::vector<double> masses;
        for (Eigen::Index i = 0; i < n; ++i) masses.push_back(1.0 + 0.1 * static_cast<double>(i % 7));
        const SparseMatrix M = diagonal(masses);
        SparseMatrix K = stiffness.K + SparseMatrix(0.01 * M);
        const Eigen::MatrixXd dense = stiffness.dense + 0.01 * Eigen::MatrixXd(M);
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> expected(dense, Eigen::MatrixXd(M));
        const Eigenpairs found = lowest(K, M, 8);
        REQUIRE(found.values.size() >= 8);
        CHECK(found.is_counted);
        for (int i = 0; i < 8; ++i)
            CHECK(found.values[i] ==
                  doctest::Approx(expected.eigenvalues()[i]).epsilon(1e-9).scale(100.0 * found.rounding));
        const Eigen::MatrixXd squares = found.vectors.transpose() * M * found.vectors;
        CHECK((squares - Eigen::MatrixXd::Identity(squares.rows(), squares.cols())).cwiseAbs().maxCoeff() < 1e-9);
        const Eigen::MatrixXd residual = dense * found.vectors -
                                         Eigen::MatrixXd(M) * found.vectors * found.values.asDiagonal();
        CHECK(residual.cwiseAbs().maxCoeff() < 1e-6 * dense.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("What has neither stiffness nor mass and moves is refused")
{
    std::vector<double> masses(10, 0.0);
    masses[0] = 1.0;
    SparseMatrix K = chain(10, false);
    for (int i = 5; i < 7; ++i) K.coeffRef(6, i) = 0.0; // the last four float
    K.coeffRef(5, 5) = 1.0;
    K.coeffRef(6, 6) = 1.0;
    CHECK_THROWS_AS(lowest(K, diagonal(masses), 2), std::domain_error);
}
