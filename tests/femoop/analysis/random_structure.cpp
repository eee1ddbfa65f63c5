#include "tests/femoop/analysis/random_structure.h"

#include <string>

using namespace femoop;

namespace {

class StructureMaker {
public:
    StructureMaker(AnalysisKind kind, unsigned seed) : generator_(seed), tapers_(seed) { model_.analysis = kind; }

    Model make()
    {
        model_.add(Material{.id = "steel", .E = 2.1e8, .alpha = 1.2e-5, .density = 7.85});
        for (int i = 0; i < 3; ++i) add_section(i);
        if (model_.analysis == AnalysisKind::Frame2d) add_shape();
        add_nodes();
        add_members();
        add_loads("P");
        add_loads("Q");
        return model_;
    }

private:
    bool is_plane() const { return !is_3d(model_.analysis) && model_.analysis != AnalysisKind::Grillage; }
    bool is_frame() const { return !is_truss(model_.analysis); }
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

    void add_section(int i)
    {
        model_.add(Section{.id = "s" + std::to_string(i),
                           .A = between(0.004, 0.02),
                           .Iz = between(0.5e-4, 4e-4),
                           .Iy = between(0.3e-4, 2e-4),
                           .J = between(0.1e-4, 1e-4),
                           .Asy = between(0.001, 0.008),
                           .Asz = between(0.001, 0.008),
                           .h = between(0.2, 0.5)});
    }

    void add_shape()
    {
        SectionShape welded{.kind = SectionShapeKind::I};
        welded.h = 0.3;
        welded.bf = 0.2;
        welded.tf = 0.015;
        welded.tw = 0.01;
        model_.add(Section{.id = "welded", .shape = welded});
    }

    // A 3 x 3 board of nodes, shaken; in space two such boards above one another.
    void add_nodes()
    {
        const int levels = is_3d(model_.analysis) ? 2 : 1;
        for (int z = 0; z < levels; ++z)
            for (int y = 0; y < 3; ++y)
                for (int x = 0; x < 3; ++x) {
                    Node node{.id = "N" + std::to_string(model_.nodes.size()),
                              .at = {4.0 * x + between(-0.7, 0.7), 3.0 * y + between(-0.7, 0.7),
                                     3.5 * z + between(-0.4, 0.4)}};
                    if (!is_3d(model_.analysis)) node.at[2] = 0.0;
                    add_support(node, x, y, z);
                    model_.add(std::move(node));
                }
        if (is_frame()) model_.nodes[4].hinge = chance(0.5);
    }

    void add_support(Node& node, int x, int y, int z)
    {
        const bool is_base = is_3d(model_.analysis) ? z == 0 && (x + y) % 2 == 0 : y == 0;
        if (!is_base) return;
        Support support{.kind = SupportKind::Fixed};
        if (is_plane() && x == 1) {
            support = {.kind = SupportKind::Custom, .fixed = {Dof::uy}, .angle = between(-50.0, 50.0)};
            if (is_frame()) support.springs.push_back({.dof = Dof::rz, .stiffness = between(500.0, 9000.0)});
        }
        if (model_.analysis == AnalysisKind::Grillage && x == 1)
            support = {
                .kind = SupportKind::Custom, .fixed = {Dof::rx}, .springs = {{.dof = Dof::uz, .stiffness = 7000.0}}};
        node.support = support;
    }

    void add_member(std::size_t a, std::size_t b)
    {
        Member member{.id = "M" + std::to_string(model_.members.size()),
                      .nodes = {NodeId(a), NodeId(b)},
                      .material = MaterialId(0),
                      .section = SectionId(std::uniform_int_distribution<std::size_t>(0, 2)(generator_))};
        if (is_frame()) {
            if (chance(0.3)) member.theory = BeamTheory::Timoshenko;
            if (chance(0.2)) member.start.release.insert(Dof::rz);
            else if (chance(0.3))
                member.start.springs.push_back({.dof = Dof::rz, .stiffness = between(1000.0, 30000.0)});
            if (chance(0.15)) member.end.springs.push_back({.dof = Dof::rz, .stiffness = between(1000.0, 30000.0)});
            if (chance(0.2) && model_.analysis != AnalysisKind::Truss2d) member.foundation = between(100.0, 3000.0);
            if (chance(0.2)) member.start.offset = arm();
            const bool is_diagonal = b - a != 1 && b - a != 3; // a frame without bars still stands
            if (chance(0.4) && is_diagonal && model_.analysis != AnalysisKind::Grillage) member.bar = true;
            if (member.bar) member.start = member.end = {}, member.foundation.reset();
        }
        if (model_.analysis == AnalysisKind::Frame2d && !member.bar && !member.foundation) taper(member);
        if (model_.nodes[a].hinge) member.start.springs.clear(); // the hinge has released what they would hold
        if (model_.nodes[b].hinge) member.end.springs.clear();
        if (is_3d(model_.analysis) && chance(0.3)) member.up = {0.3, 0.8, 0.5};
        model_.add(std::move(member));
    }

