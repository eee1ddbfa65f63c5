#include "apps/drawing/section_picture.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "femoop/section/outline.h"
#include "femoop/section/principal_axes.h"
#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"

namespace drawing {

using femoop::SectionOutline;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

/// From a section's own axes to the sheet.
struct Fit {
    Point centroid;
    double scale = 1.0;

    Fit(const SectionOutline& figure, const ui::Box& room)
        : scale(std::min(room.width() / figure.width(), room.height() / figure.height()))
    {
        const Point middle = room.center();
        centroid = {middle.x - 0.5 * scale * (figure.left + figure.right),
                    middle.y + 0.5 * scale * (figure.top + figure.bottom)};
    }
    Point operator()(double y, double z) const { return {centroid.x + scale * z, centroid.y - scale * y}; }
    std::vector<Point> operator()(const std::vector<femoop::OutlinePoint>& points) const
    {
        std::vector<Point> seen;
        for (const femoop::OutlinePoint& point : points) seen.push_back((*this)(point.y, point.z));
        return seen;
    }
};

/// What a pixel of this picture is: it grows with the theme's type, where the sheet is high enough for it.
double unit_of(const ui::Theme& theme, ui::Size sheet)
{
    return std::min(theme.type().normal / ui::TypeSizes{}.normal, sheet.height / 220.0);
}

ui::Color faded(ui::Color color, int alpha)
{
    color.a = static_cast<std::uint8_t>(alpha);
    return color;
}

void draw_area(ui::Painter& painter, const SectionOutline& figure, const Fit& fit, const ui::Theme& theme)
{
    const ui::Color ink = theme.stroke(Role::Member).color;
    const std::vector<Point> outer = fit(figure.outer), hole = fit(figure.hole);
    painter.set_layer(ui::Layer::Areas);
    painter.polygon(outer, faded(ink, 60));
    if (!hole.empty()) painter.polygon(hole, theme.background());
    painter.set_layer(ui::Layer::Lines);
    const ui::Stroke line{
        .color = ink, .width = 1.6 * std::max(unit_of(theme, painter.size()), 0.7), .join = ui::Join::Round};
    painter.polyline(outer, line, ui::PathEnds::Closed);
    if (!hole.empty()) painter.polyline(hole, line, ui::PathEnds::Closed);
}

/// The picture of one section: what is drawn around its area.
class SectionSheet {
public:
    SectionSheet(ui::Painter& painter, const SectionOutline& figure, const Fit& fit, const SectionLook& look)
        : painter_(painter), figure_(figure), fit_(fit), look_(look)
    {}

    void draw_axes(const femoop::SectionProperties& properties)
    {
        const double reach_y = fit_.scale * std::max(figure_.top, -figure_.bottom) + px(20);
        const double reach_z = fit_.scale * std::max(figure_.right, -figure_.left) + px(20);
        axis(0.0, reach_z, "z′", Role::LocalAxes);
        axis(0.5 * pi, reach_y, "y′", Role::LocalAxes);
        const double reach = 0.45 * fit_.scale * std::max(figure_.height(), figure_.width());
        const femoop::PrincipalAxes principal = principal_axes(properties);
        if (std::abs(properties.Iyz) > 1e-9 * properties.Iz) {
            slanting_ = {Axis{principal.angle, reach}, Axis{principal.angle + 0.5 * pi, reach}};
            axis(slanting_[0].angle, reach, "1", Role::Warning);
            axis(slanting_[1].angle, reach, "2", Role::Warning);
        }
        painter_.set_layer(ui::Layer::Symbols);
        painter_.disc(fit_.centroid, px(3.5), color(Role::LocalAxes));
    }

