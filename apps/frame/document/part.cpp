#include "apps/frame/document/part.h"

#include "apps/frame/document/document.h"
#include "apps/frame/document/overloaded.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Message;
using ui::translatable;

namespace {

Message named(std::string_view sentence, const std::string& id) { return {sentence, {{"id", id}}}; }

std::string_view load_title(const MemberLoad& load)
{
    return std::visit(Overloaded{
                          [](const DistributedLoad&) { return translatable("Distributed load on member {id}"); },
                          [](const PointLoad&) { return translatable("Point load on member {id}"); },
                          [](const EndLoads&) { return translatable("End loads on member {id}"); },
                          [](const TemperatureLoad&) { return translatable("Temperature of member {id}"); },
                          [](const Misfit&) { return translatable("Misfit of member {id}"); },
                      },
                      load.load);
}

} // namespace

bool has(const Document& document, const Part& part)
{
    const auto* const line = std::get_if<DimensionPlace>(&part);
    return line ? line->dimension < document.companion.dimensions.size() : has(document.model, part);
}

bool has(const Model& model, const Part& part)
{
    const auto in_case = [&](std::size_t load_case, auto list, std::size_t place) {
        return load_case < model.load_cases.size() && place < (model.load_cases[load_case].*list).size();
    };
    return std::visit(Overloaded{
                          [&](NodeId id) { return id.index < model.nodes.size(); },
                          [&](MemberId id) { return id.index < model.members.size(); },
                          [&](MaterialId id) { return id.index < model.materials.size(); },
                          [&](SectionId id) { return id.index < model.sections.size(); },
                          [&](LoadCasePlace p) { return p.load_case < model.load_cases.size(); },
                          [&](CombinationPlace p) { return p.combination < model.combinations.size(); },
                          [&](NodeLoadPlace p) { return in_case(p.load_case, &LoadCase::nodes, p.load); },
                          [&](SettlementPlace p) { return in_case(p.load_case, &LoadCase::settlements, p.settlement); },
                          [&](MemberLoadPlace p) { return in_case(p.load_case, &LoadCase::members, p.load); },
                          [](DimensionPlace) { return false; },
                      },
                      part);
}

Message title(const Document& document, const Part& part)
{
    const auto* const place = std::get_if<DimensionPlace>(&part);
    if (place == nullptr) return title(document.model, part);
    const DimensionLine& line = document.companion.dimensions[place->dimension];
    return named(translatable("Dimension line {id}"), line.nodes.front() + "–" + line.nodes.back());
}

Message title(const Model& model, const Part& part)
{
    const auto& cases = model.load_cases;
    return std::visit(Overloaded{
                          [&](NodeId id) { return named(translatable("Node {id}"), model[id].id); },
                          [&](MemberId id) { return named(translatable("Member {id}"), model[id].id); },
                          [&](MaterialId id) { return named(translatable("Material {id}"), model[id].id); },
                          [&](SectionId id) { return named(translatable("Section {id}"), model[id].id); },
                          [&](LoadCasePlace p) { return named(translatable("Load case {id}"), cases[p.load_case].id); },
                          [&](CombinationPlace p) {
                              return named(translatable("Combination {id}"), model.combinations[p.combination].id);
                          },
                          [&](NodeLoadPlace p) {
                              return named(translatable("Load on node {id}"),
                                           model[cases[p.load_case].nodes[p.load].node].id);
                          },
                          [&](SettlementPlace p) {
                              const NodeId node = cases[p.load_case].settlements[p.settlement].node;
                              return named(translatable("Settlement of node {id}"), model[node].id);
                          },
                          [&](MemberLoadPlace p) {
                              const MemberLoad& load = cases[p.load_case].members[p.load];
                              return named(load_title(load), model[load.member].id);
                          },
                          [](DimensionPlace) { return Message(translatable("Dimension line")); },
                      },
                      part);
}

namespace {

// Calls visit(part, node or member that it acts on) for every load and settlement.
template <class Visit> void each_load(const Model& model, Visit&& visit)
{
    for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
        const LoadCase& load_case = model.load_cases[c];
        for (std::size_t i = 0; i < load_case.nodes.size(); ++i)
            visit(NodeLoadPlace{c, i}, Part(load_case.nodes[i].node));
        for (std::size_t i = 0; i < load_case.settlements.size(); ++i)
            visit(SettlementPlace{c, i}, Part(load_case.settlements[i].node));
        for (std::size_t i = 0; i < load_case.members.size(); ++i)
            visit(MemberLoadPlace{c, i}, Part(load_case.members[i].member));
    }
}

} // namespace

std::vector<Part> parts(const Model& model)
{
    std::vector<Part> all;
    for (std::size_t i = 0; i < model.materials.size(); ++i) all.emplace_back(MaterialId(i));
    for (std::size_t i = 0; i < model.sections.size(); ++i) all.emplace_back(SectionId(i));
    for (std::size_t i = 0; i < model.nodes.size(); ++i) all.emplace_back(NodeId(i));
    for (std::size_t i = 0; i < model.members.size(); ++i) all.emplace_back(MemberId(i));
    for (std::size_t i = 0; i < model.load_cases.size(); ++i) all.emplace_back(LoadCasePlace{i});
    each_load(model, [&](const Part& load, const Part&) { all.push_back(load); });
    for (std::size_t i = 0; i < model.combinations.size(); ++i) all.emplace_back(CombinationPlace{i});
    return all;
}

std::size_t load_case_of(const Part& load)
{
    if (const auto* const place = std::get_if<NodeLoadPlace>(&load)) return place->load_case;
    if (const auto* const place = std::get_if<SettlementPlace>(&load)) return place->load_case;
    return std::get<MemberLoadPlace>(load).load_case;
}

std::vector<Part> loads_on(const Model& model, const Part& part)
{
    std::vector<Part> loads;
    each_load(model, [&](const Part& load, const Part& loaded) {
        if (loaded == part) loads.push_back(load);
    });
    return loads;
}

} // namespace frame