    /// By another generator, so that the rest of the structure is what it is without tapers.
    void taper(Member& member)
    {
        std::uniform_real_distribution<double> depth(0.1, 0.8);
        if (depth(tapers_) > 0.4) return;
        member.section = SectionId(model_.sections.size() - 1);
        member.depths = {depth(tapers_), depth(tapers_)};
    }

    std::vector<Quantity> arm()
    {
        std::vector<Quantity> offset{between(-0.3, 0.3), between(-0.3, 0.3)};
        if (is_3d(model_.analysis)) offset.emplace_back(between(-0.3, 0.3));
        return offset;
    }

    void add_members()
    {
        const std::size_t n = model_.nodes.size();
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < n; ++b) {
                double distance = 0.0;
                for (std::size_t i = 0; i < 3; ++i)
                    distance += std::pow(model_.nodes[a].at[i] - model_.nodes[b].at[i], 2.0);
                const double reach = is_truss(model_.analysis) ? 6.7 : 5.7;
                if (std::sqrt(distance) < reach) add_member(a, b);
            }
    }

    std::vector<Component> components(bool with_moments)
    {
        std::vector<Component> found;
        for (const Dof dof : all_dofs)
            if (dofs(model_.analysis).contains(dof) && (with_moments || index(dof) < 3))
                found.push_back({.dof = dof, .value = between(-30.0, 30.0)});
        return found;
    }

    void add_loads(const std::string& id)
    {
        LoadCase load_case{.id = id, .self_weight = between(0.5, 1.5)};
        const std::size_t loaded[] = {3, 5, 8};
        for (const std::size_t node : loaded)
            load_case.nodes.push_back({.node = NodeId(node), .components = components(false)});
        const NodeId moved(0);
        const Dof settled = model_.analysis == AnalysisKind::Grillage ? Dof::uz : Dof::uy;
        load_case.settlements.push_back(
            {.node = moved, .components = {{.dof = settled, .value = between(-0.01, 0.01)}}});
        for (std::size_t i = 0; i < model_.members.size(); ++i) {
            if (chance(0.5)) continue;
            add_member_loads(load_case, MemberId(i));
        }
        model_.add(std::move(load_case));
    }

    void add_member_loads(LoadCase& load_case, MemberId member)
    {
        const bool takes_moments = is_frame() && !model_[member].bar;
        DistributedLoad whole{.axes = chance(0.5) ? LoadAxes::Global : LoadAxes::Local};
        if (model_.analysis == AnalysisKind::Grillage) whole.axes = LoadAxes::Global;
        for (const Component& c : components(takes_moments && chance(0.5)))
            whole.values.push_back({.dof = c.dof, .start = c.value, .end = between(-20.0, 20.0)});
        if (chance(0.5)) whole.from = Position(0.4), whole.to = Position(Percent{70.0});
        load_case.members.push_back({.member = member, .load = whole});
        load_case.members.push_back(
            {.member = member,
             .load = PointLoad{.at = Percent{between(5.0, 95.0)}, .components = components(takes_moments)}});
        if (takes_moments && chance(0.5))
            load_case.members.push_back({.member = member, .load = EndLoads{.start = components(true), .end = {}}});
        if (chance(0.5)) load_case.members.push_back({.member = member, .load = TemperatureLoad{25.0, -10.0}});
        if (chance(0.3) && model_.analysis != AnalysisKind::Grillage)
            load_case.members.push_back({.member = member, .load = Misfit{between(-0.002, 0.002)}});
    }

    Model model_;
    std::mt19937 generator_;
    std::mt19937 tapers_;
};

} // namespace

Model random_structure(AnalysisKind kind, unsigned seed) { return StructureMaker(kind, seed).make(); }

void make_prismatic(Model& model)
{
    for (Member& member : model.members) {
        if (member.depths.empty()) continue;
        member.depths.clear();
        member.section = SectionId(0);
    }
}
