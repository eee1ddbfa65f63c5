#include "femoop/result/curve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace femoop {

void Curve::begin(const Law& law, const std::vector<SpanPiece>& loads)
{
    law_ = law;
    pieces_.clear();
    for (const SpanPiece& load : loads) pieces_.push_back({load, {}});
}

std::vector<double> Curve::breaks() const
{
    std::vector<double> places;
    for (const Piece& piece : pieces_)
        if (piece.load.begins_at_load) places.push_back(piece.load.begin);
    places.push_back(length());
    return places;
}

const Curve::Piece& Curve::piece_at(double x, Side side) const
{
    if (pieces_.size() == 1) return pieces_.front();
    const auto begins_after = [](double at, const Piece& piece) { return at < piece.load.begin; };
    auto next = std::upper_bound(pieces_.begin(), pieces_.end(), x, begins_after);
    if (next != pieces_.begin()) --next;
    const bool wants_before = side == Side::Before && x <= next->load.begin && next != pieces_.begin();
    return wants_before ? *std::prev(next) : *next;
}

Polynomial Curve::polynomial(MemberComponent component, const Piece& piece) const
{
    const auto axial = [&] { return law_.axial.series(piece.begin.axial, piece.load, LocalAxis::x, law_.strain); };
    const auto torsion = [&] { return law_.torsion.series(piece.begin.torsion, piece.load, LocalAxis::rx, 0.0); };
    const auto xy = [&] { return law_.xy.series(piece.begin.xy, piece.load, BendingPlane::xy, law_.curvature); };
    const auto xz = [&] { return law_.xz.series(piece.begin.xz, piece.load, BendingPlane::xz, 0.0); };
    switch (component) {
    case MemberComponent::N: return axial().N;
    case MemberComponent::T: return torsion().N;
    case MemberComponent::Vy: return xy().V;
    case MemberComponent::Mz: return xy().M;
    case MemberComponent::Vz: return xz().V;
    case MemberComponent::My: return xz().M;
    case MemberComponent::u: return axial().u;
    case MemberComponent::v: return xy().v;
    case MemberComponent::w: break;
    }
    return xz().v;
}

SectionForces Curve::forces(double x, Side side) const
{
    const Piece& piece = piece_at(x, side);
    const double t = x - piece.load.begin;
    const Beam::Forces xy = law_.xy.forces_at(t, piece.begin.xy, piece.load, BendingPlane::xy, law_.curvature);
    const double N = law_.axial.force_at(t, piece.begin.axial, piece.load, LocalAxis::x);
    if (law_.is_in_plane) return {.N = N, .Vy = xy.V, .Mz = xy.M};
    const Beam::Forces xz = law_.xz.forces_at(t, piece.begin.xz, piece.load, BendingPlane::xz, 0.0);
    return {.N = N,
            .Vy = xy.V,
            .Vz = xz.V,
            .T = law_.torsion.force_at(t, piece.begin.torsion, piece.load, LocalAxis::rx),
            .My = xz.M,
            .Mz = xy.M};
}

LocalDisplacement Curve::displacement(double x, Side side) const
{
    const Piece& piece = piece_at(x, side);
    const double t = x - piece.load.begin;
    const Beam::State xy = law_.xy.at(t, piece.begin.xy, piece.load, BendingPlane::xy, law_.curvature);
    const Beam::State xz = law_.xz.at(t, piece.begin.xz, piece.load, BendingPlane::xz, 0.0);
    return {.u = law_.axial.at(t, piece.begin.axial, piece.load, LocalAxis::x, law_.strain).u,
            .v = xy.v,
            .w = xz.v,
            .rx = law_.torsion.at(t, piece.begin.torsion, piece.load, LocalAxis::rx, 0.0).u,
            .ry = -xz.phi,
            .rz = xy.phi};
}

Station Curve::station(double x, Side side) const
{
    return {.x = x, .side = side, .forces = forces(x, side), .displacement = displacement(x, side)};
}