    void draw_size(double yc)
    {
        const Point low = fit_(figure_.bottom, figure_.left), high = fit_(figure_.top, figure_.right);
        const double left = low.x - px(32), below = low.y + px(20);
        dimension({left, low.y}, {left, high.y}, figure_.height(), Anchor::Right);
        dimension({low.x, below}, {high.x, below}, figure_.width(), Anchor::Top);
        const bool is_off_middle = std::abs(figure_.top + figure_.bottom) > 1e-9 * figure_.height();
        const double beside = fit_.centroid.x + fit_.scale * std::max(figure_.right, -figure_.left) + px(46);
        const std::string words = look_.units.text(yc, ui::Measure::SectionLength);
        const double width = painter_.measure(words, style_of(Role::Dimension)).width;
        const double right = std::min(beside, painter_.size().width - px(10) - width); // none of it is cut off
        if (is_off_middle) dimension({right, low.y}, {right, fit_.centroid.y}, yc, Anchor::Left);
    }

    /// Arrows on both sides of a thickness, its value beside them.
    void draw_flange(double tf)
    {
        const double x = fit_(0, figure_.right).x + px(10);
        const Point top = {x, fit_(figure_.top, 0).y}, under = {x, fit_(figure_.top - tf, 0).y};
        arrow(top - Point{0, px(12)}, top);
        arrow(under + Point{0, px(12)}, under);
        text({x + px(6), 0.5 * (top.y + under.y)}, value(tf), Anchor::Left);
    }

    /// At the first of these heights where the value beside it lies on no part of the figure and on no mark of its axes.
    void draw_web(double from, double to, std::initializer_list<double> heights)
    {
        const std::string words = value(to - from);
        const ui::TextExtent extent = painter_.measure(words, style_of(Role::Dimension));
        const ui::Size size{extent.width, extent.height()};
        const auto corner = [&](double y) { return fit_(y, to) + Point{px(18), -0.5 * size.height}; };
        const auto* const clear = std::ranges::find_if(heights, [&](double y) {
            const Point tail = fit_(y, from) - Point{px(14), 0};
            const ui::Box words_at = ui::box_at(corner(y), size).grown(px(4));
            return is_clear(words_at) && is_off_axes(words_at) && is_off_axes({tail, fit_(y, from)});
        });
        const double y = clear != heights.end() ? *clear : *heights.begin();
        const Point left = fit_(y, from), right = fit_(y, to);
        arrow(left - Point{px(14), 0}, left);
        arrow(right + Point{px(14), 0}, right);
        text(right + Point{px(18), 0}, words, Anchor::Left);
    }

private:
    static constexpr double pi = std::numbers::pi;

