#include "apps/drawing/results/diagram.h"

#include "apps/drawing/results/marked_values.h"
#include "apps/drawing/results/ordinates.h"
#include "apps/drawing/structure/members.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::Curve;
using femoop::MemberComponent;
using femoop::Side;

constexpr double noise = 2e-5; // of the largest value: below it a number is written as zero

bool is_truss_force(const Scene& scene, MemberComponent component)
{
    return femoop::is_truss(scene.model.analysis) && component == MemberComponent::N;
}

/// "12.5", or of a truss "12.5 (T)".
std::string value_text(const Scene& scene, MemberComponent component, double value)
{
    const bool shows_sense = is_truss_force(scene, component);
    const double shown = has_signs(scene, component) && !shows_sense ? value : std::abs(value);
    const std::string sense = !shows_sense || value == 0.0 ? "" : value > 0.0 ? " (T)" : " (C)";
    return scene.number(shown, measure_of(component)) + sense;
}

double height_of(const Scene& scene)
{
    double top = 0.0;
    double bottom = 0.0;
    for (std::size_t i = 0; i < scene.shape.nodes.size(); ++i) {
        const double y = scene.place(femoop::NodeId{i}).y;
        top = i == 0 ? y : std::min(top, y);
        bottom = i == 0 ? y : std::max(bottom, y);
    }
    return bottom - top;
}

/// Draws the diagram of one member.
class MemberDiagram {
public:
    MemberDiagram(const Scene& scene, const MemberShape& member, const Curve& curve, const Diagram& diagram)
        : scene_(scene),
          curve_(curve),
          diagram_(diagram),
          frame_(diagram_frame(scene, member, diagram.component)),
          role_(role_of(diagram.component))
    {}

