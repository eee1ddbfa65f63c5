#include "tests/bench/reference_system.h"

#include <Eigen/Dense>

namespace bench {

namespace {

using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 member_stiffness(double EA, double EI, double L, bool is_vertical)
{
    const double a = EA / L, b = 12.0 * EI / (L * L * L), c = 6.0 * EI / (L * L), d = 2.0 * EI / L;
    Matrix6 k;
    k << a, 0, 0, -a, 0, 0,    //
        0, b, c, 0, -b, c,     //
        0, c, 2 * d, 0, -c, d, //
        -a, 0, 0, a, 0, 0,     //
        0, -b, -c, 0, b, -c,   //
        0, c, d, 0, -c, 2 * d;
    if (!is_vertical) return k;
    Matrix6 T = Matrix6::Zero();
    T.block<3, 3>(0, 0) << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    T.block<3, 3>(3, 3) = T.block<3, 3>(0, 0);
    return T.transpose() * k * T;
}

} // namespace

/// Every node of the storeys has a neighbour to the right and one above: columns are written once, in order.
System plane_frame_system(FrameSize size)
{
    const auto [bays, storeys] = size;
    constexpr double E = 210e9, bay = 6.0, storey = 3.0, q = 20e3, H = 10e3;
    const Matrix6 column = member_stiffness(E * 0.01, E * 1e-4, storey, true);
    const Matrix6 beam = member_stiffness(E * 0.008, E * 2e-4, bay, false);
    const std::size_t width = bays + 1;
    System s;
    s.start.push_back(0);
    s.top_left = 3 * width * (storeys - 1);
    s.f.assign(3 * width * storeys, 0.0);
    const auto write_rows = [&](std::size_t node, const Matrix3& block, int col, int from) {
        for (int r = from; r < 3; ++r) {
            s.rows.push_back(static_cast<int>(3 * node) + r);
            s.values.push_back(block(r, col));
        }
    };
    for (std::size_t y = 0; y < storeys; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t node = y * width + x;
            const bool has_left = x > 0, has_right = x < bays, has_upper = y + 1 < storeys;
            Matrix3 own = column.bottomRightCorner<3, 3>();
            if (has_upper) own += column.topLeftCorner<3, 3>();
            if (has_left) own += beam.bottomRightCorner<3, 3>();
            if (has_right) own += beam.topLeftCorner<3, 3>();
            for (int col = 0; col < 3; ++col) {
                write_rows(node, own, col, col);
                if (has_right) write_rows(node + 1, beam.bottomLeftCorner<3, 3>(), col, 0);
                if (has_upper) write_rows(node + width, column.bottomLeftCorner<3, 3>(), col, 0);
                s.start.push_back(static_cast<int>(s.rows.size()));
            }
            double* f = s.f.data() + 3 * node;
            f[0] += x == 0 ? H : 0.0;
            f[1] -= 0.5 * q * bay * (static_cast<double>(has_left) + static_cast<double>(has_right));
            f[2] += q * bay * bay / 12.0 * (static_cast<double>(has_left) - static_cast<double>(has_right));
        }
    return s;
}

} // namespace bench
