#include "ui/paint/mesh/polygon_mesh.h"

#include "ui/paint/mesh/trapezoids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace ui {

namespace {

constexpr double same_place = 1e-4;    // [px]
constexpr double smallest_area = 1e-6; // [px^2], twice
constexpr double longest_shift = 2.0;  // of a corner's soft border, in half pixels

std::vector<Point> without_repeats(std::span<const Point> polygon)
{
    std::vector<Point> kept;
    kept.reserve(polygon.size());
    for (const Point p : polygon)
        if (kept.empty() || distance(kept.back(), p) > same_place) kept.push_back(p);
    while (kept.size() > 1 && distance(kept.back(), kept.front()) <= same_place) kept.pop_back();
    return kept;
}

/// Convex and going round once.
bool is_convex(std::span<const Point> polygon)
{
    const std::size_t n = polygon.size();
    int sign = 0, x_flips = 0, last_x = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = polygon[i], b = polygon[(i + 1) % n], c = polygon[(i + 2) % n];
        const double turn = cross(b - a, c - b);
        const int s = turn > 0.0 ? 1 : (turn < 0.0 ? -1 : 0);
        if (s != 0 && sign != 0 && s != sign) return false;
        if (s == 0 && dot(b - a, c - b) < 0.0) return false; // straight back
        if (s != 0) sign = s;
        const int dx = b.x > a.x ? 1 : (b.x < a.x ? -1 : 0);
        if (dx != 0 && last_x != 0 && dx != last_x) ++x_flips;
        if (dx != 0) last_x = dx;
    }
    return x_flips <= 2; // a star turns one way as well, but swings in x more often
}

/// Where two segments cross inside both.
std::optional<Point> crossing(Point a, Point b, Point c, Point d)
{
    const Point r = b - a, s = d - c;
    const double den = cross(r, s);
    if (den == 0.0) return std::nullopt;
    const double t = cross(c - a, s) / den, u = cross(c - a, r) / den;
    constexpr double inside = 1e-9;
    if (t <= inside || t >= 1.0 - inside || u <= inside || u >= 1.0 - inside) return std::nullopt;
    return a + t * r;
}

double distance_to_edge(Point p, Point a, Point b)
{
    const Point along = b - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    return distance(p, a + t * along);
}

/// Edges i < j of a loop meet in a point; edge k runs from corner k to the next.
struct Meeting {
    std::size_t i;
    std::size_t j;
    Point at;
};

/// A corner that lies on an edge it is no end of, or on another corner.
std::optional<Meeting> first_touch(const std::vector<Point>& loop)
{
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = loop[i], b = loop[(i + 1) % n];
        const Box near = united({a, a}, {b, b}).grown(same_place);
        for (std::size_t k = 0; k < n; ++k) {
            const Point p = loop[k];
            if (!near.contains(p) || k == i || k == (i + 1) % n) continue;
            if (distance_to_edge(p, a, b) <= same_place) return k > i ? Meeting{i, k - 1, p} : Meeting{k, i, p};
        }
    }
    return std::nullopt;
}

std::optional<Meeting> first_crossing(const std::vector<Point>& loop)
{
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
        const Point a = loop[i], b = loop[i + 1];
        const Box reach = united({a, a}, {b, b});
        for (std::size_t j = i + 2; j < n; ++j) {
            const Point c = loop[j], d = loop[(j + 1) % n];
            if (intersection(reach, united({c, c}, {d, d})).is_empty() || (i == 0 && j == n - 1)) continue;
            if (const auto at = crossing(a, b, c, d)) return Meeting{i, j, *at};
        }
    }
    return std::nullopt;
}

/// Touches come first: where edges retrace each other, a crossing found by rounding would cut slivers.
std::optional<Meeting> first_meeting(const std::vector<Point>& loop)
{
    const auto touch = first_touch(loop);
    return touch ? touch : first_crossing(loop);
}

