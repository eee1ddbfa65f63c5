#include "apps/cli/picture.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/drawing/draw.h"
#include "apps/drawing/sheet/subject.h"
#include "apps/frame/view/kept_view.h"
#include "apps/frame/view/motion_words.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/language_manner.h"

namespace cli {

namespace {

// A region is as high as the panel that the sheet leaves for it.
drawing::DrawState looked_at(const PictureOrder& order, const drawing::DrawInput& input, const ui::Painter& painter)
{
    drawing::DrawState state;
    if (!order.region || drawing::is_seen_in_space(input.model.analysis)) return state;
    const auto plan = drawing::Subject(input, order.view, state).plan(painter.size(), painter.fonts());
    if (!plan.panels.empty()) state.camera = frame::camera_on(*order.region, plan.panels.front().box.size());
    return state;
}

std::optional<femoop::counting::Counting> counting_shown(const femoop::Model& model, const drawing::DrawOptions& view)
{
    if (!view.show.contains(drawing::Show::Counting) || model.members.empty()) return std::nullopt;
    return femoop::counting::count(model);
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
    const auto counting = counting_shown(model, order.view);
    const drawing::DrawInput input{.model = model,
                                   .motion = frame::motion_choice(error.mechanisms(), shown, tr),
                                   .dimensions = order.dimensions,
                                   .counting = counting ? &*counting : nullptr};
    write_picture(
        order.file, backdrop_of(order, model), [&](ui::Painter& painter) { drawing::draw(painter, input, order.view); },
        tr);
    console.message(
        tr("{file} shows the motion {n} of {total}",
           {{"file", order.file.path.string()}, {"n", std::to_string(shown + 1)}, {"total", std::to_string(total)}}));
    return ExitStatus::CannotSolve;
}

} // namespace

void require_counterpart(const drawing::ReferenceResults& reference, const femoop::Model& model,
                         const PictureOrder& order, const ui::Catalogue& tr)
{
    if (order.view.is_envelope) throw ask_for_different_things("--compare", "--case envelope", tr);
    if (model.n_cases() == 0 || reference.counterpart(model, order.view.load_case)) return;
    std::vector<std::string> names;
    for (const femoop::CaseId id : all_cases(reference.model)) names.push_back(reference.model.case_name(id));
    throw UsageError(
        tr("--compare: {case}: there is none of this name in {file}, so there is nothing to draw behind it; "
           "name a case of {file} with --with ({names})",
           {{"case", model.case_name(order.view.load_case)},
            {"file", reference.name},
            {"names", names.empty() ? tr("it has none") : names_in_words(names)}}));
}

ExitStatus draw_picture(const femoop::Model& model, const std::string& file, const PictureOrder& order,
                        const Console& console)
{
    try {
        const femoop::Results results = femoop::analyse(model);
        if (order.mechanism)
            throw UsageError(console.tr()("--mechanism: the structure is no mechanism; leave the option out"));
        console.report(file, results.warnings());
        std::optional<drawing::ReferenceResults> reference;
        if (order.reference) {
            auto found = reference_of(*order.reference, model, results, console);
            if (const auto* status = std::get_if<ExitStatus>(&found)) return *status;
            reference = std::get<drawing::ReferenceResults>(std::move(found));
            require_counterpart(*reference, model, order, console.tr());
        }
        const auto counting = counting_shown(model, order.view);
        const drawing::DrawInput input{.model = model,
                                       .results = &results,
                                       .reference = reference ? &*reference : nullptr,
                                       .dimensions = order.dimensions,
                                       .counting = counting ? &*counting : nullptr};
        write_picture(
            order.file, backdrop_of(order, model),
            [&](ui::Painter& painter) { drawing::draw(painter, input, order.view, looked_at(order, input, painter)); },
            console.tr());
        return ExitStatus::Done;
    } catch (const femoop::MechanismError& error) {
        return draw_mechanism(model, error, file, order, console);
    } catch (const femoop::ModelError& error) {
        console.report(file, error.faults());
        return status_of(error.faults());
    }
}

Backdrop backdrop_of(const PictureOrder& order, const femoop::Model& model)
{
    return {.color = drawing::background(order.view), .title = model.title};
}

drawing::DrawOptions draw_options(const ui::Catalogue& tr)
{
    drawing::DrawOptions options;
    options.tr = tr;
    options.numbers.mark = ui::decimal_mark(tr.language());
    return options;
}

} // namespace cli
