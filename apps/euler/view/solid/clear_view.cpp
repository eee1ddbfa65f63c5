#include "apps/euler/view/solid/clear_view.h"

#include "topology/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace euler {

using topology::Point;
using topology::Vector;

namespace {

constexpr double enough = 0.08, enough_of_space = 0.33; // of the picture; of the distance in space
constexpr double price_of_turning = 0.2;                // of a radian, in clearness
constexpr std::size_t most_distances = 20'000'000;      // that are looked at: some hundredths of a second

/// Places of vertices, each once, and edges between them.
class Wires {
public:
    explicit Wires(std::span<const Subject> subjects)
    {
        for (const Subject& subject : subjects)
            for (const topology::VertexId v : subject.solid->vertices()) places.push_back(subject.solid->point(v));
        std::ranges::sort(places, is_before);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        for (const Subject& subject : subjects)
            for (const topology::EdgeId e : subject.solid->edges()) add_edge(*subject.solid, e);
        std::ranges::sort(edges);
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }

    using Ends = std::pair<std::size_t, std::size_t>;
    std::vector<Point> places;
    std::vector<Ends> edges;

private:
    static bool is_before(const Point& a, const Point& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
    std::size_t place(const Point& p) const
    {
        return static_cast<std::size_t>(std::ranges::lower_bound(places, p, is_before) - places.begin());
    }
    void add_edge(const topology::Solid& solid, topology::EdgeId e)
    {
        const topology::HalfEdgeId h = solid.edges()[e].plus;
        const std::size_t from = place(solid.point(solid.start(h))), to = place(solid.point(solid.end(h)));
        if (from != to) edges.emplace_back(std::min(from, to), std::max(from, to));
    }
};

double distance_to_edge(const Point& p, const Point& a, const Point& b)
{
    const Vector along = b - a;
    const double square = dot(along, along);
    const double t = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return length(p - (a + t * along));
}

double extent(const std::vector<Point>& points)
{
    Point least = points.front(), most = least;
    for (const Point& p : points) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
    }
    return length(most - least);
}

/// How clearly vertices are seen beside each other and beside edges.
class Clearance {
public:
    explicit Clearance(const Wires& wires) : wires_(wires) {}

    /// 1 where everything is far enough apart, 0 where something covers another; some value that is less where it is
    /// less than `worth`.
    double seen(const ui::OrbitCamera& camera, double worth)
    {
        look(camera);
        double least = 1.0;
        for (std::size_t i = 0; i < flat_.size() && least > worth && !is_weary(); ++i) least = std::min(least, of(i));
        return least;
    }
    bool is_weary() const { return n_looked_at_ > most_distances; }

private:
    void look(const ui::OrbitCamera& camera)
    {
        const ui::World3 right = camera.right(), up = camera.up();
        flat_.clear();
        for (const Point& p : wires_.places) {
            const Vector v = p - wires_.places.front();
            flat_.push_back({right.x * v.x + right.y * v.y, up.x * v.x + up.y * v.y + up.z * v.z, 0.0});
        }
        size_ = extent(flat_);
    }

    /// Of one vertex, beside those before it and beside all edges of others.
    double of(std::size_t i)
    {
        const std::vector<Point>& places = wires_.places;
        double least = 1.0;
        for (std::size_t j = 0; j < i; ++j)
            if (const double d = length(flat_[i] - flat_[j]); d < enough * size_)
                least = std::min(least, share(d, length(places[i] - places[j])));
        for (const auto& [a, b] : wires_.edges)
            if (const double d = distance_to_edge(flat_[i], flat_[a], flat_[b]); d < enough * size_ && a != i && b != i)
                least = std::min(least, share(d, distance_to_edge(places[i], places[a], places[b])));
        n_looked_at_ += i + wires_.edges.size();
        return least;
    }

    /// What touches in space too does so from everywhere.
    double share(double seen, double in_space) const
    {
        constexpr double touching = 1e-9;
        return in_space > touching * size_ ? seen / std::min(enough * size_, enough_of_space * in_space) : 1.0;
    }

    const Wires& wires_;
    std::vector<Point> flat_; ///< as they are seen
    double size_ = 0.0;       ///< of what is seen
    std::size_t n_looked_at_ = 0;
};

/// Where to look from instead of a direction: a turn about the vertical, and an elevation.
struct Turn {
    double azimuth, elevation;
    double cost; ///< how far it turns
};

std::vector<Turn> turns_about(const ui::OrbitCamera& camera)
{
    constexpr double step = std::numbers::pi / 36.0, lowest = 0.2, highest = 0.8;
    std::vector<Turn> turns{{camera.azimuth(), camera.elevation(), 0.0}};
    for (int i = -36; i < 36; ++i)
        for (double elevation = lowest; elevation <= highest; elevation += step)
            turns.push_back({camera.azimuth() + i * step, elevation,
                             std::abs(i * step) + std::abs(elevation - camera.elevation())});
    std::ranges::stable_sort(turns, {}, &Turn::cost);
    return turns;
}

} // namespace

ui::OrbitCamera clear_view(const ui::OrbitCamera& camera, std::span<const Subject> subjects)
{
    const Wires wires(subjects);
    if (wires.places.size() < 2) return camera;
    Clearance clearance(wires);
    ui::OrbitCamera best = camera;
    double most = -std::numeric_limits<double>::infinity();
    for (const Turn& turn : turns_about(camera)) {
        const double price = price_of_turning * turn.cost;
        if (1.0 - price <= most) break; // however clearly it is seen from there
        ui::OrbitCamera turned = camera;
        turned.look(turn.azimuth, turn.elevation);
        const double worth = clearance.seen(turned, most + price) - price;
        if (clearance.is_weary()) break;
        if (worth <= most) continue;
        most = worth;
        best = turned;
    }
    return best;
}

} // namespace euler
