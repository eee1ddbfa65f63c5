#include "apps/cli/picture.h"

#include <functional>

#include "apps/cli/analysis_run.h"
#include "apps/frame/view/frame_view.h"
#include "apps/frame/view/kept_view.h"
#include "apps/frame/view/sheet/subject.h"
#include "femoop/analysis/mechanism.h"
#include "ui/text/language_manner.h"

namespace cli {

namespace {

Backdrop backdrop_of(const PictureOrder& order, const femoop::Model& model)
{
    return {.color = frame::background(order.view), .title = model.title};
}

// A region is as high as the panel that the sheet leaves for it.
frame::ViewOptions looked_at(const PictureOrder& order, const femoop::Model& model, const femoop::Results& results,
                             const ui::Painter& painter)
{
    frame::ViewOptions view = order.view;
    if (!order.region || frame::is_seen_in_space(model.analysis)) return view;
    const auto plan = frame::Subject(model, &results, order.view).plan(painter.size(), painter.fonts());
    if (!plan.panels.empty()) view.camera = frame::camera_on(*order.region, plan.panels.front().box.size());
    return view;
}

ExitStatus draw_mechanism(const femoop::Model& model, const femoop::MechanismError& error, const std::string& file,
                          const PictureOrder& order, const Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const std::size_t total = error.mechanisms().size();
    const std::size_t shown = order.mechanism.value_or(0);
    if (shown >= total)
        throw UsageError(tr("--mechanism: found {found}; wanted at most {total}, the number of its motions",
                            {{"found", std::to_string(shown + 1)}, {"total", std::to_string(total)}}));
    report_mechanisms(error, file, console);
    const frame::MotionChoice motion{error.mechanisms(), shown};
    write_picture(
        order.file, backdrop_of(order, model),
        [&](ui::Painter& painter) { frame::draw(painter, model, motion, order.view); }, tr);
    console.message(
        tr("{file} shows the motion {n} of {total}",
           {{"file", order.file.path.string()}, {"n", std::to_string(shown + 1)}, {"total", std::to_string(total)}}));
    return ExitStatus::CannotSolve;
}

} // namespace

ExitStatus draw_picture(const femoop::Model& model, const std::string& file, const PictureOrder& order,
                        const Console& console)
{
    try {
        const femoop::Results results = femoop::analyse(model);
        if (order.mechanism)
            throw UsageError(console.tr()("--mechanism: the structure is no mechanism; leave the option out"));
        console.report(file, results.warnings());
        write_picture(
            order.file, backdrop_of(order, model),
            [&](ui::Painter& painter) {
                frame::draw(painter, model, &results, looked_at(order, model, results, painter));
            },
            console.tr());
        return ExitStatus::Done;
    } catch (const femoop::MechanismError& error) {
        return draw_mechanism(model, error, file, order, console);
    } catch (const femoop::ModelError& error) {
        console.report(file, error.faults());
        return status_of(error.faults());
    }
}

frame::ViewOptions view_options(const ui::Catalogue& tr)
{
    frame::ViewOptions options;
    options.tr = tr;
    options.numbers.mark = ui::decimal_mark(tr.language());
    return options;
}

} // namespace cli
