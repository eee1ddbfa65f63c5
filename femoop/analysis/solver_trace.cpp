#include "femoop/analysis/solver_trace.h"

#include <utility>

#include "femoop/discretisation/equations.h"
#include "femoop/element/analysis_model.h"
#include "femoop/model/check/check.h"
#include "femoop/solver/geometric_dissection.h"
#include "femoop/solver/index.h"

namespace femoop {

namespace {

class SolverTracer {
public:
    SolverTracer(const Model& model, SolverKind wanted)
        : model_(model),
          wanted_(wanted),
          structure_(discretise(model)),
          elements_(structure_),
          equations_(structure_, elements_, wanted),
          graph_(block_graph(structure_, elements_)),
          adjacency_(graph_)
    {}

    SolverTrace run()
    {
        trace_.wanted = wanted_;
        trace_.kind = model_.analysis;
        trace_.has_constraints = structure_.has_constraints;
        trace_.solver = equations_.pattern().solver();
        name_blocks();
        walk_all();
        if (trace_.has_details()) list_unknowns();
        trace_.graph = std::move(graph_);
        return std::move(trace_);
    }

private:
    void name_blocks()
    {
        for (const Node& node : model_.nodes) trace_.blocks.push_back({.name = node.id});
        for (std::size_t i = 0; i < equations_.member_end_dofs_of().size(); ++i)
            if (equations_.member_end_dofs_of()[i] >= 0)
                trace_.blocks.push_back({.name = model_.members[i].id, .is_member = true});
    }

    void walk_all()
    {
        const bool is_small = graph_.n_unknowns() <= SolverTrace::most_unknowns;
        const WalkDetail detail = is_small ? WalkDetail::Pattern : WalkDetail::Counts;
        for (const Ordering ordering : all_orderings) {
            const std::vector<std::int32_t> order = ordering == Ordering::NestedDissection
                                                        ? dissected()
                                                        : elimination_order(adjacency_, ordering, graph_.positions);
            const bool is_taken = ordering != Ordering::Natural && order == equations_.pattern().order();
            if (is_taken && !trace_.ordering) trace_.ordering = ordering;
            trace_.walks[static_cast<std::size_t>(ordering)] = walk_elimination(graph_, adjacency_, order, detail);
        }
    }

    // Where a structure is slender the solver may prefer minimum degree to a dissection; shown is the dissection.
    std::vector<std::int32_t> dissected()
    {
        if (graph_.n_blocks() == 0) return {};
        const Dissection dissection = geometric_dissection(adjacency_, graph_.positions);
        for (std::size_t part = 0; part < dissection.parts.size(); ++part)
            for (std::size_t i = dissection.parts[part].first; i < dissection.parts[part].end; ++i) {
                SolverTrace::Block& block = trace_.blocks[at(dissection.order[i])];
                block.piece = static_cast<std::int32_t>(part);
                if (dissection.parts[part].is_separator) block.separator = dissection.parts[part].level;
            }
        return postordered(dissection.order, elimination_tree(adjacency_, dissection.order));
    }

    void list_unknowns()
    {
        for (std::size_t node = 0; node < model_.nodes.size(); ++node)
            for (std::size_t i = 0; i < model_dofs(structure_.kind).size(); ++i)
                if (equations_.of(NodeId(node), i) != Equations::none)
                    trace_.blocks[node].unknowns.push_back(model_.nodes[node].id + '.' +
                                                           std::string(name(model_dofs(structure_.kind)[i])));
        for (std::size_t i = 0, block = model_.nodes.size(); i < equations_.member_end_dofs_of().size(); ++i)
            if (equations_.member_end_dofs_of()[i] >= 0) list_member_ends(MemberId(i), trace_.blocks[block++]);
    }

    void list_member_ends(MemberId member, SolverTrace::Block& block) const
    {
        for (std::size_t end = 0; end < 2; ++end)
            for (const Dof dof : all_dofs)
                if (equations_.of_member_end(member, end, static_cast<LocalAxis>(index(dof))) != Equations::none)
                    block.unknowns.push_back(model_[member].id + (end == 0 ? ".start." : ".end.") +
                                             std::string(name(dof)) + '\'');
    }

    const Model& model_;
    const SolverKind wanted_;
    const Discretisation structure_;
    const Elements elements_;
    const Equations equations_;
    BlockGraph graph_;
    const BlockAdjacency adjacency_;
    SolverTrace trace_;
};

} // namespace

SolverTrace trace_solver(const Model& model, SolverKind wanted)
{
    require_sound(model);
    return SolverTracer(model, wanted).run();
}

} // namespace femoop
