#include <Eigen/Geometry>
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/femoop/analysis/mobility.h"

using namespace femoop;

namespace {

class Linkage {
public:
    Linkage(AnalysisKind kind, unsigned seed) : generator_(seed) { model_.analysis = kind; }

    Model make()
    {
        model_.add(Material{.id = "steel", .E = 2.1e8});
        model_.add(Section{.id = "bar", .A = 0.01, .Iz = 1.3e-4, .Iy = chance(0.5) ? 0.7e-4 : 1e-6, .J = 0.3e-4});
        place_nodes();
        support_nodes();
        join_nodes();
        const bool is_grillage = model_.analysis == AnalysisKind::Grillage;
        LoadCase load_case{.id = "G"};
        load_case.nodes.push_back({.node = model_.members.front().nodes[below(2)],
                                   .components = {{.dof = is_grillage ? Dof::uz : Dof::uy, .value = -10.0}}});
        model_.add(std::move(load_case));
        return std::move(model_);
    }

private:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
    bool chance(double probability) { return between(0.0, 1.0) < probability; }
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator_); }
    bool in_space() const { return is_3d(model_.analysis); }

    /// Points of a small grid, turned so that rounding takes part.
    void place_nodes()
    {
        const std::size_t n = 2 + below(in_space() ? 6 : 8), steps = 3 + below(2);
        const double size = chance(0.6) ? 1.0 : between(0.3, 2.5), shake = chance(0.2) ? 0.2 : 0.0;
        const bool is_flat = !in_space() || chance(0.2), is_row = chance(0.1);
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        if (chance(0.4)) turn = Eigen::AngleAxisd(between(0.0, 6.0), Eigen::Vector3d::UnitZ()).matrix();
        if (in_space() && chance(0.4)) turn = turn * Eigen::AngleAxisd(between(0.0, 6.0), Eigen::Vector3d::UnitX());
        std::vector<std::array<std::size_t, 3>> taken;
        for (int attempt = 0; attempt < 60 && positions_.size() < n; ++attempt) {
            const std::array<std::size_t, 3> cell{below(is_row ? 8 : steps), is_row ? 0 : below(steps),
                                                  is_flat ? 0 : below(steps)};
            if (std::find(taken.begin(), taken.end(), cell) != taken.end()) continue;
            taken.push_back(cell);
            Eigen::Vector3d at(static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                               static_cast<double>(cell[2]));
            for (int i = 0; i < (in_space() ? 3 : 2); ++i) at[i] += between(-1.0, 1.0) * shake;
            positions_.emplace_back(turn * size * at);
        }
    }

    void support_nodes()
    {
        const double hinged = std::array{0.0, 0.2, 0.7, 1.0}[below(4)], supported = std::array{0.2, 0.4, 0.6}[below(3)];
        for (const Eigen::Vector3d& at : positions_) {
            Node node{.id = "N" + std::to_string(model_.nodes.size()), .at = {at.x(), at.y(), at.z()}};
            node.hinge = !is_truss(model_.analysis) && chance(hinged);
            if (model_.nodes.empty() || chance(supported)) node.support = support();
            model_.add(std::move(node));
        }
    }

    Support support()
    {
        if (chance(0.6)) return {.kind = chance(0.5) ? SupportKind::Fixed : SupportKind::Pin};
        Support support;
        for (const Dof dof : all_dofs) {
            if (!dofs(model_.analysis).contains(dof)) continue;
            if (chance(0.5)) support.fixed.insert(dof);
            else if (chance(0.15)) support.springs.push_back({.dof = dof, .stiffness = 1000.0});
        }
        if (is_plane(model_.analysis) && chance(0.3)) support.angle = chance(0.5) ? 45.0 : between(0.0, 180.0);
        return support;
    }

    /// Mostly neighbours, about as many members as a structure needs.
    void join_nodes()
    {
        struct Pair {
            std::size_t a, b;
            double length;
        };
        std::vector<Pair> pairs;
        for (std::size_t b = 0; b < positions_.size(); ++b)
            for (std::size_t a = 0; a < b; ++a)
                pairs.push_back({a, b, (positions_[a] - positions_[b]).norm() * between(0.7, 1.3)});
        std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.length < q.length; });
        const double per_node = !is_truss(model_.analysis) ? 1.5 : in_space() ? 3.0 : 2.0;
        const auto n = static_cast<double>(positions_.size());
        const auto wanted = static_cast<std::size_t>(between(n - 1.0, std::max(n, per_node * n)));
        pairs.resize(std::clamp<std::size_t>(wanted, 1, pairs.size()));
        const double released = std::array{0.0, 0.1, 0.4}[below(3)], constrained = std::array{0.0, 0.3, 0.8}[below(3)];
        const double offset = chance(0.25) ? 0.3 : 0.0;
        for (const Pair& pair : pairs) add_member(pair.a, pair.b, released, constrained, offset);
    }

    void add_member(std::size_t a, std::size_t b, double released, double constrained, double offset)
    {
        if (chance(0.5)) std::swap(a, b);
        Member member{.id = "M" + std::to_string(model_.members.size()),
                      .nodes = {NodeId(a), NodeId(b)},
                      .material = MaterialId(0),
                      .section = SectionId(0),
                      .bar = !is_truss(model_.analysis) && chance(0.15)};
        for (MemberEnd* end : {&member.start, &member.end}) {
            const bool is_cut = chance(0.1);
            for (const Dof dof : all_dofs) {
                const bool may_release = member_dofs(model_.analysis).contains(dof) && (!member.bar || dof == Dof::ux);
                if (may_release && chance(released) && (is_cut || chance(0.5))) end->release.insert(dof);
            }
            if (is_truss(model_.analysis) || !chance(offset)) continue;
            for (int i = 0; i < (in_space() ? 3 : 2); ++i)
                end->offset.emplace_back(std::array{0.0, 0.1, -0.1}[below(3)]);
        }
        if (chance(constrained)) (chance(0.5) ? member.rigid : member.inextensible) = true;
        model_.add(std::move(member));
    }

    Model model_;
    std::mt19937 generator_;
    std::vector<Eigen::Vector3d> positions_;
};

} // namespace

Model random_linkage(AnalysisKind kind, unsigned seed) { return Linkage(kind, seed).make(); }
