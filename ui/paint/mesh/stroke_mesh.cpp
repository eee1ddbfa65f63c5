#include "ui/paint/mesh/stroke_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace ui {

namespace {

constexpr double shortest_segment = 1e-3; // [px]
constexpr double miter_limit = 4.0;       // as in SVG: from the inner to the outer corner, in widths
constexpr double gentle_turn = 0.96;      // cosine above which every join is a miter
constexpr double roundness = 0.12;        // [px] that a round border may be off
constexpr double thin = 2.6;              // [px]
constexpr std::size_t most_dashes = 100'000;

std::vector<Point> without_repeats(std::span<const Point> points, PathEnds ends)
{
    std::vector<Point> kept;
    kept.reserve(points.size());
    for (const Point p : points)
        if (kept.empty() || distance(kept.back(), p) > shortest_segment) kept.push_back(p);
    while (ends == PathEnds::Closed && kept.size() > 1 && distance(kept.back(), kept.front()) <= shortest_segment)
        kept.pop_back();
    return kept;
}

Point turned(Point v, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Strip builder; a rib is given by where its left and right ends lie from a point of the line, in reaches.
class Strip {
public:
    Strip(Mesh& mesh, double width)
        : mesh_(mesh), reach_(0.5 * std::max(width, 1.0) + 0.5), coverage_(std::min(width, 1.0))
    {}

    double reach() const { return reach_; }

    void rib(Point at, Point left, Point right) { rib(at, left, right, coverage_); }
    /// Where the line has faded out.
    void faded_rib(Point at, Point left, Point right) { rib(at, left, right, 0.0); }
    /// Joins the last rib to the first.
    void close()
    {
        if (first_) join(*last_, *first_);
    }
    /// A half disc about `at`, from one side of the line over `outward` to the other.
    void half_disc(Point at, Point outward)
    {
        const int n = std::max(3, n_steps(std::numbers::pi));
        const std::uint32_t middle = mesh_.add(at, coverage_, 0.0, reach_);
        const Point start = left_normal(outward);
        std::uint32_t last = border(at, start);
        for (int i = 1; i <= n; ++i) {
            const std::uint32_t next = border(at, turned(start, std::numbers::pi * i / n));
            mesh_.triangle(middle, last, next);
            last = next;
        }
    }
    /// Steps that a turn by `angle` takes for its border to look round.
    int n_steps(double angle) const
    {
        const double step = 2.0 * std::acos(1.0 - std::min(0.5, roundness / reach_));
        return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
    }

private:
    using Rib = std::array<std::uint32_t, 2>;

    std::uint32_t border(Point at, Point direction)
    {
        return mesh_.add(at + reach_ * direction, coverage_, reach_, reach_);
    }

    void rib(Point at, Point left, Point right, double coverage)
    {
        const Rib rib = {mesh_.add(at + reach_ * left, coverage, -reach_, reach_),
                         mesh_.add(at + reach_ * right, coverage, reach_, reach_)};
        if (last_) join(*last_, rib);
        if (!first_) first_ = rib;
        last_ = rib;
    }

    void join(const Rib& a, const Rib& b) { mesh_.quad(a[0], a[1], b[1], b[0]); }

    Mesh& mesh_;
    double reach_;
    double coverage_;
    std::optional<Rib> first_;
    std::optional<Rib> last_;
};

/// A corner of the line: its place, the directions before and after, and the shorter neighbour's length.
struct Corner {
    Point at;
    Point before;
    Point after;
    double room;
};

/// Ribs with a fixed inner side and an outer side that goes from one normal to the other.
void fan_ribs(Strip& strip, const Corner& corner, Join join, const std::optional<Point>& inner)
{
    const Point n0 = left_normal(corner.before), n1 = left_normal(corner.after);
    const double angle = std::atan2(cross(corner.before, corner.after), dot(corner.before, corner.after));
    const int n = join == Join::Round ? strip.n_steps(angle) : 1;
    for (int i = 0; i <= n; ++i) {
        const Point normal = i == 0 ? n0 : (i == n ? n1 : turned(n0, angle * i / n));
        const bool turns_right = angle > 0.0; // y down: a positive cross product is a turn to the right
        if (turns_right) strip.rib(corner.at, normal, inner.value_or(-normal));
        else strip.rib(corner.at, inner.value_or(normal), -normal);
    }
}

void corner_ribs(Strip& strip, const Corner& corner, Join join)
{
    const double c = dot(corner.before, corner.after), s = cross(corner.before, corner.after);
    if (1.0 + c < 1e-6) return fan_ribs(strip, corner, join, std::nullopt); // straight back
    const Point miter = (left_normal(corner.before) + left_normal(corner.after)) / (1.0 + c);
    const double retraction = strip.reach() * std::abs(s) / (1.0 + c);
    const bool inner_fits = retraction <= corner.room;
    const bool outer_is_miter = c > gentle_turn || (join == Join::Miter && length(miter) <= miter_limit);
    if (outer_is_miter && inner_fits) return strip.rib(corner.at, miter, -miter);
    const std::optional<Point> inner = s > 0.0 ? -miter : miter;
    fan_ribs(strip, corner, outer_is_miter ? Join::Round : join, inner_fits ? inner : std::nullopt);
}

enum class End { First, Last };

/// `outward` points away from the line. A round cap lies beyond the end's rib; a straight one fades out over a pixel,
/// which on thin lines nobody sees.
void cap_ribs(Strip& strip, Point at, Point outward, End end, const StrokeShape& shape)
{
    const Point n = end == End::First ? left_normal(-outward) : left_normal(outward);
    if (shape.cap == Cap::Round) {
        strip.half_disc(at, outward);
        return strip.rib(at, n, -n);
    }
    const Point tip = at + (shape.cap == Cap::Square ? 0.5 * shape.width : 0.0) * outward;
    if (shape.width < thin) return strip.rib(tip, n, -n);
    const Point faded = tip + 0.5 * outward, full = tip - 0.5 * outward;
    if (end == End::First) strip.faded_rib(faded, n, -n);
    strip.rib(full, n, -n);
    if (end == End::Last) strip.faded_rib(faded, n, -n);
}

/// Most lines of a picture: straight, thin, with straight ends.
bool is_plain_line(std::span<const Point> points, const StrokeShape& shape)
{
    return points.size() == 2 && shape.cap == Cap::Butt && shape.width < thin &&
           distance(points[0], points[1]) > shortest_segment;
}

void add_plain_line(Mesh& mesh, Point a, Point b, double width)
{
    const Point n = left_normal(direction(b - a));
    Strip strip(mesh, width);
    strip.rib(a, n, -n);
    strip.rib(b, n, -n);
}

void add_dot(Mesh& mesh, Point at, const StrokeShape& shape)
{
    if (shape.cap == Cap::Butt) return;
    Strip strip(mesh, shape.width);
    cap_ribs(strip, at, {-1.0, 0.0}, End::First, shape);
    cap_ribs(strip, at, {1.0, 0.0}, End::Last, shape);
}

} // namespace

void add_stroke(Mesh& mesh, std::span<const Point> points, PathEnds ends, const StrokeShape& shape)
{
    if (is_plain_line(points, shape)) return add_plain_line(mesh, points[0], points[1], shape.width);
    const std::vector<Point> line = without_repeats(points, ends);
    const std::size_t n = line.size();
    if (n == 0) return;
    if (n == 1) return add_dot(mesh, line.front(), shape);
    const bool is_closed = ends == PathEnds::Closed && n > 2;
    const auto segment = [&](std::size_t i) { return line[(i + 1) % n] - line[i]; };
    const auto corner = [&](std::size_t i) {
        const Point before = segment((i + n - 1) % n), after = segment(i);
        return Corner{line[i], direction(before), direction(after), std::min(length(before), length(after))};
    };
    Strip strip(mesh, shape.width);
    if (!is_closed) cap_ribs(strip, line[0], -direction(segment(0)), End::First, shape);
    for (std::size_t i = is_closed ? 0 : 1; i < (is_closed ? n : n - 1); ++i) corner_ribs(strip, corner(i), shape.join);
    if (is_closed) strip.close();
    else cap_ribs(strip, line[n - 1], direction(segment(n - 2)), End::Last, shape);
}

namespace {

/// Walks along a dash pattern.
class DashWalk {
public:
    DashWalk(const DashPattern& pattern, double offset) : lengths_(pattern.lengths())
    {
        double rest = std::fmod(offset, pattern.period());
        while (rest >= lengths_[at_]) {
            rest -= lengths_[at_];
            at_ = (at_ + 1) % lengths_.size();
        }
        left_ = lengths_[at_] - rest;
    }

