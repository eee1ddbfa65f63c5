#include "apps/drawing/truss/joint_picture.h"

#include "apps/drawing/geometry/diagram_plan.h"
#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/truss/truss_drawing.h"
#include "femoop/io/truss/truss_equation.h"
#include "ui/paint/wrapped_lines.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector2d;
using femoop::MemberId;
using femoop::truss::ForceCause;
using femoop::truss::JointForce;

ui::Point on_sheet(const Vector2d& v) { return {v.x(), -v.y()}; }

/// One force of the joint, and where its side of the polygon stands.
struct PlannedForce {
    JointForce force;
    bool is_known = true;
    ui::Point begin{}, end{}; ///< of its side
};

/// Where the joint stands, and its polygon: known forces first, clockwise, then what the step finds.
class JointPlan {
public:
    JointPlan(const TrussPicture& picture, const ui::Box& panel, const ui::Theme& theme)
    {
        const TrussStage& stage = picture.stage();
        if (!stage.joint) return;
        collect(picture, stage);
        const bool has_polygon = picture.method == TrussMethod::Joints && largest() > 0.0;
        const ui::Box below_head{{panel.min.x, panel.min.y + 2.6 * theme.type().normal}, panel.max};
        ui::Box joint_room = below_head;
        if (has_polygon) joint_room = lay_polygon(below_head, theme);
        center_ = joint_room.center();
        const double margin = 2.0 * theme.type().normal; // for names
        text_size_ = std::clamp(panel.width() / 22.0, ui::TypeSizes().normal, theme.type().normal);
        const double beside = 0.5 * joint_room.width() - 3.5 * text_size_, above = 0.5 * joint_room.height() - margin;
        arm_ = std::clamp(std::min(beside, above), 0.0, 4.5 * margin);
    }

    const std::vector<PlannedForce>& forces() const { return forces_; }
    ui::Point center() const { return center_; }
    double arm() const { return arm_; }               ///< from the joint to the far end of an arrow [px]
    bool has_polygon() const { return scale_ > 0.0; } ///< not where nothing acts
    double scale() const { return scale_; }           ///< pixels per unit of force
    double text_size() const { return text_size_; }   ///< that the panel has room for
    const ui::Box& polygon_room() const { return polygon_room_; }

private:
    void collect(const TrussPicture& picture, const TrussStage& stage)
    {
        if (stage.step) {
            for (const JointForce& force : picture.joints.steps[*stage.step].forces)
                forces_.push_back({force, !force.is_found || picture.is_found(*force.bar)});
        } else {
            for (const femoop::truss::Spoke& spoke : picture.arrangement[stage.joint->index])
                forces_.push_back(of_spoke(picture, spoke));
        }
        std::stable_partition(forces_.begin(), forces_.end(),
                              [](const PlannedForce& one) { return !one.force.is_found; });
    }

    static PlannedForce of_spoke(const TrussPicture& picture, const femoop::truss::Spoke& spoke)
    {
        JointForce force{.bar = spoke.bar, .force = spoke.force, .away = spoke.away, .on_joint = Vector2d::Zero()};
        if (spoke.bar) return {force, picture.is_found(*spoke.bar)};
        force.on_joint = picture.truss.forces[*spoke.force].force;
        force.value = force.on_joint.norm();
        return {force};
    }

    double largest() const
    {
        double most = 0.0;
        for (const PlannedForce& one : forces_) most = std::max(most, one.force.on_joint.norm());
        return most;
    }

    /// Beside the joint, or below it, whichever leaves more. \returns what is left for the joint
    ui::Box lay_polygon(const ui::Box& room, const ui::Theme& theme)
    {
        ui::Box joint_room = room;
        polygon_room_ = room;
        if (room.width() > 1.15 * room.height())
            joint_room.max.x = polygon_room_.min.x = room.min.x + 0.46 * room.width();
        else joint_room.max.y = polygon_room_.min.y = room.min.y + 0.46 * room.height();
        std::vector<Vector2d> corners{Vector2d::Zero()};
        for (const PlannedForce& one : forces_) corners.emplace_back(corners.back() + one.force.on_joint);
        ui::Box with_names = polygon_room_;
        with_names.min.y -= 2.0 * theme.type().normal; // the plan keeps room for a head that stands elsewhere
        const DiagramPlan plan(corners, with_names, theme);
        scale_ = plan.scale();
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            forces_[i].begin = plan(corners[i]);
            forces_[i].end = plan(corners[i + 1]);
        }
        return joint_room;
    }

    std::vector<PlannedForce> forces_;
    ui::Point center_;
    double arm_ = 0.0, scale_ = 0.0, text_size_ = 0.0;
    ui::Box polygon_room_;
};

