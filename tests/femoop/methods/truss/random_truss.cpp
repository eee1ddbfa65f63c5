#include "tests/femoop/methods/truss/random_truss.h"

#include <algorithm>

#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/node_position.h"
#include "femoop/methods/dice.h"

using namespace femoop;

namespace {

double turn_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::Vector2d place_of(const Model& model, NodeId node) { return position_of(model, node).head<2>(); }

Eigen::Vector2d place(Dice& dice, double size)
{
    const double reach = 1000.0 * size;
    return {dice.roll(0, static_cast<int>(reach)) / 1000.0, dice.roll(0, static_cast<int>(reach)) / 1000.0};
}

void load_all(TrussMaker& made, Dice& dice, const std::vector<NodeId>& joints)
{
    for (const NodeId joint : joints)
        made.load(made.model[joint].id, {dice.roll(-500, 500) / 7.0, dice.roll(-500, 500) / 11.0});
}

TrussMaker triangle()
{
    TrussMaker made;
    made.node("0", {0.0, 0.0}, SupportKind::Pin).node("1", {5.3, 0.4}, SupportKind::Roller).node("2", {2.1, 3.7});
    made.bar("0", "1").bar("1", "2").bar("2", "0");
    return made;
}

bool do_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d)
{
    const double room = 0.05; // neither crossing nor nearly touching
    const double s = turn_of(b - a, c - a), t = turn_of(b - a, d - a), u = turn_of(d - c, a - c),
                 v = turn_of(d - c, b - c);
    return s * t < room && u * v < room;
}

/// Whether a new joint on two bars keeps clear of everything.
bool is_clear(const Model& model, NodeId a, NodeId b, const Eigen::Vector2d& joint)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if ((place_of(model, NodeId(i)) - joint).norm() < 0.4) return false;
    for (const Member& member : model.members) {
        const auto& [c, d] = member.nodes;
        for (const NodeId from : {a, b}) {
            if (c == from || d == from) {
                const Eigen::Vector2d other = place_of(model, c == from ? d : c) - place_of(model, from);
                const Eigen::Vector2d own = joint - place_of(model, from);
                if (std::abs(turn_of(other, own)) < 0.05 * other.norm() * own.norm() && other.dot(own) > 0.0)
                    return false;
                continue;
            }
            if (do_cross(place_of(model, from), joint, place_of(model, c), place_of(model, d))) return false;
        }
    }
    return true;
}

} // namespace

TrussMaker::TrussMaker()
{
    model.analysis = AnalysisKind::Truss2d;
    model.add(Material{.id = "m", .E = 2e8});
    model.add(Section{.id = "s", .A = 0.003});
    model.add(LoadCase{.id = "P"});
}

TrussMaker& TrussMaker::node(const std::string& id, const Eigen::Vector2d& at, SupportKind kind)
{
    Node one{.id = id, .at = {at.x(), at.y(), 0.0}};
    if (kind != SupportKind::Custom) one.support = Support{.kind = kind};
    model.add(std::move(one));
    return *this;
}

TrussMaker& TrussMaker::bar(const std::string& a, const std::string& b)
{
    model.add(Member{.id = a + "-" + b,
                     .nodes = {*model.find_node(a), *model.find_node(b)},
                     .material = MaterialId(0),
                     .section = SectionId(0)});
    return *this;
}

TrussMaker& TrussMaker::bars(const std::vector<std::string>& pairs_of_letters)
{
    for (const std::string& pair : pairs_of_letters) bar(pair.substr(0, 1), pair.substr(1));
    return *this;
}

TrussMaker& TrussMaker::load(const std::string& id, const Eigen::Vector2d& force)
{
    model.load_cases[0].nodes.push_back(
        {.node = *model.find_node(id), .components = {{Dof::ux, force.x()}, {Dof::uy, force.y()}}});
    return *this;
}

truss::Truss truss_in(const Model& model, CaseId load_case)
{
    return truss::truss_of(model, analyse(model), load_case);
}

Model random_truss(unsigned seed, int n_steps)
{
    Dice dice(seed);
    TrussMaker made = triangle();
    Model& model = made.model;
    const auto any_node = [&] {
        return NodeId(static_cast<std::size_t>(dice.roll(0, static_cast<int>(model.nodes.size()) - 1)));
    };
    for (int i = 0; i < n_steps; ++i) {
        const std::string id = std::to_string(model.nodes.size());
        const bool splits = dice.roll(0, 2) == 0;
        const auto split = static_cast<std::size_t>(dice.roll(0, static_cast<int>(model.members.size()) - 1));
        std::vector<NodeId> joints;
        if (splits) joints = {model.members[split].nodes[0], model.members[split].nodes[1]};
        const std::size_t wanted = splits ? 3 : 2;
        while (joints.size() < wanted) {
            const NodeId joint = any_node();
            if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
        }
        if (splits) model.members.erase(model.members.begin() + static_cast<std::ptrdiff_t>(split));
        made.node(id, place(dice, 12.0));
        for (const NodeId joint : joints) made.bar(model[joint].id, id);
    }
    std::vector<NodeId> all;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) all.emplace_back(i);
    load_all(made, dice, all);
    return made.model;
}

Model random_planar_truss(unsigned seed, int n_steps)
{
    Dice dice(seed);
    TrussMaker made = triangle();
    Model& model = made.model;
    std::vector<NodeId> outline{NodeId(0), NodeId(1), NodeId(2)};
    for (int i = 0; i < n_steps;) {
        const auto side = static_cast<std::size_t>(dice.roll(0, static_cast<int>(outline.size()) - 1));
        const NodeId a = outline[side], b = outline[(side + 1) % outline.size()];
        const Eigen::Vector2d along = place_of(model, b) - place_of(model, a), out(along.y(), -along.x());
        const Eigen::Vector2d joint = place_of(model, a) + dice.roll(1, 9) / 10.0 * along +
                                      dice.roll(5, 15) / 13.0 * out;
        ++i;
        if (!is_clear(model, a, b, joint)) continue;
        const std::string id = std::to_string(model.nodes.size());
        made.node(id, joint).bar(model[a].id, id).bar(id, model[b].id);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(side) + 1, NodeId(model.nodes.size() - 1));
    }
    load_all(made, dice, outline);
    return made.model;
}
