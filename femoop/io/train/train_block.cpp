#include "femoop/io/train/train_block.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/model_reader.h"
#include "femoop/model/check/check.h"

namespace femoop::influence {

namespace {

void take_errors(std::vector<Fault>& faults, std::vector<Fault> found)
{
    std::erase_if(found, [](const Fault& fault) { return severity(fault.kind) != Severity::Error; });
    std::ranges::move(found, std::back_inserter(faults));
}

std::vector<Fault> faults_of(const Model& model, const TrainBlock& block)
{
    std::vector<Fault> faults;
    take_errors(faults, check_train(model, block.train, {"train", std::nullopt}));
    for (std::size_t i = 0; i < block.checks.size(); ++i)
        take_errors(faults, check_effect(model, block.checks[i].effect, {"train.expected", i}));
    return faults;
}

} // namespace

std::optional<TrainBlock> train_block_of(const Model& model)
{
    const auto extra = std::ranges::find(model.extra, "train", &ExtraBlock::key);
    if (extra == model.extra.end()) return std::nullopt;
    const JsonReading json = parse_json(extra->json);
    if (!json.document) throw std::invalid_argument("train block: not JSON");
    ModelReader reader(model);
    TrainBlock block = reader.train_block(json.document->root());
    std::vector<Fault> faults = reader.faults();
    if (faults.empty()) faults = faults_of(model, block);
    if (!faults.empty()) throw ModelError(std::move(faults));
    return block;
}

} // namespace femoop::influence
