#include "apps/drawing/loads/loads.h"
#include "apps/drawing/sketch/symbols.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;

/// One component of a line load over a stretch where its sign does not change.
struct Stretch {
    double from = 0.0, to = 0.0;   ///< along the member
    double start = 0.0, end = 0.0; ///< values
    double largest() const { return std::max(std::abs(start), std::abs(end)); }
    double sign() const { return start + end < 0.0 ? -1.0 : 1.0; }
    double at(double t) const { return std::abs(start + t * (end - start)); }
    Reach reach() const { return {from, to}; }
};

std::vector<Stretch> of_one_sign(const Stretch& whole)
{
    if (whole.start * whole.end >= 0.0) return {whole};
    const double zero = whole.from + (whole.to - whole.from) * whole.start / (whole.start - whole.end);
    return {{whole.from, zero, whole.start, 0.0}, {zero, whole.to, 0.0, whole.end}};
}

/// Where a stretch is drawn: `away` points from the heads to the tails.
struct Placing {
    Vector3d away;
    double base = 0.0;   ///< pixels from the member to the heads
    double height = 0.0; ///< pixels of the largest value
    double level = 0.0;  ///< model length along `away` up to a base square to it, of projected loads
    bool is_projected = false;
};

class LineLoadPicture {
public:
    LineLoadPicture(const Scene& scene, const MemberShape& member, const Stretch& load, const Placing& placing)
        : scene_(scene), member_(member), load_(load), placing_(placing)
    {}

    void draw() const
    {
        const int n = n_arrows();
        std::vector<ui::Point> outline;
        for (int i = 0; i <= n; ++i) outline.push_back(tail(static_cast<double>(i) / n));
        draw_area(outline);
        scene_.sketch.polyline(outline, scene_.sketch.thin(ui::Role::Load));
        if (scene_.detail.is_reduced()) { // the ends' arrows would run into columns, the base into the member
            for (int i = 0; i < n; ++i) draw_arrow((i + 0.5) / n);
        } else {
            scene_.sketch.line(head(0.0), head(1.0), scene_.sketch.thin(ui::Role::Load), Clearance::None);
            for (int i = 0; i <= n; ++i) draw_arrow(static_cast<double>(i) / n);
        }
        if (placing_.is_projected) draw_droplines();
    }

    ui::Point tail(double t) const { return head(t) + height(t) * away(); }
    ui::Point head(double t) const
    {
        Vector3d place = on_member(t);
        if (placing_.is_projected) place += (placing_.level - place.dot(placing_.away)) * placing_.away;
        return scene_.projection(place) + placing_.base * away();
    }

private:
    double height(double t) const { return placing_.height * load_.at(t) / load_.largest(); }
    ui::Point away() const { return scene_.projection.direction(placing_.away); }
    Vector3d on_member(double t) const { return member_.at(load_.from + t * (load_.to - load_.from)); }

    int n_arrows() const
    {
        const double length = ui::distance(head(0.0), head(1.0));
        const double widest = scene_.sketch.px(34.0);
        const double spacing = std::clamp(length / 20.0, scene_.sketch.px(15.0), widest);
        const double apart = scene_.detail.is_reduced() ? 2.0 * widest : spacing; // smaller arrows are not more
        return std::clamp(static_cast<int>(std::lround(length / apart)), 1, 200);
    }

    void draw_area(std::vector<ui::Point> outline) const
    {
        outline.push_back(head(1.0));
        outline.push_back(head(0.0));
        const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Areas);
        const ui::Color fill = scene_.sketch.theme().fill(ui::Role::Load);
        scene_.sketch.polygon(outline, ui::with_opacity(fill, 0.5 * fill.a / 255.0));
    }

    void draw_arrow(double t) const
    {
        if (height(t) < scene_.sketch.px(3.0)) return;
        drawing::draw(scene_.sketch, {.tail = tail(t),
                                      .head = head(t),
                                      .role = ui::Role::Load,
                                      .head_size = 7.0,
                                      .facing = -placing_.away.dot(scene_.projection.toward_eye())});
    }

    // From the ends of the projected length to the member's.
    void draw_droplines() const
    {
        const ui::Stroke stroke = {
            .color = scene_.sketch.stroke(ui::Role::Load).color, .width = 0.8, .dash = {3.0, 3.0}};
        for (const double t : {0.0, 1.0})
            scene_.sketch.line(scene_.projection(on_member(t)), head(t), stroke, Clearance::Soft);
    }

    const Scene& scene_;
    const MemberShape& member_;
    Stretch load_;
    Placing placing_;
};

