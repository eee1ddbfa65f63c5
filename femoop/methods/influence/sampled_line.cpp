#include "femoop/methods/influence/sampled_line.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "femoop/algebra/dense_solution.h"

namespace femoop::influence {

SampledStretch::SampledStretch(double from, double to, std::size_t degree) : from_(from), to_(to)
{
    const double n = static_cast<double>(degree) + 1.0;
    for (std::size_t i = 0; i <= degree; ++i)
        nodes_.push_back(-std::cos((static_cast<double>(i) + 0.5) * std::numbers::pi / n));
}

std::vector<double> SampledStretch::places() const
{
    std::vector<double> places;
    for (const double node : nodes_) places.push_back(0.5 * (from_ + to_) + 0.5 * (to_ - from_) * node);
    return places;
}

LinePiece SampledStretch::piece(const std::vector<double>& values) const
{
    const auto n = static_cast<Eigen::Index>(nodes_.size());
    Eigen::MatrixXd powers(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k)
            powers(i, k) = std::pow(nodes_[static_cast<std::size_t>(i)], static_cast<double>(k));
    Eigen::VectorXd c = dense_solution(powers, Eigen::Map<const Eigen::VectorXd>(values.data(), n));
    // from powers of the place in -1 .. 1 to those of t = s - from: the argument is 2 t / h - 1
    for (Eigen::Index first = 0; first + 1 < n; ++first)
        for (Eigen::Index i = n - 1; i-- > first;) c[i] -= c[i + 1];
    LinePiece piece{.from = from_, .to = to_, .coefficients = {}};
    double scale = 1.0;
    for (Eigen::Index k = 0; k < n; ++k, scale *= 2.0 / (to_ - from_)) piece.coefficients.push_back(scale * c[k]);
    return piece;
}

} // namespace femoop::influence
