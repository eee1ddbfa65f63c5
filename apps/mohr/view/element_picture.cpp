#include "apps/mohr/view/element_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "apps/mohr/view/arrow.h"
#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/names.h"
#include "apps/mohr/view/sentence.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;

namespace {

using std::numbers::pi;

enum class Words : std::uint8_t { All, Few };

/// One element, turned by an angle, and what acts on its faces.
class Element {
public:
    Element(ui::Painter& painter, const Scene& scene, const ElementMap& map, double angle)
        : painter_(painter),
          scene_(scene),
          map_(map),
          theme_(scene.look.full_theme()),
          state_(fm::rotated(scene.solution.plane, angle)),
          x_{std::cos(angle), -std::sin(angle)},
          y_{-std::sin(angle), -std::cos(angle)}
    {}

    ui::Point at(double x, double y) const { return map_.middle + x * x_ + y * y_; }
    const fm::PlaneState& state() const { return state_; }
    bool is_inertia() const { return scene_.document.subject == Subject::Inertia; }
    double length(double component) const { return map_.arrow * std::abs(component) / scene_.frame.largest; }

    void draw_body() const
    {
        const double h = map_.half;
        if (fm::is_strain(scene_.solution.state.kind)) return draw_strained();
        if (is_inertia()) return draw_ellipse();
        const std::array corners{at(-h, -h), at(h, -h), at(h, h), at(-h, h)};
        painter_.polygon(corners, theme_.fill(Role::Deformed));
        painter_.polyline(corners, theme_.stroke(Role::Edge), ui::PathEnds::Closed);
    }

    void draw_arrows(Labels& labels, Words words) const
    {
        if (is_inertia()) return add_labels(labels, words);
        for (const double side : {1.0, -1.0}) {
            draw_normal(x_, side, state_.x);
            draw_normal(y_, side, state_.y);
            draw_shear(x_, y_, side);
            draw_shear(y_, x_, side);
        }
        add_labels(labels, words);
    }

    ui::Point tip(ui::Point along, double component) const
    {
        return map_.middle + (map_.half + gap + (component < 0.0 ? 0.0 : length(component))) * along;
    }
    ui::Point x() const { return x_; }
    ui::Point y() const { return y_; }
    static constexpr double gap = 5.0;

private:
    void draw_normal(ui::Point along, double side, double component) const
    {
        if (length(component) < 1.0) return;
        const ui::Point near = map_.middle + side * (map_.half + gap) * along;
        const ui::Point far = near + side * length(component) * along;
        const bool is_tension = component > 0.0;
        arrow(painter_, is_tension ? near : far, is_tension ? far : near, theme_.stroke(Role::BendingMoment), head());
    }

    /// On the face whose normal is `normal`, along `along`: positive on the positive face along the positive axis.
    void draw_shear(ui::Point normal, ui::Point along, double side) const
    {
        const double half = std::min(0.9 * map_.half,
                                     0.5 * map_.arrow * std::abs(state_.xy) / scene_.frame.largest + 4.0);
        if (length(state_.xy) < 1.0) return;
        const ui::Point middle = map_.middle + side * (map_.half + gap) * normal;
        const ui::Point reach = (side * state_.xy > 0.0 ? 1.0 : -1.0) * half * along;
        arrow(painter_, middle - reach, middle + reach, solid(theme_.stroke(Role::ShearForce)), head());
    }

    /// The axes, and the ellipse whose radius along an axis goes with 1 / sqrt(I) about that axis.
    void draw_ellipse() const
    {
        const double least = scene_.solution.principal.second, reach = map_.half + 0.8 * map_.arrow;
        arrow(painter_, at(-reach, 0.0), at(reach, 0.0), theme_.stroke(Role::Edge), head());
        arrow(painter_, at(0.0, -reach), at(0.0, reach), theme_.stroke(Role::Edge), head());
        if (!(least > 0.0)) return;
        std::vector<ui::Point> points;
        constexpr int n = 90;
        for (int i = 0; i < n; ++i) {
            const double t = 2.0 * pi * i / n,
                         r = 1.2 * map_.half * std::sqrt(least / std::max(least, fm::rotated(state_, t).x));
            points.push_back(at(r * std::cos(t), r * std::sin(t)));
        }
        painter_.polygon(points, theme_.fill(Role::Deformed));
        painter_.polyline(points, theme_.stroke(Role::Deformed), ui::PathEnds::Closed);
    }

