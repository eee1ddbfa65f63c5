#include "femoop/analysis/driven_rotation.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr double rounding_of_moments = 1e-9; // of the moments that come to a node

void add_node_loads(const CaseLoads& loads, std::vector<double>& moments)
{
    for (const CaseLoads::OnNode& load : loads.nodes)
        moments[load.node.index] += std::hypot(load.value[3], load.value[4], load.value[5]);
}

/// Adds what forces on an element's degrees of freedom turn its nodes with.
void add_moments(const ElementDofs& dofs, const ElementVector& forces, std::vector<double>& moments)
{
    for (std::size_t k = 0; k < dofs.n_of_nodes(); ++k)
        if (is_rotation(dofs.of_each_node[k % dofs.of_each_node.size()]))
            moments[dofs.nodes[k / dofs.of_each_node.size()].index] += std::abs(forces[static_cast<Eigen::Index>(k)]);
}

void add_span_loads(const Assembler& assembler, const CaseLoads& loads, std::vector<double>& moments)
{
    if (loads.first.empty()) return;
    SpanLoading room;
    ElementVector forces;
    for (std::size_t i = 0; i < assembler.structure().members.size(); ++i) {
        const std::span<const SpanLoad> on_member = loads.of(MemberId(i));
        if (on_member.empty()) continue;
        const Element& element = assembler.elements()[i];
        element.equivalent_forces({.span_loads = on_member, .room = &room}, forces);
        add_moments(element.dofs(), forces, moments);
    }
}

/// Settlements that move a member as a body bring moments that cancel within it.
void add_settlements(const Assembler& assembler, const CaseLoads& loads, std::vector<double>& moments)
{
    const std::vector<double> moved = assembler.settlements(loads);
    if (moved.empty()) return;
    ElementMatrix K;
    for (std::size_t i = 0; i < assembler.structure().members.size(); ++i) {
        const double u = assembler.prescribed(i, moved).norm();
        if (u == 0.0) continue;
        assembler.elements()[i].stiffness(K);
        add_moments(assembler.elements()[i].dofs(), u * K.rowwise().norm(), moments);
    }
}

} // namespace

bool DrivenRotations::contains(const ArtificialRestraint& rotation)
{
    for (std::size_t c = 0; c < loads_.size(); ++c)
        if (is_driven(rotation, c)) return true;
    return false;
}

bool DrivenRotations::is_driven(const ArtificialRestraint& rotation, std::size_t load_case)
{
    double moment = 0.0;
    for (std::size_t i = 0; i < rotation.parts.size(); ++i)
        moment += rotation.direction[static_cast<Eigen::Index>(i)] *
                  F_(rotation.parts[i].row, static_cast<Eigen::Index>(load_case));
    if (moment == 0.0) return false;
    const std::vector<double>& moments = moments_at_nodes(load_case);
    double largest = 0.0;
    for (const ArtificialRestraint::Part& part : rotation.parts) largest = std::max(largest, moments[part.node.index]);
    return std::abs(moment) > rounding_of_moments * largest;
}

const std::vector<double>& DrivenRotations::moments_at_nodes(std::size_t load_case)
{
    if (moments_.empty()) moments_.resize(loads_.size());
    std::vector<double>& moments = moments_[load_case];
    if (!moments.empty()) return moments;
    moments.resize(assembler_.structure().positions.size(), 0.0);
    add_node_loads(loads_[load_case], moments);
    add_span_loads(assembler_, loads_[load_case], moments);
    add_settlements(assembler_, loads_[load_case], moments);
    return moments;
}

} // namespace femoop
