#include "apps/drawing/draw.h"

#include "apps/drawing/sheet/subject.h"

namespace drawing {

void draw(ui::Painter& painter, const femoop::Model& model, const femoop::Results* results, const ViewOptions& options)
{
    Subject(model, results, options).draw(painter);
}

void draw(ui::Painter& painter, const femoop::Model& model, const MotionChoice& motion, const ViewOptions& options)
{
    Subject(model, motion, options).draw(painter);
}

Camera fitted_camera(const femoop::Model& model, const femoop::Results* results, const ViewOptions& options,
                     ui::Size sheet, const ui::Fonts& fonts)
{
    ViewOptions fitting = options;
    fitting.camera.reset();
    return Subject(model, results, fitting).plan(sheet, fonts).camera;
}

bool is_seen_in_space(femoop::AnalysisKind kind)
{
    return femoop::is_3d(kind) || kind == femoop::AnalysisKind::Grillage;
}

ui::Color background(const ViewOptions& options) { return ui::Theme(options.theme).background(); }

} // namespace drawing
