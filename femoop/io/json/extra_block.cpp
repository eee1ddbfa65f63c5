#include "femoop/io/json/extra_block.h"

#include <algorithm>
#include <utility>

#include "femoop/model/fault/fault.h"

namespace femoop {

std::optional<JsonDocument> extra_block(const Model& model, std::string_view key)
{
    const auto block = std::ranges::find(model.extra, key, &ExtraBlock::key);
    if (block == model.extra.end()) return std::nullopt;
    JsonReading reading = parse_json(block->json);
    if (!reading.document) throw ModelError(std::move(reading.faults));
    return std::move(reading.document);
}

} // namespace femoop
