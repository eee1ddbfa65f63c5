#include "apps/drawing/results/influence_words.h"

#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/results/moving_words.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/influence/line_shape.h"
#include "femoop/result/magnitudes.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace drawing {

namespace {

using femoop::influence::LineExtreme;

/// Says what stands on one picture.
class LineWords {
public:
    LineWords(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture)
        : model_(model),
          options_(options),
          picture_(picture),
          units_(display_units(model, options)),
          unit_(ordinate_unit(units_, picture))
    {}

    std::string title() const
    {
        std::string members;
        for (const auto& on : picture_.path.members) members += (members.empty() ? "" : ", ") + model_[on.member].id;
        return tr()("Influence line of {effect} under a unit load on {members}, s = 0 to {length}",
                    {{"effect", effect_text(model_, units_, picture_.line.effect)},
                     {"members", members},
                     {"length", length(picture_.path.length())}});
    }

    std::vector<std::string> line() const
    {
        const femoop::MovingEffect& effect = picture_.line.effect;
        const auto& ordinates = picture_.line.ordinates;
        if (const auto why = zero_by_support(model_, effect, tr())) return {why->substr(0, why->rfind('.'))};
        if (!(ordinates.largest() > 0.0)) return {tr()("zero everywhere")};
        const double rounding = written_as_zero * ordinates.largest();
        std::vector<std::string> lines;
        const LineExtreme max = ordinates.max(), min = ordinates.min();
        if (max.value > rounding) lines.push_back(extreme(tr()("max"), max));
        if (min.value < -rounding) lines.push_back(extreme(tr()("min"), min));
        lines.push_back(areas_text(units_, picture_, tr()));
        add_shape(lines);
        return lines;
    }

    std::vector<std::string> loads(const StandingTrain& standing) const
    {
        constexpr std::size_t most_told = 12;
        std::vector<std::string> lines;
        for (const auto& force : picture_.forces)
            lines.push_back(tr()("{force} at s = {place}, ordinate {ordinate}",
                                 {{"force", with_minus(units_.text(force.force, ui::Measure::Force))},
                                  {"place", length(force.s)},
                                  {"ordinate", ordinate_text(units_, unit_, force.ordinate)}}));
        if (lines.size() > most_told)
            lines = {lines.front(), tr()("{count} more between them", {{"count", std::to_string(lines.size() - 2)}}),
                     lines.back()};
        for (const femoop::influence::Stretch& on : standing.placing.uniform)
            lines.push_back(
                tr()("{load} on s = {from} to {to}",
                     {{"load", with_minus(units_.text(standing.train.uniform, ui::Measure::ForcePerLength))},
                      {"from", length(on.from)},
                      {"to", length(on.to)}}));
        return lines;
    }

private:
    const ui::Catalogue& tr() const { return options_.tr; }
    std::string length(double value) const { return with_minus(units_.text(value, ui::Measure::Length)); }

    std::string extreme(std::string_view which, const LineExtreme& extreme) const
    {
        return tr()(
            "{which} {value} at s = {place}",
            {{"which", which}, {"value", ordinate_text(units_, unit_, extreme.value)}, {"place", all_of(extreme)}});
    }

    /// Where it is zero, where it jumps and breaks, and what it is between.
    void add_shape(std::vector<std::string>& lines) const
    {
        const femoop::influence::LineShape shape = shape_of(picture_.line);
        std::vector<std::string> zeros;
        for (const double s : shape.zeros) zeros.push_back(length(s));
        if (!zeros.empty()) lines.push_back(tr()("zero at s = {places}", {{"places", some_of(zeros)}}));
        std::vector<std::string> jumps, kinks, stretches;
        for (const auto& jump : shape.jumps)
            jumps.push_back(tr()("{place} (from {before} to {after})",
                                 {{"place", length(jump.s)},
                                  {"before", ordinate_text(units_, unit_, without_noise(jump.before))},
                                  {"after", ordinate_text(units_, unit_, without_noise(jump.after))}}));
        if (!jumps.empty()) lines.push_back(tr()("jump at s = {places}", {{"places", some_of(jumps)}}));
        for (const double s : shape.kinks) kinks.push_back(length(s));
        if (!kinks.empty()) lines.push_back(tr()("kink at s = {places}", {{"places", some_of(kinks)}}));
        for (const auto& stretch : shape.stretches)
            stretches.push_back(
                tr()(degree_text(stretch), {{"from", length(stretch.from)}, {"to", length(stretch.to)}}));
        lines.push_back(some_of(stretches));
    }

