#include "apps/frame/session/solver_commands.h"

#include <array>

namespace frame {

using femoop::Ordering;
using ui::Key;
using ui::translatable;

namespace {

bool shows_solver(const Desk& desk) { return desk.bottom.shows(BottomContent::Solver); }

std::optional<ui::Phrase> why_not_step(const Desk& desk)
{
    if (!shows_solver(desk)) return translatable("the solver is not shown; Ctrl+F4 shows it");
    if (desk.solver.n_steps() == 0) return translatable("there is no front that walks");
    return std::nullopt;
}

struct StepEntry {
    std::string_view id, label;
    void (*run)(SolverShow& show);
};
constexpr std::array steps{
    StepEntry{"solver.first", translatable("First front"), [](SolverShow& show) { show.go_to(0); }},
    StepEntry{"solver.previous", translatable("Previous front"),
              [](SolverShow& show) { show.go_to(show.step() == 0 ? 0 : show.step() - 1); }},
    StepEntry{"solver.next", translatable("Next front"), [](SolverShow& show) { show.go_to(show.step() + 1); }},
    StepEntry{"solver.last", translatable("Last front"), [](SolverShow& show) { show.go_to(show.n_steps()); }},
};

struct OrderEntry {
    std::string_view id, label;
    Ordering ordering;
};
constexpr std::array orders{
    OrderEntry{"solver.natural", translatable("Eliminate in natural order"), Ordering::Natural},
    OrderEntry{"solver.cuthill_mckee", translatable("Eliminate in reverse Cuthill-McKee order"),
               Ordering::CuthillMcKee},
    OrderEntry{"solver.minimum_degree", translatable("Eliminate by minimum degree"), Ordering::MinimumDegree},
    OrderEntry{"solver.nested_dissection", translatable("Eliminate by nested dissection"), Ordering::NestedDissection},
};

} // namespace

void add_solver_commands(CommandTable& table)
{
    table.add({.id = "view.solver",
               .menu = translatable("Tables"),
               .label = translatable("The solver at work"),
               .shortcuts = {{Key::F4, ui::ctrl}},
               .run =
                   [](Desk& desk) {
                       desk.bottom = {!shows_solver(desk), desk.bottom.table, BottomContent::Solver};
                       desk.solver.follow(desk.session);
                   },
               .is_on = shows_solver});
    for (const StepEntry& entry : steps)
        table.add({.id = entry.id,
                   .label = entry.label,
                   .run =
                       [run = entry.run](Desk& desk) {
                           desk.solver.rest();
                           run(desk.solver);
                       },
                   .why_not = why_not_step});
    table.add({.id = "solver.play",
               .label = translatable("Let the front walk"),
               .run = [](Desk& desk) { desk.solver.is_playing() ? desk.solver.rest() : desk.solver.play(); },
               .why_not = why_not_step,
               .is_on = [](const Desk& desk) { return desk.solver.is_playing(); }});
    for (const OrderEntry& entry : orders)
        table.add(
            {.id = entry.id,
             .label = entry.label,
             .run = [ordering = entry.ordering](Desk& desk) { desk.solver.choose(ordering); },
             .why_not = why_not_step,
             .is_on = [ordering = entry.ordering](
                          const Desk& desk) { return shows_solver(desk) && desk.solver.ordering() == ordering; }});
}

} // namespace frame
