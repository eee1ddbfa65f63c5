#include "apps/cli/solver_trace.h"

#include "apps/cli/argument.h"
#include "apps/cli/picture_file.h"
#include "apps/frame/view/solver/solver_picture.h"

namespace cli {

using femoop::Ordering;
using femoop::SolverTrace;

void SolverTraceOptions::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options.add_flag(
        "--trace-solver", is_traced_,
        tr("print how the system is eliminated instead of the results: "
           "the orders side by side with what they cost, the fronts one after the other, and where L fills in"));
    options
        .add_option("--ordering", ordering_,
                    tr("with --trace-solver: whose fronts walk, natural, "
                       "cuthill-mckee, minimum-degree or nested-dissection (default: the solver's own order)"))
        .option_text("NAME");
    options.add_option("--step", step_, tr("with --trace-solver: the front that is shown more closely, from 1"))
        .option_text("N");
    options
        .add_option("-o,--output", out_,
                    tr("with --trace-solver: draw the step too; the extension chooses the kind: .png, .svg or .pdf"))
        .option_text("OUT");
    options.add_option("--size", size_, tr("width and height in pixels (default 1280x800)")).option_text("WxH");
    options
        .add_option("--scale", scale_,
                    tr("pixels per pixel of --size in a PNG: 2 draws it twice as sharp and twice as large (default 1)"))
        .option_text("K");
    options.add_option("--theme", theme_, tr("light (default), dark, print or projector (large type, thick lines)"))
        .option_text("NAME");
}

void SolverTraceOptions::require_trace(const ui::Catalogue& tr) const
{
    if (is_traced_) return;
    const auto refuse = [&](bool is_given, const char* option) {
        if (is_given) throw UsageError(tr("{option} goes with --trace-solver; add it", {{"option", option}}));
    };
    refuse(ordering_.has_value(), "--ordering");
    refuse(step_.has_value(), "--step");
    refuse(out_.has_value(), "-o");
    refuse(size_.has_value(), "--size");
    refuse(scale_.has_value(), "--scale");
    refuse(theme_.has_value(), "--theme");
}

femoop::SolverTraceRequest SolverTraceOptions::request(const SolverTrace& trace, const ui::Catalogue& tr) const
{
    femoop::SolverTraceRequest request;
    if (ordering_) {
        request.ordering = femoop::ordering_named(*ordering_);
        std::vector<std::string> names;
        for (const Ordering ordering : femoop::all_orderings) names.emplace_back(name(ordering));
        if (!request.ordering) throw unknown_choice("--ordering", *ordering_, names, tr);
    }
    if (!step_) return request;
    const auto n = static_cast<long>(trace.walk(request.ordering.value_or(usual_ordering(trace))).fronts.size());
    if (n == 0 || !trace.has_details())
        throw UsageError(tr("--step: no fronts are told of a system of {count} unknowns; leave the option out",
                            {{"count", std::to_string(trace.n_unknowns())}}));
    request.step = static_cast<std::size_t>(whole_number("--step", *step_, {1, n}, tr) - 1);
    return request;
}

void SolverTraceOptions::show(const femoop::Model& model, femoop::SolverKind wanted, bool is_json,
                              Console& console) const
{
    const SolverTrace trace = femoop::trace_solver(model, wanted);
    const femoop::SolverTraceRequest asked = request(trace, console.tr());
    if (out_) draw(model, trace, asked, console);
    console.print(is_json ? femoop::solver_trace_json(trace) : femoop::solver_trace_text(trace, asked, console.tr()));
}

void SolverTraceOptions::draw(const femoop::Model& model, const SolverTrace& trace,
                              const femoop::SolverTraceRequest& request, Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const PictureFile file = picture_file(*out_, size_.value_or("1280x800"), scale_.value_or("1"), tr);
    const Ordering ordering = request.ordering.value_or(usual_ordering(trace));
    const std::size_t n = trace.walk(ordering).fronts.size();
    const frame::SolverLook look{.theme = ui::Theme(theme_named(theme_.value_or("light"), tr)),
                                 .tr = tr,
                                 .ordering = ordering,
                                 .step = request.step.value_or(n / 2)};
    write_picture(
        file, {.color = look.theme.background(), .title = model.title},
        [&](ui::Painter& painter) { frame::draw_solver(painter, trace, look); }, tr);
    console.message(tr("written: {file}", {{"file", file.path.string()}}));
}

} // namespace cli
