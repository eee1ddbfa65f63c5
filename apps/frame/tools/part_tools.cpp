#include "apps/frame/tools/part_tools.h"

#include <array>

#include "apps/frame/document/command.h"
#include "apps/frame/document/drawing.h"
#include "femoop/edit/member_line.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Message;
using ui::translatable;

namespace {

Message about(const Document& document, std::string_view sentence, const Part& part)
{
    return {sentence, {{"part", title(document, part)}}};
}

} // namespace

namespace {

Change freed(const Document& document, NodeId node)
{
    return {about(document, translatable("Free: {part}"), node),
            [=](Document& changed) { set_support(changed, node, std::nullopt); }};
}

} // namespace

std::optional<Change> SupportTool::press(const Work& work, const Aim& at)
{
    if (at.points_at_support()) return freed(work.document, at.support->node);
    if (!at.node) return std::nullopt;
    const NodeId node = *at.node;
    const std::optional<Support>& there = work.document.model[node].support;
    const SupportKind kind = settings_.support;
    if (there && there->kind == kind) return freed(work.document, node);
    return Change{about(work.document, translatable("Support: {part}"), node),
                  [=](Document& changed) { set_support(changed, node, kind); }};
}

std::optional<Change> HingeTool::press(const Work& work, const Aim& at)
{
    const Model& model = work.document.model;
    if (is_truss(model.analysis)) return std::nullopt; // hinged already
    const std::string_view sentence = translatable("Hinge: {part}");
    if (at.node) {
        const Joint joint = model[*at.node].hinge ? Joint::Rigid : Joint::Hinged;
        return Change{about(work.document, sentence, *at.node),
                      [joint, node = *at.node](Document& changed) { set_joint(changed, node, joint); }};
    }
    if (!at.cut) return std::nullopt;
    const Member& member = model[at.cut->member];
    const bool is_start = at.cut->x < 0.5 * line_of(model, member).length;
    const MemberEndName end = is_start ? MemberEndName::Start : MemberEndName::End;
    const Dof bending = is_3d(model.analysis) ? Dof::ry : Dof::rz;
    const bool is_hinged = (is_start ? member.start : member.end).release.contains(bending);
    return Change{about(work.document, sentence, at.cut->member), [=, id = at.cut->member](Document& changed) {
                      set_release(changed, id, end, bending, is_hinged ? Switch::Off : Switch::On);
                  }};
}

std::optional<Change> DeleteTool::press(const Work& work, const Aim& at)
{
    if (at.points_at_support()) return freed(work.document, at.support->node);
    const std::optional<Part> part = at.part();
    if (!part) return std::nullopt;
    return Change{about(work.document, translatable("Delete: {part}"), *part),
                  [part = *part](Document& changed) { remove(changed, std::array{part}); }};
}

} // namespace frame
