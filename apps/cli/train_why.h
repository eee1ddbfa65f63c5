#pragma once

#include <string>

#include "apps/cli/console.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/model/model.h"

namespace cli {

/// A number of a train, or of an envelope of trains, that is asked where it comes from.
struct TrainNumber {
    const femoop::Train* train = nullptr;             ///< else:
    const femoop::MovingEnvelope* envelope = nullptr; ///< of which the train that governs is followed
    femoop::MovingEffect effect;                      ///< without a place the worst section of its member
};

/// The way to it: which train governs and where it stands, the sum of its forces times the ordinates of the influence
/// line, what stays beside it, and how an analysis of the structure under that train comes to the same.
/// \throws ModelError, MechanismError as the analyses
std::string train_why(const femoop::Model& model, const TrainNumber& number, bool is_json, const Console& console);

} // namespace cli
