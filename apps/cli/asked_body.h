#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/cli/argument.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/step_format.h"
#include "femoop/methods/free_body/free_body.h"
#include "femoop/result/results.h"

namespace cli {

/// The free body that `solve --free-body WHAT --about X,Y` asks for.
class AskedBody {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);

    bool is_asked() const { return what_.has_value(); }
    /// The point without the body asks for nothing. \throws UsageError
    void require_sensible(const ui::Catalogue& tr) const;

    /// In words, as JSON, or for LaTeX. \throws UsageError, ModelError where what was typed is none of the model's
    std::string output(const femoop::Model& model, const femoop::Results& results, femoop::CaseId load_case,
                       StepFormat format, const ui::Catalogue& tr) const;
    /// What was typed without a unit, before the model is counted in another one.
    void count_lengths_in(std::string_view unit);

private:
    femoop::free_body::Body body(const femoop::Model& model, const ui::Catalogue& tr) const;
    Eigen::Vector3d about(const femoop::Model& model, const femoop::free_body::FreeBody& body,
                          const ui::Catalogue& tr) const;

    std::optional<std::string> what_, about_;
};

} // namespace cli
