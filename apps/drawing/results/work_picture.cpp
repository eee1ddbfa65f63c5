#include "apps/drawing/results/work_picture.h"

#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/solved_case.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "femoop/model/dof.h"

#include <array>
#include <utility>

namespace drawing {

ui::Measure unit_load_measure(const WorkPicture& picture)
{
    const auto& dof = picture.work.displacement.dof;
    return dof && femoop::is_rotation(*dof) ? ui::Measure::Moment : ui::Measure::Force;
}

DrawOptions with_unit_load(DrawOptions options, femoop::AnalysisKind kind)
{
    const ShowSet before = options.show;
    Show diagram = is_truss(kind) ? Show::N : Show::M;
    for (const Show item : {Show::T, Show::V, Show::N, Show::M}) // the last that is shown is the first of them
        if (before.contains(item) && !components(item, kind).empty()) diagram = item;
    options.show = before & ShowSet{Show::Values, Show::NodeNames, Show::LocalAxes, Show::Legend};
    for (const Show item : {Show::Loads, Show::UnitLoad, diagram}) options.show.insert(item);
    options.is_envelope = false;
    return options;
}

std::vector<std::string> work_sentences(const WorkPicture& picture, const femoop::Model& model,
                                        const ui::DisplayUnits& units, const ui::Catalogue& tr)
{
    const femoop::MovingEffect& displacement = picture.work.displacement;
    const auto text = [&](double value) {
        const double told = femoop::virtual_work::without_round_off(value, picture.work.work);
        return ui::with_minus_signs(units.text(told, measure_of(displacement)));
    };
    std::vector<std::string> sentences{
        tr("1 · {displacement} = the sum of the work = {sum}; the analysis has {value}",
           {{"displacement", effect_text(model, units, displacement)},
            {"sum", text(picture.work.sum)},
            {"value", text(picture.work.value)}}),
        tr("F(x): under the loads, f(x): under the unit load; x from the member's first node; in {length}, {force}, rad.",
           {{"length", femoop::name(model.units.length)}, {"force", femoop::name(model.units.force)}})};
    if (std::string taper = femoop::virtual_work::taper_sentence(picture.work.work, tr); !taper.empty())
        sentences.push_back(std::move(taper));
    return sentences;
}

} // namespace drawing