    /// The square before, and after a strain that is drawn so large that it shows.
    void draw_strained() const
    {
        const double h = map_.half, k = 0.25 / scene_.frame.largest;
        const auto moved = [&](double x, double y) {
            return at(x + k * (state_.x * x + state_.xy * y), y + k * (state_.y * y + state_.xy * x));
        };
        painter_.polyline({at(-h, -h), at(h, -h), at(h, h), at(-h, h)}, theme_.stroke(Role::Undeformed),
                          ui::PathEnds::Closed);
        const std::array corners{moved(-h, -h), moved(h, -h), moved(h, h), moved(-h, h)};
        painter_.polygon(corners, theme_.fill(Role::Deformed));
        painter_.polyline(corners, theme_.stroke(Role::Deformed), ui::PathEnds::Closed);
    }

    void keep_clear(Labels& labels) const
    {
        const double h = map_.half;
        labels.obstacles().add_polygon(std::array{at(-h, -h), at(h, -h), at(h, h), at(-h, h)});
        for (const double side : {1.0, -1.0}) {
            const auto line = [&](ui::Point along, double component) {
                const ui::Point near = map_.middle + side * h * along;
                labels.obstacles().add_segment(near, near + side * (gap + length(component)) * along, 6.0);
            };
            line(x_, state_.x);
            line(y_, state_.y);
        }
    }

    void add_labels(Labels& labels, Words words) const
    {
        keep_clear(labels);
        const Names names = names_of(scene_.document.subject);
        const auto text = [&](const char* part, const std::string& name, double value) {
            const std::string number = scene_.look.number(value);
            return words == Words::All ? name + part + " = " + number : number;
        };
        ui::TextStyle normal = theme_.text(Role::BendingMoment), shear = theme_.text(Role::ShearForce);
        if (words == Words::Few) normal.size = shear.size = theme_.type().small;
        const auto add_normal = [&](ui::Point along, const char* part, double component) {
            const ui::Point end = (map_.half + gap + length(component)) * along;
            labels.add(map_.middle + end, along, text(part, names.normal, component), normal, 5.0,
                       {{map_.middle - end, -1.0 * along}}); // the opposite face has the same stress
        };
        add_normal(x_, "x′", state_.x);
        add_normal(y_, "y′", state_.y);
        if (length(state_.xy) < 1.0 && words == Words::Few) return;
        const fm::Kind kind = scene_.solution.state.kind;
        const std::string name = fm::is_strain(kind) ? "γ" : is_inertia() ? "I" : "τ";
        const double side = state_.xy >= 0.0 ? 1.0 : -1.0;
        const auto corner = [&](ui::Point outwards, ui::Point along, double which) {
            const ui::Point reach = (map_.half + gap) * outwards + 0.75 * side * map_.half * along;
            return Labels::Place{map_.middle + which * reach, which * (outwards + 0.9 * side * along)};
        };
        const Labels::Place first = corner(x_, y_, 1.0);
        labels.add(first.target, first.away, text("x′y′", name, fm::given_shear(kind, state_.xy)), shear, 4.0,
                   {corner(x_, y_, -1.0), corner(y_, x_, 1.0), corner(y_, x_, -1.0)});
    }

    double head() const { return 9.0 * theme_.symbol_scale(); }

