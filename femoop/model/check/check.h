#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

/// Everything that is wrong with a model, errors and warnings, each naming the guilty parts and a remedy:
/// duplicate ids, references to nothing, values out of range, loads beyond a member's end, combinations that
/// name themselves, coincident nodes, unused parts, members that cross without a node, ...
std::vector<Fault> check(const Model& model);

/// How faults name a part that is in no list of the model: influence.lines[2], or without an index a word like --path.
struct PartName {
    std::string_view list;
    std::optional<std::size_t> index;
};

/// The same of a line that is not, or not yet, one of the model's: of its path, its unit load and the effect.
/// \pre the rest of the model has no error
std::vector<Fault> check_line(const Model& model, const InfluenceLineDefinition& line, const PartName& part);

/// Likewise of a train, and of an effect that a moving load is asked for.
std::vector<Fault> check_train(const Model& model, const Train& train, const PartName& part);
std::vector<Fault> check_effect(const Model& model, const MovingEffect& effect, const PartName& part);

/// \throws ModelError with every error of the model; warnings are no reason.
void require_sound(const Model& model);

} // namespace femoop
