#include "femoop/analysis/solver_trace.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "femoop/analysis/linear_static.h"
#include "femoop/discretisation/equations.h"
#include "femoop/model/fault/fault.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

std::vector<std::string> unknowns(const SolverTrace& trace)
{
    std::vector<std::string> all;
    for (const SolverTrace::Block& block : trace.blocks)
        all.insert(all.end(), block.unknowns.begin(), block.unknowns.end());
    return all;
}

} // namespace

TEST_SUITE("solver trace")
{
    TEST_CASE("It tells the solver, its order and the unknowns that the analysis has, in structures of every kind")
    {
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= 6; ++seed) {
                CAPTURE(name(kind));
                CAPTURE(seed);
                const Model model = random_structure(kind, seed);
                const SolverTrace trace = trace_solver(model);
                const AnalysisStatistics statistics = LinearStatic(model).statistics();
                CHECK(trace.blocks.size() == trace.graph.n_blocks());
                if (trace.has_details()) CHECK(unknowns(trace).size() == trace.n_unknowns());
                for (std::size_t b = 0; trace.has_details() && b < trace.blocks.size(); ++b)
                    CHECK(trace.blocks[b].unknowns.size() == static_cast<std::size_t>(trace.graph.block_sizes[b]));
                if (trace.has_constraints) continue;
                CHECK(trace.n_unknowns() == statistics.dofs);
                CHECK(name(trace.solver) == statistics.solver);
                for (const EliminationWalk& walk : trace.walks)
                    CHECK(walk.counts.n_entries_of_K == statistics.nonzeros);
                REQUIRE(trace.ordering);
                if (trace.solver == SolverKind::Skyline)
                    CHECK(trace.walk(*trace.ordering).counts.n_profile_entries == statistics.factor_nonzeros);
            }
    }

    TEST_CASE("Its unknowns are named by node and displacement; those at a support have none")
    {
        const SolverTrace trace = trace_solver(storey_frame(1, 1));
        CHECK(trace.blocks[0].unknowns.empty());
        CHECK(trace.blocks[2].unknowns == std::vector<std::string>{"2.ux", "2.uy", "2.rz"});
        CHECK(trace.solver == SolverKind::Skyline);
        CHECK(trace.ordering == Ordering::CuthillMcKee);
        CHECK(trace.n_unknowns() == 6);
    }

    TEST_CASE("A member without extension whose end is flexible has unknowns of its own, named by it")
    {
        Model model = storey_frame(1, 1);
        model.members[2].inextensible = true;
        model.members[2].end.springs = {{.dof = Dof::rz, .stiffness = Quantity(5000.0)}};
        const SolverTrace trace = trace_solver(model);
        CHECK(trace.has_constraints);
        REQUIRE(trace.blocks.size() == 5);
        CHECK(trace.blocks[4].is_member);
        CHECK(trace.blocks[4].name == "2-3");
        CHECK(trace.blocks[4].unknowns == std::vector<std::string>{"2-3.end.rz'"});
    }

    TEST_CASE("In a frame of bays and storeys every ordering eliminates all, dissection with the lowest tree")
    {
        const SolverTrace trace = trace_solver(storey_frame(7, 8));
        for (const EliminationWalk& walk : trace.walks) {
            CHECK(walk.counts.n_unknowns == 3 * 8 * 8);
            CHECK(walk.counts.n_levels >= trace.walk(Ordering::NestedDissection).counts.n_levels);
        }
        CHECK(trace.walk(Ordering::NestedDissection).counts.n_entries <=
              trace.walk(Ordering::Natural).counts.n_entries);
        const auto top = std::ranges::count_if(trace.blocks, [](const auto& block) { return block.separator == 0; });
        CHECK(top > 0);
        CHECK(top <= 8); // a slanted line across all storeys
    }

    TEST_CASE("Where every displacement is prescribed there is nothing to eliminate")
    {
        Model model = storey_frame(1, 1);
        for (Node& node : model.nodes) node.support = Support{.kind = SupportKind::Fixed};
        const SolverTrace trace = trace_solver(model);
        CHECK(trace.n_unknowns() == 0);
        for (const EliminationWalk& walk : trace.walks) CHECK(walk.fronts.empty());
    }

    TEST_CASE("Without members, or without anything, there is nothing to eliminate either")
    {
        Model model;
        CHECK(trace_solver(model).n_unknowns() == 0);
        model.add(Node{.id = "A", .at = {1.0, 2.0, 0.0}});
        CHECK(trace_solver(model).n_unknowns() == 0);
    }

    TEST_CASE("Of a structure with more than 400 unknowns it has the counts alone")
    {
        const SolverTrace small = trace_solver(storey_frame(9, 13)), large = trace_solver(storey_frame(9, 14));
        CHECK(small.n_unknowns() == 390);
        CHECK(small.has_details());
        CHECK(large.n_unknowns() == 420);
        CHECK_FALSE(large.has_details());
        for (const EliminationWalk& walk : large.walks) {
            CHECK(walk.columns.empty());
            CHECK(walk.counts.n_fill() > 0);
        }
    }

    TEST_CASE("A model with errors is refused with them")
    {
        Model model = storey_frame(1, 1);
        model.nodes[3].at = model.nodes[2].at;
        CHECK_THROWS_AS(trace_solver(model), ModelError);
    }
}
