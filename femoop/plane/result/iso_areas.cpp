#include "femoop/plane/result/iso_areas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace femoop::plane {

namespace {

using Eigen::Vector2d;
using Half = std::uint32_t;

/// A triangle that a level crosses: along its border one half-edge leads down through the level and one leads up.
struct Crossed {
    Half down, up;
};

/// One level of a field.
class LevelSet {
public:
    LevelSet(const TriangulatedField& field, double level) : field_(field), level_(level) {}

    bool is_above(Half h) const { return field_.start_value(h) >= level_; }
    bool ends_above(Half h) const { return is_above(TriangulatedField::next(h)); }

    /// Whether the level crosses the triangle.
    bool is_crossed(std::size_t t) const
    {
        const auto& v = field_.values[t];
        const bool first = v[0] >= level_;
        return (v[1] >= level_) != first || (v[2] >= level_) != first;
    }
    Crossed crossing(std::size_t t) const
    {
        Crossed crossed{};
        for (Half k = 0; k < 3; ++k) {
            const Half h = static_cast<Half>(3 * t) + k;
            if (is_above(h) && !ends_above(h)) crossed.down = h;
            if (!is_above(h) && ends_above(h)) crossed.up = h;
        }
        return crossed;
    }

    Vector2d at_start(Half h) const { return field_.places[field_.start(h)]; }
    Vector2d at_crossing(Half h) const
    {
        const double a = field_.start_value(h), b = field_.end_value(h);
        const Vector2d &from = at_start(h), &to = at_start(TriangulatedField::next(h));
        // counted from the corner above, so that both sides of an edge find the same place
        return a > b ? from + (a - level_) / (a - b) * (to - from) : to + (b - level_) / (b - a) * (from - to);
    }

    bool is_continuous(Half h) const { return field_.is_continuous(h); }
    /// Is what lies above on this half-edge no border: the neighbour is above just there too?
    bool is_inner(Half h) const
    {
        const Half twin = field_.twins[h];
        if (twin == TriangulatedField::none) return false;
        const bool start = is_above(h), end = ends_above(h), twin_start = is_above(twin), twin_end = ends_above(twin);
        if (start != twin_end || end != twin_start) return false;
        return (start && end) || is_continuous(h);
    }

private:
    const TriangulatedField& field_;
    double level_;
};

/// Walks the borders of what lies above a level.
class BorderWalk {
public:
    BorderWalk(const TriangulatedField& field, double level)
        : field_(field), set_(field, level), is_walked_(field.triangles.size()), is_walked_edge_()
    {}

    std::vector<IsoLoop> loops()
    {
        is_walked_edge_.resize(field_.twins.size());
        for (std::size_t t = 0; t < field_.triangles.size(); ++t)
            if (!is_walked_[t] && set_.is_crossed(t)) walk_from(t);
        for (const Half h : field_.ends) {
            if (is_walked_edge_[h] || !set_.is_above(h) || !set_.ends_above(h) || set_.is_inner(h)) continue;
            loop_.clear();
            walk(h);
        }
        return std::move(loops_);
    }

private:
    void walk_from(std::size_t t)
    {
        loop_.clear();
        cross(t);
    }

    void add(const Vector2d& at)
    {
        if (loop_.empty() || loop_.back() != at) loop_.push_back(at);
    }

    /// Goes through triangles from crossing to crossing, then along borders, until it is where it began.
    void cross(std::size_t t)
    {
        while (!is_walked_[t]) {
            is_walked_[t] = true;
            const auto [down, up] = set_.crossing(t);
            add(set_.at_crossing(down));
            add(set_.at_crossing(up));
            if (set_.is_inner(up)) t = field_.twins[up] / 3;
            else return walk(up);
        }
        close();
    }

    /// Along half-edges that are border, from this one on.
    void walk(Half h)
    {
        while (!is_walked_edge_[h]) {
            is_walked_edge_[h] = true;
            if (set_.is_above(h)) add(set_.at_start(h));
            if (!set_.ends_above(h)) return cross(h / 3);
            h = turn(h);
        }
        close();
    }

    /// The border after this one, about its end: through neighbours as long as they are above there.
    Half turn(Half h) const
    {
        Half next = TriangulatedField::next(h);
        while (set_.is_inner(next)) next = TriangulatedField::next(field_.twins[next]);
        return next;
    }

