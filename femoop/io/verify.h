#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

enum class Verdict : std::uint8_t { Passed, Failed, Skipped };

/// Why a check was not made.
enum class SkipReason : std::uint8_t {
    AnalysisNotBuilt, ///< P-delta, buckling, modal and plastic analysis
};

/// What became of one expected result.
struct CheckOutcome {
    std::string what; ///< "case L: displacement uy of node B", in the reader's language
    Verdict verdict = Verdict::Skipped;
    double expected = 0.0;
    std::optional<double> result; ///< nothing when skipped
    double tolerance = 0.0;       ///< max(atol, rtol |expected|)
    double magnitude = 0.0;       ///< of the numbers that the result comes from: beside them rounding is 0
    std::optional<SkipReason> skipped;
};

/// A number compared: passed where it is within the tolerance.
CheckOutcome compared(std::string what, double expected, double found, double tolerance);

struct CheckCounts {
    int passed = 0, failed = 0, skipped = 0;

    CheckCounts& operator+=(const CheckCounts& other);
};
CheckCounts count(const std::vector<CheckOutcome>& outcomes);

/// True if a check of the model needs the linear analysis, so that `verify` wants its results.
bool needs_linear_analysis(const Model& model);

/// Compares every `expected` entry of the model with its results, in file order, then works the sheet of its `cross`
/// block (femoop/io/cross/cross_check.h), compares the lines of its `influence` block
/// (femoop/io/influence/influence_check.h) and runs the train of its `train` block (femoop/io/train/train_check.h). A
/// check passes when abs(result - value) <= max(atol, rtol abs(value)), with rtol 1e-6 and atol 0 where the file is
/// silent.
///
/// At a jump the + side is read unless the check says `"side": "-"`; at the member's end there is only the - side.
/// \throws ModelError, MechanismError where the sheet of a `cross` block cannot be worked
/// \pre `check(model)` finds no error; `results` are the model's own, or nothing if no check needs them
std::vector<CheckOutcome> verify(const Model& model, const std::optional<Results>& results,
                                 const Translator& tr = english);

} // namespace femoop
