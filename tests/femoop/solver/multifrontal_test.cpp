#include "femoop/solver/multifrontal/multifrontal_solver.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "femoop/solver/at_once.h"
#include "femoop/solver/multifrontal/dense_front.h"
#include "femoop/solver/multifrontal/schedule.h"
#include "femoop/solver/team.h"
#include "tests/femoop/solver/graph_kinds.h"

using namespace femoop;
using namespace femoop_test;

namespace {

Eigen::MatrixXd solution(const GraphSystem& system, MultifrontalSolver& solver, const Eigen::MatrixXd& B)
{
    solver.analyse(system.pattern);
    REQUIRE(solver.factorize(system.K).is_positive_definite);
    return solver.solve(B);
}

} // namespace

TEST_CASE("Fronts solve chains and grids and stars and what falls apart and dense rows in every order")
{
    for (const GraphKind& kind : graph_kinds)
        for (const Ordering ordering : orderings)
            for (std::int32_t size = 1; size <= 6; ++size) {
                CAPTURE(kind.name);
                CAPTURE(static_cast<int>(ordering));
                CAPTURE(size);
                const GraphSystem system(kind.make(kind.n, size), ordering, 17);
                const Eigen::MatrixXd B = system.load(4);
                MultifrontalSolver solver;
                CHECK(residual(system.K, solution(system, solver, B), B) <= 1e-9);
            }
}

TEST_CASE("Large fronts that several threads share solve what they should")
{
    const GraphSystem system(whole(130, 5), Ordering::MinimumDegree, 5); // 650 unknowns in one front
    const Eigen::MatrixXd B = system.load(2);
    MultifrontalSolver solver(2);
    CHECK(residual(system.K, solution(system, solver, B), B) <= 1e-7);
}

TEST_CASE("One thread or eight: the same numbers to the last bit")
{
    const GraphSystem system(grid(60, 3), Ordering::NestedDissection, 29); // worth a team
    const Eigen::MatrixXd B = system.load(3);
    MultifrontalSolver alone(1);
    const Eigen::MatrixXd expected = solution(system, alone, B);
    CHECK(residual(system.K, expected, B) <= 1e-8);
    for (int n_threads = 2; n_threads <= 8; ++n_threads) {
        CAPTURE(n_threads);
        MultifrontalSolver together(n_threads);
        CHECK(solution(system, together, B) == expected);
    }
}

TEST_CASE("Whatever the threads the same pivot is told to be the weakest")
{
    GraphSystem system(grid(60, 3), Ordering::NestedDissection, 29);
    const std::int32_t soft = 5000;
    system.K.valuePtr()[system.K.outerIndexPtr()[soft]] *= 1e-3; // no longer positive definite
    MultifrontalSolver alone(1);
    alone.analyse(system.pattern);
    const Pivots expected = alone.factorize(system.K);
    CHECK_FALSE(expected.is_positive_definite);
    MultifrontalSolver together(2);
    together.analyse(system.pattern);
    const Pivots pivots = together.factorize(system.K);
    CHECK(pivots.weakest == expected.weakest);
    CHECK(pivots.smallest_ratio == expected.smallest_ratio);
}

TEST_CASE("Every equation is eliminated once, and what a front leaves is part of its parent")
{
    const GraphSystem system(grid(20, 3), Ordering::NestedDissection, 1);
    const FrontTree tree({.column_start = system.pattern.column_start(), .rows = system.pattern.rows()});
    std::set<std::int32_t> eliminated;
    for (std::size_t f = 0; f < tree.fronts().size(); ++f) {
        const FrontTree::Front& front = tree.fronts()[f];
        const auto rows = tree.rows(front);
        for (std::int32_t i = 0; i < front.n_pivots; ++i) CHECK(eliminated.insert(rows[at(i)]).second);
        if (front.parent == FrontTree::none) {
            CHECK(front.n_updated() == 0);
            continue;
        }
        CHECK(at(front.parent) > f);
        const auto above = tree.rows(tree.fronts()[at(front.parent)]);
        for (std::int32_t i = 0; i < front.n_updated(); ++i)
            CHECK(above[at(tree.places_in_parent(front)[at(i)])] == rows[at(front.n_pivots + i)]);
    }
    CHECK(eliminated.size() == tree.n_equations());
}

TEST_CASE("A schedule has every front once, and no task waits for another")
{
    const GraphSystem system(grid(40, 3), Ordering::NestedDissection, 1);
    const FrontTree tree({.column_start = system.pattern.column_start(), .rows = system.pattern.rows()});
    const Schedule schedule(tree, 4);
    CHECK(schedule.tasks.size() >= 8);
    std::vector<int> task_of(tree.fronts().size(), -1); // -1: at the top
    for (std::size_t t = 0; t < schedule.tasks.size(); ++t)
        for (std::int32_t f = schedule.tasks[t].first; f < schedule.tasks[t].end; ++f) {
            CHECK(task_of[at(f)] == -1);
            task_of[at(f)] = static_cast<int>(t);
        }
    for (const std::int32_t f : schedule.top) CHECK(task_of[at(f)] == -1);
    for (std::size_t f = 0; f < task_of.size(); ++f)
        if (const std::int32_t parent = tree.fronts()[f].parent; task_of[f] != -1 && parent != FrontTree::none) {
            const bool parent_is_at_home = task_of[at(parent)] == task_of[f] || task_of[at(parent)] == -1;
            CHECK(parent_is_at_home);
        }
    CHECK(Schedule(tree, 1).tasks.size() == 1);
}

