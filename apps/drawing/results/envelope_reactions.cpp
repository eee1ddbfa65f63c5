#include "apps/drawing/results/envelope_reactions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "apps/drawing/measures.h"
#include "apps/drawing/structure/supports.h"

namespace drawing {

namespace {

using femoop::Dof;

class ReactionRanges {
public:
    ReactionRanges(const Scene& scene, const EnvelopePicture& envelope) : scene_(scene), envelope_(envelope) {}

    void draw()
    {
        const std::vector<ReactionBand>& all = envelope_.reactions;
        for (auto begin = all.begin(); begin != all.end();) {
            const auto end = std::find_if(begin, all.end(), [&](const auto& one) { return one.node != begin->node; });
            std::vector<Line> lines;
            for (auto band = begin; band != end; ++band)
                if (std::string words = range_of(*band); !words.empty()) lines.push_back({&*band, std::move(words)});
            if (!lines.empty()) write(begin->node, lines);
            begin = end;
        }
    }

private:
    struct Line {
        const ReactionBand* band;
        std::string words;
    };

    // "fy 42 (G) … 56.7 (U) kN"; nothing where there is no reaction.
    std::string range_of(const ReactionBand& band) const
    {
        const auto& [node, dof, least, most] = band;
        if (least.value == 0.0 && most.value == 0.0) return {};
        const std::string range = least.value == most.value ? words(least, dof)
                                                            : words(least, dof) + " … " + words(most, dof);
        return std::string(femoop::force_name(dof)) + " " + range + " " +
               scene_.units.unit(force_measures.of(dof)).name;
    }

    bool is_written_over(const ui::Box& box) const
    {
        return std::ranges::any_of(written_, [&](const ui::Box& other) { return other.overlaps(box); });
    }

    // How far off its place, a line at a time, a box covers neither a band nor what is written; a band where all is full.
    template <class BoxAt> double off_bands(BoxAt&& box, double line) const
    {
        constexpr int most_lines = 16;
        const auto is_in_sight = [&](const ui::Box& one) {
            return scene_.sketch.is_in_sight(one.min) && scene_.sketch.is_in_sight(one.max);
        };
        for (int i = 0; i < most_lines && is_in_sight(box(i * line)); ++i)
            if (!is_written_over(box(i * line)) && scene_.sketch.is_free(box(i * line))) return i * line;
        double off = 0.0;
        while (is_written_over(box(off))) off += line;
        return off;
    }

    // One line under the other beyond the support's symbol, farther off where another support's stand already.
    void write(femoop::NodeId node, const std::vector<Line>& lines)
    {
        Sketch& sketch = scene_.sketch;
        ui::TextStyle style = sketch.theme().text(ui::Role::Reaction, ui::Anchor::Center);
        style.size = sketch.theme().type().small;
        style.plate = sketch.theme().background(); // bands may lie behind
        const double line = 1.35 * style.size;
        ui::Size size{0.0, line * static_cast<double>(lines.size())};
        for (const Line& one : lines)
            size.width = std::max(size.width, sketch.painter().measure(one.words, style).width);
        const ui::Point away = support_side(scene_, node).value_or(ui::Point{0.0, 1.0});
        const double half = 0.5 * (std::abs(away.x) * size.width + std::abs(away.y) * size.height);
        const ui::Point foot = scene_.place(node) + support_reach(sketch) * away;
        const auto box = [&](double off) {
            const ui::Point center = foot + (half + off) * away;
            return ui::box_at(center - 0.5 * ui::Point{size.width, size.height}, size);
        };
        const double off = off_bands(box, line);
        const ui::Point center = box(off).center();
        if (off > line) sketch.line(foot, foot + (off - 2.0) * away, sketch.thin(ui::Role::Reaction));
        const ui::Box taken = box(off).grown(2.0);
        written_.push_back(taken);
        sketch.keep_clear({taken.min, {taken.max.x, taken.min.y}, taken.max, {taken.min.x, taken.max.y}});
        sketch.include(taken.min);
        sketch.include(taken.max);
        const ui::LayerScope layer(sketch.painter(), ui::Layer::Labels);
        const ui::Box written = box(off);
        double y = written.min.y + 0.5 * line;
        for (const Line& one : lines) {
            sketch.painter().text({center.x, y}, one.words, style);
            mark(*one.band, {{written.min.x, y - 0.5 * line}, {written.max.x, y + 0.5 * line}});
            y += line;
        }
    }

    // The left half of a range is its least value.
    void mark(const ReactionBand& band, const ui::Box& box) const
    {
        const femoop::MovingEffect number{
            .quantity = femoop::ExpectedQuantity::Reaction, .node = band.node, .dof = band.dof};
        ui::Box left = box, right = box;
        left.max.x = right.min.x = 0.5 * (box.min.x + box.max.x);
        scene_.sketch.mark(NumberMark{left, number, RangeEnd{femoop::ExtremeKind::Min, band.least.made_by}});
        scene_.sketch.mark(NumberMark{right, number, RangeEnd{femoop::ExtremeKind::Max, band.most.made_by}});
    }

    std::string words(const Bound& bound, Dof dof) const
    {
        return governed(scene_.number(bound.value, force_measures.of(dof)), bound, envelope_.names);
    }

    const Scene& scene_;
    const EnvelopePicture& envelope_;
    std::vector<ui::Box> written_; ///< of the supports so far
};

} // namespace

void draw_reaction_ranges(const Scene& scene, const EnvelopePicture& envelope)
{
    ReactionRanges(scene, envelope).draw();
}

} // namespace drawing
