#include "apps/cli/picture.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <stdexcept>

#include "apps/cli/analysis_run.h"
#include "apps/cli/output_file.h"
#include "apps/frame/view/frame_view.h"
#include "apps/frame/view/kept_view.h"
#include "apps/frame/view/sheet/subject.h"
#include "femoop/analysis/mechanism.h"
#include "ui/context/paint_to_png.h"
#include "ui/paint/paint_to_file.h"

namespace cli {

namespace {

void write_picture(const PictureOrder& order, const std::string& title, const ui::Drawing& drawing,
                   const ui::Catalogue& tr)
{
    require_writable(order.path, tr);
    const ui::Sheet sheet{
        .size = order.size, .scale = order.pixel_scale, .background = frame::background(order.view), .title = title};
    const std::string kind = kind_of(order.path);
    try {
        if (kind == ".png") ui::paint_to_png(order.path, sheet, drawing);
        if (kind == ".svg") ui::paint_to_svg(order.path, sheet, drawing);
        if (kind == ".pdf") ui::paint_to_pdf(order.path, sheet, drawing);
    } catch (const std::exception& error) {
        throw UsageError(tr("cannot draw {file}: {reason}", {{"file", order.path.string()}, {"reason", error.what()}}));
    }
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
        order, model.title, [&](ui::Painter& painter) { frame::draw(painter, model, motion, order.view); }, tr);
    console.message(
        tr("{file} shows the motion {n} of {total}",
           {{"file", order.path.string()}, {"n", std::to_string(shown + 1)}, {"total", std::to_string(total)}}));
    return ExitStatus::CannotSolve;
}

} // namespace

std::string kind_of(const std::filesystem::path& path)
{
    std::string kind = path.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return kind;
}

bool is_picture(const std::filesystem::path& path)
{
    const std::string kind = kind_of(path);
    return kind == ".png" || kind == ".svg" || kind == ".pdf";
}

ExitStatus draw_picture(const femoop::Model& model, const std::string& file, const PictureOrder& order,
                        const Console& console)
{
    try {
        const femoop::Results results = femoop::analyse(model);
        if (order.mechanism)
            throw UsageError(console.tr()("--mechanism: the structure is no mechanism; leave the option out"));
        console.report(file, results.warnings());
        write_picture(
            order, model.title,
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
    if (tr.language() == ui::Language::Portuguese) options.numbers.mark = ui::DecimalMark::Comma;
    return options;
}

} // namespace cli
