#include "apps/frame/view/derivation/state_pictures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/drawing/draw.h"
#include "femoop/methods/force_method/force_steps.h"

namespace frame {

using femoop::derivation::StepKind;
using femoop::force_method::ForceMethod;

namespace {

std::size_t n_pictures(const ForceMethod& method) { return method.n_redundants() + 2; }

bool is_sum(const ForceMethod& method, std::size_t state) { return state == method.n_redundants() + 1; }

/// Does the step speak of this state?
bool is_meant(const ForceMethod& method, std::size_t state, const femoop::derivation::Step& step)
{
    if (step.kind == StepKind::StateSuperposition) return is_sum(method, state);
    const bool speaks_of_one = step.kind == StepKind::State || step.kind == StepKind::Flexibility;
    return speaks_of_one && step.state == state;
}

std::string title(const ForceMethod& method, std::size_t state, const ui::Catalogue& tr)
{
    if (state == 0) return tr("state 0: the loads");
    if (is_sum(method, state)) return tr("all states added up");
    return tr("state {n}: {redundant} = 1",
              {{"n", std::to_string(state)}, {"redundant", femoop::force_method::redundant_name(state)}});
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

std::vector<StateCell> state_cells(const ForceMethod& method, ui::Size room)
{
    const auto n = static_cast<double>(n_pictures(method));
    const double columns = std::clamp(std::round(std::sqrt(n * room.width / (1.4 * std::max(room.height, 1.0)))), 1.0,
                                      n);
    const double rows = std::ceil(n / columns);
    const ui::Point size{room.width / columns, room.height / rows};
    std::vector<StateCell> cells;
    for (std::size_t state = 0; state < n_pictures(method); ++state) {
        const double row = std::floor(static_cast<double>(state) / columns);
        const double column = static_cast<double>(state) - row * columns;
        const ui::Point corner{column * size.x, row * size.y};
        cells.push_back({state, {corner, corner + size}});
    }
    return cells;
}

void draw_state(ui::Painter& painter, const ForceMethod& method, std::size_t state, const StateLook& look)
{
    const DrawOptions options = options_for(method, state, look.view);
    drawing::draw(painter, {.model = method.primary.model, .results = &method.states}, options);
    const ui::Theme theme(look.view.theme);
    ui::TextStyle style = theme.text(ui::Role::Label, ui::Anchor::BottomLeft);
    if (is_meant(method, state, look.step)) style.weight = ui::Weight::Bold;
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    painter.text({6.0, painter.size().height - 4.0}, title(method, state, look.view.tr), style);
}

} // namespace frame
