// The band between the largest and the smallest value of all cases.
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace drawing {

namespace {

using femoop::Curve;
using femoop::MemberComponent;
using femoop::Side;

/// A value, and the place among the cases of the one that makes it; of equal ones the first.
struct Bound {
    double value = 0.0;
    std::size_t made_by = 0;
    friend bool operator==(const Bound&, const Bound&) = default;
};

struct Range {
    double x = 0.0;
    Bound least, most;
    friend bool operator==(const Range&, const Range&) = default;
};

Range range_at(const std::vector<SolvedCase>& cases, femoop::MemberId member, MemberComponent component, double x,
               Side side)
{
    Range range{.x = x};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double value = cases[i][member].value(component, x, side);
        if (i == 0 || value < range.least.value) range.least = {value, i};
        if (i == 0 || value > range.most.value) range.most = {value, i};
    }
    return range;
}

/// Places along a member at which the band has its corners: the load points, the extremes and the points between.
std::vector<double> places(const std::vector<SolvedCase>& cases, femoop::MemberId member, MemberComponent component)
{
    constexpr int n_between = 40;
    const double length = cases.front()[member].length();
    std::vector<double> all;
    for (int i = 0; i <= n_between; ++i) all.push_back(length * i / n_between);
    for (const SolvedCase& solved : cases) {
        const Curve& curve = solved[member];
        for (const double x : curve.breaks()) all.push_back(x);
        const femoop::Extremes extremes = curve.extremes(component);
        all.insert(all.end(), {extremes.max.x, extremes.min.x});
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Both sides of each place, so that jumps stand upright.
std::vector<Range> band(const std::vector<SolvedCase>& cases, femoop::MemberId member, MemberComponent component)
{
    std::vector<Range> ranges;
    for (const double x : places(cases, member, component)) {
        for (const Side side : {Side::Before, Side::After}) {
            const Range range = range_at(cases, member, component, x, side);
            const bool is_told = !ranges.empty() && ranges.back() == range;
            if (!is_told) ranges.push_back(range);
        }
    }
    return ranges;
}

class BandPicture {
public:
    BandPicture(const Scene& scene, const std::vector<SolvedCase>& cases, femoop::MemberId member,
                const Diagram& diagram)
        : scene_(scene),
          cases_(cases),
          diagram_(diagram),
          frame_(diagram_frame(scene, scene.shape[member], diagram.component)),
          band_(band(cases, member, diagram.component))
    {}

    void draw() const
    {
        std::vector<ui::Point> most, least;
        for (const Range& range : band_) {
            most.push_back(at(range.x, range.most.value));
            least.push_back(at(range.x, range.least.value));
        }
        std::vector<ui::Point> area = most;
        area.insert(area.end(), least.rbegin(), least.rend());
        Sketch& sketch = scene_.sketch;
        const ui::Role role = role_of(diagram_.component);
        {
            const ui::LayerScope layer(sketch.painter(), ui::Layer::Areas);
            sketch.polygon(area, sketch.theme().fill(role), Clearance::Soft);
        }
        sketch.polyline(area, sketch.stroke(role), Clearance::Hard, ui::PathEnds::Closed);
        if (!scene_.shows(Show::Values)) return;
        write_marks({&Range::most, 1.0});
        write_marks({&Range::least, -1.0});
    }

private:
    /// One of the two lines of the band; the sign is that of the way out of it.
    struct Line {
        Bound Range::*bound;
        double sign;
    };

    ui::Point at(double x, double value) const
    {
        return frame_(x * scene_.projection.scale(), value * diagram_.pixels_per_unit);
    }
    double rounding() const { return 1e-4 * diagram_.largest; }
    double outward(const Line& line, std::size_t i) const { return line.sign * (band_[i].*line.bound).value; }

    // The ends, and every place from which the line falls back on both sides.
    bool is_marked(const Line& line, std::size_t i) const
    {
        if (i == 0 || i + 1 == band_.size()) return true;
        const double here = outward(line, i);
        return here - outward(line, i - 1) > rounding() && here - outward(line, i + 1) > rounding();
    }

    void write_marks(const Line& line) const
    {
        std::size_t peak = 0;
        for (std::size_t i = 1; i < band_.size(); ++i)
            if (outward(line, i) > outward(line, peak) + rounding()) peak = i;
        for (std::size_t i = 0; i < band_.size(); ++i) {
            const bool is_closed = band_[i].most.value - band_[i].least.value < rounding();
            const bool is_said_by_other = is_closed && line.sign < 0.0;
            if (i == peak || (is_marked(line, i) && !is_said_by_other))
                write(band_[i].x, band_[i].*line.bound, line, i == peak ? Rank::Extreme : Rank::Value);
        }
    }

    void write(double x, const Bound& bound, const Line& line, Rank rank) const
    {
        if (std::abs(bound.value) < rounding()) return;
        const bool is_largest = std::abs(bound.value) > diagram_.largest - rounding();
        scene_.sketch.caption({.text = words(bound),
                               .role = role_of(diagram_.component),
                               .target = at(x, bound.value),
                               .toward = line.sign * frame_.y,
                               .gap = 4.5,
                               .rank = is_largest ? Rank::Largest : rank});
    }

    // "58.5 (G)"
    std::string words(const Bound& bound) const
    {
        const double shown = has_signs(scene_, diagram_.component) ? bound.value : std::abs(bound.value);
        const std::string number = scene_.number(shown, measure_of(diagram_.component));
        return cases_.size() == 1 ? number : governed(number, cases_[bound.made_by].result.name());
    }

    const Scene& scene_;
    const std::vector<SolvedCase>& cases_;
    const Diagram& diagram_;
    SymbolFrame frame_;
    std::vector<Range> band_;
};

} // namespace

Diagram envelope_diagram(const Scene& scene, const std::vector<SolvedCase>& cases, MemberComponent component,
                         ui::Size panel)
{
    Diagram widest;
    for (const SolvedCase& solved : cases) {
        const Diagram diagram = make_diagram(scene, solved, component, panel);
        if (diagram.largest >= widest.largest) widest = diagram;
    }
    widest.component = component;
    return widest;
}

void draw_envelope(const Scene& scene, const std::vector<SolvedCase>& cases, const Diagram& diagram)
{
    if (diagram.is_zero() || cases.empty()) return;
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i)
        BandPicture(scene, cases, femoop::MemberId(i), diagram).draw();
}

} // namespace drawing
