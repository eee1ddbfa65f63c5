#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/topology/halfedge/random_walk.h"

using namespace topology;

namespace {

class Notebook : public Observer {
public:
    void changed(const Change& change) override { changes.push_back(change); }
    std::vector<Change> changes;
};

template <class Table> void compare(const Table& before, const Table& after, std::vector<std::set<Entity>>& lists)
{
    using Id = decltype(before.last());
    for (std::uint32_t row = 0; row < std::max(before.n_rows(), after.n_rows()); ++row) {
        const Id id{row};
        if (!before.has(id) && after.has(id)) lists[0].insert(id);
        if (before.has(id) && !after.has(id)) lists[1].insert(id);
        if (before.has(id) && after.has(id) && !(before[id] == after[id])) lists[2].insert(id);
    }
}

/// Created, killed and changed entities, found by comparing every row.
std::vector<std::set<Entity>> difference(const Tables& before, const Tables& after)
{
    std::vector<std::set<Entity>> lists(3);
    compare(before.vertices, after.vertices, lists);
    compare(before.half_edges, after.half_edges, lists);
    compare(before.edges, after.edges, lists);
    compare(before.loops, after.loops, lists);
    compare(before.faces, after.faces, lists);
    return lists;
}

void check_told(const Solid& before, const Solid& after, const Change& told)
{
    const auto lists = difference(before.tables(), after.tables());
    const std::set<Entity> changed(told.changed.begin(), told.changed.end());
    REQUIRE(std::set<Entity>(told.created.begin(), told.created.end()) == lists[0]);
    REQUIRE(std::set<Entity>(told.killed.begin(), told.killed.end()) == lists[1]);
    REQUIRE(std::includes(changed.begin(), changed.end(), lists[2].begin(), lists[2].end()));
    for (const Entity& entity : changed) {
        REQUIRE_FALSE(lists[0].contains(entity));
        REQUIRE_FALSE(lists[1].contains(entity));
    }
    for (const SplitOrJoin& split_or_join : told.split) REQUIRE(lists[0].contains(split_or_join.other));
    for (const SplitOrJoin& split_or_join : told.joined) REQUIRE(lists[1].contains(split_or_join.other));
    for (const auto* list : {&told.split, &told.joined})
        for (const SplitOrJoin& split_or_join : *list)
            REQUIRE_FALSE((lists[0].contains(split_or_join.stays) || lists[1].contains(split_or_join.stays)));
}

} // namespace

TEST_SUITE("observers")
{
    TEST_CASE("An observer is told of everything that is made, killed or linked otherwise, also by undo and redo")
    {
        for (std::uint32_t seed = 1; seed <= 60; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            Notebook notebook;
            walk.op().observe(notebook);
            for (int i = 0; i < 120; ++i) {
                const Solid before = walk.solid;
                const OperatorKind kind = walk.step(1.5);
                CAPTURE(name(kind));
                const Solid after = walk.solid;
                check_told(before, after, notebook.changes.back());
                walk.op().undo();
                check_told(after, before, notebook.changes.back());
                walk.op().redo();
                check_told(before, after, notebook.changes.back());
                REQUIRE(notebook.changes.size() == 3 * static_cast<std::size_t>(i + 1));
            }
        }
    }

    TEST_CASE("A split tells parent and child, its undo tells the child joined to the parent under the inverse's name")
    {
        Solid solid;
        Journal journal;
        EulerOperator op(solid, journal);
        Notebook notebook;
        op.observe(notebook);
        const LoneVertex first = op.mvfs({0, 0, 0});
        const NewEdge strut = op.mev(first.half_edge, {1, 0, 0});
        CHECK(notebook.changes.back().split.empty()); // a strut divides no vertex
        const NewEdge part = op.semv(strut.plus, {2, 0, 0});
        CHECK(notebook.changes.back().split == std::vector<SplitOrJoin>{{strut.edge, part.edge}});
        const NewFace lid = op.mef(strut.minus, part.plus);
        CHECK(notebook.changes.back().split ==
              std::vector<SplitOrJoin>{{first.face, lid.face}, {first.loop, lid.loop}});
        op.undo();
        CHECK(notebook.changes.back().kind == OperatorKind::KEF);
        CHECK(notebook.changes.back().joined ==
              std::vector<SplitOrJoin>{{first.face, lid.face}, {first.loop, lid.loop}});
    }

    TEST_CASE("Refused operators are not told")
    {
        Solid solid;
        EulerOperator op(solid);
        Notebook notebook;
        const LoneVertex lone = op.mvfs({0, 0, 0});
        op.observe(notebook);
        CHECK_THROWS_AS(op.kev(lone.half_edge), EulerError);
        CHECK(notebook.changes.empty());
    }
}