void write_values(const Scene& scene, const Stretch& load, const LineLoadPicture& picture, ui::Point away,
                  bool is_repeat, std::size_t load_mark)
{
    const bool is_short = ui::distance(picture.head(0.0), picture.head(1.0)) < scene.sketch.px(120.0);
    if (!scene.shows(Show::Values) || (is_repeat && is_short)) return;
    const auto write = [&](double value, std::initializer_list<double> places) {
        if (value == 0.0) return;
        Caption caption{.text = scene.text(std::abs(value), ui::Measure::ForcePerLength),
                        .role = ui::Role::Load,
                        .target = picture.tail(*places.begin()),
                        .toward = away,
                        .rank = is_repeat ? Rank::Minor : Rank::Load,
                        .is_repeat = is_repeat,
                        .load_mark = load_mark};
        for (const double t : places) caption.others.push_back(picture.tail(t));
        scene.sketch.caption(std::move(caption));
    };
    if (std::abs(load.start - load.end) <= 1e-9 * load.largest()) return write(load.start, {0.5, 0.35, 0.65, 0.2, 0.8});
    write(load.start, {0.0, 0.05});
    write(load.end, {1.0, 0.95});
}

double arrow_height(const Scene& scene, double value, double largest)
{
    const double share = largest > 0.0 ? value / largest : 1.0;
    return scene.sketch.px(12.0 + 22.0 * share) * scene.options.load_factor;
}

/// A stretch of a line load on its member.
struct StretchLoad {
    const MemberShape& member;
    Stretch load;
    Vector3d direction;        ///< of a positive value
    bool is_projected = false; ///< per unit of projected length
    double largest = 0.0;      ///< value per length in the whole case
    Part part;                 ///< the load
    femoop::Dof dof;
    bool is_repeat = false; ///< its value is written beside it

    double along() const { return direction.dot(member.x()); }
};

void draw_across(const Scene& scene, const StretchLoad& stretch, LoadStack& stack)
{
    const auto& [member, load, direction, is_projected, largest, part, dof, is_repeat] = stretch;
    Placing placing{.away = -load.sign() * direction, .height = arrow_height(scene, load.largest(), largest)};
    const double taken = stack.height(placing.away, load.reach());
    placing.base = taken > 0.0 ? taken + scene.sketch.px(5.0) : scene.sketch.px(3.0);
    placing.is_projected = is_projected && std::abs(direction.dot(member.x())) > 1e-6;
    placing.level = std::max(member.at(load.from).dot(placing.away), member.at(load.to).dot(placing.away));
    if (placing.is_projected) placing.base += scene.sketch.px(12.0);
    const LineLoadPicture picture(scene, member, load, placing);
    picture.draw();
    const double at = std::abs(load.start) > std::abs(load.end)   ? 0.0
                      : std::abs(load.start) < std::abs(load.end) ? 1.0
                                                                  : 0.5;
    const std::size_t mark = scene.sketch.mark(
        {.load = part,
         .dof = dof,
         .area = {picture.head(0.0), picture.tail(0.0), picture.tail(1.0), picture.head(1.0)},
         .root = picture.head(at),
         .tip = picture.tail(at)});
    write_values(scene, load, picture, scene.projection.direction(placing.away), is_repeat, mark);
    // The value stands between this load and the one on top of it.
    const double text = scene.shows(Show::Values) ? 1.3 * scene.sketch.theme().type().normal : 0.0;
    stack.raise(placing.away, load.reach(), placing.base + placing.height + text);
}

