#include <doctest/doctest.h>

#include <cmath>

#include "femoop/algebra/congruence.h"
#include "femoop/algebra/dense_solution.h"
#include "femoop/algebra/least_squares.h"
#include "femoop/algebra/symmetric_eigen.h"

using namespace femoop;

TEST_CASE("A system whose first pivot is zero is solved by exchanging rows")
{
    Eigen::Matrix3d A;
    A << 0.0, 2.0, -1.0, //
        3.0, 0.5, 4.0,   //
        -2.0, 7.0, 1.5;
    Eigen::Matrix<double, 3, 2> X;
    X << 5.0, -0.25, //
        -3.0, 1.75,  //
        0.5, 11.0;
    CHECK((dense_solution(A, A * X) - X).norm() < 1e-13);
    CHECK((A * dense_inverse(A) - Eigen::Matrix3d::Identity()).norm() < 1e-14);
}

TEST_CASE(
    "A line fitted to points has the slope and the height of textbooks, and leaves a rest that its columns do not see")
{
    const Eigen::Vector4d x(1.0, 2.0, 4.0, 7.0), y(3.0, 2.5, 6.0, 8.0);
    Eigen::Matrix<double, 4, 2> A;
    A << Eigen::Vector4d::Ones(), x;
    const double mean_x = x.mean(), mean_y = y.mean();
    const double slope = (x.array() - mean_x).matrix().dot((y.array() - mean_y).matrix()) /
                         (x.array() - mean_x).matrix().squaredNorm();
    const Eigen::VectorXd fit = least_squares(A, y);
    CHECK(fit[1] == doctest::Approx(slope));
    CHECK(fit[0] == doctest::Approx(mean_y - slope * mean_x));
    CHECK((A.transpose() * (A * fit - y)).norm() < 1e-13);
}

TEST_CASE("Columns that depend on one another are fitted as well as those that do not")
{
    Eigen::Matrix<double, 4, 3> A;
    A << 1.0, 2.0, 3.0,  //
        0.5, -1.0, -0.5, //
        4.0, 0.25, 4.25, //
        -2.0, 3.0, 1.0;
    const Eigen::Vector4d b(1.0, -2.0, 0.5, 3.0);
    const Eigen::VectorXd whole = least_squares(A, b), independent = least_squares(A.leftCols<2>(), b);
    CHECK((A * whole - A.leftCols<2>() * independent).norm() < 1e-13);
}

TEST_CASE("The stresses of a plane state are the eigenvalues of its tensor, the least first")
{
    const double sx = 80.0, sy = -30.0, txy = 25.0;
    Eigen::Matrix2d tensor;
    tensor << sx, txy, txy, sy;
    const double centre = 0.5 * (sx + sy), radius = std::hypot(0.5 * (sx - sy), txy);
    const SymmetricEigen eigen = symmetric_eigen(tensor);
    CHECK(eigen.values[0] == doctest::Approx(centre - radius));
    CHECK(eigen.values[1] == doctest::Approx(centre + radius));
    const Eigen::Vector2d first = eigen.vectors.col(1);
    CHECK(2.0 * std::atan(first.y() / first.x()) == doctest::Approx(std::atan2(txy, 0.5 * (sx - sy))));
    CHECK((eigen.vectors.transpose() * eigen.vectors - Eigen::Matrix2d::Identity()).norm() < 1e-14);
}

TEST_CASE("A stiffness is felt by displacements with the energy that it has of the strains they make")
{
    const Eigen::Matrix2d S{{4.0, -1.5}, {-1.5, 7.0}};
    const Eigen::Matrix<double, 2, 3> B{{0.5, -2.0, 3.0}, {1.25, 6.0, -0.75}};
    const Eigen::Vector3d u(2.0, -0.5, 5.0);
    const Eigen::Vector2d e = B * u;
    const Eigen::MatrixXd K = congruence(S, B);
    CHECK(u.dot(K * u) == doctest::Approx(e.dot(S * e)));
    CHECK(K.rows() == 3);
}
