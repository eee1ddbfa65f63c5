#include "apps/cross/view/structure_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "apps/cross/view/lock.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/stiffness.h"
#include "apps/drawing/loads/loads.h"
#include "apps/drawing/results/deformed.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/locked_scale.h"
#include "apps/drawing/results/reactions.h"
#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/dimensions.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/supports.h"
#include "ui/paint/text_measure.h"
#include "ui/paint/wrapped_lines.h"

namespace cross {

namespace fc = femoop::cross;
using drawing::Show;

namespace {

void draw_supports_and_joints(const drawing::Scene& in)
{
    {
        const ui::LayerScope layer(in.sketch.painter(), ui::Layer::Symbols);
        drawing::draw_supports(in);
    }
    drawing::draw_joints(in);
}

/// Results of the present state, and the scale: of what the distribution comes to.
struct Solved {
    drawing::SolvedCase present;
    std::optional<drawing::LockedScale> scale;
};

std::optional<Solved> solved(const Scene& scene)
{
    if (scene.state == nullptr) return std::nullopt;
    auto present = drawing::solved_case(*scene.state, fc::state_case(*scene.state));
    if (!present) return std::nullopt;
    const std::optional<femoop::Results>& balanced = scene.solution.task->balanced;
    if (!balanced || scene.document.stage != 0) return Solved{*std::move(present), std::nullopt};
    auto scale = drawing::locked_scale(scene.document.model, *balanced, fc::state_case(*balanced));
    if (scale) scale->load_case = scene.document.method.load_case;
    return Solved{*std::move(present), scale};
}

std::optional<drawing::LockedScale> scale_of(const std::optional<Solved>& results)
{
    return results ? results->scale : std::nullopt;
}

/// What locks of the sheet that is worked on do now.
class Locked {
public:
    Locked(const Scene& scene, const drawing::Scene& in, const ui::Box& panel, const drawing::SolvedCase& present,
           double scale)
        : scene_(scene),
          in_(in),
          panel_(panel),
          present_(present),
          scale_(scale),
          numbers_(scene.document, scene.solution, scene.look)
    {
        for (const Eigen::Vector3d& node : in.shape.nodes) middle_ += node / static_cast<double>(in.shape.nodes.size());
    }

    void draw_all(const fc::Sheet& sheet)
    {
        const fc::Problem& problem = scene_.solution.task->problem;
        for (std::size_t j = 0; j < problem.joints.size(); ++j) draw_one(sheet, problem, fc::JointId(j));
        const std::vector<double> forces = held_by_props(scene_.document, scene_.solution);
        const bool is_listed = !has_room_beside(problem, forces);
        for (std::size_t k = 0; k < problem.sways.size(); ++k) {
            draw_prop(problem.sways[k]);
            if (!is_listed) write_beside(problem.sways[k], forces[k]);
        }
        if (is_listed) list(problem, forces);
    }

private:
    ui::Point displaced(femoop::NodeId node) const
    {
        const femoop::NodeVector d = present_.result.displacement(node);
        return in_.projection(in_.shape[node] + scale_ * Eigen::Vector3d(d[0], d[1], 0.0));
    }

    /// At the node that it holds, along the direction in which that would move, outwards.
    drawing::SymbolFrame frame_of(const fc::Sway& sway) const
    {
        const Eigen::Vector3d positive(sway.direction.x(), sway.direction.y(), 0.0);
        const bool is_outward = positive.dot(in_.shape[sway.prop] - middle_) >= 0.0;
        const Eigen::Vector3d along = is_outward ? positive : Eigen::Vector3d(-positive);
        const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
        return {displaced(sway.prop), in_.projection.direction(along), in_.projection.direction(across)};
    }

    double reach() const { return in_.sketch.px(24.0); }
    double beyond_ground() const { return in_.sketch.px(8.0); }

    /// A strut to the ground.
    void draw_prop(const fc::Sway& sway)
    {
        const drawing::SymbolFrame frame = frame_of(sway);
        const double reach = this->reach();
        const ui::LayerScope layer(in_.sketch.painter(), ui::Layer::Symbols);
        in_.sketch.line(frame.origin, frame(reach, 0.0), in_.sketch.stroke(ui::Role::Support));
        for (const double end : {in_.sketch.px(3.0), reach})
            in_.sketch.disc(frame(end, 0.0), in_.sketch.px(2.4), in_.sketch.stroke(ui::Role::Support).color);
        const drawing::SymbolFrame foot = frame.moved(reach, 0.0);
        drawing::draw_ground(in_.sketch, {foot.origin, foot.y, -foot.x}, in_.sketch.px(10.0));
    }