/// Inside the ear a-b-c or on its third side, which would then pass a corner: the rest would fold back on itself.
bool is_in_the_way(Point p, Point a, Point b, Point c, double sense)
{
    return sense * cross(b - a, p - a) > 0.0 && sense * cross(c - b, p - b) > 0.0 && sense * cross(a - c, p - c) >= 0.0;
}

/// The corners that are left while ears are cut off.
class EarClipper {
public:
    explicit EarClipper(std::span<const Point> polygon)
        : polygon_(polygon), sense_(twice_area(polygon) >= 0.0 ? 1.0 : -1.0), left_(polygon.size())
    {
        std::iota(left_.begin(), left_.end(), std::uint32_t{0});
    }

    std::vector<std::array<std::uint32_t, 3>> triangles()
    {
        std::vector<std::array<std::uint32_t, 3>> result;
        while (left_.size() >= 3) {
            const std::size_t k = next_ear();
            result.push_back(corner(k));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
            from_ = left_.empty() ? 0 : (k + left_.size() - 1) % left_.size();
        }
        return result;
    }

private:
    std::array<std::uint32_t, 3> corner(std::size_t k) const
    {
        const std::size_t n = left_.size();
        return {left_[(k + n - 1) % n], left_[k], left_[(k + 1) % n]};
    }

    double turn(std::size_t k) const
    {
        const auto [a, b, c] = corner(k);
        return sense_ * cross(polygon_[b] - polygon_[a], polygon_[c] - polygon_[b]);
    }

    bool is_ear(std::size_t k) const
    {
        if (turn(k) <= 0.0) return false;
        const auto [a, b, c] = corner(k);
        for (const std::uint32_t i : left_) {
            if (i == a || i == b || i == c) continue;
            if (is_in_the_way(polygon_[i], polygon_[a], polygon_[b], polygon_[c], sense_)) return false;
        }
        return true;
    }

    /// Where rounding leaves no ear, the flattest corner goes: nothing visible is lost with it.
    std::size_t next_ear() const
    {
        const std::size_t n = left_.size();
        for (std::size_t step = 0; step < n; ++step)
            if (const std::size_t k = (from_ + step) % n; is_ear(k)) return k;
        std::size_t flattest = 0;
        for (std::size_t k = 1; k < n; ++k)
            if (std::abs(turn(k)) < std::abs(turn(flattest))) flattest = k;
        return flattest;
    }

    std::span<const Point> polygon_;
    double sense_;
    std::vector<std::uint32_t> left_;
    std::size_t from_ = 0;
};

/// For each corner the shift that moves both its edges outward by one.
std::vector<Point> outward_shifts(const std::vector<Point>& loop)
{
    const std::size_t n = loop.size();
    const double sense = twice_area(loop) > 0.0 ? 1.0 : -1.0;
    std::vector<Point> shifts(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Point before = direction(loop[i] - loop[(i + n - 1) % n]);
        const Point after = direction(loop[(i + 1) % n] - loop[i]);
        const Point n0 = sense * left_normal(before), n1 = sense * left_normal(after);
        const Point sum = n0 + n1;
        const double c = 1.0 + dot(n0, n1);
        shifts[i] = c > 1e-6 ? sum / c : before;
        const double l = length(shifts[i]);
        if (l > longest_shift) shifts[i] = (longest_shift / l) * shifts[i];
    }
    return shifts;
}

/// The inside of a loop, of which vertex i of the loop is vertex `first + stride i` of the mesh.
void add_inside(Mesh& mesh, const std::vector<Point>& loop, std::uint32_t first, std::uint32_t stride)
{
    const auto vertex = [&](std::uint32_t i) { return first + stride * i; };
    if (is_convex(loop)) {
        for (std::uint32_t i = 1; i + 1 < loop.size(); ++i) mesh.triangle(vertex(0), vertex(i), vertex(i + 1));
    } else {
        for (const auto& [a, b, c] : triangulation(loop)) mesh.triangle(vertex(a), vertex(b), vertex(c));
    }
}

