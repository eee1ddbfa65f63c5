#include "apps/drawing/draw.h"

#include "apps/drawing/sheet/subject.h"

namespace drawing {

void draw(ui::Painter& painter, const DrawInput& input, const DrawOptions& options, const DrawState& state)
{
    Subject(input, options, state).draw(painter);
}

Camera fitted_camera(const DrawInput& input, const DrawOptions& options, ui::Size sheet, const ui::Fonts& fonts)
{
    const DrawState state;
    return Subject(input, options, state).plan(sheet, fonts).camera;
}

bool is_seen_in_space(femoop::AnalysisKind kind)
{
    return femoop::is_3d(kind) || kind == femoop::AnalysisKind::Grillage;
}

ui::Color background(const DrawOptions& options) { return ui::Theme(options.theme).background(); }

} // namespace drawing