    void write_beside(const fc::Sway& sway, double force)
    {
        const drawing::SymbolFrame frame = frame_of(sway);
        in_.sketch.caption({.text = in_.text(force, ui::Measure::Force),
                            .role = ui::Role::Reaction,
                            .target = frame(reach(), 0.0),
                            .toward = frame.x,
                            .gap = beyond_ground(),
                            .rank = drawing::Rank::Largest});
    }

    /// Of every force beside the ground of its prop. A single one is near it in any case, and a list has few lines.
    bool has_room_beside(const fc::Problem& problem, const std::vector<double>& forces) const
    {
        constexpr std::size_t most_listed = 3;
        if (forces.size() < 2 || forces.size() > most_listed) return true;
        const ui::TextStyle style = in_.sketch.theme().text(ui::Role::Reaction);
        for (std::size_t k = 0; k < forces.size(); ++k) {
            const drawing::SymbolFrame frame = frame_of(problem.sways[k]);
            const double width = in_.sketch.painter().measure(in_.text(forces[k], ui::Measure::Force), style).width;
            if (std::abs(frame.x.x) > 0.5 && !panel_.contains(frame(reach() + beyond_ground() + width, 0.0)))
                return false;
        }
        return true;
    }

    /// "C −13.22 kN", at the foot of a narrow picture.
    void list(const fc::Problem& problem, const std::vector<double>& forces)
    {
        const ui::LayerScope layer(in_.sketch.painter(), ui::Layer::Labels);
        ui::TextStyle style = in_.sketch.theme().text(ui::Role::Reaction, ui::Anchor::BottomLeft);
        style.plate = in_.sketch.theme().background();
        ui::Point at{panel_.min.x + 0.4 * style.size, panel_.max.y - 0.3 * style.size};
        for (std::size_t k = 0; k < forces.size(); ++k, at.y -= 1.15 * style.size) {
            const std::string& node = scene_.document.model[problem.sways[k].prop].id;
            const std::string words = node + "  " + in_.text(forces[k], ui::Measure::Force);
            in_.sketch.reserve(ui::text_box(in_.sketch.painter().fonts(), at, words, style));
            in_.sketch.painter().text(at, words, style);
        }
    }

    void draw_one(const fc::Sheet& sheet, const fc::Problem& problem, fc::JointId id)
    {
        const fc::Joint& joint = problem[id];
        const auto turned_by = scene_.solution.sheet_problem(scene_.document).balanced_for(id);
        const bool is_turning = scene_.phase < 1.0 && !sheet.steps.empty() && turned_by &&
                                (!sheet.steps.back().joint || sheet.steps.back().joint == turned_by);
        const bool is_open = is_turning || (joint.is_released_once && sheet.end.rotations[id.index] != 0.0);
        const ui::Point at = displaced(joint.node) + ui::Point{0.0, -in_.sketch.px(17.0)};
        draw(in_.sketch, Lock{at, !is_open});
        if (!is_open) write_held(at, sheet.end.unbalance[id.index], sheet.tolerance);
    }

    void write_held(ui::Point at, double moment, double tolerance)
    {
        const bool is_done = std::abs(moment) <= tolerance;
        in_.sketch.caption({.text = numbers_.moment(moment),
                            .role = is_done ? ui::Role::FaintLabel : ui::Role::Reaction,
                            .target = at,
                            .toward = {1.0, -0.1},
                            .gap = in_.sketch.px(9.0),
                            .rank = drawing::Rank::Largest,
                            .weight = is_done ? ui::Weight::Regular : ui::Weight::Bold});
    }