// A section force has a closed form of its own; the series of all its relatives would take much longer.
double Curve::value(MemberComponent component, double x, Side side) const
{
    const Piece& piece = piece_at(x, side);
    const double t = x - piece.load.begin;
    const auto xy = [&] { return law_.xy.forces_at(t, piece.begin.xy, piece.load, BendingPlane::xy, law_.curvature); };
    const auto xz = [&] { return law_.xz.forces_at(t, piece.begin.xz, piece.load, BendingPlane::xz, 0.0); };
    switch (component) {
    case MemberComponent::N: return law_.axial.force_at(t, piece.begin.axial, piece.load, LocalAxis::x);
    case MemberComponent::T: return law_.torsion.force_at(t, piece.begin.torsion, piece.load, LocalAxis::rx);
    case MemberComponent::Vy: return xy().V;
    case MemberComponent::Mz: return xy().M;
    case MemberComponent::Vz: return xz().V;
    case MemberComponent::My: return xz().M;
    default: return polynomial(component, piece)(t);
    }
}

Extremes Curve::extremes(MemberComponent component) const
{
    Extremes found;
    bool is_first = true;
    const auto offer = [&](double x, double value) {
        const double rounding = 1e-13 * std::abs(value); // equal but for rounding: the first stays
        if (is_first || value > found.max.value + rounding) found.max = {.x = x, .value = value};
        if (is_first || value < found.min.value - rounding) found.min = {.x = x, .value = value};
        is_first = false;
    };
    for (const Piece& piece : pieces_) {
        const Polynomial p = polynomial(component, piece);
        const double end = piece.load.length();
        offer(piece.load.begin, p(0.0));
        for (const double t : p.derivative().roots(end)) offer(piece.load.begin + t, p(t));
        offer(piece.load.end, p(end));
    }
    return found;
}

std::vector<double> Curve::zeros(MemberComponent component) const
{
    std::vector<double> places;
    const double apart = 1e-9 * length();
    const auto add = [&](double x) {
        if (places.empty() || x - places.back() > apart) places.push_back(x);
    };
    double last = 0.0; // value at the end of the piece before
    for (const Piece& piece : pieces_) {
        const Polynomial p = polynomial(component, piece);
        const bool jumps_through = last * p(0.0) < 0.0;
        if (jumps_through) add(piece.load.begin);
        bool is_zero = true;
        for (std::size_t i = 0; i < p.n_terms(); ++i) is_zero &= p[i] == 0.0;
        if (is_zero) {
            add(piece.load.begin);
            add(piece.load.end);
        }
        for (const double t : p.roots(piece.load.length())) add(piece.load.begin + t);
        last = p(piece.load.length());
    }
    return places;
}

bool Curve::jumps_at(double x) const
{
    const Piece& piece = piece_at(x, Side::After);
    const auto is_loaded = [](double value) { return value != 0.0; };
    return piece.load.begin == x && std::any_of(piece.load.jump.begin(), piece.load.jump.end(), is_loaded);
}

std::vector<Station> Curve::stations(std::size_t n) const
{
    if (n < 2) throw std::invalid_argument("Curve::stations: at least the two ends are stations");
    const double L = length();
    std::vector<double> places = breaks();
    const std::size_t n_breaks = places.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double x = L * static_cast<double>(i) / static_cast<double>(n - 1);
        const auto is_same = [&](double place) { return std::abs(place - x) <= 1e-12 * L; };
        const auto end = places.begin() + static_cast<std::ptrdiff_t>(n_breaks);
        if (std::none_of(places.begin(), end, is_same)) places.push_back(x);
    }
    std::sort(places.begin(), places.end());

    std::vector<Station> stations;
    for (const double x : places) {
        if (x > 0.0 && x < L && jumps_at(x)) stations.push_back(station(x, Side::Before));
        stations.push_back(station(x, x < L ? Side::After : Side::Before));
    }
    return stations;
}

} // namespace femoop
