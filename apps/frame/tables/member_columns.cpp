#include <Eigen/Core>
#include <algorithm>

#include "apps/frame/document/command.h"
#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

constexpr auto member_of = [](auto& model, const Part& part) -> auto&
{
    return model.members[std::get<MemberId>(part).index];
};

Column end_column(std::string_view heading, std::size_t end)
{
    Column column{.heading = heading, .need = Need::Required, .read = {}};
    column.read = [end](const Model& model, const Part& part) -> CellValue {
        return model[member_of(model, part).nodes[end]].id;
    };
    column.write = [end](Document& document, const Part& part, const CellText& entry) -> Refusal {
        const auto node = place_of_name(document.model.nodes, entry);
        if (const auto* const reason = std::get_if<std::string>(&node)) return *reason;
        member_of(document.model, part).nodes[end] = NodeId(std::get<std::size_t>(node));
        return std::nullopt;
    };
    return column;
}

// From node to node.
Column length_column()
{
    Column column{.heading = translatable("Length"), .measure = Measure::Length, .is_number = true, .read = {}};
    column.read = [](const Model& model, const Part& part) -> CellValue {
        const Member& member = member_of(model, part);
        const auto place = [&](std::size_t end) {
            const Node& node = model[member.nodes[end]];
            return Eigen::Vector3d(node.at[0], node.at[1], is_3d(model.analysis) ? node.at[2].value() : 0.0);
        };
        return Quantity((place(1) - place(0)).norm());
    };
    return column;
}

// The material or section of a member; members that are rigid need none.
template <class Id, class Entries>
Column property_column(std::string_view heading, Entries Model::*list, std::optional<Id> Member::*property)
{
    Column column{.heading = heading, .read = {}};
    column.read = [=](const Model& model, const Part& part) -> CellValue {
        const std::optional<Id>& id = member_of(model, part).*property;
        if (!id) return {};
        return (model.*list)[id->index].id;
    };
    column.write = [=](Document& document, const Part& part, const CellText& entry) -> Refusal {
        std::optional<Id>& id = member_of(document.model, part).*property;
        if (entry.is_empty()) {
            id.reset();
            return std::nullopt;
        }
        const auto place = place_of_name(document.model.*list, entry);
        if (const auto* const reason = std::get_if<std::string>(&place)) return *reason;
        id = Id(std::get<std::size_t>(place));
        return std::nullopt;
    };
    return column;
}

Column trait_column(std::string_view heading, MemberTrait trait)
{
    return word_column(heading, {.words = {translatable("no"), translatable("yes")},
                                 .get = [trait](const Model& model, const Part& part) -> std::size_t {
                                     return has_trait(member_of(model, part), trait) ? 1 : 0;
                                 },
                                 .set =
                                     [trait](Document& document, const Part& part, std::size_t word) {
                                         set_trait(document, std::get<MemberId>(part), trait,
                                                   word == 1 ? Switch::On : Switch::Off);
                                     }});
}

Column theory_column()
{
    return word_column(translatable("Theory"),
                       {.words = {translatable("Euler-Bernoulli"), translatable("Timoshenko")},
                        .get = [](const Model& model, const Part& part) -> std::size_t {
                            return member_of(model, part).theory == BeamTheory::Timoshenko ? 1 : 0;
                        },
                        .set =
                            [](Document& document, const Part& part, std::size_t word) {
                                set_theory(document, std::get<MemberId>(part),
                                           word == 1 ? BeamTheory::Timoshenko : BeamTheory::EulerBernoulli);
                            }});
}

// Of a tapered member at one end; the first that is given holds at both, an empty one makes it prismatic.
Column depth_column(std::string_view heading, std::size_t end)
{
    return number_column(heading, Measure::SectionLength,
                         {.get = [end](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto& depths = member_of(model, part).depths;
                              return end < depths.size() ? std::optional(depths[end]) : std::nullopt;
                          },
                          .set = [end](Document& document, const Part& part, const std::optional<Quantity>& value,
                                       const Manner&) -> Refusal {
                              auto& depths = member_of(document.model, part).depths;
                              if (!value) depths.clear();
                              else if (depths.size() == 2) depths[end] = *value;
                              else depths = {*value, *value};
                              return std::nullopt;
                          }});
}

// One of the three numbers of `up`; the first that is given makes the others 0.
Column up_column(std::size_t axis)
{
    static constexpr const char* axes[] = {"x", "y", "z"};
    return number_column(ui::Message(translatable("Up {axis}"), {{"axis", axes[axis]}}), Measure::Plain,
                         {.get = [axis](const Model& model, const Part& part) -> std::optional<Quantity> {
                              const auto& up = member_of(model, part).up;
                              return axis < up.size() ? std::optional(up[axis]) : std::nullopt;
                          },
                          .set = [axis](Document& document, const Part& part, const std::optional<Quantity>& value,
                                        const Manner&) -> Refusal {
                              auto& up = member_of(document.model, part).up;
                              if (!value && up.empty()) return std::nullopt;
                              up.resize(3);
                              up[axis] = value.value_or(Quantity(0.0));
                              if (std::ranges::all_of(up, [](double number) { return number == 0.0; })) up.clear();
                              return std::nullopt;
                          }});
}

} // namespace

std::vector<Column> member_columns(const Model& model)
{
    std::vector<Column> all{
        name_column<MemberId>(translatable("Member"), &Model::members),
        end_column(translatable("Start"), 0),
        end_column(translatable("End"), 1),
        length_column(),
        property_column(translatable("Material"), &Model::materials, &Member::material),
        property_column(translatable("Section"), &Model::sections, &Member::section),
    };
    if (is_truss(model.analysis)) return all;
    all.push_back(release_column(translatable("Released at start"), MemberEndName::Start));
    all.push_back(release_column(translatable("Released at end"), MemberEndName::End));
    all.push_back(trait_column(translatable("Bar"), MemberTrait::Bar));
    all.push_back(trait_column(translatable("Rigid"), MemberTrait::Rigid));
    all.push_back(theory_column());
    all.push_back(field_column(translatable("Elastic foundation"), Measure::FoundationModulus,
                               [](auto& m, const Part& part) { return &member_of(m, part).foundation; }));
    if (model.analysis == AnalysisKind::Frame2d) {
        all.push_back(depth_column(translatable("Depth h, start"), 0));
        all.push_back(depth_column(translatable("Depth h, end"), 1));
    }
    for (std::size_t i = 0; i < 3 && is_3d(model.analysis); ++i) all.push_back(up_column(i));
    return all;
}

} // namespace frame
