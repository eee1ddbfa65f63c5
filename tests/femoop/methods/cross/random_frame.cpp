#include "tests/femoop/methods/cross/random_frame.h"

#include <random>
#include <string>

using namespace femoop;

namespace {

class Maker {
public:
    explicit Maker(unsigned seed) : generator_(seed)
    {
        model_.add(Material{.id = "steel", .E = 2.1e8, .alpha = 1.2e-5, .density = 7.85});
        for (int i = 0; i < 3; ++i)
            model_.add(Section{.id = "s" + std::to_string(i),
                               .A = between(0.004, 0.02),
                               .Iz = between(0.5e-4, 4e-4),
                               .Asy = between(0.001, 0.008),
                               .h = between(0.2, 0.5)});
    }

    Model beam()
    {
        const int n = whole(1, 6);
        const bool has_left = chance(0.3), has_right = chance(0.3);
        double x = 0.0;
        if (has_left) add_node("L", x - between(0.5, 2.0), 0.0);
        for (int i = 0; i <= n; ++i) {
            add_node(std::string(1, static_cast<char>('A' + i)), x, 0.0);
            support_beam(model_.nodes.back(), i == 0 || i == n, i == 0);
            x += between(2.0, 8.0);
        }
        if (has_right) add_node("R", x - 1.5, 0.0);
        for (std::size_t i = 0; i + 1 < model_.nodes.size(); ++i) add_member(i, i + 1);
        add_loads(0.002);
        return model_;
    }

    Model frame()
    {
        const int bays = whole(1, 3), storeys = whole(1, 3);
        const double slope = chance(0.5) ? 0.0 : between(-0.6, 0.6);
        for (int j = 0; j <= storeys; ++j)
            for (int i = 0; i <= bays; ++i) {
                add_node("N" + std::to_string(model_.nodes.size()), 5.0 * i + slope * j + between(-0.3, 0.3),
                         3.5 * j + (j > 0 ? between(-0.4, 0.4) : 0.0));
                if (j == 0) support_column(model_.nodes.back());
            }
        const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * (bays + 1) + i); };
        for (int j = 1; j <= storeys; ++j)
            for (int i = 0; i <= bays; ++i) {
                add_member(at(i, j - 1), at(i, j));
                if (i < bays) add_member(at(i, j), at(i + 1, j));
            }
        if (chance(0.4)) {
            add_node("T", 5.0 * bays + slope * storeys + 2.0, 3.5 * storeys);
            add_member(at(bays, storeys), model_.nodes.size() - 1);
        }
        if (chance(0.3)) add_bar(at(0, 0), at(1, 1));
        add_loads(0.0);
        return model_;
    }

private:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }

    void add_node(const std::string& id, double x, double y)
    {
        Node node{.id = id};
        node.at = {x, y, 0.0};
        model_.add(std::move(node));
    }

    void support_beam(Node& node, bool is_last, bool is_first)
    {
        const double lot = between(0.0, 1.0);
        if (is_last && lot < 0.35) node.support = Support{.kind = SupportKind::Fixed};
        else if (is_first) node.support = Support{.kind = SupportKind::Pin};
        else node.support = Support{.kind = SupportKind::Roller};
        if (lot <= 0.8) return;
        node.support->springs.push_back({.dof = Dof::rz, .stiffness = between(500.0, 9000.0)});
        node.support->fixed = node.support->blocked(AnalysisKind::Frame2d);
        node.support->kind = SupportKind::Custom;
    }

    void support_column(Node& node)
    {
        node.support = Support{.kind = chance(0.7) ? SupportKind::Fixed : SupportKind::Pin};
    }

    void add_member(std::size_t a, std::size_t b)
    {
        Member member{.id = "M" + std::to_string(model_.members.size()),
                      .nodes = {NodeId(a), NodeId(b)},
                      .material = MaterialId(0),
                      .section = SectionId(static_cast<std::size_t>(whole(0, 2)))};
        if (chance(0.2)) std::swap(member.nodes[0], member.nodes[1]);
        if (chance(0.2)) member.theory = BeamTheory::Timoshenko;
        if (chance(0.15)) member.start.springs.push_back({.dof = Dof::rz, .stiffness = between(1000.0, 30000.0)});
        if (chance(0.1)) member.foundation = between(100.0, 3000.0);
        model_.add(std::move(member));
    }

    void add_bar(std::size_t a, std::size_t b)
    {
        model_.add(Member{.id = "bar",
                          .nodes = {NodeId(a), NodeId(b)},
                          .material = MaterialId(0),
                          .section = SectionId(0),
                          .start = {},
                          .end = {},
                          .bar = true});
    }

    void add_loads(double settlement)
    {
        LoadCase load_case{.id = "P", .self_weight = chance(0.5) ? 1.0 : 0.0};
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            if (chance(0.3))
                load_case.nodes.push_back(
                    {.node = NodeId(i),
                     .components = {{Dof::ux, between(-20.0, 20.0)}, {Dof::rz, between(-20.0, 20.0)}}});
            const auto& support = model_.nodes[i].support;
            if (settlement > 0.0 && support && chance(0.3))
                load_case.settlements.push_back(
                    {.node = NodeId(i), .components = {{Dof::uy, between(-settlement, settlement)}}});
        }
        for (std::size_t i = 0; i < model_.members.size(); ++i)
            if (chance(0.7)) load_member(load_case, i, settlement > 0.0);
        model_.add(std::move(load_case));
    }

    void load_member(LoadCase& load_case, std::size_t i, bool with_heat)
    {
        const MemberId member(i);
        DistributedLoad q;
        q.values.push_back({.dof = Dof::uy, .start = between(-30.0, 5.0), .end = Quantity(between(-30.0, 5.0))});
        if (chance(0.4)) q.from = Position(Percent{20.0}), q.to = Position(Percent{75.0});
        load_case.members.push_back({.member = member, .load = q});
        if (model_[member].bar) return;
        if (chance(0.5))
            load_case.members.push_back({.member = member,
                                         .load = PointLoad{.at = Percent{between(5.0, 95.0)},
                                                           .components = {{Dof::ux, between(-9.0, 9.0)},
                                                                          {Dof::uy, between(-60.0, 20.0)},
                                                                          {Dof::rz, between(-20.0, 20.0)}}}});
        if (chance(0.2))
            load_case.members.push_back(
                {.member = member,
                 .load = EndLoads{.start = {{Dof::rz, between(-9.0, 9.0)}}, .end = {{Dof::rz, between(-9.0, 9.0)}}}});
        if (with_heat && chance(0.3))
            load_case.members.push_back({.member = member, .load = TemperatureLoad{10.0, -10.0}});
    }

    std::mt19937 generator_;
    Model model_;
};

} // namespace

Model random_beam(unsigned seed) { return Maker(seed).beam(); }
Model random_frame(unsigned seed) { return Maker(seed).frame(); }
