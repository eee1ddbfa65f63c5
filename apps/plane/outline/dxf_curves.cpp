#include "apps/plane/outline/dxf_curves.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace outline {

namespace {

EllipticArc bulged_side(const Place& from, const Place& to, double bulge)
{
    const Eigen::Vector2d chord = to - from, left(-chord.y(), chord.x());
    const Place center = 0.5 * (from + to) + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
    const Eigen::Vector2d u = from - center;
    return {.center = center, .u = u, .v = {-u.y(), u.x()}, .from = 0.0, .to = 4.0 * std::atan(bulge)};
}

/// The blossom of the piece of a B-spline that begins at knot `span`.
Place blossom(const std::vector<Place>& control, const std::vector<double>& knots, std::size_t span,
              std::span<const double> at)
{
    const std::size_t p = at.size(), first = span - p;
    std::vector<Place> d(control.begin() + static_cast<std::ptrdiff_t>(first),
                         control.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t r = 1; r <= p; ++r)
        for (std::size_t k = p; k >= r; --k) {
            const double low = knots[first + k], high = knots[span + 1 + k - r];
            const double share = (at[r - 1] - low) / (high - low);
            d[k] = (1.0 - share) * d[k - 1] + share * d[k];
        }
    return d[p];
}

/// The control points of that piece, as many as its degree and one.
std::vector<Place> piece(const std::vector<Place>& control, const std::vector<double>& knots, std::size_t span,
                         std::size_t degree)
{
    std::vector<Place> places;
    for (std::size_t n_at_end = 0; n_at_end <= degree; ++n_at_end) {
        std::vector<double> at(degree, knots[span]);
        for (std::size_t i = 0; i < n_at_end; ++i) at[degree - 1 - i] = knots[span + 1];
        places.push_back(blossom(control, knots, span, at));
    }
    return places;
}

} // namespace

std::vector<Curve> bulged_polyline(const std::vector<BulgedCorner>& corners, bool is_closed)
{
    std::vector<Curve> curves;
    constexpr double straight = 1e-9;
    Polyline run;
    const auto end_run = [&] {
        if (run.places.size() > 1) curves.emplace_back(run);
        run.places.clear();
    };
    const std::size_t n_sides = corners.empty() ? 0 : corners.size() - (is_closed ? 0 : 1);
    for (std::size_t i = 0; i < n_sides; ++i) {
        const BulgedCorner &from = corners[i], &to = corners[(i + 1) % corners.size()];
        if (run.places.empty()) run.places.push_back(from.at);
        if (std::abs(from.bulge) < straight) {
            run.places.push_back(to.at);
            continue;
        }
        end_run();
        if (from.at != to.at) curves.emplace_back(bulged_side(from.at, to.at, from.bulge));
    }
    end_run();
    return curves;
}

Curve bspline(const std::vector<Place>& control, const std::vector<double>& knots, int degree)
{
    if (degree == 1) return Polyline{control, false};
    const auto p = static_cast<std::size_t>(degree);
    CubicChain chain;
    for (std::size_t span = p; span < control.size(); ++span) {
        if (!(knots[span + 1] > knots[span])) continue;
        std::vector<Place> places = piece(control, knots, span, p);
        if (p == 2) {
            const std::array<Place, 4> cubic = raised({places[0], places[1], places[2]});
            places.assign(cubic.begin(), cubic.end());
        }
        const auto new_ones = places.begin() + (chain.places.empty() ? 0 : 1);
        chain.places.insert(chain.places.end(), new_ones, places.end());
    }
    return chain;
}

} // namespace outline
