#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "apps/euler/document/stepper.h"

namespace euler {

/// One of the solids of a lesson, as it was at some place. Copies share what they show.
struct Snapshot {
    std::string name;
    std::shared_ptr<const topology::Solid> solid;
    std::shared_ptr<const topology::Names> names;

    bool is_alive() const { return !solid->is_empty(); }
};

/// The lesson's solids where it stands, in the order of the runner's.
std::vector<Snapshot> snapshots(const Stepper& lesson);
/// The same, where those at the lesson's end are known: only solids that go on changing are copied.
std::vector<Snapshot> snapshots(const Stepper& lesson, std::vector<Snapshot> at_end);
/// One of them alone is taken anew.
std::vector<Snapshot> retaken(const Stepper& lesson, std::size_t solid, std::vector<Snapshot> others);

} // namespace euler
