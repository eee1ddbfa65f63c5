#include "apps/cli/plane_render.h"

#include <algorithm>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/plane_input.h"
#include "apps/cli/plane_modes.h"
#include "apps/cli/plane_places.h"
#include "apps/plane/backdrop/view_file.h"
#include "apps/plane/view/cut_panel.h"
#include "apps/plane/view/plate_words.h"
#include "apps/plane/view/singular_notice.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "ui/files/view_file.h"

namespace cli {

namespace {

namespace fp = femoop::plane;

::plane::PlateShown plate_shown_by(const std::string& list, const ui::Catalogue& tr)
{
    ::plane::PlateShown all;
    for (const std::string& word : comma_list(list)) {
        const auto shown = ::plane::plate_shown(word);
        if (!shown) throw unknown_choice("--show", word, ::plane::all_plate_words(), tr);
        for (const ::plane::FieldShow& field : shown->fields)
            if (std::ranges::find(all.fields, field.style, &::plane::FieldShow::style) != all.fields.end())
                throw UsageError(tr("--show: {word} is the second of its kind; a picture has one", {{"word", word}}));
        all = all | *shown;
    }
    return all;
}

femoop::CaseId case_named(const fp::PlaneModel& model, const std::string& name, const ui::Catalogue& tr)
{
    if (const auto found = model.find_case(name)) return *found;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < model.n_cases(); ++i) names.push_back(model.case_name(femoop::CaseId(i)));
    throw unknown_choice("--case", name, names, tr);
}

/// What results are asked of a case that is not there.
void require_case(const fp::PlaneModel& model, const ui::Catalogue& tr)
{
    if (model.n_cases() == 0)
        throw UsageError(tr("--show: results need a load case, and the model has none; leave them out"));
}

void require_room(const ::plane::PlateOptions& options, const PlaneRender::Order& order, const ui::Catalogue& tr)
{
    const std::size_t most = ::plane::most_cuts(ui::Theme(options.theme), order.file.size.width);
    if (options.cuts.size() > most)
        throw UsageError(tr("--cut: {found} cuts; a picture of this width has room for {most}, a wider one for more",
                            {{"found", std::to_string(options.cuts.size())}, {"most", std::to_string(most)}}));
}

} // namespace

void PlaneRender::declare(OptionParser& options, const ui::Catalogue& tr)
{
    at_ = options.option("--at");
    at_->last_value().add_description(
        tr("of a plane model a place X,Y where displacements and stresses are written, may be given again"));
    options
        .add_option(
            "--cut", cuts_,
            tr("of a plane model: draw the stresses on the cut from one place to another, N, V and M, and those "
               "of beam theory; may be given again"))
        .option_text("X1,Y1,X2,Y2")
        .one_value_each();
    options
        .add_option("--read", read_,
                    tr("of a plane model: stresses smoothed (default), or element: those of each element, with jumps"))
        .option_text("READING");
    options
        .add_option("--range", range_,
                    tr("of a plane model: the least and the largest value of the colours, in the file's units"))
        .option_text("LOW,HIGH");
    options
        .add_option(
            "--step", step_,
            tr("of a plane model that is drawn: its mesh as it stands after so many steps of being made, and what "
               "the last of them did"))
        .option_text("K");
    options
        .add_option("--analysis", analysis_,
                    tr("of a plane model: linear (default), or modal: how it vibrates by itself"))
        .option_text("KIND");
    options.add_option("--mode", mode_, tr("with --analysis modal: which natural mode is drawn, from 1 (default)"))
        .option_text("N");
    options.add_flag("--describe", is_described_,
                     tr("of a plane model: print what the picture shows in sentences; then -o may be left out"));
}

