#include "apps/drawing/results/position_curve.h"

#include "apps/drawing/sketch/scene.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace drawing {

namespace {

using femoop::Side;
using femoop::influence::PositionFunction;
using Place = PositionCurve::Place;
using Run = PositionCurve::Run;

// Where a run begins and ends, and from break to break so densely that it looks smooth; at a break both sides.
std::vector<Place> places_of(const Run& run)
{
    constexpr int n = 16; // parts of a piece: mostly straight, of degree four at most
    std::vector<Place> places{{run.from, run.effect.value(run.from, Side::Before, 0.0)}};
    for (const PositionFunction::Piece& piece : run.effect.pieces()) {
        if (piece.to < run.from || piece.from > run.to) continue;
        for (int i = 0; i <= n; ++i) {
            const double t = (piece.to - piece.from) * i / n;
            places.push_back({std::clamp(piece.from + t, run.from, run.to), piece.value(t)});
        }
    }
    places.push_back({run.to, run.effect.value(run.to, Side::After, 0.0)});
    return places;
}

/// The diagram in its box.
class CurveDrawing {
public:
    CurveDrawing(ui::Painter& painter, const PositionCurve& curve, const ui::Box& box, const CurveLook& look)
        : painter_(painter), curve_(curve), look_(look), size_(look.theme.type().small)
    {
        const auto [from, to] = positions(curve);
        from_ = from;
        to_ = to;
        for (const Run& run : curve.runs) {
            runs_.push_back(places_of(run));
            for (const Place& place : runs_.back()) include(place.value);
        }
        include(curve.now.value);
        const double side = 16.0 + 0.5 * size_;
        below_ = 0.4 * size_;
        if (is_ringed_at_foot()) below_ = std::max(below_, ring_radius() + 0.3 * size_);
        room_ = {{box.min.x + side, box.min.y + 3.3 * size_}, {box.max.x - side, box.max.y - 1.2 * size_ - below_}};
        begin_ = room_.min.x;
        end_ = room_.max.x;
        if (look.path) stand_below(*look.path, box);
    }

    void draw() const
    {
        const ui::LayerScope layer(painter_, ui::Layer::Overlay);
        draw_axis();
        for (std::size_t i = 0; i < runs_.size(); ++i) draw_run(runs_[i], curve_.runs[i].is_reversed);
        draw_marks();
    }

private:
    void include(double value)
    {
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }

    double radius() const { return 4.0 * look_.theme.symbol_scale(); }
    double ring_radius() const { return radius() + 2.0 * look_.theme.stroke(curve_.role).width; }

    /// The ring of the critical place would lie over the words below the axis.
    bool is_ringed_at_foot() const
    {
        constexpr double near = 0.1; // of the height
        return curve_.worst && curve_.worst->value - least_ <= near * (most_ - least_);
    }

    // To the scale of the path where that leaves room for the positions beyond its ends.
    void stand_below(const PathOnSheet& path, const ui::Box& box)
    {
        constexpr double rim = 6.0; // [px] that a disc keeps

        const double scale = (path.end - path.begin) / curve_.path_length;
        const double begin = path.begin + scale * from_, end = path.begin + scale * to_;
        if (std::min(begin, end) < box.min.x + rim || std::max(begin, end) > box.max.x - rim) return;
        begin_ = begin;
        end_ = end;
    }

    ui::Point at(const Place& place) const
    {
        const double height = most_ > least_ ? (place.value - least_) / (most_ - least_) : 0.0;
        const double along = to_ > from_ ? (place.position - from_) / (to_ - from_) : 0.0;
        return {begin_ + along * (end_ - begin_), room_.max.y - height * room_.height()};
    }

    ui::TextStyle style(ui::Role role, ui::Anchor anchor) const
    {
        ui::TextStyle style = look_.theme.text(role, anchor);
        style.size = size_;
        return style;
    }

    std::string place_text(double position) const
    {
        return "s = " + with_minus(look_.units.text(position, ui::Measure::Length));
    }

    // The position from end to end, thick where the leading axle is on the path.
    void draw_axis() const
    {
        ui::Stroke axis = look_.theme.stroke(ui::Role::Leader);
        painter_.line(at({from_, 0.0}), at({to_, 0.0}), axis);
        axis.width *= 3.0;
        painter_.line(at({0.0, 0.0}), at({curve_.path_length, 0.0}), axis);
        const double y = room_.max.y + below_;
        const bool is_rightwards = end_ > begin_;
        painter_.text({begin_, y}, place_text(from_),
                      style(ui::Role::FaintLabel, is_rightwards ? ui::Anchor::TopLeft : ui::Anchor::TopRight));
        painter_.text({end_, y}, place_text(to_),
                      style(ui::Role::FaintLabel, is_rightwards ? ui::Anchor::TopRight : ui::Anchor::TopLeft));
        painter_.text({0.5 * (begin_ + end_), y}, look_.tr("position of the leading axle"),
                      style(ui::Role::FaintLabel, ui::Anchor::Top));
    }

