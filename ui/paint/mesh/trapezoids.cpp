#include "ui/paint/mesh/trapezoids.h"

#include <algorithm>
#include <cstddef>

namespace ui {

namespace {

/// From its upper end to its lower one.
struct FallingEdge {
    Point from;
    Point to;

    double x_at(double y) const
    {
        if (y <= from.y) return from.x;
        if (y >= to.y) return to.x;
        return from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x);
    }
};

using EdgeIndex = std::size_t;

class LevelSweep {
public:
    explicit LevelSweep(std::span<const std::vector<Point>> loops)
    {
        for (const std::vector<Point>& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i) add(loop[i], loop[(i + 1) % loop.size()]);
        std::sort(edges_.begin(), edges_.end(),
                  [](const FallingEdge& a, const FallingEdge& b) { return a.from.y < b.from.y; });
        std::sort(levels_.begin(), levels_.end());
        levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
        open_.resize(edges_.size());
    }

    std::vector<Trapezoid> made()
    {
        for (std::size_t k = 0; k + 1 < levels_.size(); ++k) {
            const double y = levels_[k];
            std::erase_if(crossed_, [&](EdgeIndex e) { return edges_[e].to.y <= y; });
            for (; next_ < edges_.size() && edges_[next_].from.y <= y; ++next_) crossed_.push_back(next_);
            sort_at(0.5 * (y + levels_[k + 1]));
            pair_from(y);
        }
        if (!levels_.empty()) close_all(levels_.back());
        return std::move(made_);
    }

private:
    /// Since when the edge is the left side of what is filled, and which one is the right side.
    struct Filled {
        EdgeIndex right = 0;
        double from = 0.0;
        std::size_t seen = 0; ///< at which level last; 0: never
    };

    void add(Point a, Point b)
    {
        if (a.y == b.y) return; // level edges are sides of trapezoids by themselves
        edges_.push_back(a.y < b.y ? FallingEdge{a, b} : FallingEdge{b, a});
        levels_.insert(levels_.end(), {a.y, b.y});
    }

    /// They are almost sorted from level to level. Where edges begin at one place the middle of the strip decides.
    void sort_at(double y)
    {
        places_.resize(crossed_.size());
        for (std::size_t i = 0; i < crossed_.size(); ++i) {
            const EdgeIndex edge = crossed_[i];
            const double x = edges_[edge].x_at(y);
            std::size_t k = i;
            for (; k > 0 && places_[k - 1] > x; --k) {
                crossed_[k] = crossed_[k - 1];
                places_[k] = places_[k - 1];
            }
            crossed_[k] = edge;
            places_[k] = x;
        }
    }

    /// Pairs that stay go on; the others end here, and new ones begin.
    void pair_from(double y)
    {
        ++level_;
        std::vector<EdgeIndex>& ended = lefts_;
        begun_.clear();
        for (std::size_t i = 0; i + 1 < crossed_.size(); i += 2) {
            const EdgeIndex left = crossed_[i], right = crossed_[i + 1];
            Filled& filled = open_[left];
            const bool was_open = filled.seen != 0 && filled.seen + 1 == level_;
            if (was_open && filled.right != right) emit(left, filled, y);
            if (!was_open || filled.right != right) filled = {.right = right, .from = y};
            filled.seen = level_;
            begun_.push_back(left);
        }
        for (const EdgeIndex left : ended)
            if (open_[left].seen + 1 == level_) emit(left, open_[left], y);
        ended.swap(begun_);
    }

    void close_all(double y)
    {
        for (const EdgeIndex left : lefts_) emit(left, open_[left], y);
    }

    void emit(EdgeIndex left, const Filled& filled, double y)
    {
        const FallingEdge &l = edges_[left], &r = edges_[filled.right];
        const double top = filled.from;
        made_.push_back({.top = {Point{l.x_at(top), top}, Point{r.x_at(top), top}},
                         .bottom = {Point{l.x_at(y), y}, Point{r.x_at(y), y}}});
    }

    std::vector<FallingEdge> edges_; ///< by their upper ends
    std::vector<double> levels_;     ///< of all corners
    std::vector<EdgeIndex> crossed_; ///< by the level line, from left to right
    std::vector<double> places_;     ///< of those, in the middle of the strip
    std::vector<Filled> open_;       ///< of each edge as a left side
    std::vector<EdgeIndex> lefts_, begun_;
    std::vector<Trapezoid> made_;
    EdgeIndex next_ = 0;
    std::size_t level_ = 0;
};

} // namespace

std::vector<Trapezoid> trapezoids(std::span<const std::vector<Point>> loops) { return LevelSweep(loops).made(); }

} // namespace ui