void PlaneRender::look(::plane::PlateOptions& options, const Order& order, const ui::Catalogue& tr) const
{
    if (order.show) options.show = plate_shown_by(*order.show, tr);
    const bool has_bands = std::ranges::any_of(
        options.show.fields, [](const ::plane::FieldShow& field) { return field.style == ::plane::FieldStyle::Bands; });
    if (has_bands && options.show.set.contains(::plane::PlateShow::Error))
        throw contradiction("--show error", "--show bands:", tr);
    if (range_ && options.show.fields.empty() && !options.show.set.contains(::plane::PlateShow::Error))
        throw needs_too("--range", "--show bands:mises", tr);
    if (options.deformation_scale && !options.show.set.contains(::plane::PlateShow::Deformed) && !is_modal(tr))
        throw needs_too("--magnify", "--show deformed", tr);
    if (read_ && !options.show.needs_results() && places().empty()) throw needs_too("--read", "--show bands:mises", tr);
    if (step_ && (!places().empty() || !cuts_.empty()))
        throw contradiction("--step", places().empty() ? "--cut" : "--at", tr);
    if (range_) {
        const std::vector<double> ends = numbers_of("--range", *range_, 2, tr);
        if (!(ends[0] < ends[1]))
            throw UsageError(tr("--range: found {found}; wanted the smaller number first", {{"found", *range_}}));
        options.range = {ends[0], ends[1]};
    }
    if (read_ == "element") options.reading = fp::StressReading::Element;
    else if (read_ && *read_ != "smoothed") throw not_one_of("--read", *read_, "smoothed, element", tr);
}

void PlaneRender::require_none(const ui::Catalogue& tr) const
{
    if (is_modal(tr)) throw modes_of_members(tr);
    if (!cuts_.empty() || read_ || range_ || step_ || is_described_ || places().size() > 1)
        throw UsageError(tr(
            "--cut, --read, --range, --step, --describe, and --at more than once, are for plane models; this is a structure "
            "of members"));
}

std::vector<std::string> PlaneRender::places() const { return at_ ? at_->results() : std::vector<std::string>(); }

ExitStatus PlaneRender::draw(fp::PlaneReading& reading, const std::string& name, const Order& order,
                             Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    ::plane::PlateOptions options = order.look;
    look(options, order, tr);
    const bool has_questions = !places().empty() || !cuts_.empty();
    const bool has_modes = is_modal(tr);
    if (has_modes) require_modes_alone(order, tr);
    const bool needs_results = options.show.needs_results() || has_questions || order.mechanism;
    const bool needs_mesh = options.show.needs_mesh() || needs_results || step_ || has_modes;
    const PlaneInput input(reading, needs_mesh ? PlaneInput::Depth::Mesh : PlaneInput::Depth::Drawing);
    console.report(name, reading.faults);
    if (!reading.is_sound()) return ExitStatus::BadInput;
    if (order.load_case) options.load_case = case_named(reading.model, *order.load_case, tr);
    ::plane::PlateInput shown{.model = reading.model, .drawing = input.drawing()};
    if (input.mesh() != nullptr) shown.mesh = &input.model();
    const ::plane::ViewReading beside = order.model_file ? ::plane::read_view_of(*order.model_file)
                                                         : ::plane::ViewReading{};
    if (order.model_file) console.report(ui::view_path(*order.model_file).string(), beside.faults);
    if (beside.backdrop) shown.backdrop = &*beside.backdrop;
    if (has_modes) return draw_mode(shown, options, name, order, console);
    const std::unique_ptr<discretize::MeshPlayer> player = player_at_step(input.drawing(), tr);
    shown.player = player.get();
    if (player || !needs_results) return write(shown, order, options, console);
    require_case(reading.model, tr);
    try {
        const fp::PlaneResults results = fp::analyse(input.model());
        if (order.mechanism) throw UsageError(tr("--mechanism: the structure is no mechanism; leave the option out"));
        console.report(name, results.warnings());
        options.probes = places_in(results.locator(), places(), tr);
        options.cuts = cuts_through(results.model(), results.locator(), cuts_, tr);
        require_room(options, order, tr);
        shown.results = &results;
        if (shown.drawing != nullptr && !is_described_ && ::plane::shows_stresses(options))
            tell_singular_corners(*shown.drawing, name, options, console);
        return write(shown, order, options, console);
    } catch (const femoop::MechanismError& error) {
        return draw_motion(shown, error, name, order, options, console);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, name, console);
    }
}