    ui::Painter& painter_;
    const Scene& scene_;
    const ElementMap& map_;
    ui::Theme theme_;
    fm::PlaneState state_;
    ui::Point x_, y_;
};

void draw_axis(ui::Painter& painter, const Scene& scene, const ui::Arc& axis, const std::string& name, Role role)
{
    const ui::Theme theme = scene.look.full_theme();
    const ui::Point end = axis.at(axis.start);
    arrow(painter, axis.center, end, theme.stroke(role), 8.0 * theme.symbol_scale());
    const ui::Point along = ui::direction(end - axis.center);
    const ui::TextStyle style = theme.text(role);
    const double reach = 0.5 * std::abs(along.x) * painter.measure(name, style).width + 0.5 * style.size;
    painter.text(end + reach * along, name, style);
}

/// The directions of a rosette's gauges, each with its letter, and with its reading where there is room for it.
void draw_gauges(ui::Painter& painter, const Scene& scene, ui::Point from, double length, Words words)
{
    const auto& rosette = scene.solution.rosette;
    for (std::size_t i = 0; rosette && i < 3; ++i) {
        const std::string reading = words == Words::All ? " = " + scene.look.number(rosette->readings[i]) : "";
        draw_axis(painter, scene, {from, length, rosette->angles[i], 0.0}, std::string(1, "abc"[i]) + reading,
                  Role::Torsion);
    }
}

/// Fixed axes, and how far the element is turned from them.
void draw_axes_corner(ui::Painter& painter, const Scene& scene, const ui::Box& box, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const double length = 2.6 * theme.type().normal;
    const ui::Point corner{box.min.x + 2.0 * theme.type().normal, box.min.y + 2.0 * theme.type().normal + length};
    draw_axis(painter, scene, {corner, length, 0.0, 0.0}, "x", Role::Label);
    draw_axis(painter, scene, {corner, length, 0.5 * pi, 0.0}, "y", Role::Label);
    const double room = length + 1.5 * theme.type().normal;
    if (scene.solution.rosette && !scene.conceals) { // below them
        const ui::Point from = corner + ui::Point{0.5 * length, 1.3 * room};
        draw_gauges(painter, scene, from, length, Words::Few);
        labels.obstacles().add_box({{from.x - room, from.y - room}, {from.x + room, from.y + 0.5 * room}});
    }
    labels.obstacles().add_box({{corner.x - 0.5 * room, corner.y - room}, {corner.x + room, corner.y + 0.5 * room}});
}

void draw_turn(ui::Painter& painter, const Scene& scene, const ElementMap& map, Labels& labels, Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    const double reach = map.half + map.arrow + 1.8 * theme.type().normal;
    const ui::Arc axis{map.middle, reach, scene.solution.angle, 0.0};
    const ui::Stroke stroke = theme.stroke(Role::Dimension);
    painter.line(map.middle, map.middle + ui::Point{reach, 0.0}, stroke);
    painter.line(map.middle, axis.at(axis.start), stroke);
    arc_arrow(painter, {map.middle, 0.92 * reach, 0.0, scene.solution.angle}, theme.stroke(Role::LocalAxes),
              8.0 * theme.symbol_scale());
    const ui::Arc arc{map.middle, 0.92 * reach, 0.0, 0.0};
    const double half = 0.5 * scene.solution.angle;
    labels.add(arc.at(half), {std::cos(half), -std::sin(half)}, "θ = " + scene.look.number(scene.document.angle) + "°",
               theme.text(Role::LocalAxes), 7.0);
    draw_mark(painter, scene, axis.at(axis.start), Handle::Turn, Role::LocalAxes);
    const ui::Point away = ui::direction(axis.at(axis.start) - map.middle);
    labels.add(axis.at(axis.start), away, "x′", theme.text(Role::LocalAxes), 6.0);
    drawn.places.push_back({Handle::Turn, axis.at(axis.start)});
}

void add_places(const Element& element, const ElementMap& map, Drawn& drawn)
{
    const fm::PlaneState& s = element.state();
    const auto end = [&](ui::Point along, double component) {
        return map.middle + (map.half + Element::gap + element.length(component)) * along;
    };
    drawn.places.push_back({Handle::ArrowX, end(element.x(), s.x)});
    drawn.places.push_back({Handle::ArrowY, end(element.y(), s.y)});
    const double half = std::min(0.9 * map.half, 0.5 * element.length(s.xy) + 4.0);
    drawn.places.push_back({Handle::ArrowShear, element.at(map.half + Element::gap, s.xy < 0.0 ? -half : half)});
}

void draw_hover(ui::Painter& painter, const Scene& scene, const Drawn& drawn)
{
    if (scene.hover != Handle::ArrowX && scene.hover != Handle::ArrowY && scene.hover != Handle::ArrowShear) return;
    const ui::Theme theme = scene.look.full_theme();
    for (const Place& place : drawn.places)
        if (place.handle == scene.hover)
            painter.circle(place.at, 9.0 * theme.symbol_scale(), theme.stroke(Role::Hover));
}

/// A small element in directions of its own, with a caption below.
void draw_small(ui::Painter& painter, const Scene& scene, const ui::Box& box, double angle, const std::string& title)
{
    const ui::Theme theme = scene.look.full_theme();
    ui::TextStyle style = theme.text(Role::Label, ui::Anchor::Bottom);
    style.size = theme.type().small;
    std::vector<std::string> caption = lines_of(painter, title, style, box.width());
    caption.push_back("θ = " + scene.look.number(angle * 180.0 / pi) + "°");
    const double line = 1.5 * style.size, foot = line * static_cast<double>(caption.size());
    const ui::Box above{box.min, {box.max.x, box.max.y - foot}};
    const double room = std::min(above.width(), above.height());
    const ElementMap map{above.center(), 0.2 * room, 0.2 * room};
    Labels labels(above, painter.fonts());
    const Element element(painter, scene, map, angle);
    element.draw_body();
    element.draw_arrows(labels, Words::Few);
    labels.draw(painter, theme);
    for (std::size_t i = 0; i < caption.size(); ++i)
        painter.text({box.center().x, above.max.y + line * static_cast<double>(i + 1)}, caption[i], style);
}

void draw_special(ui::Painter& painter, const Scene& scene, const ui::Box& box)
{
    const Solution& s = scene.solution;
    if (!s.principal.angle || !s.shear_angle) return;
    const double middle = box.center().x;
    const bool is_strain = fm::is_strain(s.state.kind);
    draw_small(painter, scene, {box.min, {middle, box.max.y}}, *s.principal.angle,
               scene.look.tr("principal directions"));
    draw_small(painter, scene, {{middle, box.min.y}, box.max}, *s.shear_angle,
               is_strain                           ? scene.look.tr("largest shear strain γ")
               : s.state.kind == fm::Kind::Inertia ? scene.look.tr("largest product")
                                                   : scene.look.tr("largest shear in this plane"));
}

} // namespace