    void close()
    {
        if (!loop_.empty() && loop_.front() == loop_.back()) loop_.pop_back();
        if (loop_.size() > 2) loops_.push_back(std::move(loop_));
        loop_.clear();
    }

    const TriangulatedField& field_;
    LevelSet set_;
    std::vector<bool> is_walked_, is_walked_edge_;
    IsoLoop loop_;
    std::vector<IsoLoop> loops_;
};

struct LoopBox {
    Vector2d low, high;
    explicit LoopBox(const IsoLoop& loop) : low(loop.front()), high(loop.front())
    {
        for (const Vector2d& at : loop) {
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
    }
    bool contains(const LoopBox& other) const
    {
        return (low.array() <= other.low.array()).all() && (high.array() >= other.high.array()).all();
    }
};

bool encloses_place(const IsoLoop& loop, const Vector2d& p)
{
    bool is_inside = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vector2d &a = loop[i], &b = loop[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            is_inside = !is_inside;
    }
    return is_inside;
}

/// Whether most of some places of a loop lie in another: they may touch.
bool encloses_loop(const IsoLoop& outer, const IsoLoop& inner)
{
    constexpr std::size_t most = 5;
    const std::size_t step = 1 + inner.size() / most;
    int votes = 0;
    for (std::size_t i = 0; i < inner.size(); i += step)
        votes += encloses_place(outer, 0.5 * (inner[i] + inner[(i + 1) % inner.size()])) ? 1 : -1;
    return votes > 0;
}

std::vector<IsoArea> sorted_areas(std::vector<IsoLoop> loops)
{
    std::vector<IsoArea> areas;
    std::vector<IsoLoop> holes;
    for (IsoLoop& loop : loops) {
        if (area(loop) > 0.0) areas.push_back({std::move(loop), {}});
        else holes.push_back(std::move(loop));
    }
    if (holes.empty()) return areas;
    std::ranges::sort(areas, {}, [](const IsoArea& a) { return area(a.outside); }); // the innermost first
    std::vector<LoopBox> boxes;
    for (const IsoArea& one : areas) boxes.emplace_back(one.outside);
    for (IsoLoop& hole : holes) {
        const LoopBox box(hole);
        for (std::size_t i = 0; i < areas.size(); ++i)
            if (boxes[i].contains(box) && encloses_loop(areas[i].outside, hole)) {
                areas[i].holes.push_back(std::move(hole));
                break;
            }
    }
    return areas;
}

/// Lines of one level, piece by piece through triangles.
class LineWalk {
public:
    LineWalk(const TriangulatedField& field, double level)
        : field_(field), set_(field, level), is_walked_(field.triangles.size())
    {}

    std::vector<std::vector<Vector2d>> lines()
    {
        // those with an end first: else a walk from their middle would cut them
        for (const bool must_begin : {true, false})
            for (std::size_t t = 0; t < field_.triangles.size(); ++t)
                if (!is_walked_[t] && set_.is_crossed(t) && (!must_begin || !set_.is_continuous(set_.crossing(t).down)))
                    walk(t);
        return std::move(lines_);
    }

private:
    void walk(std::size_t t)
    {
        std::vector<Vector2d> line{set_.at_crossing(set_.crossing(t).down)};
        while (!is_walked_[t]) {
            is_walked_[t] = true;
            const Half up = set_.crossing(t).up;
            const Vector2d at = set_.at_crossing(up);
            if (at != line.back()) line.push_back(at);
            if (!set_.is_continuous(up)) break;
            t = field_.twins[up] / 3;
        }
        if (line.size() > 1) lines_.push_back(std::move(line));
    }

    const TriangulatedField& field_;
    LevelSet set_;
    std::vector<bool> is_walked_;
    std::vector<std::vector<Vector2d>> lines_;
};

} // namespace

double area(const IsoLoop& loop)
{
    double twice = 0.0;
    for (std::size_t i = 2; i < loop.size(); ++i) {
        const Vector2d a = loop[i - 1] - loop[0], b = loop[i] - loop[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

std::vector<IsoLoop> loops_above(const TriangulatedField& field, double level)
{
    return BorderWalk(field, level).loops();
}

std::vector<IsoArea> areas_above(const TriangulatedField& field, double level)
{
    return sorted_areas(loops_above(field, level));
}

std::vector<std::vector<Vector2d>> iso_lines(const TriangulatedField& field, double level)
{
    return LineWalk(field, level).lines();
}

} // namespace femoop::plane