TEST_CASE("A team does every item once and hands on what an item throws")
{
    for (const int size : {1, 2, 8}) {
        CAPTURE(size);
        Team team(size);
        for (int round = 0; round < 200; ++round) {
            std::vector<std::atomic<int>> done(37);
            team.for_each(37, [&](std::int32_t item, int) { ++done[at(item)]; });
            for (const std::atomic<int>& n : done) CHECK(n == 1);
        }
        const auto fails = [](std::int32_t item, int) {
            if (item == 5) throw std::runtime_error("item 5");
        };
        CHECK_THROWS_WITH(team.for_each(20, fails), "item 5");
        int n = 0;
        team.for_each(1, [&](std::int32_t, int) { ++n; });
        CHECK(n == 1);
    }
}

TEST_CASE("Ranges cover every number once, and two works both end before either's exception comes out")
{
    for (const std::size_t n : {0, 1, 6, 7, 8, 50}) {
        CAPTURE(n);
        std::vector<std::atomic<int>> done(n);
        in_ranges(n, 7, [&](std::size_t begin, std::size_t end) {
            CHECK(begin % 7 == 0);
            for (std::size_t i = begin; i < end; ++i) ++done[i];
        });
        for (const std::atomic<int>& times : done) CHECK(times == 1);
    }
    int first = 0, second = 0;
    at_once([&] { first = 3; }, [&] { second = 5; });
    CHECK(first + second == 8);
    CHECK_THROWS_WITH(at_once([] { throw std::runtime_error("first"); }, [] {}), "first");
}

TEST_CASE("A front's elimination leaves the Schur complement and L D L'")
{
    for (const std::int32_t n : {1, 7, 24, 25, 96, 97, 230})
        for (const std::int32_t m : {0, 1, 50, 192, 400}) {
            CAPTURE(n);
            CAPTURE(m);
            const Eigen::Index size = n + m;
            std::srand(4);
            const Eigen::MatrixXd R = Eigen::MatrixXd::Random(size, size);
            Eigen::MatrixXd K = R + R.transpose();
            for (Eigen::Index i = 0; i < size; ++i) K(i, i) += (i % 3 == 0 ? -2.0 : 2.0) * static_cast<double>(size);
            Eigen::MatrixXd panel = K.leftCols(n), update = K.bottomRightCorner(m, m);
            std::vector<double> workspace(workspace_size(n, n + m));
            const DenseFront front{panel.data(), update.data(), n, n + m};
            CHECK(dense_kernel().eliminate(front, workspace.data(), one_by_one) == n);
            Eigen::MatrixXd schur = K.bottomRightCorner(m, m);
            if (m > 0)
                schur -= K.bottomLeftCorner(m, n) *
                         K.topLeftCorner(n, n).partialPivLu().solve(Eigen::MatrixXd(K.topRightCorner(n, m)));
            const double scale = K.cwiseAbs().maxCoeff();
            for (Eigen::Index j = 0; j < m; ++j)
                CHECK((update.col(j).tail(m - j) - schur.col(j).tail(m - j)).cwiseAbs().maxCoeff() <= 1e-12 * scale);
            const Eigen::MatrixXd L = panel.topRows(n).triangularView<Eigen::UnitLower>();
            const Eigen::MatrixXd D = panel.topRows(n).diagonal().asDiagonal();
            CHECK((L * D * L.transpose() - K.topLeftCorner(n, n)).cwiseAbs().maxCoeff() <= 1e-12 * scale);
        }
}

TEST_CASE("A right-hand side goes through the columns of a front's L as through triangles and rectangles")
{
    for (const std::int32_t n : {1, 3, 4, 6, 8, 97})
        for (const std::int32_t m : {0, 1, 5, 8, 230}) {
            CAPTURE(n);
            CAPTURE(m);
            std::srand(7);
            Eigen::MatrixXd panel = 0.1 * Eigen::MatrixXd::Random(n + m, n);
            panel.topRows(n).triangularView<Eigen::Upper>().setConstant(std::numeric_limits<double>::quiet_NaN());
            const Eigen::VectorXd x = Eigen::VectorXd::Random(n + m);
            const auto square = panel.topRows(n).triangularView<Eigen::UnitLower>();
            const FrontColumns L{panel.data(), n, n + m};

            Eigen::VectorXd forward = x, expected = x;
            dense_kernel().solve_forward(L, forward.data());
            expected.head(n) = square.solve(x.head(n));
            expected.tail(m) -= panel.bottomRows(m) * expected.head(n);
            CHECK((forward - expected).norm() <= 1e-13 * expected.norm());

            Eigen::VectorXd backward = x;
            dense_kernel().solve_backward(L, backward.data());
            expected = x;
            expected.head(n) -= panel.bottomRows(m).transpose() * x.tail(m);
            expected.head(n) = square.transpose().solve(Eigen::VectorXd(expected.head(n)));
            CHECK((backward - expected).norm() <= 1e-13 * expected.norm());
        }
}

TEST_CASE("Elimination of a front stops at a pivot that is zero or no number")
{
    for (const double bad : {0.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        Eigen::Matrix3d panel = Eigen::Vector3d(2.0, bad, 1.0).asDiagonal();
        std::vector<double> workspace(workspace_size(3, 3));
        CHECK(dense_kernel().eliminate({panel.data(), nullptr, 3, 3}, workspace.data(), one_by_one) == 1);
    }
}