    double px(double pixels) const { return unit_of(look_.theme, painter_.size()) * pixels; }
    ui::TextStyle style_of(Role role, Anchor anchor = Anchor::Center) const
    {
        ui::TextStyle style = look_.theme.text(role, anchor);
        style.size = px(ui::TypeSizes{}.normal);
        style.plate = faded(look_.theme.background(), 200);
        return style;
    }
    ui::Color color(Role role) const { return look_.theme.stroke(role).color; }
    std::string value(double stored) const { return look_.units.number(stored, ui::Measure::SectionLength); }
    /// No line of the outline passes it, and none goes round it.
    bool is_clear(const ui::Box& box) const
    {
        const std::vector<Point> outer = fit_(figure_.outer);
        bool is_inside = false;
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const Point a = outer[i], b = outer[(i + 1) % outer.size()];
            if (passes(a, b, box)) return false;
            const Point at = box.center();
            const bool is_beside = (a.y > at.y) != (b.y > at.y);
            if (is_beside && at.x < a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y)) is_inside = !is_inside;
        }
        return !is_inside;
    }
    /// Neither the centroid nor a principal axis that slants lies there.
    bool is_off_axes(const ui::Box& box) const
    {
        if (box.grown(px(3.5)).contains(fit_.centroid)) return false;
        return std::ranges::none_of(slanting_, [&](const Axis& one) {
            const Point end = one.reach * Point{std::cos(one.angle), -std::sin(one.angle)};
            return passes(fit_.centroid - end, fit_.centroid + end, box);
        });
    }
    /// Where the line lies within the box, from one share of its length to another.
    static bool passes(Point a, Point b, const ui::Box& box)
    {
        double from = 0.0, to = 1.0;
        const auto cut = [&](double start, double step, double least, double most) {
            if (step == 0.0) return start >= least && start <= most;
            const auto [first, last] = std::minmax({(least - start) / step, (most - start) / step});
            from = std::max(from, first);
            to = std::min(to, last);
            return from <= to;
        };
        return cut(a.x, b.x - a.x, box.min.x, box.max.x) && cut(a.y, b.y - a.y, box.min.y, box.max.y);
    }
    void text(Point at, const std::string& words, Anchor anchor)
    {
        const ui::LayerScope labels(painter_, ui::Layer::Labels);
        painter_.text(at, words, style_of(Role::Dimension, anchor));
    }

    void axis(double angle, double reach, const std::string& name, Role role)
    {
        const ui::LayerScope lines(painter_, ui::Layer::Symbols);
        const Point along{std::cos(angle), -std::sin(angle)};
        const ui::Stroke stroke{.color = color(role), .width = px(1.2), .dash = {10, 3, 2, 3}};
        painter_.line(fit_.centroid - reach * along, fit_.centroid + reach * along, stroke);
        ui::TextStyle style = style_of(role);
        style.weight = ui::Weight::Bold;
        const ui::LayerScope labels(painter_, ui::Layer::Labels);
        painter_.text(fit_.centroid + (reach + px(8)) * along, name, style);
    }

    void dimension(Point a, Point b, double stored, Anchor anchor)
    {
        const ui::Stroke stroke = look_.theme.stroke(Role::Dimension);
        const Point along = ui::direction(b - a), across = ui::left_normal(along);
        painter_.line(a, b, stroke);
        for (const Point end : {a, b}) {
            painter_.line(end - px(5) * across, end + px(5) * across, stroke);
            painter_.line(end - px(3.5) * (across + along), end + px(3.5) * (across + along), stroke);
        }
        const Point away = anchor == Anchor::Right  ? Point{-px(6), 0}
                           : anchor == Anchor::Left ? Point{px(6), 0}
                                                    : Point{0, px(6)};
        text(0.5 * (a + b) + away, look_.units.text(stored, ui::Measure::SectionLength), anchor);
    }

    void arrow(Point from, Point to)
    {
        const ui::Stroke stroke = look_.theme.stroke(Role::Dimension);
        const Point along = ui::direction(to - from), across = ui::left_normal(along);
        painter_.line(from, to, stroke);
        painter_.polygon({to, to - px(6) * along + px(2.4) * across, to - px(6) * along - px(2.4) * across},
                         stroke.color);
    }

    ui::Painter& painter_;
    const SectionOutline& figure_;
    const Fit& fit_;
    const SectionLook& look_;
    struct Axis {
        double angle = 0.0, reach = 0.0;
    };
    std::vector<Axis> slanting_; ///< principal axes of a section without symmetry
};

/// Thicknesses of what is built of plates, while it stands upright.
struct Plates {
    double flange = 0.0; ///< 0: none to show
    double web_from = 0.0, web = 0.0;
};

/// The one thickness that is shown of a section that lies on its side: that of its flange, which stands then.
Plates lying(const Plates& upright, const SectionOutline& figure)
{
    const double thickness = upright.flange > 0.0 ? upright.flange : upright.web;
    return {.web_from = figure.left, .web = thickness};
}

