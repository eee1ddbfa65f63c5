#include "apps/frame/view/derivation/state_pictures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "apps/drawing/draw.h"
#include "femoop/methods/force_method/force_steps.h"

namespace frame {

using femoop::derivation::StepKind;
using femoop::force_method::ForceMethod;

namespace {

std::size_t n_pictures(const ForceMethod& method) { return method.n_redundants() + 2; }

bool is_sum(const ForceMethod& method, std::size_t state) { return state == method.n_redundants() + 1; }

/// That the step speaks of; nothing where it is of all of them.
std::optional<std::size_t> state_meant(const ForceMethod& method, const femoop::derivation::Step& step)
{
    if (step.kind == StepKind::StateSuperposition) return method.n_redundants() + 1;
    const bool speaks_of_one = step.kind == StepKind::State || step.kind == StepKind::Flexibility;
    return speaks_of_one ? std::optional(step.state) : std::nullopt;
}

std::string title(const ForceMethod& method, std::size_t state, const ui::Catalogue& tr)
{
    if (state == 0) return tr("state 0: the loads");
    if (is_sum(method, state)) return tr("all states added up");
    return tr("state {n}: {redundant} = 1",
              {{"n", std::to_string(state)}, {"redundant", femoop::force_method::redundant_name(state)}});
}

std::string short_title(const ForceMethod& method, std::size_t state)
{
    if (is_sum(method, state)) return "Σ";
    if (state == 0) return "X = 0";
    return femoop::force_method::redundant_name(state) + " = 1";
}

/// That a state can be read in, with its name, in ems: in space moments in two planes and their values crowd it.
ui::Size least_size(femoop::AnalysisKind kind)
{
    return femoop::is_3d(kind) ? ui::Size{20.0, 14.0} : ui::Size{12.0, 8.5};
}

DrawOptions options_for(const ForceMethod& method, std::size_t state, const DrawOptions& view)
{
    DrawOptions options = view;
    const Show diagram = is_truss(method.primary.model.analysis) ? Show::N : Show::M;
    options.show = {diagram, Show::Values};
    if (!is_sum(method, state)) options.show.insert(Show::Loads);
    options.load_case = is_sum(method, state) ? method.superposition : method.cases[state];
    options.layout = drawing::Layout::Overlay;
    options.is_envelope = false;
    options.left_out.clear();
    return options;
}

} // namespace

std::vector<StateCell> state_cells(const ForceMethod& method, ui::Size room, const StateLook& look)
{
    constexpr double name_height = 1.5; // ems
    const ui::Size least = least_size(method.primary.model.analysis);
    const double em = ui::Theme(look.view.theme).type().normal;
    const auto n = static_cast<double>(n_pictures(method));
    const double columns = std::clamp(std::round(std::sqrt(n * room.width / (1.4 * std::max(room.height, 1.0)))), 1.0,
                                      n);
    const ui::Point size{room.width / columns, room.height / std::ceil(n / columns)};
    const auto cell = [&](std::size_t state, const ui::Box& box) {
        const double foot = std::max(box.min.y, box.max.y - name_height * em);
        return StateCell{state, {box.min, {box.max.x, foot}}, {{box.min.x, foot}, box.max}};
    };
    if (size.x < least.width * em || size.y < least.height * em)
        return {cell(state_meant(method, look.step).value_or(0), {{}, {room.width, room.height}})};
    std::vector<StateCell> cells;
    for (std::size_t state = 0; state < n_pictures(method); ++state) {
        const double row = std::floor(static_cast<double>(state) / columns);
        const double column = static_cast<double>(state) - row * columns;
        const ui::Point corner{column * size.x, row * size.y};
        cells.push_back(cell(state, {corner, corner + size}));
    }
    return cells;
}

void draw_state(ui::Painter& painter, const ForceMethod& method, std::size_t state, const StateLook& look)
{
    drawing::draw(painter, {.model = method.primary.model, .results = &method.states},
                  options_for(method, state, look.view));
}

void draw_state_name(ui::Painter& painter, const ForceMethod& method, std::size_t state, const StateLook& look)
{
    ui::TextStyle style = ui::Theme(look.view.theme).text(ui::Role::Label, ui::Anchor::Center);
    if (state_meant(method, look.step) == state) style.weight = ui::Weight::Bold;
    const std::string whole = title(method, state, look.view.tr);
    const bool has_room = painter.measure(whole, style).width <= painter.size().width;
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    painter.text({0.5 * painter.size().width, 0.5 * painter.size().height},
                 has_room ? whole : short_title(method, state), style);
}

} // namespace frame
