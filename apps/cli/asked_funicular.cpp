#include "apps/cli/asked_funicular.h"

#include <array>
#include <variant>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/asked_effect.h"
#include "apps/cli/asked_units.h"
#include "femoop/io/funicular/funicular_text.h"
#include "femoop/io/json/model_json.h"

namespace cli {

using femoop::Model;
using namespace femoop::funicular;

void AskedFunicular::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            "--funicular", what_,
            tr("print the funicular of the vertical loads on a chain of members that runs from left to right, an arch "
               "or a beam, instead of the results: members=M,.., or automatic for the only chain of the structure; of "
               "the first load case, or that of --case"))
        .option_text("WHAT");
    options
        .add_option("--closing", closing_,
                    tr("with --funicular: heights of its closing line at the left end and at the right one (default: "
                       "those of the chain)"))
        .option_text("YA,YB");
    options
        .add_option("--through", through_,
                    tr("with --funicular: a point that it passes through (default: the hinge of the chain, else where "
                       "the chain is farthest from the line between its ends)"))
        .option_text("X,Y");
}

void AskedFunicular::require_sensible(const ui::Catalogue& tr) const
{
    if (closing_ && !what_) throw needs_too("--closing", "--funicular", tr);
    if (through_ && !what_) throw needs_too("--through", "--funicular", tr);
}

void AskedFunicular::count_lengths_in(std::string_view unit)
{
    for (auto* const words : {&closing_, &through_})
        if (*words) *words = with_unit(**words, unit);
}

LoadedChain AskedFunicular::loaded_chain(const Model& model, femoop::CaseId load_case, const ui::Catalogue& tr) const
{
    std::vector<std::string> names;
    const std::array<KeyedList, 1> keys{{{"members=", &names}}};
    const bool is_understood = *what_ == "automatic" || (read_keyed_lists(*what_, keys) && !names.empty());
    if (!is_understood)
        throw UsageError(tr("--funicular: \"{found}\" names no chain; write it like \"members=AB,BC\", or "
                            "\"automatic\"",
                            {{"found", femoop::printable(*what_)}}));
    const auto found = femoop::funicular::loaded_chain(model, members_named("--funicular", names, model, tr),
                                                       load_case);
    if (const auto* refusal = std::get_if<Refusal>(&found))
        throw UsageError("--funicular: " + sentence(*refusal, model, tr));
    return std::get<LoadedChain>(found);
}

Funicular AskedFunicular::funicular(const LoadedChain& loaded, const Model& model, const ui::Catalogue& tr) const
{
    const auto& [chain, span] = loaded;
    ClosingLine line{chain.left().y(), chain.right().y()};
    if (closing_) {
        const std::vector<double> heights = lengths_named("--closing", *closing_, 2, model, tr);
        require_near("--closing", *closing_, heights, model, tr);
        line = {heights[0], heights[1]};
    }
    if (!through_) return {span, line, usual_thrust(chain, span)};
    const std::vector<double> point = lengths_named("--through", *through_, 2, model, tr);
    require_near("--through", *through_, point, model, tr);
    if (const auto H = thrust_through(span, line, {point[0], point[1]})) return {span, line, *H, point[0]};
    throw UsageError(tr("--through: no funicular passes through {found}: M0 is 0 there, or the closing line passes "
                        "through it; choose a point between the ends and off that line",
                        {{"found", femoop::printable(*through_)}}));
}

std::string AskedFunicular::output(const Model& model, femoop::CaseId load_case, StepFormat format,
                                   const ui::Catalogue& tr) const
{
    const LoadedChain loaded = loaded_chain(model, load_case, tr);
    const Funicular found = funicular(loaded, model, tr);
    if (format == StepFormat::Text) return funicular_text(found, loaded.chain, model, tr);
    if (format == StepFormat::Latex) return funicular_latex(found, loaded.chain, model, tr);
    femoop::JsonWriter json;
    begin_output(json, model.units);
    json.key("funicular").begin_object(femoop::JsonWriter::Layout::Block).member("case", model.case_name(load_case));
    write_funicular(json, found, loaded.chain, model);
    json.end().end();
    return json.take();
}

} // namespace cli
