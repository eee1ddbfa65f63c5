#include "apps/euler/document/snapshot.h"

namespace euler {

std::vector<Snapshot> snapshots(const Stepper& lesson)
{
    std::vector<Snapshot> taken;
    for (const topology::NamedSolid& in : lesson.runner().solids())
        taken.push_back({in.name, std::make_shared<const topology::Solid>(in.solid),
                         std::make_shared<const topology::Names>(in.names)});
    return taken;
}

std::vector<Snapshot> snapshots(const Stepper& lesson, std::vector<Snapshot> at_end)
{
    for (std::size_t i = 0; i < at_end.size(); ++i)
        if (lesson.runner().solids()[i].journal.n_undone() != 0) at_end = retaken(lesson, i, std::move(at_end));
    return at_end;
}

// The names of the end are good at every place: those of entities that are not there yet do no harm.
std::vector<Snapshot> retaken(const Stepper& lesson, std::size_t solid, std::vector<Snapshot> others)
{
    others[solid].solid = std::make_shared<const topology::Solid>(lesson.runner().solids()[solid].solid);
    return others;
}

} // namespace euler
