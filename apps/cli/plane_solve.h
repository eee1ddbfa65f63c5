#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/phase_times.h"
#include "femoop/analysis/analysis_options.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/model/plane_model.h"

namespace cli {

class AskedUnits;
class PlaneInput;

/// What `cremona solve` does with a plane model, and the options that only such a model has.
class PlaneSolve {
public:
    struct Question {
        femoop::plane::PlaneReading& reading;
        std::string file;                     ///< as messages call it
        std::optional<std::string> case_name; ///< of --case; none, "all" or "envelope": all of them
        bool is_json = false;
        std::optional<std::string> traced_element{}; ///< of --trace
        const AskedUnits& units;                     ///< of --unit
        std::optional<std::string> csv_folder{};
        bool is_described = false, is_timed = false, is_refined = false;
        double seconds_to_read = 0.0;
    };

    void declare(OptionParser& options, const ui::Catalogue& tr);
    void require_none(const ui::Catalogue& tr) const; ///< \throws UsageError if an option is given: no plane model
    bool is_modal(const ui::Catalogue& tr) const;     ///< of --analysis. \throws UsageError
    ExitStatus solve(const Question& question, const femoop::AnalysisOptions& options, Console& console) const;

private:
    void require_one_output(const Question& question, const ui::Catalogue& tr) const;
    std::size_t n_cycles(const ui::Catalogue& tr) const; ///< of --cycles. \throws UsageError
    ExitStatus print_modes(const Question& question, const PlaneInput& input, const femoop::AnalysisOptions& options,
                           Console& console) const;
    femoop::plane::PlaneSelection selection(const Question& question, const PlaneInput& input,
                                            const ui::Catalogue& tr) const; ///< \throws UsageError
    static bool asks_for_envelope(const Question& question);
    std::string output(const Question& question, const PlaneInput& input, const femoop::plane::PlaneResults& results,
                       const femoop::plane::PlaneSelection& selection, const ui::Catalogue& tr) const;
    void print_trace(const Question& question, const femoop::plane::PlaneModel& model, Console& console) const;
    ExitStatus print_results(const Question& question, const PlaneInput& input, const femoop::AnalysisOptions& options,
                             PhaseTimes phases, Console& console) const;

    std::vector<std::string> places_, cuts_;
    std::optional<std::string> cycles_, analysis_, modes_;
    bool is_full_ = false;
};

} // namespace cli
