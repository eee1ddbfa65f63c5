#include "apps/frame/window/explained_step.h"

#include <algorithm>
#include <string>

#include "femoop/element/analysis_model.h"

namespace frame {

namespace {

constexpr std::size_t most_numbered = 200; // nodes: of more the numbers could not be read

bool speaks_of(const femoop::derivation::Step& step, const femoop::Model& model, femoop::NodeId node)
{
    if (step.node) return step.node == node;
    if (!step.member) return false;
    const auto& ends = model[*step.member].nodes;
    return std::ranges::find(ends, node) != ends.end();
}

} // namespace

const femoop::derivation::Step* explained_step(const Workspace& workspace)
{
    const bool is_shown = workspace.bottom.shows(BottomContent::Derivation) &&
                          workspace.derivation.is_at(workspace.session);
    return is_shown ? workspace.derivation.shown_step() : nullptr;
}

std::vector<NodeNumbers> node_numbers(const Workspace& workspace)
{
    const auto* const step = explained_step(workspace);
    const femoop::Model& model = workspace.session.model();
    const DerivationShow& show = workspace.derivation;
    const bool has_numbers = step != nullptr && show.force_method() == nullptr && !show.is_of_kept_model();
    if (!has_numbers || model.nodes.size() > most_numbered) return {};
    const std::span<const femoop::Dof> dofs = femoop::model_dofs(model.analysis);
    std::vector<std::string> texts(model.nodes.size() * dofs.size(), "0");
    const auto& unknowns = workspace.derivation.derivation()->system.unknowns;
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        if (unknowns[i].end_of) continue; // an end of a member beside its node
        const auto dof = static_cast<std::size_t>(std::ranges::find(dofs, unknowns[i].dof) - dofs.begin());
        texts[unknowns[i].node.index * dofs.size() + dof] = std::to_string(i + 1);
    }
    std::vector<NodeNumbers> numbers;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        std::string text;
        for (std::size_t j = 0; j < dofs.size(); ++j) text += (j == 0 ? "" : " ") + texts[i * dofs.size() + j];
        numbers.push_back({femoop::NodeId(i), "(" + text + ")", speaks_of(*step, model, femoop::NodeId(i))});
    }
    return numbers;
}

void light_step(Highlight& highlight, const Workspace& workspace)
{
    const auto* const step = explained_step(workspace);
    if (step == nullptr) return;
    const femoop::Model& shown = workspace.session.model();
    const femoop::Model& of = workspace.derivation.model(workspace.session);
    const bool is_same = !workspace.derivation.is_of_kept_model();
    const auto member = is_same || !step->member ? step->member : shown.find_member(of[*step->member].id);
    const auto node = is_same || !step->node ? step->node : shown.find_node(of[*step->node].id);
    if (member) highlight.members.push_back(*member);
    else if (node && !step->member) highlight.nodes.push_back(*node);
}

} // namespace frame
