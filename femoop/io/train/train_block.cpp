#include "femoop/io/train/train_block.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "femoop/io/json/extra_block.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/reader/model_reader.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"

namespace femoop::influence {

namespace {

std::vector<Fault> faults_of(const Model& model, const TrainBlock& block)
{
    std::vector<Fault> faults = check_train(model, block.train, {"train", std::nullopt});
    for (std::size_t i = 0; i < block.checks.size(); ++i)
        std::ranges::move(check_effect(model, block.checks[i].effect, {"train.expected", i}),
                          std::back_inserter(faults));
    return errors_among(std::move(faults));
}

} // namespace

std::optional<TrainBlock> train_block_of(const Model& model)
{
    const std::optional<JsonDocument> json = extra_block(model, "train");
    if (!json) return std::nullopt;
    ModelReader reader(model);
    TrainBlock block = reader.train_block(json->root());
    std::vector<Fault> faults = reader.faults();
    if (faults.empty()) faults = faults_of(model, block);
    if (!faults.empty()) throw ModelError(std::move(faults));
    return block;
}

} // namespace femoop::influence
