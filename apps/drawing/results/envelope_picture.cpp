// The band between the largest and the least value of an envelope.
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_band.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace drawing {

namespace {

using femoop::MemberComponent;

class BandPicture {
public:
    BandPicture(const Scene& scene, const EnvelopePicture& envelope, femoop::MemberId member, const Diagram& diagram)
        : scene_(scene),
          member_(member),
          band_(envelope.find(diagram.component)->members[member.index]),
          names_(envelope.names),
          frame_(diagram_frame(scene, scene.shape[member], diagram.component)),
          diagram_(diagram)
    {}

    void draw() const
    {
        std::vector<ui::Point> most, least;
        for (const BandSection& section : band_) {
            most.push_back(at(section.x, section.most.value));
            least.push_back(at(section.x, section.least.value));
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
        write_marks({&BandSection::most, femoop::ExtremeKind::Max, 1.0});
        write_marks({&BandSection::least, femoop::ExtremeKind::Min, -1.0});
    }

private:
    /// One of the two lines of the band; the sign is that of the way out of it.
    struct Line {
        Bound BandSection::*bound;
        femoop::ExtremeKind kind;
        double sign;
    };

    ui::Point at(double x, double value) const
    {
        return frame_(x * scene_.projection.scale(), value * diagram_.pixels_per_unit);
    }
    double unseen() const { return 1e-4 * diagram_.largest; }
    double rounding() const { return 1e-9 * diagram_.largest; }
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
            const bool is_closed = band_[i].most.value - band_[i].least.value < unseen();
            const bool is_said_by_other = is_closed && line.sign < 0.0;
            if (i == peak || (is_marked(line, i) && !is_said_by_other))
                write(band_[i].x, band_[i].*line.bound, line, i == peak ? Rank::Extreme : Rank::Value);
        }
    }

    void write(double x, const Bound& bound, const Line& line, Rank rank) const
    {
        if (std::abs(bound.value) < unseen()) return;
        const double length = scene_.shape[member_].length;
        const bool is_largest = std::abs(bound.value) > diagram_.largest - rounding();
        scene_.sketch.caption({.text = words(bound),
                               .role = role_of(diagram_.component),
                               .target = at(x, bound.value),
                               .toward = line.sign * frame_.y,
                               .gap = 4.5,
                               .rank = is_largest ? Rank::Largest : rank,
                               .number = number_at_section({member_, x}, diagram_.component, length),
                               .end = RangeEnd{line.kind, bound.made_by}});
    }

    // "58.5 (G)"
    std::string words(const Bound& bound) const
    {
        const double shown = has_signs(scene_, diagram_.component) ? bound.value : std::abs(bound.value);
        return governed(scene_.number(shown, measure_of(diagram_.component)), bound, names_);
    }

    const Scene& scene_;
    femoop::MemberId member_;
    const std::vector<BandSection>& band_;
    const std::vector<std::string>& names_;
    SymbolFrame frame_;
    const Diagram& diagram_;
};

} // namespace

void draw_envelope(const Scene& scene, const EnvelopePicture& envelope, const Diagram& diagram)
{
    const EnvelopeBands* const bands = envelope.find(diagram.component);
    if (diagram.is_zero() || bands == nullptr) return;
    for (std::size_t i = 0; i < bands->members.size(); ++i)
        BandPicture(scene, envelope, femoop::MemberId(i), diagram).draw();
}

} // namespace drawing