class JointDrawing {
public:
    JointDrawing(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
        : scene_(scene), picture_(picture), plan_(picture, panel, scene.sketch.theme())
    {}

    void draw() const
    {
        if (!picture_.stage().joint) return;
        for (const PlannedForce& one : plan_.forces()) draw_at_joint(one);
        draw_pin();
        if (!plan_.has_polygon()) return;
        const bool is_solved = std::ranges::all_of(plan_.forces(), &PlannedForce::is_known);
        for (std::size_t i = 0; i < plan_.forces().size(); ++i) {
            if (plan_.forces()[i].is_known) draw_side(plan_.forces()[i]);
            else draw_open_side(i);
        }
        if (!is_solved) return;
        for (const PlannedForce& one : plan_.forces()) sketch().disc(one.end, sketch().px(2.4), ink(), Clearance::None);
    }

private:
    Sketch& sketch() const { return scene_.sketch; }
    ui::Color ink() const { return sketch().theme()[ui::Role::Label].text; }

    double text_size() const { return std::min(plan_.text_size(), sketch().lesser_value_size()); }

    bool is_lit(const PlannedForce& one) const
    {
        return one.force.bar && std::ranges::find(picture_.stage().lit, *one.force.bar) != picture_.stage().lit.end();
    }

    bool is_reaction(const JointForce& force) const
    {
        return picture_.truss.forces[*force.force].cause == ForceCause::Reaction;
    }

    ui::Role role(const PlannedForce& one) const
    {
        if (!one.force.bar) return is_reaction(one.force) ? ui::Role::Reaction : ui::Role::Load;
        return one.is_known ? role_of(one.force.value) : ui::Role::Label;
    }

    ui::Stroke stroke(const PlannedForce& one) const
    {
        ui::Stroke line = sketch().stroke(ui::Role::Bar);
        if (!one.force.bar) line.color = sketch().theme().stroke(role(one)).color;
        else if (one.is_known) line.color = stroke_of(scene_, one.force.value).color;
        return line;
    }

    /// "AD 36.06 (C)", "N(AD)" while it is unknown, of a load its value alone.
    std::string text(const PlannedForce& one) const
    {
        const std::string value = scene_.number(std::abs(one.force.value), ui::Measure::Force);
        if (!one.force.bar) return value;
        const std::string& name = scene_.model[*one.force.bar].id;
        if (picture_.method == TrussMethod::ZeroForces) return one.is_known ? name + "  0" : name;
        if (!one.is_known) return femoop::truss::force_symbol(*one.force.bar, scene_.model);
        const std::string sense = one.force.value == 0.0 ? "" : one.force.value > 0.0 ? " (T)" : " (C)";
        return name + "  " + value + sense;
    }

    void draw_at_joint(const PlannedForce& one) const
    {
        const ui::Point away = on_sheet(one.force.away), center = plan_.center();
        const ui::Point far = center + plan_.arm() * away;
        if (is_lit(one)) {
            const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
            sketch().line(center, far, highlight_stroke(scene_, lit_role), Clearance::None);
        }
        if (!one.force.bar) draw_force_at_joint(one, far);
        else draw_stub(one, far);
        sketch().caption({.text = text(one),
                          .role = role(one),
                          .target = far,
                          .toward = away,
                          .gap = sketch().px(5.0),
                          .rank = Rank::Largest,
                          .size = text_size(),
                          .others = {0.8 * far + 0.2 * center, 0.6 * far + 0.4 * center},
                          .reach = 60.0});
    }

    /// A bar without force has dots, one whose force is not asked for a plain line, else an arrow as it acts on the joint.
    void draw_stub(const PlannedForce& one, ui::Point far) const
    {
        const ui::Point center = plan_.center();
        const bool is_zero = one.is_known && one.force.value == 0.0;
        if (is_zero) return sketch().line(center, far, stroke_of(scene_, 0.0));
        if (picture_.method == TrussMethod::ZeroForces) return sketch().line(center, far, stroke(one));
        const ui::Point cut = center + 0.4 * (far - center);
        sketch().line(center, cut, sketch().stroke(ui::Role::Bar));
        const bool is_push = one.is_known && one.force.value < 0.0;
        const ui::Point tail = cut + 0.1 * (far - center);
        arrow(is_push ? far : tail, is_push ? tail : far, one);
    }

    void draw_force_at_joint(const PlannedForce& one, ui::Point far) const
    {
        const ui::Point near = plan_.center() + 0.16 * (far - plan_.center());
        const bool is_pull = one.force.on_joint.dot(one.force.away) > 0.0;
        const bool is_along = std::abs(one.force.on_joint.normalized().dot(one.force.away)) > 0.999;
        if (is_along) return arrow(is_pull ? near : far, is_pull ? far : near, one);
        const ui::Point half = 0.25 * plan_.arm() * on_sheet(one.force.on_joint.normalized());
        const ui::Point middle = 0.6 * far + 0.4 * near; // between bars, where its own line is taken by them
        arrow(middle - half, middle + half, one);
    }

    void arrow(ui::Point tail, ui::Point head, const PlannedForce& one) const
    {
        drawing::draw(sketch(),
                      {.tail = tail, .head = head, .role = role(one), .head_size = 10.0, .stroke = stroke(one)});
    }

    void draw_pin() const
    {
        const ui::LayerScope layer(sketch().painter(), ui::Layer::Symbols);
        const ui::Stroke rim = sketch().stroke(ui::Role::Hinge);
        sketch().disc(plan_.center(), sketch().px(5.0), sketch().theme().background());
        sketch().ring(plan_.center(), sketch().px(5.0), {.color = rim.color, .width = rim.width});
    }

    void draw_side(const PlannedForce& one) const
    {
        if (is_lit(one)) {
            const ui::LayerScope layer(sketch().painter(), ui::Layer::Areas);
            sketch().line(one.begin, one.end, highlight_stroke(scene_, lit_role), Clearance::None);
        }
        if (one.force.on_joint.isZero(0.0)) return;
        const ui::Point along = ui::direction(one.end - one.begin);
        const ui::Stroke line = stroke(one);
        const double head = std::min(sketch().px(12.0), 0.6 * ui::distance(one.begin, one.end));
        sketch().line(one.begin, one.end, line);
        arrow_head(sketch(), 0.5 * (one.begin + one.end) + 0.5 * head * along, along, head, line.color);
        sketch().caption({.text = one.force.bar ? scene_.model[*one.force.bar].id : text(one),
                          .role = role(one),
                          .target = 0.5 * (one.begin + one.end),
                          .toward = ui::left_normal(along),
                          .gap = sketch().px(6.0),
                          .rank = Rank::Value,
                          .size = text_size(),
                          .reach = 50.0});
    }

    /// Of two unknown bars each has its line through one end of what is known: they meet where the polygon closes.
    void draw_open_side(std::size_t i) const
    {
        const std::vector<PlannedForce>& all = plan_.forces();
        const bool is_last = i + 1 == all.size() && !all[i - (i > 0 ? 1 : 0)].is_known;
        const ui::Point from = is_last ? all.front().begin : all[i].begin, along = on_sheet(all[i].force.away);
        const double length = ui::length({plan_.polygon_room().width(), plan_.polygon_room().height()});
        const ui::ClipScope clip(sketch().painter(), plan_.polygon_room().grown(-4.0));
        sketch().line(from - length * along, from + length * along, sketch().thin(ui::Role::Dimension),
                      Clearance::Soft);
    }

    const Scene& scene_;
    const TrussPicture& picture_;
    JointPlan plan_;
};

/// At the stage that counts them.
bool lists_rules(const TrussPicture& picture)
{
    return picture.method == TrussMethod::ZeroForces && picture.n_stages == picture.stages.size();
}

/// As many as there is room for.
void write_rules(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    ui::Painter& painter = scene.sketch.painter();
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    ui::TextStyle style = scene.sketch.theme().text(ui::Role::Label, ui::Anchor::TopLeft);
    style.size = scene.sketch.lesser_value_size();
    const double line_height = 1.5 * style.size, border = 16.0;
    double y = panel.min.y + 3.0 * scene.sketch.theme().type().normal;
    for (std::size_t i = 0; i + 1 < picture.stages.size(); ++i)
        for (const MemberId bar : picture.stages[i].found)
            for (const std::string& line : ui::wrapped_lines(painter.fonts(), picture.bar_sentences[bar.index], style,
                                                             panel.width() - 2.0 * border)) {
                if (y + line_height > panel.max.y) return;
                painter.text({panel.min.x + border, y}, line, style);
                y += line_height;
            }
}

} // namespace

