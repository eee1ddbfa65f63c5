#include "apps/frame/truss/asked_truss.h"

#include <algorithm>

#include "apps/drawing/sketch/counted_units.h"
#include "femoop/io/truss/truss_sentence.h"

namespace frame {

void AskedTruss::show(Method method)
{
    method_ = method;
    stage_.reset();
    if (method != Method::Cremona) stage_ = 1;
}

void AskedTruss::step(Way way)
{
    const std::size_t n = n_stages();
    if (n == 0) return;
    if (!stage_ && way == Way::On) {
        stage_ = 1;
        return;
    }
    const std::size_t now = std::min(stage_.value_or(n), n);
    if (way == Way::On) stage_ = std::min(now + 1, n);
    else stage_ = std::max<std::size_t>(now, 2) - 1;
}

const drawing::TrussPicture* AskedTruss::picture(const femoop::Model& model, const femoop::Results* results,
                                                 std::uint64_t generation, const drawing::DrawOptions& options) const
{
    if (!method_ || results == nullptr) {
        found_ = {};
        return nullptr;
    }
    const femoop::Units units = drawing::counted_units(model, options).units;
    const bool is_here = found_.generation == generation && found_.method == method_ &&
                         found_.load_case == options.load_case && found_.language == options.tr.language() &&
                         found_.units == units;
    if (!is_here) {
        found_ = {.generation = generation,
                  .method = method_,
                  .load_case = options.load_case,
                  .language = options.tr.language(),
                  .units = units};
        find(model, *results, options);
    }
    if (!found_.picture) return nullptr;
    found_.picture->n_stages = std::clamp<std::size_t>(stage_.value_or(n_stages()), 1, n_stages());
    return &*found_.picture;
}

void AskedTruss::find(const femoop::Model& model, const femoop::Results& results,
                      const drawing::DrawOptions& options) const
{
    if (const auto refusal = femoop::truss::why_no_truss(model, results)) {
        found_.why_none = sentence(*refusal, model, options.tr);
        return;
    }
    const femoop::truss::Truss truss = femoop::truss::truss_of(model, results, options.load_case);
    if (const auto refusal = why_not(*method_, truss)) found_.why_none = sentence(*refusal, model, options.tr);
    else found_.picture = drawing::truss_picture(*method_, model, truss, options.tr);
    const drawing::CountedUnits units = drawing::counted_units(model, options);
    if (!found_.picture || units.units == model.units) return;
    const drawing::TrussPicture counted = drawing::truss_picture(*method_, counted_in(units, model),
                                                                 scaled(truss, units.length, units.force), options.tr);
    const std::size_t n_stages = std::min(counted.stages.size(), found_.picture->stages.size());
    for (std::size_t i = 0; i < n_stages; ++i) found_.picture->stages[i].lines = counted.stages[i].lines;
    found_.picture->bar_sentences = counted.bar_sentences;
}

} // namespace frame