    bool is_drawn() const { return at_ % 2 == 0; }
    double left() const { return left_; }
    void walk(double length) { left_ -= length; }
    void turn()
    {
        at_ = (at_ + 1) % lengths_.size();
        left_ = lengths_[at_];
    }

private:
    std::span<const double> lengths_;
    std::size_t at_ = 0;
    double left_ = 0.0;
};

} // namespace

std::vector<std::vector<Point>> dashes_of(const Path& path, const DashPattern& pattern)
{
    std::vector<Point> line(path.points.begin(), path.points.end());
    if (path.ends == PathEnds::Closed && !line.empty()) line.push_back(line.front());
    std::vector<std::vector<Point>> dashes;
    if (line.size() < 2) return dashes;
    DashWalk walk(pattern, std::max(0.0, path.dash_offset));
    if (walk.is_drawn()) dashes.push_back({line.front()});
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double whole = distance(line[i], line[i + 1]);
        double walked = 0.0;
        while (whole - walked > walk.left()) {
            walked += walk.left();
            const Point at = line[i] + (walked / whole) * (line[i + 1] - line[i]);
            if (walk.is_drawn()) dashes.back().push_back(at);
            walk.turn();
            if (dashes.size() >= most_dashes) return dashes;
            if (walk.is_drawn()) dashes.push_back({at});
        }
        walk.walk(whole - walked);
        if (walk.is_drawn()) dashes.back().push_back(line[i + 1]);
    }
    return dashes;
}

} // namespace ui