    static std::string_view degree_text(const femoop::influence::LineShape::Stretch& stretch)
    {
        if (stretch.is_zero) return ui::translatable("zero on s = {from} to {to}");
        if (stretch.is_series) return ui::translatable("curved, no polynomial, on s = {from} to {to}");
        const bool has_pieces = stretch.n_pieces > 1;
        switch (stretch.degree) {
        case 0:
            return has_pieces ? ui::translatable("constant piece by piece on s = {from} to {to}")
                              : ui::translatable("constant on s = {from} to {to}");
        case 1:
            return has_pieces ? ui::translatable("straight piece by piece on s = {from} to {to}")
                              : ui::translatable("straight on s = {from} to {to}");
        case 2:
            return has_pieces ? ui::translatable("of degree 2 piece by piece on s = {from} to {to}")
                              : ui::translatable("of degree 2 on s = {from} to {to}");
        default:
            return has_pieces ? ui::translatable("of degree 3 piece by piece on s = {from} to {to}")
                              : ui::translatable("of degree 3 on s = {from} to {to}");
        }
    }

    /// "20 ft, 40 ft"; of many the first ones and the last.
    std::string some_of(const std::vector<std::string>& all) const
    {
        constexpr std::size_t most_told = 12;
        const std::size_t n = all.size() > most_told ? most_told - 2 : all.size();
        std::string text;
        for (std::size_t i = 0; i < n; ++i) text += (i > 0 ? ", " : "") + all[i];
        if (n == all.size()) return text;
        return text + ", " + tr()("{count} more between them", {{"count", std::to_string(all.size() - n - 1)}}) + ", " +
               all.back();
    }

    double without_noise(double value) const
    {
        return femoop::without_rounding(value, picture_.line.ordinates.largest());
    }

    // "20 ft, 40 ft"
    std::string all_of(const LineExtreme& extreme) const
    {
        std::string text;
        for (const std::string& place : places_text(options_, units_, extreme))
            text += (text.empty() ? "" : ", ") + place;
        return text;
    }

    const femoop::Model& model_;
    const DrawOptions& options_;
    const InfluencePicture& picture_;
    ui::DisplayUnits units_;
    OrdinateUnit unit_;
};

} // namespace

std::string influence_words(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture)
{
    const LineWords words(model, options, picture);
    return paragraph(words.title(), words.line());
}

std::string train_words(const femoop::Model& model, const DrawOptions& options, const InfluencePicture& picture,
                        const StandingTrain& standing, const femoop::influence::WorstPlacings& worst)
{
    std::vector<std::string> lines;
    for (const auto kind : {femoop::ExtremeKind::Max, femoop::ExtremeKind::Min}) {
        StandingTrain there = standing;
        there.placing = kind == femoop::ExtremeKind::Max ? worst.max : worst.min;
        there.kind = kind;
        there.is_worst = true;
        lines.push_back(train_sentence(model, options, picture, there));
    }
    std::string text = paragraph(options.tr("Train {name}", {{"name", standing.name}}), lines);
    std::vector<std::string> here = train_sentences(model, options, picture, standing);
    for (std::string& load : LineWords(model, options, picture).loads(standing)) here.push_back(std::move(load));
    return text + paragraph(options.tr("It stands on the line"), here);
}

} // namespace drawing