    void draw() const
    {
        const femoop::Extremes extremes = curve_.extremes(diagram_.component);
        const double own = std::max(std::abs(extremes.max.value), std::abs(extremes.min.value));
        if (!(own > noise * diagram_.largest)) return;
        const std::vector<Ordinate> ordinates = ordinates_of(curve_, diagram_.component,
                                                             0.3 / diagram_.pixels_per_unit);
        std::vector<ui::Point> line{at(0.0, 0.0)};
        for (const Ordinate& o : ordinates) line.push_back(at(o.x, o.value));
        line.push_back(at(curve_.length(), 0.0));
        {
            const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
            sketch().polygon(line, sketch().theme().fill(role_), Clearance::Soft);
            if (!scene_.crowding.is_crowded()) draw_hatching();
        }
        sketch().polyline(line, sketch().stroke(role_), Clearance::Hard);
        if (has_signs(scene_, diagram_.component)) draw_signs(ordinates);
        if (scene_.shows(Show::Values)) write_values();
        else if (scene_.shows(Show::StepValues)) write_step_values({});
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Point at(double x, double value) const
    {
        return frame_(x * scene_.projection.scale(), value * diagram_.pixels_per_unit);
    }

    void draw_hatching() const
    {
        const double step = sketch().px(8.0) / scene_.projection.scale();
        const int n = std::min(400, static_cast<int>(curve_.length() / step));
        ui::Stroke stroke = sketch().thin(role_);
        stroke.width *= 0.55;
        stroke.color = ui::with_opacity(stroke.color, 0.55);
        for (int i = 1; i <= n; ++i) {
            const double x = (i - 0.5) * curve_.length() / n;
            const double value = curve_.value(diagram_.component, x);
            if (std::abs(value) * diagram_.pixels_per_unit > 2.0)
                sketch().line(at(x, 0.0), at(x, value), stroke, Clearance::None);
        }
    }

    // A + or a - in the highest part of every area of one sign.
    void draw_signs(const std::vector<Ordinate>& ordinates) const
    {
        std::size_t begin = 0;
        while (begin < ordinates.size()) {
            const bool is_positive = ordinates[begin].value > 0.0;
            std::size_t end = begin;
            while (end < ordinates.size() && (ordinates[end].value > 0.0) == is_positive) ++end;
            mark_area(ordinates, begin, end);
            begin = end;
        }
    }

    void mark_area(const std::vector<Ordinate>& ordinates, std::size_t begin, std::size_t end) const
    {
        // An end that is zero but for rounding belongs to the area on either side of it.
        const double sign = ordinates[begin].value > 0.0 ? 1.0 : -1.0;
        const std::size_t first = begin > 0 ? begin - 1 : 0, last = std::min(end, ordinates.size() - 1);
        double area = 0.0;
        double moment = 0.0;
        for (std::size_t i = first; i < last; ++i) {
            const auto [a, b] = part_of_sign(sign, ordinates[i], ordinates[i + 1]);
            const double sum = sign * (a.value + b.value), width = b.x - a.x;
            if (!(sum > 0.0)) continue;
            area += 0.5 * sum * width;
            moment += 0.5 * sum * width * (a.x + width * (sign * a.value + 2.0 * sign * b.value) / (3.0 * sum));
        }
        if (area == 0.0) return;
        const double r = sketch().px(6.0);
        std::vector<ui::Point> places = sign_places(moment / area, sign, r, ordinates[first].x, ordinates[last].x);
        if (places.empty()) return;
        sketch().sign({.places = std::move(places), .radius = r, .is_positive = sign > 0.0, .role = role_});
    }

    // The straight piece from a to b, cut where it passes through zero.
    static std::pair<Ordinate, Ordinate> part_of_sign(double sign, Ordinate a, Ordinate b)
    {
        if (a.value * b.value >= 0.0) return {a, b};
        const Ordinate zero{a.x + (b.x - a.x) * a.value / (a.value - b.value), 0.0};
        return sign * a.value > 0.0 ? std::pair{a, zero} : std::pair{zero, b};
    }

    // Where the area is high enough for a sign of radius r: best about `middle`, else ever farther from it.
    std::vector<ui::Point> sign_places(double middle, double sign, double r, double from, double to) const
    {
        std::vector<ui::Point> places;
        const double step = 1.5 * r / scene_.projection.scale();
        const int n = std::min(24, static_cast<int>((to - from) / step) + 1);
        for (int i = 0; i < 2 * n; ++i) {
            const double x = middle + (i % 2 == 0 ? 0.5 : -0.5) * (i + i % 2) * step;
            if (x < from || x > to) continue;
            const double value = curve_.value(diagram_.component, x);
            const double height = sign * value * diagram_.pixels_per_unit;
            if (height < 2.6 * r) {
                if (i == 0) return {};
                continue;
            }
            places.push_back(at(x, 0.5 * value));
            if (height < 5.2 * r) continue;
            places.push_back(at(x, 0.27 * value));
            places.push_back(at(x, 0.73 * value));
        }
        return places;
    }

    void write_values() const
    {
        const std::vector<MarkedValue> marks = marked_values(curve_, diagram_.component, noise * diagram_.largest);
        for (const MarkedValue& marked : marks) {
            // In space small values of one plane would hide the large ones of the other.
            if (!scene_.is_flat() && std::abs(marked.value) < 0.02 * diagram_.largest) continue;
            Caption caption = value_at(marked.x, marked.value);
            caption.rank = rank_of(marked);
            for (const double x : marked.others) caption.others.push_back(at(x, marked.value));
            sketch().caption(std::move(caption));
        }
        if (scene_.shows(Show::StepValues)) write_step_values(marks);
    }

    // The largest value of a diagram is what one looks for first.
    Rank rank_of(const MarkedValue& marked) const
    {
        if (std::abs(marked.value) >= (1.0 - noise) * diagram_.largest) return Rank::Largest;
        return marked.is_peak ? Rank::Extreme : Rank::Value;
    }

    Caption value_at(double x, double value) const
    {
        return {.text = value_text(scene_, diagram_.component, value),
                .role = role_,
                .target = at(x, value),
                .toward = value < 0.0 ? -frame_.y : frame_.y,
                .gap = 4.5};
    }

    // Where nothing stands yet, and not along a stretch of one value, which is written once.
    void write_step_values(const std::vector<MarkedValue>& marks) const
    {
        const int n = scene_.options.steps;
        const double length = curve_.length();
        const auto says = [&](const MarkedValue& mark, double x) {
            const bool is_on_plateau = !mark.others.empty() && x >= mark.others.front() && x <= mark.others.back();
            return is_on_plateau || std::abs(mark.x - x) < 0.25 * length / n;
        };
        for (int i = 1; i < n; ++i) {
            const double x = i * length / n;
            const double value = curve_.value(diagram_.component, x);
            if (std::abs(value) <= noise * diagram_.largest) continue;
            if (std::ranges::any_of(marks, [&](const MarkedValue& mark) { return says(mark, x); })) continue;
            sketch().disc(at(x, value), sketch().px(2.0), sketch().stroke(role_).color, Clearance::None);
            Caption caption = value_at(x, value);
            caption.rank = Rank::Minor;
            caption.size = sketch().lesser_value_size();
            caption.reach = 14.0; // farther off it would seem to belong to another step
            sketch().caption(std::move(caption));
        }
    }

    const Scene& scene_;
    const Curve& curve_;
    const Diagram& diagram_;
    SymbolFrame frame_;
    ui::Role role_;
};

// A band has one breadth: a member whose force changes along it gets a diagram.
bool has_one_force(const Curve& curve, double largest)
{
    const femoop::Extremes N = curve.extremes(MemberComponent::N);
    return N.max.value - N.min.value <= noise * largest;
}

// The force of a bar, written beside it.
void write_force(const Scene& scene, femoop::MemberId id, double N, double half, Rank rank)
{
    const MemberShape& member = scene.shape[id];
    const ui::Point along = scene.projection.direction(member.x());
    const double length = member.length * scene.projection.scale();
    const auto target = [&](double x) { return scene.projection(member.start) + x * length * along; };
    scene.sketch.caption({.text = value_text(scene, MemberComponent::N, N),
                          .role = ui::Role::AxialForce,
                          .target = target(0.5),
                          .toward = ui::left_normal(ui::direction(along)),
                          .gap = 4.0 + half,
                          .rank = rank,
                          .others = {target(0.4), target(0.6), target(0.3), target(0.7), target(0.2), target(0.8)},
                          .along = along});
}

// The bar as broad as its force is large; tension is filled, compression is hatched.
void draw_band(const Scene& scene, femoop::MemberId id, const Curve& curve, const Diagram& diagram)
{
    Sketch& sketch = scene.sketch;
    const MemberShape& member = scene.shape[id];
    const double N = curve.value(MemberComponent::N, 0.5 * curve.length());
    const double share = diagram.largest > 0.0 ? std::abs(N) / diagram.largest : 0.0;
    const bool is_zero = share <= noise;
    const double half = sketch.px(1.5 + 5.0 * share);
    const double length = member.length * scene.projection.scale();
    const double end = std::min(sketch.px(8.0), 0.15 * length);
    const ui::Point along = scene.projection.direction(member.x());
    const ui::Point across = ui::left_normal(ui::direction(along));
    const ui::Point a = scene.projection(member.start);
    const auto corner = [&](double x, double y) { return a + x * along + y * across; };
    if (!is_zero) {
        const ui::LayerScope layer(sketch.painter(), ui::Layer::Areas);
        const ui::Stroke stroke = sketch.thin(ui::Role::AxialForce);
        const std::vector<ui::Point> band{corner(end, half), corner(length - end, half), corner(length - end, -half),
                                          corner(end, -half)};
        const double opacity = N > 0.0 ? 0.55 : 0.12;
        sketch.polygon(band, ui::with_opacity(stroke.color, opacity));
        sketch.polyline(band, stroke, Clearance::Hard, ui::PathEnds::Closed);
        const double step = sketch.px(6.0);
        if (N < 0.0)
            for (double x = end + step; x < length - end; x += step)
                sketch.line(corner(x - half, -half), corner(x, half), stroke, Clearance::None);
    }
    if (!scene.shows(Show::Values)) return;
    write_force(scene, id, is_zero ? 0.0 : N, half, share >= 1.0 - noise ? Rank::Largest : Rank::Value);
}

bool is_hinged(const Scene& scene, const femoop::MemberEnd& end, femoop::NodeId node)
{
    return scene.model[node].hinge || end.release.contains(femoop::Dof::rz);
}

// Made as a bar, or hinged at both ends: the bars of a truss in a plane frame.
bool acts_as_bar(const Scene& scene, femoop::MemberId id)
{
    const femoop::Member& member = scene.model[id];
    return is_bar(scene.model, id) ||
           (is_hinged(scene, member.start, member.nodes[0]) && is_hinged(scene, member.end, member.nodes[1]));
}

bool is_zero_bar(const Scene& scene, femoop::MemberId id, const Curve& curve, const Diagram& diagram)
{
    if (diagram.component != MemberComponent::N || !acts_as_bar(scene, id)) return false;
    const femoop::Extremes N = curve.extremes(MemberComponent::N);
    return std::max(std::abs(N.max.value), std::abs(N.min.value)) <= noise * diagram.largest;
}

} // namespace

