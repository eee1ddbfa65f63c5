#include "femoop/io/influence/influence_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "femoop/io/influence/influence_block.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::influence {

namespace {

constexpr double place_tolerance = 1e-5; // of the path's length

/// The checks of one line, one after the other.
class LineComparison {
public:
    LineComparison(const LineCheck& check, const InfluenceLine& line, std::string name, const Translator& tr)
        : check_(check), line_(line.ordinates), name_(std::move(name)), tr_(tr), size_(line_.largest())
    {}

    std::vector<CheckOutcome> outcomes()
    {
        for (std::size_t i = 0; i < check_.values.size(); ++i) {
            const PathPosition& at = check_.positions[i];
            const double found = line_.value(at.s, at.side.value_or(Side::After));
            add_value(fill(tr_(translatable("{0} at s = {1}")), {name_, at.text}), check_.values[i], found);
        }
        if (check_.max) compare(*check_.max, line_.max(), "max");
        if (check_.min) compare(*check_.min, line_.min(), "min");
        return std::move(outcomes_);
    }

private:
    void add(std::string what, double expected, double found, double tolerance, double size)
    {
        outcomes_.push_back(compared(std::move(what), expected, found, tolerance));
        outcomes_.back().magnitude = size;
    }

    void add_value(std::string what, double expected, double found)
    {
        add(std::move(what), expected, found, std::max(check_.atol, check_.rtol * std::abs(expected)), size_);
    }

    void compare(const ExtremeCheck& wanted, const LineExtreme& found, const std::string& which)
    {
        const std::string what = name_ + " " + which;
        if (wanted.value) add_value(what, *wanted.value, found.value);
        if (wanted.positions) compare_places(*wanted.positions, found, what);
    }

    /// Where it is on a stretch that keeps the value, the place itself; else the nearest of its places.
    static double nearest(const LineExtreme& found, double s)
    {
        double best = found.positions.front();
        for (std::size_t i = 0; i < found.positions.size(); ++i) {
            const double end = found.is_level_after[i] ? found.positions[i + 1] : found.positions[i];
            const double here = std::clamp(s, found.positions[i], end);
            if (std::abs(here - s) < std::abs(best - s)) best = here;
        }
        return best;
    }

    // Of a stretch one listed place is enough.
    void compare_places(const std::vector<double>& wanted, const LineExtreme& found, const std::string& what)
    {
        const double tolerance = place_tolerance * line_.length();
        for (const double s : wanted)
            add(fill(tr_(translatable("{0}, place")), {what}), s, nearest(found, s), tolerance, line_.length());
        for (std::size_t i = 0; i < found.positions.size(); ++i) {
            const bool is_end = i > 0 && found.is_level_after[i - 1];
            const double from = found.positions[i];
            const double to = found.is_level_after[i] ? found.positions[i + 1] : from;
            const auto is_here = [&](double s) { return s >= from - tolerance && s <= to + tolerance; };
            if (is_end || std::ranges::any_of(wanted, is_here)) continue;
            const double listed = wanted.empty() ? -line_.length()
                                                 : *std::ranges::min_element(
                                                       wanted, {}, [&](double s) { return std::abs(s - from); });
            add(fill(tr_(translatable("{0}, place that is not listed")), {what}), listed, from, tolerance,
                line_.length());
        }
    }

    const LineCheck& check_;
    const PiecewiseLine& line_;
    std::string name_;
    const Translator& tr_;
    double size_;
    std::vector<CheckOutcome> outcomes_;
};

} // namespace

std::vector<CheckOutcome> check_block(const Model& model, const Translator& tr)
{
    const std::optional<Block> block = block_of(model);
    if (!block) return {};
    std::vector<InfluenceLineDefinition> definitions;
    for (const LineCheck& check : block->lines) definitions.push_back(check.line);
    const InfluenceLines found = influence_lines(model, definitions);
    std::vector<CheckOutcome> outcomes;
    for (std::size_t i = 0; i < block->lines.size(); ++i) {
        const std::string name = fill(tr("line {0}: {1}"),
                                      {definitions[i].id, effect_name(model, definitions[i].effect, tr)});
        LineComparison comparison(block->lines[i], found.lines[i], name, tr);
        for (CheckOutcome& outcome : comparison.outcomes()) outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

} // namespace femoop::influence
