#include "femoop/io/influence/influence_block.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "femoop/io/json/extra_block.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/model_reader.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop::influence {

namespace {

constexpr double beyond_end = 1e-9; // of the path's length: so far beyond an end is the end

std::string place_of(std::size_t i) { return "influence.lines[" + std::to_string(i) + "]"; }

void check_positions(const Model& model, const LineCheck& check, const std::string& place, std::vector<Fault>& faults)
{
    const double length = lay_out(model, members_of(model, check.line.path)).length();
    for (const PathPosition& position : check.positions)
        if (position.s < -beyond_end * length || position.s > (1.0 + beyond_end) * length)
            faults.push_back({FaultKind::PositionOffPath,
                              {place, quantity_text(position.s, dimension::length, model.units),
                               quantity_text(length, dimension::length, model.units)}});
    if (!check.values.empty() && check.values.size() != check.positions.size())
        faults.push_back({FaultKind::WrongValueCount,
                          {place, std::to_string(check.values.size()), std::to_string(check.positions.size())}});
}

std::vector<Fault> faults_of(const Model& model, const Block& block)
{
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < block.lines.size(); ++i) {
        std::vector<Fault> found = errors_among(check_line(model, block.lines[i].line, {"influence.lines", i}));
        if (found.empty()) check_positions(model, block.lines[i], place_of(i), faults);
        std::ranges::move(found, std::back_inserter(faults));
    }
    return faults;
}

} // namespace

std::optional<Block> block_of(const Model& model)
{
    const std::optional<JsonDocument> json = extra_block(model, "influence");
    if (!json) return std::nullopt;
    ModelReader reader(model);
    Block block = reader.influence_block(json->root());
    std::vector<Fault> faults = reader.faults();
    if (faults.empty()) faults = faults_of(model, block);
    if (!faults.empty()) throw ModelError(std::move(faults));
    return block;
}

} // namespace femoop::influence
