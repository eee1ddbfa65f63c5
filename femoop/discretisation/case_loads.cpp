#include "femoop/discretisation/case_loads.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace femoop {

namespace {

constexpr double round_off = 1e-14; // of the larger of two temperatures whose mean is 0

double length_at(const Position& position, double L)
{
    const double x = std::holds_alternative<Percent>(position) ? 0.01 * std::get<Percent>(position).value * L
                                                               : std::get<Quantity>(position).value();
    return std::min(std::max(x, 0.0), L);
}

/// A load's components as one vector along global or member axes.
struct Load6 {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    void set(Dof dof, double value)
    {
        const auto i = static_cast<int>(index(dof));
        (i < 3 ? force[i] : moment[i - 3]) = value;
    }
    void turn(const Eigen::Matrix3d& axes)
    {
        force = axes * force;
        moment = axes * moment;
    }
    double operator[](std::size_t axis) const
    {
        const auto i = static_cast<int>(axis);
        return i < 3 ? force[i] : moment[i - 3];
    }
};

/// Turns the member loads of one load case into span loads in member axes, member by member.
class SpanLoadTable {
public:
    explicit SpanLoadTable(const Discretisation& structure) : structure_(structure) {}

    void add(const MemberLoad& load)
    {
        member_ = load.member;
        geometry_ = structure_.geometry(load.member);
        std::visit([this](const auto& l) { add(l); }, load.load);
    }

    void add_self_weight(double factor)
    {
        for (std::size_t i = 0; i < structure_.members.size(); ++i) {
            member_ = MemberId(i);
            const double weight = structure_.properties_of(member_).weight;
            const MemberEndConditions* end_conditions = structure_.end_conditions_of(member_);
            if (weight == 0.0 || (end_conditions != nullptr && end_conditions->constraint == Constraint::Rigid))
                continue;
            geometry_ = structure_.geometry(member_);
            Load6 q;
            q.set(is_plane(structure_.kind) ? Dof::uy : Dof::uz, -factor * weight);
            q.turn(geometry_.axes);
            add_distributed(q, q, 0.0, geometry_.length);
        }
    }

    /// Sorts what was added by member.
    void move_into(CaseLoads& loads)
    {
        if (loads_.empty()) return;
        loads.first.assign(structure_.members.size() + 1, 0);
        for (const auto& [member, load] : loads_) ++loads.first[member.index + 1];
        for (std::size_t i = 0; i < structure_.members.size(); ++i) loads.first[i + 1] += loads.first[i];
        loads.span_loads.resize(loads_.size());
        std::vector<std::uint32_t> next(loads.first.begin(), loads.first.end() - 1);
        for (const auto& [member, load] : loads_) loads.span_loads[next[member.index]++] = load;
    }

private:
    void add(const DistributedLoad& load)
    {
        Load6 start, end;
        for (const DistributedLoad::Value& value : load.values) {
            const double share = load.projected ? projection(value.dof) : 1.0;
            start.set(value.dof, share * value.start);
            end.set(value.dof, share * (value.end ? *value.end : value.start));
        }
        if (load.axes == LoadAxes::Global) {
            start.turn(geometry_.axes);
            end.turn(geometry_.axes);
        }
        const double L = geometry_.length;
        add_distributed(start, end, load.from ? length_at(*load.from, L) : 0.0, load.to ? length_at(*load.to, L) : L);
    }

    void add(const PointLoad& load) { add_point(load.components, load.axes, length_at(load.at, geometry_.length)); }

    void add(const EndLoads& load)
    {
        add_point(load.start, load.axes, 0.0);
        add_point(load.end, load.axes, geometry_.length);
    }

    void add(const TemperatureLoad& load)
    {
        const MemberProperties& p = structure_.properties_of(member_);
        const double difference = load.top - load.bottom;
        const double gradient = difference == 0.0 ? 0.0 : difference / p.depth;
        const double largest = std::max(std::abs(load.top.value()), std::abs(load.bottom.value()));
        const double mean = load.bottom + gradient * p.centroid;
        add_strain(std::abs(mean) > round_off * largest ? p.alpha * mean : 0.0, -p.alpha * gradient);
    }

