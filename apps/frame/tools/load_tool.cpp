#include "apps/frame/tools/load_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/frame/document/loading.h"
#include "femoop/edit/member_line.h"
#include "ui/canvas/click.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

bool is_upright(AnalysisKind kind) { return kind == AnalysisKind::Grillage || is_3d(kind); } // z is up
Dof downwards(AnalysisKind kind) { return is_upright(kind) ? Dof::uz : Dof::uy; }

bool is_distributed(const ToolLoad& load) { return load.kind != LoadKind::Force && load.kind != LoadKind::Moment; }

/// The direction, or the axis of a moment.
Dof dof_of(const ToolLoad& load, AnalysisKind kind)
{
    const bool turns = load.kind == LoadKind::Moment;
    switch (load.way) {
    case LoadWay::X: return turns ? Dof::rx : Dof::ux;
    case LoadWay::Y: return turns ? Dof::ry : Dof::uy;
    case LoadWay::Z: return turns ? Dof::rz : Dof::uz;
    case LoadWay::Down: break;
    }
    return downwards(kind);
}

Quantity along_axis(const Quantity& value, LoadWay way) { return way == LoadWay::Down ? Quantity(-value) : value; }

/// From nothing to the whole value, either way.
DistributedLoad::Value triangle(Dof dof, const Quantity& value, bool grows)
{
    if (grows) return {dof, Quantity(0.0), value};
    return {dof, value, Quantity(0.0)};
}

ui::Message label(const Work& work, const Part& part)
{
    return {translatable("Load: {part}"), {{"part", title(work.document, part)}}};
}

double foot_of(const MemberLine& line, const Aim& at)
{
    return (Eigen::Vector3d(at.pointer.x(), at.pointer.y(), 0.0) - line.start).dot(line.direction);
}

/// The place of a member's line that is nearest to the pointer, at one of its ends where it is near.
double place_along(const MemberLine& line, const Aim& at, double grid)
{
    const double near = ui::click_reach * at.pixel, step = 0.1 * grid;
    const double x = foot_of(line, at);
    if (x < near) return 0.0;
    if (x > line.length - near) return line.length;
    return at.is_exact || !(step > 0.0) ? x : std::clamp(step * std::round(x / step), 0.0, line.length);
}

} // namespace

std::optional<Component> force_of(const ToolSettings& settings, AnalysisKind kind)
{
    if (is_distributed(settings.load)) return std::nullopt;
    const Quantity& value = settings.load.kind == LoadKind::Moment ? settings.moment : settings.force;
    const Component load{dof_of(settings.load, kind), along_axis(value, settings.load.way)};
    return dofs(kind).contains(load.dof) ? std::optional(load) : std::nullopt;
}

std::optional<MemberLoadValue> member_load_of(const ToolSettings& settings, AnalysisKind kind, const LoadReach& reach)
{
    if (!is_distributed(settings.load)) {
        const auto force = force_of(settings, kind);
        if (!force) return std::nullopt;
        return PointLoad{.at = reach.at, .components = {*force}};
    }
    const bool is_across = settings.load.kind == LoadKind::UniformAcross;
    const Dof dof = is_across ? Dof::uy : dof_of(settings.load, kind);
    if (!is_across && !dofs(kind).contains(dof)) return std::nullopt;
    const Quantity value = along_axis(settings.line_load, settings.load.way);
    DistributedLoad load{.values = {{dof, value, std::nullopt}}, .from = reach.from, .to = reach.to};
    if (settings.load.kind == LoadKind::Triangular) load.values = {triangle(dof, value, reach.grows)};
    if (is_across) load.axes = LoadAxes::Local;
    return load;
}

std::optional<Change> LoadTool::press(const Work& work, const Aim& at)
{
    stroke_.reset();
    const Model& model = work.document.model;
    if (at.node) {
        const auto load = force_of(settings_, model.analysis);
        if (!load) return std::nullopt;
        return Change{label(work, *at.node),
                      [load = *load, node = *at.node, wanted = settings_.load_case](Document& changed) {
                          add_node_load(changed, load_case_for(changed, wanted), node, load);
                      }};
    }
    if (!at.cut) return std::nullopt;
    if (!is_distributed(settings_.load)) return put(work, at.cut->member, {.at = Quantity(at.cut->x)});
    const MemberLine line = line_of(model, model[at.cut->member]);
    const double x = is_3d(model.analysis) ? at.cut->x : place_along(line, at, settings_.grid);
    stroke_ = Stroke{.member = at.cut->member, .length = line.length, .start = x, .now = x, .press = foot_of(line, at)};
    stroke_->begin = stroke_->end = line.at(x);
    return std::nullopt;
}

std::optional<Change> LoadTool::move(const Work& work, const Aim& to)
{
    if (!stroke_ || stroke_->member.index >= work.document.model.members.size()) return std::nullopt;
    const MemberLine line = line_of(work.document.model, work.document.model[stroke_->member]);
    const double x = place_along(line, to, settings_.grid);
    stroke_->is_drawn = stroke_->is_drawn || std::abs(foot_of(line, to) - stroke_->press) > ui::click_reach * to.pixel;
    if (!stroke_->is_drawn) return std::nullopt;
    stroke_->now = x;
    stroke_->end = line.at(x);
    return std::nullopt;
}

std::optional<Change> LoadTool::release(const Work& work, const Aim&)
{
    const std::optional<Stroke> stroke = std::exchange(stroke_, std::nullopt);
    if (!stroke || stroke->member.index >= work.document.model.members.size()) return std::nullopt;
    if (!stroke->is_drawn) return put(work, stroke->member, {.grows = stroke->start >= 0.5 * stroke->length});
    if (stroke->now == stroke->start) return std::nullopt; // back to where it began
    LoadReach reach{.grows = stroke->now > stroke->start};
    const auto [from, to] = std::minmax(stroke->start, stroke->now);
    if (from > 0.0) reach.from = Quantity(from);
    if (to < stroke->length) reach.to = Quantity(to);
    return put(work, stroke->member, reach);
}

std::optional<Change> LoadTool::put(const Work& work, MemberId member, const LoadReach& reach) const
{
    const auto load = member_load_of(settings_, work.document.model.analysis, reach);
    if (!load) return std::nullopt;
    return Change{label(work, member), [=, load = *load, wanted = settings_.load_case](Document& changed) {
                      add_member_load(changed, load_case_for(changed, wanted), member, load);
                  }};
}

bool LoadTool::escape() { return std::exchange(stroke_, std::nullopt).has_value(); }

Preview LoadTool::preview() const
{
    if (!stroke_ || !stroke_->is_drawn) return {};
    return {.lines = {{stroke_->begin, stroke_->end}}};
}

} // namespace frame
