#include "apps/euler/view/planar/layout_on_its_way.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace euler {

using topology::EdgeId;
using topology::HalfEdgeId;
using topology::Point;
using topology::VertexId;

namespace {

using Layout = PlacedSolid::Layout;
using Path = std::vector<ui::Point>;

ui::Point flat(const Point& p) { return {p.x, p.y}; }

ui::Point turned(ui::Point p, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

ui::Point blend(ui::Point a, ui::Point b, double share) { return share * a + (1.0 - share) * b; }

/// At the same share of the path's pieces.
ui::Point at_share(const Path& path, double share)
{
    const double x = share * static_cast<double>(path.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(x), path.size() - 2);
    return blend(path[i + 1], path[i], x - static_cast<double>(i));
}

bool have_same_outside(const Layout& a, const Layout& b)
{
    const auto is_same = [](const auto& x, const auto& y) { return x.first == y.first; };
    return std::ranges::equal(a.outside, b.outside, is_same) && a.left_out == b.left_out;
}

class OnItsWay {
public:
    OnItsWay(const DrawnInPlane& home, const DrawnInPlane& away, double share) : home_(home), away_(away), share_(share)
    {
        if (home.layout.outside.size() == 1) {
            home_middle_ = middle_of(home.layout);
            away_middle_ = middle_of(away.layout);
        }
        find_away_places();
        if (home.layout.outside.size() == 1) turn_ = turn();
    }

    Layout layout() const
    {
        Layout between = home_.layout;
        for (const VertexId v : home_.solid.vertices())
            if (const auto& from = away_places_[v.index]) between.vertices[v.index] = placed(at_home(v), *from);
        for (const EdgeId e : home_.solid.edges())
            if (is_curved(home_, e) || (away_.solid.has(e) && is_curved(away_, e)))
                between.curves[e] = curve(e, between.vertices);
        for (auto& [f, rim] : between.outside) {
            const std::vector<Point>& other = away_.layout.outside.at(f);
            for (std::size_t i = 0; i < rim.size(); ++i) rim[i] = raised(blend(flat(rim[i]), flat(other[i]), share_));
        }
        return between;
    }

private:
    static Point raised(ui::Point p) { return {p.x, p.y, 0.0}; }
    static ui::Point middle_of(const Layout& layout)
    {
        const std::vector<Point>& rim = layout.outside.begin()->second;
        ui::Point sum;
        for (const Point& p : rim) sum = sum + flat(p);
        return (1.0 / static_cast<double>(rim.size())) * sum;
    }
    static bool is_curved(const DrawnInPlane& drawn, EdgeId e) { return drawn.layout.curves.contains(e); }
    static Path path(const DrawnInPlane& drawn, EdgeId e)
    {
        Path path;
        if (const auto curve = drawn.layout.curves.find(e); curve != drawn.layout.curves.end()) {
            for (const Point& p : curve->second) path.push_back(flat(p));
            return path;
        }
        for (const HalfEdgeId h : {drawn.solid.plus(e), drawn.solid.minus(e)})
            path.push_back(flat(drawn.layout.vertices[drawn.solid.start(h).index]));
        return path;
    }
    ui::Point at_home(VertexId v) const { return flat(home_.layout.vertices[v.index]); }

    // In rounds, since new vertices may hang on new ones: those that hang on old ones come first.
    void find_away_places()
    {
        away_places_.resize(home_.layout.vertices.size());
        for (const VertexId v : home_.solid.vertices())
            if (away_.solid.has(v)) away_places_[v.index] = flat(away_.layout.vertices[v.index]);
        for (bool has_grown = true; has_grown;) {
            auto next = away_places_;
            for (const VertexId v : home_.solid.vertices())
                if (!next[v.index]) next[v.index] = origin(v);
            has_grown = next != away_places_;
            away_places_ = std::move(next);
        }
    }

    // Where a vertex comes from that is not away.
    std::optional<ui::Point> origin(VertexId v) const
    {
        std::optional<ui::Point> neighbour;
        std::optional<EdgeId> divided;
        std::size_t n = 0;
        for (const HalfEdgeId h : home_.solid.fan(v)) {
            const auto e = home_.solid.edge(h);
            if (!e) continue;
            ++n;
            if (away_.solid.has(*e)) divided = e;
            else if (const auto& place = away_places_[home_.solid.end(h).index]) neighbour = place;
        }
        if (n == 2 && divided) return at_share(path(away_, *divided), 0.5);
        return neighbour;
    }

    // By which the drawing away is turned against that at home [rad].
    double turn() const
    {
        double sine = 0.0, cosine = 0.0;
        for (const VertexId v : home_.solid.vertices()) {
            if (!away_.solid.has(v)) continue;
            const ui::Point at = at_home(v) - home_middle_, other = *away_places_[v.index] - away_middle_;
            sine += ui::cross(at, other);
            cosine += at.x * other.x + at.y * other.y;
        }
        return std::atan2(sine, cosine);
    }

    Point placed(ui::Point at_home, ui::Point away) const
    {
        const ui::Point other = turned(away - away_middle_, -turn_);
        const ui::Point arm = turned(blend(at_home - home_middle_, other, share_), (1.0 - share_) * turn_);
        return raised(blend(home_middle_, away_middle_, share_) + arm);
    }

    // Each point goes its way; then the ends are brought to their vertices.
    std::vector<Point> curve(EdgeId e, const std::vector<Point>& vertices) const
    {
        const Path own = path(home_, e), other = away_.solid.has(e) ? path(away_, e) : own;
        const std::size_t n = std::max(own.size(), other.size());
        std::vector<Point> between;
        for (std::size_t i = 0; i < n; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(n - 1);
            between.push_back(placed(at_share(own, t), at_share(other, t)));
        }
        const auto off = [&](HalfEdgeId h, const Point& end) {
            return flat(vertices[home_.solid.start(h).index]) - flat(end);
        };
        const ui::Point at_start = off(home_.solid.plus(e), between.front()),
                        at_end = off(home_.solid.minus(e), between.back());
        for (std::size_t i = 0; i < n; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(n - 1);
            between[i] = raised(flat(between[i]) + blend(at_end, at_start, t));
        }
        return between;
    }

    DrawnInPlane home_, away_;
    double share_;
    double turn_ = 0.0;
    ui::Point home_middle_{}, away_middle_{};
    std::vector<std::optional<ui::Point>> away_places_; ///< by vertex
};

} // namespace

Layout layout_on_its_way(const DrawnInPlane& home, const DrawnInPlane& away, double share)
{
    if (!have_same_outside(home.layout, away.layout)) return home.layout;
    return OnItsWay(home, away, share).layout();
}

} // namespace euler