void draw_joint(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    if (lists_rules(picture)) write_rules(scene, picture, panel);
    else JointDrawing(scene, picture, panel).draw();
}

PanelHead joint_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel)
{
    const ui::Catalogue& tr = scene.options.tr;
    const TrussStage& stage = picture.stage();
    if (!stage.joint) return {.name = lists_rules(picture) ? tr("The rule of each") : std::string(), .note = {}};
    const std::string name = tr("Joint {name}", {{"name", scene.model[*stage.joint].id}});
    const JointPlan plan(picture, panel, scene.sketch.theme());
    if (!plan.has_polygon()) return {.name = name, .note = {}};
    return force_diagram_head(scene, tr("{joint} and its force polygon", {{"joint", name}}), plan.scale());
}

std::optional<MemberId> bar_of_joint_at(const TrussPicture& picture, const ui::Box& panel, const ui::Theme& theme,
                                        ui::Point at, double reach)
{
    const JointPlan plan(picture, panel, theme);
    std::optional<MemberId> nearest;
    const auto look_at = [&](MemberId bar, ui::Point a, ui::Point b) {
        const double off = distance_to_segment(at, a, b);
        if (off > reach) return;
        reach = off;
        nearest = bar;
    };
    for (const PlannedForce& one : plan.forces()) {
        if (!one.force.bar) continue;
        look_at(*one.force.bar, plan.center(), plan.center() + plan.arm() * on_sheet(one.force.away));
        if (plan.has_polygon() && one.is_known) look_at(*one.force.bar, one.begin, one.end);
    }
    return nearest;
}

} // namespace drawing
