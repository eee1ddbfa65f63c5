#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"
#include "femoop/analysis/analysis_options.h"
#include "femoop/io/plane/plane_file.h"

namespace cli {

class PlaneInput;

/// What `cremona solve` does with a plane model, and the options that only such a model has.
class PlaneSolve {
public:
    struct Question {
        femoop::plane::PlaneReading& reading;
        std::string file;      ///< as messages call it
        std::string case_name; ///< of --case
        bool is_json = false;
        std::optional<std::string> traced_element{}; ///< of --trace
    };

    void declare(OptionParser& options, const ui::Catalogue& tr);
    void require_none(const ui::Catalogue& tr) const; ///< \throws UsageError if an option is given: no plane model
    bool is_modal(const ui::Catalogue& tr) const;     ///< of --analysis. \throws UsageError
    ExitStatus solve(const Question& question, const femoop::AnalysisOptions& options, Console& console) const;

private:
    std::size_t n_cycles(const ui::Catalogue& tr) const; ///< of --cycles. \throws UsageError
    void require_modes_alone(const Question& question, const ui::Catalogue& tr) const;
    ExitStatus print_modes(const Question& question, const PlaneInput& input, const femoop::AnalysisOptions& options,
                           Console& console) const;

    std::vector<std::string> places_, cuts_;
    std::optional<std::string> cycles_, analysis_, modes_;
    bool is_full_ = false;
};

} // namespace cli
