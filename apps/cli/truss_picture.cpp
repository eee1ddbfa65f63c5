#include "apps/cli/truss_picture.h"

#include <variant>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/drawing/draw.h"
#include "apps/drawing/truss/truss_picture.h"
#include "femoop/io/truss/truss_sentence.h"

namespace cli {

namespace {

UsageError refused(const femoop::truss::Refusal& refusal, const femoop::Model& model, const ui::Catalogue& tr)
{
    return UsageError("--truss: " + sentence(refusal, model, tr));
}

} // namespace

void TrussPicture::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option("--truss", method_,
                    tr("draw a plane truss worked out by hand: zero-force (bars that carry nothing, with their rules), "
                       "joints (joint by joint, with the force polygon of each) or cremona (Bow's notation, and the "
                       "Cremona diagram beside it)"))
        .option_text("METHOD");
    options.add_flag("--cremona", is_cremona_, tr("the same as --truss cremona"));
    options.add_option("--stage", stage_, tr("draw the truss up to this stage, from 1 (default all)")).option_text("N");
}

void TrussPicture::require_sensible(const ui::Catalogue& tr) const
{
    if (stage_ && !is_asked()) throw needs_too("--stage", "--truss", tr);
    if (method_) method(tr);
}

drawing::TrussMethod TrussPicture::method(const ui::Catalogue& tr) const
{
    using drawing::TrussMethod;
    if (!method_ || *method_ == "cremona") return TrussMethod::Cremona;
    if (is_cremona_) throw contradiction("--cremona", "--truss " + *method_, tr);
    if (*method_ == "joints") return TrussMethod::Joints;
    if (*method_ == "zero-force") return TrussMethod::ZeroForces;
    throw not_one_of("--truss", *method_, "zero-force, joints, cremona", tr);
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
    if (const auto refusal = why_not(method(tr), truss)) throw refused(*refusal, model, tr);
    drawing::TrussPicture picture = drawing::truss_picture(method(tr), model, truss, tr);
    if (stage_) {
        const auto most = static_cast<long>(picture.stages.size());
        picture.n_stages = static_cast<std::size_t>(whole_number("--stage", *stage_, {1, most}, tr));
    }
    if (!shows_own)
        order.view.show = drawing::ShowSet{drawing::Show::Values, drawing::Show::NodeNames, drawing::Show::Legend};
    order.view.show.insert(drawing::Show::Truss);
    const drawing::DrawInput input{
        .model = model, .results = &results, .dimensions = order.dimensions, .truss = &picture};
    write_picture(
        order.file, backdrop_of(order, model), [&](ui::Painter& painter) { drawing::draw(painter, input, order.view); },
        tr);
    return ExitStatus::Done;
}

} // namespace cli
