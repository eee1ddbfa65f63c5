#include "apps/euler/view/solid/paint_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace euler {

namespace {

constexpr double edge_on = 1e-4;    // cosine between normal and sight
constexpr double same_depth = 0.02; // [px] of depth, which rounding may make of nothing

std::optional<ui::Point> crossing(ui::Point a, ui::Point b, ui::Point c, ui::Point d)
{
    const ui::Point r = b - a, s = d - c;
    const double den = ui::cross(r, s);
    if (den == 0.0) return std::nullopt;
    const double t = ui::cross(c - a, s) / den, u = ui::cross(c - a, r) / den;
    if (t <= 0.0 || t >= 1.0 || u <= 0.0 || u >= 1.0) return std::nullopt;
    return a + t * r;
}

/// How much nearer to the eye a is than b, where that is most; positive where a lies in front.
class Comparison {
public:
    Comparison(const SeenPiece& a, const SeenPiece& b) : a_(a), b_(b)
    {
        look_at_corners(a, b);
        look_at_corners(b, a);
        look_at_crossings();
    }
    double nearer() const { return most_; }

private:
    void look_at(ui::Point p)
    {
        const double nearer = (*a_.plane)(p) - (*b_.plane)(p);
        if (std::abs(nearer) > std::abs(most_)) most_ = nearer;
    }
    /// Those of one that lie in the other.
    void look_at_corners(const SeenPiece& one, const SeenPiece& other)
    {
        for (const auto& loop : one.area)
            for (const ui::Point p : loop)
                if (other.bounds.contains(p) && is_inside(other.area, p)) look_at(p);
    }
    void look_at_crossings()
    {
        for_each_side(a_.area, [&](ui::Point a, ui::Point b) {
            for_each_side(b_.area, [&](ui::Point c, ui::Point d) {
                if (const auto at = crossing(a, b, c, d)) look_at(*at);
            });
        });
    }

    const SeenPiece& a_;
    const SeenPiece& b_;
    double most_ = 0.0;
};

/// Who has to be painted before whom.
struct Cover {
    std::vector<std::vector<std::size_t>> in_front_of;
    std::vector<int> n_behind;
};

Cover cover(std::span<const SeenPiece> pieces)
{
    Cover result{std::vector<std::vector<std::size_t>>(pieces.size()), std::vector<int>(pieces.size(), 0)};
    std::vector<std::size_t> by_x(pieces.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::sort(by_x.begin(), by_x.end(),
              [&](std::size_t a, std::size_t b) { return pieces[a].bounds.min.x < pieces[b].bounds.min.x; });
    const auto compare = [&](std::size_t i, std::size_t j) {
        if (!pieces[i].plane || !pieces[j].plane || !pieces[i].bounds.overlaps(pieces[j].bounds)) return;
        const double nearer = Comparison(pieces[i], pieces[j]).nearer();
        if (std::abs(nearer) < same_depth) return;
        const std::size_t front = nearer > 0.0 ? i : j, behind = nearer > 0.0 ? j : i;
        result.in_front_of[behind].push_back(front);
        ++result.n_behind[front];
    };
    for (std::size_t a = 0; a < by_x.size(); ++a)
        for (std::size_t b = a + 1; b < by_x.size() && pieces[by_x[b]].bounds.min.x < pieces[by_x[a]].bounds.max.x; ++b)
            compare(by_x[a], by_x[b]);
    return result;
}

std::vector<std::size_t> by_mean_depth(std::span<const SeenPiece> pieces)
{
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pieces[a].nearness < pieces[b].nearness; });
    return order;
}

} // namespace

std::optional<DepthPlane> depth_plane(const topology::Point& at, const topology::Vector& normal,
                                      const ViewTransform& transform)
{
    const double toward = dot(normal, transform.toward_eye());
    if (!(std::abs(toward) > edge_on * length(normal))) return std::nullopt;
    return DepthPlane{transform.to_sheet(at),
                      transform.scale() * transform.nearness(at),
                      {-dot(normal, transform.right()) / toward, dot(normal, transform.up()) / toward}};
}

/// Of those with nothing unpainted behind them the one seen from inside, and then the farthest, goes first.
std::vector<std::size_t> back_to_front(std::span<const SeenPiece> pieces)
{
    if (pieces.size() > most_compared) return by_mean_depth(pieces);
    Cover waiting = cover(pieces);
    using Turn = std::tuple<bool, double, std::size_t>;
    const auto turn = [&](std::size_t i) { return Turn{!pieces[i].is_back, pieces[i].nearness, i}; };
    std::set<Turn> ready, blocked;
    for (std::size_t i = 0; i < pieces.size(); ++i) (waiting.n_behind[i] == 0 ? ready : blocked).insert(turn(i));
    std::vector<std::size_t> order;
    while (!ready.empty() || !blocked.empty()) {
        std::set<Turn>& from = ready.empty() ? blocked : ready;
        const std::size_t next = std::get<std::size_t>(*from.begin());
        from.erase(from.begin());
        order.push_back(next);
        for (const std::size_t front : waiting.in_front_of[next])
            if (--waiting.n_behind[front] == 0 && blocked.erase(turn(front)) != 0) ready.insert(turn(front));
    }
    return order;
}

namespace {

constexpr std::size_t n_map_cells = 24; // of a map, along each side

std::size_t cell_of(double at, double min, double max)
{
    if (!(max > min)) return 0;
    const double place = std::floor(static_cast<double>(n_map_cells) * (at - min) / (max - min));
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(n_map_cells - 1)));
}

} // namespace

CoverMap::CoverMap(std::span<const SeenPiece> pieces) : pieces_(pieces), cells_(n_map_cells * n_map_cells)
{
    if (pieces.empty()) return;
    bounds_ = pieces.front().bounds;
    for (const SeenPiece& piece : pieces) bounds_ = ui::united(bounds_, piece.bounds);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Cell first = cell(pieces[i].bounds.min), last = cell(pieces[i].bounds.max);
        for (std::size_t row = first.row; row <= last.row; ++row)
            for (std::size_t column = first.column; column <= last.column; ++column)
                cells_[row * n_map_cells + column].push_back(i);
    }
}

CoverMap::Cell CoverMap::cell(ui::Point p) const
{
    return {cell_of(p.x, bounds_.min.x, bounds_.max.x), cell_of(p.y, bounds_.min.y, bounds_.max.y)};
}

bool CoverMap::is_covered(ui::Point at, double nearness) const
{
    constexpr double clearly = 0.5; // [px]
    const Cell here = cell(at);
    const std::vector<std::size_t>& near = cells_[here.row * n_map_cells + here.column];
    return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
        const SeenPiece& piece = pieces_[i];
        return piece.plane && piece.bounds.contains(at) && (*piece.plane)(at) > nearness + clearly &&
               is_inside(piece.area, at);
    });
}

} // namespace euler
