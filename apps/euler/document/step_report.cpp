#include "apps/euler/document/step_report.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace euler {

namespace {

using topology::Change;
using topology::Entity;

std::string difference(std::size_t before, std::size_t after)
{
    if (after > before) return " +" + std::to_string(after - before);
    return after < before ? " -" + std::to_string(before - after) : " 0";
}

/// Those that are not among the others.
std::vector<Entity> without(const std::set<Entity>& list, const std::set<Entity>& others)
{
    std::vector<Entity> rest;
    std::set_difference(list.begin(), list.end(), others.begin(), others.end(), std::back_inserter(rest));
    return rest;
}

} // namespace

std::string deltas(const StepSummary& step)
{
    const topology::EulerCounts &a = step.before, &b = step.after;
    return step.name + ":" + difference(a.V, b.V) + difference(a.E, b.E) + difference(a.F, b.F) + difference(a.L, b.L) +
           difference(a.S, b.S) + difference(a.G, b.G);
}

Change together(const std::vector<Change>& changes)
{
    if (changes.size() == 1) return changes.front();
    Change all;
    std::set<Entity> created, killed, changed;
    for (const Change& change : changes) {
        all.kind = changes.front().kind;
        created.insert(change.created.begin(), change.created.end());
        killed.insert(change.killed.begin(), change.killed.end());
        changed.insert(change.changed.begin(), change.changed.end());
        for (const topology::SplitOrJoin& split : change.split) all.split.push_back(split);
        for (const topology::SplitOrJoin& joined : change.joined) all.joined.push_back(joined);
    }
    all.created = without(created, killed);
    all.killed = without(killed, created);
    std::set<Entity> gone = created;
    gone.insert(killed.begin(), killed.end());
    all.changed = without(changed, gone);
    return all;
}

} // namespace euler