    void add(const Misfit& load) { add_strain(load.elongation / geometry_.length, 0.0); }

    /// How much of a metre along the member shows square to a global axis.
    double projection(Dof dof) const
    {
        const double cosine = geometry_.axes(0, static_cast<int>(index(dof) % 3));
        return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    }

    void add_distributed(const Load6& start, const Load6& end, double from, double to)
    {
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (start[axis] != 0.0 || end[axis] != 0.0)
                loads_.emplace_back(member_, SpanLoad{.kind = SpanLoad::Kind::Distributed,
                                                      .axis = static_cast<LocalAxis>(axis),
                                                      .from = from,
                                                      .to = to,
                                                      .start = start[axis],
                                                      .end = end[axis]});
    }

    void add_point(const std::vector<Component>& components, LoadAxes axes, double at)
    {
        Load6 load;
        for (const Component& component : components) load.set(component.dof, component.value);
        if (axes == LoadAxes::Global) load.turn(geometry_.axes);
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (load[axis] != 0.0)
                loads_.emplace_back(member_, SpanLoad{.kind = SpanLoad::Kind::Point,
                                                      .axis = static_cast<LocalAxis>(axis),
                                                      .from = at,
                                                      .to = at,
                                                      .start = load[axis],
                                                      .end = 0.0});
    }

    void add_strain(double strain, double curvature)
    {
        loads_.emplace_back(member_, SpanLoad{.kind = SpanLoad::Kind::Strain, .start = strain, .end = curvature});
    }

    const Discretisation& structure_;
    MemberId member_;
    MemberGeometry geometry_;
    std::vector<std::pair<MemberId, SpanLoad>> loads_;
};

CaseLoads::OnNode on_node(NodeId node, const std::vector<Component>& components)
{
    CaseLoads::OnNode row{.node = node};
    for (const Component& component : components) row.value[index(component.dof)] += component.value;
    return row;
}

} // namespace

std::vector<CaseLoads> loads_of(const Model& model, const Discretisation& structure)
{
    std::vector<CaseLoads> all;
    for (const LoadCase& load_case : model.load_cases) {
        CaseLoads loads;
        for (const NodeLoad& load : load_case.nodes) loads.nodes.push_back(on_node(load.node, load.components));
        for (const Settlement& s : load_case.settlements) loads.settlements.push_back(on_node(s.node, s.components));
        SpanLoadTable table(structure);
        for (const MemberLoad& load : load_case.members) table.add(load);
        if (load_case.self_weight != 0.0) table.add_self_weight(load_case.self_weight);
        table.move_into(loads);
        all.push_back(std::move(loads));
    }
    return all;
}

std::vector<CaseTerms> cases_of(const Model& model)
{
    const std::size_t n = model.load_cases.size();
    std::vector<CaseTerms> cases;
    for (std::size_t i = 0; i < n; ++i)
        cases.push_back({.name = model.load_cases[i].id, .terms = {{.load_case = i, .factor = 1.0}}});

    // A combination may name others, also later ones: each is expanded once into a factor per load case.
    std::vector<std::vector<double>> factors(model.combinations.size());
    const auto expand = [&](const auto& self, std::size_t combination) -> const std::vector<double>& {
        std::vector<double>& mine = factors[combination];
        if (!mine.empty()) return mine;
        std::vector<double> sum(n + 1, 0.0); // one more, so that an expanded one is never empty
        for (const Combination::Term& term : model.combinations[combination].terms) {
            if (term.of.index < n) {
                sum[term.of.index] += term.factor;
                continue;
            }
            const std::vector<double>& other = self(self, term.of.index - n);
            for (std::size_t i = 0; i < n; ++i) sum[i] += term.factor * other[i];
        }
        return mine = std::move(sum);
    };
    for (std::size_t c = 0; c < model.combinations.size(); ++c) {
        CaseTerms terms{.name = model.combinations[c].id, .terms = {}};
        for (std::size_t i = 0; i < n; ++i)
            if (const double factor = expand(expand, c)[i]; factor != 0.0)
                terms.terms.push_back({.load_case = i, .factor = factor});
        cases.push_back(std::move(terms));
    }
    return cases;
}

} // namespace femoop
