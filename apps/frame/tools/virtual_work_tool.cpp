#include "apps/frame/tools/virtual_work_tool.h"

#include <utility>

#include "femoop/geometry/member_geometry.h"

namespace frame {

std::optional<Change> VirtualWorkTool::press(const Work& work, const Aim& at)
{
    const femoop::Model& model = work.document.model;
    pressed_ = work.virtual_work;
    before_ = *pressed_;
    const bool is_shown = work.virtual_work->is_on(model); // else the sheet is parted now, under the hand
    if (at.node) work.virtual_work->ask(model, *at.node);
    else if (at.support) work.virtual_work->ask(model, at.support->node);
    else if (at.cut) {
        if (is_shown) held_ = at.cut->member;
        const double length = femoop::geometry_of(model, model[at.cut->member]).length;
        work.virtual_work->ask(model, Cut{at.cut->member, round_section(at.cut->x, length, at)});
    }
    return std::nullopt;
}

bool VirtualWorkTool::escape()
{
    if (pressed_ == nullptr) return false;
    *std::exchange(pressed_, nullptr) = before_;
    held_.reset();
    return true;
}

bool VirtualWorkTool::takes_hold(const Work& work, const Aim& at) const
{
    return at.points_at_section() && work.virtual_work->is_on(work.document.model);
}

std::optional<Change> VirtualWorkTool::move(const Work& work, const Aim& to)
{
    if (const auto section = held_ ? section_under(work.document.model, *held_, to) : std::nullopt)
        work.virtual_work->ask(work.document.model, *section);
    return std::nullopt;
}

std::optional<Change> VirtualWorkTool::release(const Work&, const Aim&)
{
    held_.reset();
    pressed_ = nullptr;
    return std::nullopt;
}

} // namespace frame
