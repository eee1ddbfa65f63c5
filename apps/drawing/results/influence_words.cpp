#include "apps/drawing/results/influence_words.h"

#include "apps/drawing/results/line_diagram.h"
#include "apps/drawing/sketch/scene.h"

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
            {{"which", which}, {"value", ordinate_text(units_, unit_, extreme.value)}, {"place", places(extreme)}});
    }

    // "20 ft, 40 ft"; of a level stretch "20 ft to 40 ft".
    std::string places(const LineExtreme& extreme) const
    {
        std::string text;
        for (std::size_t i = 0; i < extreme.positions.size(); ++i) {
            if (i > 0) text += extreme.is_level_after[i - 1] ? " " + tr()("to") + " " : ", ";
            text += length(extreme.positions[i]);
        }
        return text;
    }

    const femoop::Model& model_;
    const DrawOptions& options_;
    const InfluencePicture& picture_;
    ui::DisplayUnits units_;
    OrdinateUnit unit_;
};

std::string paragraph(const std::string& title, const std::vector<std::string>& lines)
{
    std::string text = title + ".\n";
    for (const std::string& line : lines) text += "  " + line + ".\n";
    return text;
}

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
