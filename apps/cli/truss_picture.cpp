#include "apps/cli/truss_picture.h"

#include <CLI/CLI.hpp>
#include <variant>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/drawing/draw.h"
#include "apps/drawing/truss/cremona_picture.h"
#include "femoop/io/truss/truss_sentence.h"

namespace cli {

namespace {

UsageError refused(const femoop::truss::Refusal& refusal, const femoop::Model& model, const ui::Catalogue& tr)
{
    return UsageError("--cremona: " + sentence(refusal, model, tr));
}

} // namespace

void TrussPicture::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_flag("--cremona", is_asked_,
                 tr("draw a truss with Bow's notation, and beside it its Cremona diagram: tension as full lines, "
                    "compression as dashes"));
    app.add_option("--stage", stage_, tr("draw the Cremona diagram up to this stage, from 1 (default all)"))
        ->option_text("N");
}

void TrussPicture::require_sensible(const ui::Catalogue& tr) const
{
    if (stage_ && !is_asked_) throw needs_too("--stage", "--cremona", tr);
}

ExitStatus TrussPicture::draw(const femoop::Model& model, const std::string& file, PictureOrder order, bool shows_own,
                              const Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    const auto solved = solve_model(model, file, {}, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    const femoop::Results& results = std::get<Solved>(solved).results;
    if (const auto refusal = femoop::truss::why_no_truss(model, results)) throw refused(*refusal, model, tr);
    const femoop::truss::Truss truss = femoop::truss::truss_of(model, results, order.view.load_case);
    if (const auto refusal = why_no_reciprocal(truss)) throw refused(*refusal, model, tr);
    drawing::CremonaPicture picture = drawing::cremona_picture(model, truss, tr);
    if (stage_) {
        const auto most = static_cast<long>(picture.diagram.steps.size());
        picture.n_stages = static_cast<std::size_t>(whole_number("--stage", *stage_, {1, most}, tr));
    }
    if (!shows_own)
        order.view.show = drawing::ShowSet{drawing::Show::Values, drawing::Show::NodeNames, drawing::Show::Legend};
    order.view.show.insert(drawing::Show::Cremona);
    const drawing::DrawInput input{
        .model = model, .results = &results, .dimensions = order.dimensions, .cremona = &picture};
    write_picture(
        order.file, backdrop_of(order, model), [&](ui::Painter& painter) { drawing::draw(painter, input, order.view); },
        tr);
    return ExitStatus::Done;
}

} // namespace cli