ui::Role role_of(MemberComponent component)
{
    switch (component) {
    case MemberComponent::N: return ui::Role::AxialForce;
    case MemberComponent::Vy:
    case MemberComponent::Vz: return ui::Role::ShearForce;
    case MemberComponent::T: return ui::Role::Torsion;
    default: return ui::Role::BendingMoment;
    }
}

ui::Measure measure_of(MemberComponent component)
{
    switch (component) {
    case MemberComponent::N:
    case MemberComponent::Vy:
    case MemberComponent::Vz: return ui::Measure::Force;
    case MemberComponent::T:
    case MemberComponent::My:
    case MemberComponent::Mz: return ui::Measure::Moment;
    default: return ui::Measure::Displacement;
    }
}

Diagram make_diagram(const Scene& scene, const SolvedCase& solved, const SolvedCase& scaled_by,
                     MemberComponent component, ui::Size panel)
{
    Diagram diagram{.component = component, .largest = largest_value(solved, component, scene.shape.size)};
    if (!(diagram.largest > 0.0)) return diagram;
    const double share = is_moment(component) ? 0.17 : 0.125;
    // What the structure itself leaves free of the panel's height makes a beam's diagrams higher.
    const double spare = std::max(0.0, panel.height - height_of(scene) - 100.0);
    const double room = share * (std::min(panel.width, panel.height) + 0.6 * spare);
    const double height = std::clamp(std::min(room, 3.2 * share * scene.crowding.median_length()), 16.0, 130.0);
    const bool is_held = &scaled_by != &solved;
    const double given = is_held ? largest_value(scaled_by, component, scene.shape.size) : diagram.largest;
    diagram.pixels_per_unit = height * scene.options.diagram_factor / held(given, diagram.largest);
    return diagram;
}

void draw_diagram(const Scene& scene, const SolvedCase& solved, const Diagram& diagram)
{
    if (!(diagram.largest > 0.0) && diagram.component != MemberComponent::N) return;
    const bool is_truss = is_truss_force(scene, diagram.component);
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const femoop::MemberId id{i};
        if (is_truss && has_one_force(solved[id], diagram.largest)) draw_band(scene, id, solved[id], diagram);
        else if (scene.shows(Show::Values) && is_zero_bar(scene, id, solved[id], diagram))
            write_force(scene, id, 0.0, 0.0, Rank::Value);
        else if (!diagram.is_zero()) MemberDiagram(scene, scene.shape[id], solved[id], diagram).draw();
    }
}

} // namespace drawing