/// A body that can move has no results; it is drawn where the motion takes it.
ExitStatus PlaneRender::draw_motion(::plane::PlateInput shown, const femoop::MechanismError& error,
                                    const std::string& name, const Order& order, const ::plane::PlateOptions& options,
                                    Console& console) const
{
    const std::size_t total = error.mechanisms().size(), which = order.mechanism.value_or(0);
    if (which >= total && order.mechanism)
        throw UsageError(console.tr()("--mechanism: found {found}; wanted at most {total}, the number of its motions",
                                      {{"found", std::to_string(which + 1)}, {"total", std::to_string(total)}}));
    const ExitStatus status = report_unsolved(error, name, console);
    if (which >= total || !order.has_file) return status;
    shown.motion = &error.mechanisms()[which].motion;
    shown.results = nullptr;
    write(shown, order, options, console);
    return status;
}

bool PlaneRender::is_modal(const ui::Catalogue& tr) const
{
    const bool is_modal = asks_for_modes(analysis_, tr);
    if (mode_ && !is_modal) throw needs_too("--mode", "--analysis modal", tr);
    return is_modal;
}

void PlaneRender::require_modes_alone(const Order& order, const ui::Catalogue& tr) const
{
    const auto refuse = [&](bool is_given, std::string_view option) {
        if (is_given) throw contradiction("--analysis modal", option, tr);
    };
    refuse(order.load_case.has_value(), "--case");
    refuse(!places().empty(), "--at");
    refuse(!cuts_.empty(), "--cut");
    refuse(step_.has_value(), "--step");
    refuse(read_.has_value(), "--read");
    refuse(range_.has_value(), "--range");
}

ExitStatus PlaneRender::draw_mode(::plane::PlateInput shown, ::plane::PlateOptions options, const std::string& name,
                                  const Order& order, Console& console) const
{
    const std::size_t n = mode_
                              ? static_cast<std::size_t>(whole_number("--mode", *mode_, {1, most_modes}, console.tr()))
                              : 1;
    try {
        const fp::NaturalModes modes = fp::natural_modes(shown.mesh != nullptr ? *shown.mesh : shown.model, n);
        console.report(name, modes.warnings);
        shown.modes = &modes;
        options.mode = n - 1;
        return write(shown, order, options, console);
    } catch (const femoop::ModelError& error) {
        return report_unsolved(error, name, console);
    }
}

/// Null where no step is asked for.
std::unique_ptr<discretize::MeshPlayer> PlaneRender::player_at_step(const discretize::Drawing* drawing,
                                                                    const ui::Catalogue& tr) const
{
    if (!step_) return nullptr;
    if (drawing == nullptr)
        throw UsageError(tr("--step: the mesh is the file's own, and has no steps; give a drawing of curves"));
    auto player = std::make_unique<discretize::MeshPlayer>(*drawing);
    player->go_to(
        static_cast<std::size_t>(whole_number("--step", *step_, {0, static_cast<long>(player->n_steps())}, tr)));
    return player;
}

ExitStatus PlaneRender::write(const ::plane::PlateInput& input, const Order& order,
                              const ::plane::PlateOptions& options, Console& console) const
{
    if (is_described_) console.print(::plane::in_words(input, options));
    if (!order.has_file) return ExitStatus::Done;
    write_picture(
        order.file, {.color = ::plane::background(options), .title = input.model.title},
        [&](ui::Painter& painter) { ::plane::draw(painter, input, options); }, console.tr());
    return ExitStatus::Done;
}

} // namespace cli
