#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/step_format.h"
#include "femoop/result/results.h"

namespace cli {

/// The force method with the redundants that `solve --force-method WHAT` asks for, once for each, or `automatic`.
class AskedRedundants {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);

    bool are_asked() const { return !what_.empty(); }

    /// \throws UsageError, ModelError where what was typed is none of the model's or cannot be
    /// released, MechanismError where the structure can move without
    std::string output(const femoop::Model& model, const femoop::Results& results, femoop::CaseId load_case,
                       StepFormat format, const ui::Catalogue& tr) const;
    /// What was typed without a unit, before the model is counted in another one.
    void count_lengths_in(std::string_view unit);

private:
    std::vector<femoop::MovingEffect> redundants(const femoop::Model& model, const ui::Catalogue& tr) const;

    std::vector<std::string> what_;
};

} // namespace cli