void add_loop(Mesh& mesh, const std::vector<Point>& loop, Border border)
{
    const auto n = static_cast<std::uint32_t>(loop.size());
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    if (border == Border::Hard) {
        for (const Point p : loop) mesh.add(p, 1.0);
        return add_inside(mesh, loop, first, 1);
    }
    const std::vector<Point> out = outward_shifts(loop);
    for (std::uint32_t i = 0; i < n; ++i) {
        mesh.add(loop[i] - 0.5 * out[i], 1.0);
        mesh.add(loop[i] + 0.5 * out[i], 0.0);
    }
    add_inside(mesh, loop, first, 2);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % n);
        mesh.quad(a, a + 1, b + 1, b);
    }
}

} // namespace

double twice_area(std::span<const Point> polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
        sum += cross(a, b);
    }
    return sum;
}

std::vector<std::vector<Point>> simple_loops(std::span<const Point> polygon)
{
    constexpr std::size_t most_loops = 1000;
    std::vector<std::vector<Point>> open{without_repeats(polygon)}, simple;
    while (!open.empty()) {
        std::vector<Point> loop = std::move(open.back());
        open.pop_back();
        if (loop.size() < 3) continue;
        const auto cut = simple.size() + open.size() < most_loops ? first_meeting(loop) : std::nullopt;
        if (!cut) {
            if (std::abs(twice_area(loop)) > smallest_area) simple.push_back(std::move(loop));
            continue;
        }
        const auto at = [&](std::size_t k) { return loop.begin() + static_cast<std::ptrdiff_t>(k); };
        std::vector<Point> inner(at(cut->i + 1), at(cut->j + 1)), outer(loop.begin(), at(cut->i + 1));
        inner.push_back(cut->at);
        outer.push_back(cut->at);
        outer.insert(outer.end(), at(cut->j + 1), loop.end());
        open.push_back(without_repeats(outer));
        open.push_back(without_repeats(inner));
    }
    return simple;
}

std::vector<std::array<std::uint32_t, 3>> triangulation(std::span<const Point> polygon)
{
    return EarClipper(polygon).triangles();
}

void add_fill(Mesh& mesh, std::span<const Point> polygon, Border border)
{
    const std::vector<Point> clean = without_repeats(polygon);
    if (clean.size() < 3) return;
    if (is_convex(clean)) return add_loop(mesh, clean, border);
    for (const auto& loop : simple_loops(clean)) add_loop(mesh, loop, border);
}

void add_region(Mesh& mesh, std::span<const std::vector<Point>> loops)
{
    for (const auto& [top, bottom] : trapezoids(loops)) {
        const bool has_top = top[0] != top[1], has_bottom = bottom[0] != bottom[1];
        if (!has_top && !has_bottom) continue;
        const std::uint32_t a = mesh.add(top[0], 1.0), b = has_top ? mesh.add(top[1], 1.0) : a;
        const std::uint32_t c = mesh.add(bottom[1], 1.0), d = has_bottom ? mesh.add(bottom[0], 1.0) : c;
        if (has_top) mesh.triangle(a, b, c);
        if (has_bottom) mesh.triangle(a, c, d);
    }
}

void add_disc(Mesh& mesh, Point center, double radius)
{
    const double reach = radius + 0.5;
    const double step = 2.0 * std::acos(1.0 - std::min(0.5, 0.12 / reach));
    const int n = std::max(6, static_cast<int>(std::ceil(2.0 * std::numbers::pi / step)));
    const double outer = reach * 2.0 / (1.0 + std::cos(std::numbers::pi / n)); // as far outside as inside the circle
    const std::uint32_t middle = mesh.add(center, 1.0, 0.0, reach);
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n;
        mesh.add(center + outer * Point{std::cos(angle), std::sin(angle)}, 1.0, reach, reach);
    }
    for (int i = 0; i < n; ++i)
        mesh.triangle(middle, middle + 1 + static_cast<std::uint32_t>(i),
                      middle + 1 + static_cast<std::uint32_t>((i + 1) % n));
}

} // namespace ui