    void draw_run(const std::vector<Place>& places, bool is_reversed) const
    {
        std::vector<ui::Point> points;
        for (const Place& place : places) points.push_back(at(place));
        ui::Stroke stroke = look_.theme.stroke(curve_.role);
        if (is_reversed) stroke.dash = {5.0, 4.0};
        painter_.polyline(points, stroke);
    }

    void draw_marks() const
    {
        const ui::Stroke stroke = look_.theme.stroke(curve_.role);
        const double radius = this->radius();
        const ui::Point now = at(curve_.now);
        painter_.line({now.x, room_.min.y}, {now.x, room_.max.y}, look_.theme.stroke(ui::Role::Label));
        for (const Place& candidate : curve_.candidates) painter_.disc(at(candidate), 0.45 * radius, stroke.color);
        if (curve_.worst) painter_.circle(at(*curve_.worst), radius + 1.5 * stroke.width, stroke);
        painter_.disc(now, radius, stroke.color);
        write_marks(now);
    }

    // In one line over the curve: what it is where the train stands, and, if that is elsewhere, at the critical place.
    void write_marks(ui::Point now) const
    {
        const double y = room_.min.y - 1.0 * size_;
        const std::string here = mark_text(curve_.now);
        ui::TextStyle bold = style(curve_.role, ui::Anchor::BottomLeft);
        bold.weight = ui::Weight::Bold;
        const double x = written(here, now.x, y, bold);
        if (!curve_.worst || curve_.worst->position == curve_.now.position) return;
        const std::string there = look_.tr("critical: {value}", {{"value", mark_text(*curve_.worst)}});
        const ui::TextStyle plain = style(curve_.role, ui::Anchor::BottomLeft);
        const double width = painter_.measure(here, bold).width, gap = 1.5 * size_;
        const double other = within(there, at(*curve_.worst).x, plain);
        const double other_width = painter_.measure(there, plain).width;
        const bool is_apart = other + other_width + gap < x || other > x + width + gap;
        if (is_apart) painter_.text({other, y}, there, plain);
        else if (x + width + gap + other_width <= room_.max.x) painter_.text({x + width + gap, y}, there, plain);
        else if (x - gap - other_width >= room_.min.x) painter_.text({x - gap - other_width, y}, there, plain);
    }

    std::string mark_text(const Place& place) const
    {
        return with_minus(look_.units.text(place.value, curve_.measure)) + "  (" + place_text(place.position) + ")";
    }

    // Where a text about x begins that stays in the box.
    double within(const std::string& text, double x, const ui::TextStyle& style) const
    {
        const double width = painter_.measure(text, style).width;
        return std::max(room_.min.x, std::min(x - 0.5 * width, room_.max.x - width));
    }

    double written(const std::string& text, double x, double y, const ui::TextStyle& style) const
    {
        const double begin = within(text, x, style);
        painter_.text({begin, y}, text, style);
        return begin;
    }

    ui::Painter& painter_;
    const PositionCurve& curve_;
    const CurveLook& look_;
    double size_;        ///< em
    double below_ = 0.0; ///< the axis its words stand
    ui::Box room_;
    std::vector<std::vector<Place>> runs_;
    double from_ = 0.0, to_ = 0.0, least_ = 0.0, most_ = 0.0;
    double begin_ = 0.0, end_ = 0.0; ///< x of these positions on the sheet
};

} // namespace

femoop::influence::Stretch positions(const PositionCurve& curve)
{
    femoop::influence::Stretch all;
    for (const PositionCurve::Run& run : curve.runs) all = {std::min(all.from, run.from), std::max(all.to, run.to)};
    return all;
}

double curve_height(const ui::Theme& theme, ui::Size sheet)
{
    constexpr double ample = 10.0, least = 8.0, share = 0.25; // em, em, of the sheet
    const double height = std::min(ample * theme.type().small, share * sheet.height);
    return height >= least * theme.type().small ? height : 0.0;
}

void draw_position_curve(ui::Painter& painter, const PositionCurve& curve, const ui::Box& box, const CurveLook& look)
{
    CurveDrawing(painter, curve, box, look).draw();
}

} // namespace drawing