void draw_element(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    const bool has_room = 0.30 * box.height() > 8.0 * theme.type().small;
    const bool has_special = has_room && scene.look.special && !scene.conceals && scene.solution.principal.angle;
    ui::Box main = box;
    if (has_special) main.max.y -= 0.30 * box.height();
    if (scene.solution.rosette && !scene.conceals) main.min.x += 3.0 * theme.type().normal; // for the gauges
    const double room = 0.5 * std::min(main.width(), main.height()) - 2.4 * theme.type().normal;
    drawn.element = {main.center(), std::max(8.0, 0.45 * room), std::max(8.0, 0.40 * room)};
    Labels labels(main, painter.fonts());
    draw_axes_corner(painter, scene, box, labels);
    if (scene.conceals && scene.solution.rosette) // its strains are asked for
        return draw_gauges(painter, scene, drawn.element.middle, drawn.element.half + drawn.element.arrow, Words::All);
    const Element element(painter, scene, drawn.element, scene.solution.angle);
    draw_turn(painter, scene, drawn.element, labels, drawn);
    element.draw_body();
    element.draw_arrows(labels, Words::All);
    labels.draw(painter, theme);
    add_places(element, drawn.element, drawn);
    draw_hover(painter, scene, drawn);
    if (has_special) draw_special(painter, scene, {{box.min.x, main.max.y}, box.max});
}

} // namespace mohr
