#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/step_format.h"
#include "femoop/methods/funicular/loaded_chain.h"

namespace cli {

/// The funicular that `solve --funicular WHAT --closing YA,YB --through X,Y` asks for.
class AskedFunicular {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);

    bool is_asked() const { return what_.has_value(); }
    /// A closing line or a point without the funicular asks for nothing. \throws UsageError
    void require_sensible(const ui::Catalogue& tr) const;

    /// In words, as JSON, or for LaTeX. \throws UsageError where what was typed is none of the model's, or has no funicular
    std::string output(const femoop::Model& model, femoop::CaseId load_case, StepFormat format,
                       const ui::Catalogue& tr) const;
    /// What was typed without a unit, before the model is counted in another one.
    void count_lengths_in(std::string_view unit);

private:
    femoop::funicular::LoadedChain loaded_chain(const femoop::Model& model, femoop::CaseId load_case,
                                                const ui::Catalogue& tr) const;
    femoop::funicular::Funicular funicular(const femoop::funicular::LoadedChain& loaded, const femoop::Model& model,
                                           const ui::Catalogue& tr) const;

    std::optional<std::string> what_, closing_, through_;
};

} // namespace cli
