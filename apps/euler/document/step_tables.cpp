#include "apps/euler/document/step_tables.h"

namespace euler {

namespace {

topology::EntityTables tables(const topology::ScriptRunner& runner, std::size_t solid)
{
    if (!runner.solids()[solid].is_alive()) return {};
    return entity_tables(runner.solids()[solid].solid, place_among_living(runner, solid));
}

} // namespace

topology::ComparedTables step_tables(const Stepper& lesson, std::size_t step)
{
    const std::size_t solid = lesson.report(step).solid;
    Stepper there = lesson;
    there.go_to(step);
    topology::EntityTables after = tables(there.runner(), solid);
    there.go_to(step - 1);
    return compared(tables(there.runner(), solid), std::move(after));
}

} // namespace euler
