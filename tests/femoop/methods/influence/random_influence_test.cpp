// Influence lines of random structures beside unit loads that stand on the path.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/result/components.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

using Generator = std::mt19937;

double between(Generator& dice, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(dice);
}

template <class List> auto any_of(Generator& dice, const List& list)
{
    return list[std::uniform_int_distribution<std::size_t>(0, list.size() - 1)(dice)];
}

/// Up to four members, one after the other.
std::vector<MemberId> random_path(const Model& model, Generator& dice)
{
    std::vector<MemberId> path{MemberId(std::uniform_int_distribution<std::size_t>(0, model.members.size() - 1)(dice))};
    NodeId at = model[path.front()].nodes[1];
    while (path.size() < 4) {
        std::vector<MemberId> next;
        for (std::size_t i = 0; i < model.members.size(); ++i) {
            const auto& nodes = model.members[i].nodes;
            const bool is_new = std::ranges::find(path, MemberId(i)) == path.end();
            if (is_new && (nodes[0] == at || nodes[1] == at)) next.emplace_back(i);
        }
        if (next.empty()) break;
        path.push_back(any_of(dice, next));
        const auto& nodes = model[path.back()].nodes;
        at = nodes[0] == at ? nodes[1] : nodes[0];
    }
    return path;
}

NodeVector random_load(const Model& model, Generator& dice)
{
    NodeVector load{};
    for (const Dof dof : all_dofs)
        if (dofs(model.analysis).contains(dof) && (!is_rotation(dof) || model.analysis == AnalysisKind::Frame2d))
            load[index(dof)] = between(dice, -1.0, 1.0);
    return load;
}

/// Anywhere within it, at its ends, or as near to them as one can still see.
Percent random_section(Generator& dice, int i)
{
    const double near = std::pow(10.0, between(dice, -10.0, 0.0));
    switch (i) {
    case 4: return {near};
    case 5: return {100.0 - near};
    case 6: return {0.0};
    case 7: return {100.0};
    default: return {between(dice, 0.0, 100.0)};
    }
}

std::vector<MovingEffect> random_effects(const Model& model, const std::vector<MemberId>& path, Generator& dice)
{
    std::vector<MovingEffect> effects;
    for (int i = 0; i < 8; ++i) { // half of them on the path
        MovingEffect effect;
        effect.member = i % 2 == 0
                            ? any_of(dice, path)
                            : MemberId(std::uniform_int_distribution<std::size_t>(0, model.members.size() - 1)(dice));
        effect.component = any_of(dice, member_components(model.analysis));
        effect.at = random_section(dice, i);
        effects.push_back(effect);
    }
    for (std::size_t n = 0; n < model.nodes.size(); n += 2) {
        MovingEffect effect{.quantity = ExpectedQuantity::Displacement, .node = NodeId(n)};
        effect.dof = any_of(dice, dof_list(model.analysis));
        effects.push_back(effect);
        effect.quantity = ExpectedQuantity::Reaction;
        if (model.nodes[n].support) effects.push_back(effect);
    }
    return effects;
}

double read(const CaseResult& result, const MovingEffect& effect)
{
    if (effect.quantity == ExpectedQuantity::Reaction) return result.reaction(*effect.node)[index(*effect.dof)];
    if (effect.node) return result.displacement(*effect.node)[index(*effect.dof)];
    const Curve curve = result.curve(*effect.member);
    const double x = 0.01 * std::get<Percent>(*effect.at).value * curve.length();
    return curve.value(*effect.component, x, x < curve.length() ? Side::After : Side::Before);
}

/// The unit load at places of the path, each a load case.
Model with_loads(Model model, const PathLayout& path, const NodeVector& load, const std::vector<double>& places)
{
    model.load_cases.clear();
    for (const double s : places) {
        const PathPlace place = path.place(s);
        PointLoad point{.at = Quantity(place.x), .components = {}};
        for (const Dof dof : all_dofs)
            if (load[index(dof)] != 0.0) point.components.push_back({dof, load[index(dof)]});
        model.load_cases.push_back({.id = std::to_string(model.load_cases.size()), .members = {{place.member, point}}});
    }
    return model;
}

void compare(const Model& model, Generator& dice)
{
    const std::vector<MemberId> members = random_path(model, dice);
    const PathLayout path = lay_out(model, members);
    const NodeVector load = random_load(model, dice);
    const std::vector<MovingEffect> effects = random_effects(model, members, dice);
    std::vector<double> places;
    for (int i = 0; i < 7; ++i) places.push_back(between(dice, 0.0, path.length()));
    InfluenceAnalysis analysis(model);
    const std::vector<InfluenceLine> lines = analysis.lines(path, load, effects);
    const Results direct = analyse(with_loads(model, path, load, places));
    for (std::size_t k = 0; k < effects.size(); ++k) {
        CAPTURE(effect_name(model, effects[k]));
        double largest = lines[k].ordinates.largest();
        for (std::size_t i = 0; i < places.size(); ++i)
            largest = std::max(largest, std::abs(read(direct[CaseId(i)], effects[k])));
        for (std::size_t i = 0; i < places.size(); ++i) {
            CAPTURE(places[i]);
            const double wanted = read(direct[CaseId(i)], effects[k]);
            const double tolerance = 1e-7 * largest + 1e-12;
            CHECK(std::abs(lines[k].ordinates.value(places[i]) - wanted) <= tolerance);
        }
    }
}

/// Some members of it no longer lengthen, and one is rigid.
Model constrained(Model model, Generator& dice)
{
    for (Member& member : model.members) {
        if (member.bar || between(dice, 0.0, 1.0) < 0.8) continue;
        member.inextensible = true;
        if (between(dice, 0.0, 1.0) < 0.3 && member.start.release.is_empty()) {
            member.rigid = true;
            member.inextensible = false;
        }
    }
    return model;
}

} // namespace

TEST_CASE("Each ordinate is the effect of a unit load there, in every kind of structure")
{
    for (const AnalysisKind kind : every_model)
        for (unsigned seed = 0; seed < 8; ++seed) {
            CAPTURE(name(kind));
            CAPTURE(seed);
            Generator dice(seed);
            Model model = random_structure(kind, seed);
            model.load_cases.clear();
            compare(model, dice);
        }
}

TEST_CASE("Constraints change nothing of that")
{
    int n_compared = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        Generator dice(seed);
        Model model = random_structure(AnalysisKind::Frame2d, seed);
        model.load_cases.clear();
        model = constrained(model, dice);
        try {
            analyse(model);
        } catch (const ModelError&) {
            continue; // the constraints lock it
        }
        compare(model, dice);
        ++n_compared;
    }
    CHECK(n_compared > 4);
}