// A load along the member: a row of arrows beside it.
void draw_along(const Scene& scene, const StretchLoad& stretch, LoadStack& stack)
{
    const MemberShape& member = stretch.member;
    const Stretch& load = stretch.load;
    const double sense = stretch.along() * load.sign();
    Sketch& sketch = scene.sketch;
    const Vector3d side = member.y().y() < -1e-9 ? Vector3d(-member.y()) : member.y();
    const double at = std::max(stack.height(side, load.reach()), sketch.px(2.0)) + sketch.px(7.0);
    const double length = (load.to - load.from) * scene.projection.scale();
    const int n = std::clamp(static_cast<int>(length / sketch.px(30.0)), 1, 100);
    const SymbolFrame f = scene.projection.frame(member.at(load.from), member.x(), side);
    const double step = length / n;
    for (int i = 0; i < n; ++i) {
        const double share = load.at((i + 0.5) / n) / load.largest();
        const double half = 0.42 * step * std::max(0.25, share);
        const double middle = (i + 0.5) * step;
        draw(sketch, {.tail = f(middle - sense * half, at), .head = f(middle + sense * half, at), .head_size = 7.0});
    }
    stack.raise(side, load.reach(), at + sketch.px(5.0));
    if (!scene.shows(Show::Values)) return;
    const bool is_uniform = load.start == load.end;
    const std::string units = scene.units.unit(ui::Measure::ForcePerLength).name;
    const std::string text = is_uniform ? scene.text(load.largest(), ui::Measure::ForcePerLength)
                                        : scene.number(std::abs(load.start), ui::Measure::ForcePerLength) + " … " +
                                              scene.text(std::abs(load.end), ui::Measure::ForcePerLength);
    sketch.caption({.text = text,
                    .role = ui::Role::Load,
                    .target = f(0.5 * length, at + sketch.px(4.0)),
                    .toward = f.y,
                    .rank = Rank::Load});
}

// Moments per length: a row of small curved arrows about their axis.
void draw_moments(const Scene& scene, const StretchLoad& stretch, LoadStack& stack)
{
    const MemberShape& member = stretch.member;
    const Stretch& load = stretch.load;
    const Vector3d& axis = stretch.direction;
    Sketch& sketch = scene.sketch;
    const double length = (load.to - load.from) * scene.projection.scale();
    const int n = std::clamp(static_cast<int>(length / sketch.px(34.0)), 1, 60);
    const Vector3d across = std::abs(axis.dot(member.y())) > 0.9 ? member.z() : member.y();
    for (int i = 0; i < n; ++i) {
        const Vector3d at = member.at(load.from + (i + 0.5) / n * (load.to - load.from));
        const Vector3d x = across.cross(axis);
        draw(sketch, CurvedArrow{.frame = scene.projection.frame(at, x, across), .radius = 9.0, .sense = load.sign()});
    }
    stack.raise(member.y(), load.reach(), sketch.px(14.0));
    stack.raise(-member.y(), load.reach(), sketch.px(14.0));
    if (!scene.shows(Show::Values)) return;
    const auto value = [&](double v) { return scene.text(std::abs(v), ui::Measure::MomentPerLength); };
    sketch.caption({.text = load.start == load.end ? value(load.start) : value(load.start) + " … " + value(load.end),
                    .role = ui::Role::LoadMoment,
                    .target = scene.projection(member.at(0.5 * (load.from + load.to))),
                    .toward = scene.projection.direction(member.y()),
                    .gap = sketch.px(14.0),
                    .rank = Rank::Load});
}

} // namespace

void draw_line_load(const Scene& scene, const ShownLoad& shown, const LargestLoads& largest, LoadStack& stack)
{
    const MemberShape& member = scene.shape[shown.member];
    const femoop::LoadComponent& load = shown.component;
    const Stretch whole{load.from, load.to, load.start, load.end};
    if (!(whole.largest() > 0.0) || !(load.to > load.from)) return;
    const Vector3d direction = femoop::direction_of(load, member);
    for (const Stretch& part : of_one_sign(whole)) {
        if (!(part.largest() > 0.0)) continue;
        const StretchLoad stretch{member,     part,     direction,      load.is_projected, largest.per_length,
                                  shown.part, load.dof, shown.is_repeat};
        if (femoop::is_rotation(load.dof)) draw_moments(scene, stretch, stack);
        else if (std::abs(stretch.along()) > 0.95) draw_along(scene, stretch, stack);
        else draw_across(scene, stretch, stack);
    }
}

} // namespace drawing
