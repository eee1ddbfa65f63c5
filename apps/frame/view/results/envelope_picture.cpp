// The band between the largest and the smallest value of all cases.
#include "apps/frame/view/results/diagram.h"

#include <algorithm>
#include <cmath>

namespace frame {

namespace {

using femoop::Curve;
using femoop::MemberComponent;
using femoop::Side;

struct Range {
    double x, least, most;
    friend bool operator==(const Range&, const Range&) = default;
};

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
            Range range{x, 0.0, 0.0};
            bool is_first = true;
            for (const SolvedCase& solved : cases) {
                const double value = solved[member].value(component, x, side);
                range.least = is_first ? value : std::min(range.least, value);
                range.most = is_first ? value : std::max(range.most, value);
                is_first = false;
            }
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
          diagram_(diagram),
          frame_(diagram_frame(scene, scene.shape[member], diagram.component)),
          band_(band(cases, member, diagram.component))
    {}

    void draw() const
    {
        std::vector<ui::Point> most, least;
        for (const Range& range : band_) {
            most.push_back(at(range.x, range.most));
            least.push_back(at(range.x, range.least));
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
        write(*std::ranges::max_element(band_, {}, &Range::most), &Range::most, 1.0);
        write(*std::ranges::min_element(band_, {}, &Range::least), &Range::least, -1.0);
    }

private:
    ui::Point at(double x, double value) const
    {
        return frame_(x * scene_.projection.scale(), value * diagram_.pixels_per_unit);
    }
    void write(const Range& range, double Range::*value, double side) const
    {
        const double shown = range.*value;
        if (std::abs(shown) < 1e-4 * diagram_.largest) return;
        const double written = has_signs(scene_, diagram_.component) ? shown : std::abs(shown);
        scene_.sketch.caption({.text = scene_.number(written, measure_of(diagram_.component)),
                               .role = role_of(diagram_.component),
                               .target = at(range.x, shown),
                               .toward = side * frame_.y,
                               .gap = 4.5,
                               .rank = Rank::Extreme});
    }

    const Scene& scene_;
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
        const Diagram diagram = make_diagram(scene, solved, solved, component, panel);
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

} // namespace frame
