#include "ui/paint/mesh/keyhole.h"

#include "ui/paint/mesh/polygon_mesh.h"

#include <algorithm>

namespace ui {

namespace {

using Walk = std::vector<LoopCorner>;

bool cross_inside(Point a, Point b, Point c, Point d)
{
    const auto side = [](Point p, Point q, Point r) { return cross(q - p, r - p); };
    return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

/// Between a corner of the outline and one of a hole, by their places in the two walks.
struct Slit {
    std::size_t hole;
    std::size_t from;
    std::size_t to;
    double length;
};

class Keyhole {
public:
    explicit Keyhole(std::span<const std::vector<Point>> loops) : loops_(loops)
    {
        for (std::size_t l = 0; l < loops.size(); ++l)
            if (!loops[l].empty()) holes_.push_back(walk(l));
    }

    Walk outline()
    {
        if (holes_.empty()) return {};
        outline_ = std::move(holes_.front());
        holes_.erase(holes_.begin());
        while (!holes_.empty()) enter(best_slit());
        return outline_;
    }

private:
    Point at(LoopCorner c) const { return loops_[c.loop][c.corner]; }

    /// The outer loop as it was given, holes against it.
    Walk walk(std::size_t l) const
    {
        Walk corners(loops_[l].size());
        for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = {l, i};
        const bool is_outer = holes_.empty();
        if (!is_outer && (twice_area(loops_[l]) > 0.0) == (twice_area(loops_[holes_.front().front().loop]) > 0.0))
            std::reverse(corners.begin(), corners.end());
        return corners;
    }

    bool meets(Point a, Point b, const Walk& walk) const
    {
        for (std::size_t i = 0; i < walk.size(); ++i)
            if (cross_inside(a, b, at(walk[i]), at(walk[(i + 1) % walk.size()]))) return true;
        return false;
    }

    bool is_free(const Slit& slit) const
    {
        const Point a = at(outline_[slit.from]), b = at(holes_[slit.hole][slit.to]);
        return !meets(a, b, outline_) &&
               std::none_of(holes_.begin(), holes_.end(), [&](const Walk& hole) { return meets(a, b, hole); });
    }

    /// The shortest that crosses nothing; the shortest of all where each crosses something.
    Slit best_slit() const
    {
        std::vector<Slit> slits;
        for (std::size_t h = 0; h < holes_.size(); ++h)
            for (std::size_t i = 0; i < outline_.size(); ++i)
                for (std::size_t j = 0; j < holes_[h].size(); ++j)
                    slits.push_back({h, i, j, distance(at(outline_[i]), at(holes_[h][j]))});
        std::stable_sort(slits.begin(), slits.end(), [](const Slit& a, const Slit& b) { return a.length < b.length; });
        const auto found = std::find_if(slits.begin(), slits.end(), [&](const Slit& slit) { return is_free(slit); });
        return found != slits.end() ? *found : slits.front();
    }

    void enter(const Slit& slit)
    {
        const Walk& hole = holes_[slit.hole];
        Walk detour;
        for (std::size_t k = 0; k <= hole.size(); ++k) detour.push_back(hole[(slit.to + k) % hole.size()]);
        detour.push_back(outline_[slit.from]);
        outline_.insert(outline_.begin() + static_cast<std::ptrdiff_t>(slit.from + 1), detour.begin(), detour.end());
        holes_.erase(holes_.begin() + static_cast<std::ptrdiff_t>(slit.hole));
    }

    std::span<const std::vector<Point>> loops_;
    Walk outline_;
    std::vector<Walk> holes_;
};

} // namespace

std::vector<LoopCorner> keyhole(std::span<const std::vector<Point>> loops) { return Keyhole(loops).outline(); }

} // namespace ui