Plates plates(const femoop::Profile& p, double k, const SectionOutline& figure)
{
    using femoop::ProfileFamily;
    switch (p.family) {
    case ProfileFamily::L:
    case ProfileFamily::CHS:
    case ProfileFamily::SHS:
    case ProfileFamily::RHS: return {0.0, figure.left, k * p.tw};
    case ProfileFamily::UPN: return {k * p.tf, figure.left, k * p.tw};
    case ProfileFamily::IPE:
    case ProfileFamily::HEA:
    case ProfileFamily::HEB:
    case ProfileFamily::HEM:
    case ProfileFamily::W:
    case ProfileFamily::WMetric:
    case ProfileFamily::HPMetric: break;
    }
    return {k * p.tf, -0.5 * k * p.tw, k * p.tw};
}

std::optional<Plates> plates(const femoop::Section& section, const SectionOutline& figure, const femoop::Units& file)
{
    using femoop::SectionShapeKind;
    if (const femoop::Profile* p = section.profile ? femoop::find_profile(*section.profile) : nullptr)
        return plates(*p, metres(p->unit) / metres(file.length), figure);
    if (!section.shape) return std::nullopt;
    const femoop::SectionShape& shape = *section.shape;
    switch (shape.kind) {
    case SectionShapeKind::I:
    case SectionShapeKind::T: return Plates{*shape.tf, -0.5 * *shape.tw, *shape.tw};
    case SectionShapeKind::C: return Plates{*shape.tf, figure.left, *shape.tw};
    case SectionShapeKind::Box:
    case SectionShapeKind::L:
    case SectionShapeKind::Tube: return Plates{0.0, figure.left, *shape.t};
    case SectionShapeKind::Rectangle:
    case SectionShapeKind::Circle: break;
    }
    return std::nullopt;
}

void draw_plates(SectionSheet& sheet, const Plates& plates, const SectionOutline& figure)
{
    if (plates.flange > 0.0) sheet.draw_flange(plates.flange);
    const bool is_round = figure.outer.size() > 40; // whose thickness is seen on a diameter only
    const double to = plates.web_from + plates.web;
    if (is_round) return sheet.draw_web(plates.web_from, to, {0.0});
    const auto at = [&](double share) { return figure.bottom + share * figure.height(); };
    sheet.draw_web(plates.web_from, to, {at(0.28), at(0.72), at(0.6), at(0.85)}); // clear of the axes
}

} // namespace

void draw_section(ui::Painter& painter, const femoop::Section& section, const femoop::Units& file,
                  const SectionLook& look)
{
    const std::optional<SectionOutline> figure = outline(section, file);
    if (!figure) return;
    const double k = unit_of(look.theme, painter.size());
    const ui::Box sheet = painter.sheet();
    painter.set_layer(ui::Layer::Background);
    painter.rectangle(sheet, look.theme.background());
    const double beside = section.turned ? 124 : 108; // a broad figure leaves its dimensions no other room
    ui::TextStyle style = look.theme.text(Role::Dimension, Anchor::Right);
    style.size = k * ui::TypeSizes{}.normal;
    const std::string height = look.units.text(figure->height(), ui::Measure::SectionLength);
    const double left = std::max(k * 96, painter.measure(height, style).width + k * 42); // none of it is cut off
    const Fit fit(*figure, {sheet.min + Point{left, k * 40}, sheet.max - k * Point{beside, 48}});
    draw_area(painter, *figure, fit, look.theme);
    SectionSheet picture(painter, *figure, fit, look);
    const femoop::SectionProperties properties = section_properties(section, file);
    picture.draw_axes(properties);
    picture.draw_size(properties.yc.value_or(-figure->bottom));
    if (const auto thin = plates(section, *figure, file))
        draw_plates(picture, section.turned ? lying(*thin, *figure) : *thin, *figure);
}

void draw_section_icon(ui::Painter& painter, const femoop::SectionShape& shape, const ui::Theme& theme)
{
    const SectionOutline figure = outline(shape);
    const double inset = 0.14 * std::min(painter.size().width, painter.size().height);
    draw_area(painter, figure, Fit(figure, painter.sheet().grown(-inset)), theme);
}

} // namespace drawing