    const Scene& scene_;
    const drawing::Scene& in_;
    ui::Box panel_;
    const drawing::SolvedCase& present_;
    double scale_;
    Numbers numbers_;
    Eigen::Vector3d middle_ = Eigen::Vector3d::Zero(); // props stand outside
};

/// Of a mechanism: why there is no deformed shape.
void write_remark(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    if (scene.solution.task->remarks.empty()) return;
    const ui::Theme theme = theme_in(panel, scene.look);
    ui::TextStyle style = theme.text(ui::Role::Error, ui::Anchor::TopLeft);
    style.plate = theme.background();
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    ui::Point at = panel.box.min +
                   ui::Point{0.6 * style.size, std::max(2.0 * style.size, panel.title ? panel.title->height() : 0.0)};
    const std::string words = fault_text(scene.solution.task->remarks.front(), scene.look.tr);
    for (const std::string& line :
         ui::wrapped_lines(painter.fonts(), words, style, panel.box.width() - 1.2 * style.size)) {
        painter.text(at, line, style);
        at.y += 1.4 * style.size;
    }
}

std::string bracketed(const std::string& words, const Scene& scene)
{
    return words + " [" + Numbers(scene.document, scene.solution, scene.look).moment_unit() + "]";
}

} // namespace

namespace {

constexpr std::size_t most_stiffnesses = 24; // of members that have theirs written

/// "EI", "2EI" at the middle of every member, or along it; in a narrow picture only where that takes room from nothing.
void write_stiffnesses(const Scene& scene, const drawing::Scene& in)
{
    const bool is_brief = in.units_stand == drawing::UnitsStand::InTitle;
    const std::size_t n = scene.document.model.members.size();
    for (std::size_t m = 0; m < n && n <= most_stiffnesses; ++m) {
        const femoop::MemberId id(m);
        const ui::Point a = in.projection(in.shape[id].start_node), b = in.projection(in.shape[id].end_node);
        const ui::Point below = std::abs(b.x - a.x) > std::abs(b.y - a.y) ? ui::Point{0.0, 1.0} : ui::Point{1.0, 0.0};
        const auto at = [&](double share) { return a + share * (b - a); };
        in.sketch.caption({.text = stiffness_text(*scene.solution.task, id, in.units.format()),
                           .role = ui::Role::FaintLabel,
                           .target = at(0.5),
                           .toward = below,
                           .rank = drawing::Rank::Minor,
                           .size = in.sketch.theme().type().small,
                           .others = {at(0.35), at(0.65), at(0.2), at(0.8)}, // loads and their values come first
                           .reach = 16.0,
                           .side = is_brief ? std::optional(ui::HalfPlane{a, below}) : std::nullopt,
                           .is_repeat = is_brief});
    }
}

} // namespace

namespace {

/// Whether units of loads follow from those of forces and lengths, so that a title can say them for all.
bool are_units_coherent(const ui::DisplayUnits& units)
{
    const auto name = [&](ui::Measure measure) { return units.unit(measure).name; };
    const std::string force = name(ui::Measure::Force), length = name(ui::Measure::Length);
    return name(ui::Measure::ForcePerLength) == force + "/" + length &&
           name(ui::Measure::Moment) == force + "·" + length;
}

/// A narrow picture says its units in the title, and the lengths of spans and storeys alone: so the structure is larger.
bool is_narrow(const Panel& panel, const Scene& scene)
{
    constexpr double narrow = 20.0; // ems
    return panel.box.width() < narrow * scene.look.full_theme().type().normal;
}

StructureLook look_of_loads(const Panel& panel, const Scene& scene)
{
    const bool is_brief = is_narrow(panel, scene) && are_units_coherent(units_of(scene.document.model, scene.look.tr));
    return {.show = {Show::Loads, Show::Values, Show::NodeNames, Show::Dimensions},
            .units_stand = is_brief ? drawing::UnitsStand::InTitle : drawing::UnitsStand::WithValues};
}

drawing::Chains chains_in(const Panel& panel, const Scene& scene)
{
    return is_narrow(panel, scene) ? drawing::Chains::Brief : drawing::Chains::Full;
}

/// "Structure and loads: G", in a narrow picture "Loads: G [kN, m]".
std::string title_of_loads(const Scene& scene, const StructureLook& look)
{
    const std::string& name = scene.document.model.case_name(scene.document.method.load_case);
    if (look.units_stand == drawing::UnitsStand::WithValues)
        return scene.look.tr("Structure and loads: {case}", {{"case", name}});
    const ui::DisplayUnits units = units_of(scene.document.model, scene.look.tr);
    return scene.look.tr("Loads: {case}", {{"case", name}}) + " [" + units.unit(ui::Measure::Force).name + ", " +
           units.unit(ui::Measure::Length).name + "]";
}

enum class Stiffnesses : std::uint8_t { Written, LeftOut };

Marks marks_of_loads(const Panel& panel, const Scene& scene, Stiffnesses stiffnesses)
{
    return [&scene, stiffnesses, chains = chains_in(panel, scene)](const drawing::Scene& in) {
        drawing::draw_members(in, drawing::Presence::Subject);
        draw_supports_and_joints(in);
        drawing::draw_loads(in);
        drawing::draw_names(in);
        drawing::draw_dimensions(in, chains);
        if (stiffnesses == Stiffnesses::Written) write_stiffnesses(scene, in);
    };
}

} // namespace

LoadedView view_of_loads(const Panel& panel, const Scene& scene, const ui::Fonts& fonts)
{
    const Marks marks = marks_of_loads(panel, scene, Stiffnesses::LeftOut); // which stand where they find room
    const StructureLook look = look_of_loads(panel, scene);
    Panel titled = panel;
    titled.title = title_box(ui::Painter(panel.box.size(), fonts), panel, title_of_loads(scene, look),
                             theme_in(panel, scene.look));
    if (is_beam(drawing::shape_of(scene.document.model))) return beam_around(marks, titled, scene, look, fonts);
    return {camera_around(marks, titled, scene, look, fonts)};
}

drawing::Grips draw_loaded(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    const StructureLook look = look_of_loads(panel, scene);
    Panel below = panel;
    below.title = draw_title(painter, panel, title_of_loads(scene, look), theme_in(panel, scene.look));
    return draw_structure_in(painter, below, scene, look, marks_of_loads(panel, scene, Stiffnesses::Written));
}

void draw_deformed_state(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    const fc::Sheet* const sheet = scene.solution.sheet(scene.document);
    const std::string title = sheet != nullptr ? bracketed(tr("Deformed shape, locks and their moments"), scene)
                                               : tr("Deformed shape, no joint locked");
    Panel below = panel;
    below.title = draw_title(painter, panel, title, theme_in(panel, scene.look));
    const std::optional<Solved> results = solved(scene);
    draw_structure_in(painter, below, scene, {{Show::Deformed}, scale_of(results)}, [&](const drawing::Scene& in) {
        drawing::draw_members(in, drawing::Presence::Behind);
        if (results) {
            const double scale = drawing::deformation_scale(in, results->present, panel.box.size());
            drawing::draw_deformed(in, results->present, scale);
            if (sheet != nullptr) Locked(scene, in, panel.box, results->present, scale).draw_all(*sheet);
        }
        draw_supports_and_joints(in);
    });
    if (!results) write_remark(painter, below, scene);
}

namespace {

/// One section force of the present state along the members.
void draw_force_state(ui::Painter& painter, const Panel& panel, const Scene& scene, femoop::MemberComponent component)
{
    const bool is_shear = component == femoop::MemberComponent::Vy;
    const std::optional<Solved> results = solved(scene);
    draw_structure_in(painter, panel, scene, {{is_shear ? Show::V : Show::M, Show::Values}, scale_of(results)},
                      [&](const drawing::Scene& in) {
                          drawing::draw_members(in, drawing::Presence::Subject);
                          if (results) {
                              const drawing::Diagram diagram = drawing::make_diagram(in, results->present, component,
                                                                                     panel.box.size());
                              drawing::draw_diagram(in, results->present, diagram);
                          }
                          draw_supports_and_joints(in);
                          if (results && is_shear) drawing::draw_reactions(in, results->present);
                      });
}

} // namespace

void draw_moment_state(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    Panel below = panel;
    below.title = draw_title(painter, panel, bracketed(tr("Bending moments on the tension side"), scene),
                             theme_in(panel, scene.look));
    draw_force_state(painter, below, scene, femoop::MemberComponent::Mz);
}

void draw_shear_state(ui::Painter& painter, const Panel& panel, const Scene& scene)
{
    const ui::Catalogue& tr = scene.look.tr;
    const std::string unit = units_of(scene.document.model, tr).unit(ui::Measure::Force).name;
    draw_title(painter, panel, tr("Shear forces and reactions") + " [" + unit + "]", theme_in(panel, scene.look));
    draw_force_state(painter, panel, scene, femoop::MemberComponent::Vy);
}

} // namespace cross
