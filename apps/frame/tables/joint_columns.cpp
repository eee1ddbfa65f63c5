#include <algorithm>

#include "apps/drawing/measures.h"
#include "apps/frame/document/command.h"
#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Message;
using ui::translatable;

namespace {

MemberEnd& end_at(Model& model, const Part& part, MemberEndName end)
{
    Member& member = model.members[std::get<MemberId>(part).index];
    return end == MemberEndName::Start ? member.start : member.end;
}
const MemberEnd& end_at(const Model& model, const Part& part, MemberEndName end)
{
    const Member& member = model[std::get<MemberId>(part)];
    return end == MemberEndName::Start ? member.start : member.end;
}

// The spring takes the place of a release on the same degree of freedom.
Column spring_column(std::string_view heading, MemberEndName end, Dof dof)
{
    return number_column(Message(heading, {{"dof", std::string(name(dof))}}), spring_measures.of(dof),
                         {.get = [=](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto& springs = end_at(model, part, end).springs;
                              const auto found = std::ranges::find(springs, dof, &Spring::dof);
                              return found != springs.end() ? std::optional(found->stiffness) : std::nullopt;
                          },
                          .set = [=](Document& document, const Part& part, const std::optional<Quantity>& value,
                                     const Manner& manner) -> Refusal {
                              if (value && !(*value > 0.0)) return manner.tr("a stiffness is greater than 0");
                              MemberEnd& joint = end_at(document.model, part, end);
                              std::erase_if(joint.springs, [dof](const Spring& spring) { return spring.dof == dof; });
                              if (!value) return std::nullopt;
                              joint.release.erase(dof);
                              joint.springs.push_back({dof, *value});
                              return std::nullopt;
                          }});
}

// One of the lengths of a rigid arm; the first that is given makes the others 0.
Column offset_column(std::string_view heading, MemberEndName end, std::size_t axis)
{
    static constexpr const char* axes[] = {"x", "y", "z"};
    return number_column(Message(heading, {{"axis", axes[axis]}}), ui::Measure::Length,
                         {.get = [=](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto& offset = end_at(model, part, end).offset;
                              return axis < offset.size() ? std::optional(offset[axis]) : std::nullopt;
                          },
                          .set = [=](Document& document, const Part& part, const std::optional<Quantity>& value,
                                     const Manner&) -> Refusal {
                              auto& offset = end_at(document.model, part, end).offset;
                              if (!value && offset.empty()) return std::nullopt;
                              offset.resize(n_coordinates(document.model.analysis));
                              offset[axis] = value.value_or(Quantity(0.0));
                              if (std::ranges::all_of(offset, [](double length) { return length == 0.0; }))
                                  offset.clear();
                              return std::nullopt;
                          }});
}

} // namespace

Column release_column(std::string_view heading, MemberEndName end)
{
    Column column{.heading = heading, .read = {}};
    column.read = [end](const Model& model, const Part& part) -> CellValue {
        return names_of(end_at(model, part, end).release);
    };
    column.write = [end](Document& document, const Part& part, const CellText& entry) -> Refusal {
        const DofSet allowed = member_dofs(document.model.analysis);
        const auto released = dofs_of(entry, allowed);
        if (const auto* const reason = std::get_if<std::string>(&released)) return *reason;
        for (const Dof dof : all_dofs) {
            if (!allowed.contains(dof)) continue;
            const Switch state = std::get<DofSet>(released).contains(dof) ? Switch::On : Switch::Off;
            set_release(document, std::get<MemberId>(part), end, dof, state);
        }
        return std::nullopt;
    };
    return column;
}

std::vector<Column> joint_columns(const Model& model)
{
    Column member = name_column<MemberId>(translatable("Member"), &Model::members);
    member.write = {}; // it is named where it is made
    std::vector<Column> all{std::move(member)};
    const auto add_end = [&](MemberEndName end, std::string_view released, std::string_view spring,
                             std::string_view offset) {
        all.push_back(release_column(released, end));
        for (const Dof dof : all_dofs)
            if (member_dofs(model.analysis).contains(dof)) all.push_back(spring_column(spring, end, dof));
        for (std::size_t axis = 0; axis < n_coordinates(model.analysis); ++axis)
            all.push_back(offset_column(offset, end, axis));
    };
    add_end(MemberEndName::Start, translatable("Released at start"), translatable("Spring {dof}, start"),
            translatable("Offset {axis}, start"));
    add_end(MemberEndName::End, translatable("Released at end"), translatable("Spring {dof}, end"),
            translatable("Offset {axis}, end"));
    return all;
}

} // namespace frame
