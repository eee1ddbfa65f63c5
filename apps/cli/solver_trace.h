#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "femoop/analysis/solver_trace.h"
#include "femoop/io/results/solver_trace_text.h"
#include "femoop/model/model.h"

namespace cli {

/// The options of `cremona solve` that show the solver at work, and what they print.
class SolverTraceOptions {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);

    bool are_given() const { return is_traced_; }
    /// \throws UsageError if the others are given without --trace-solver
    void require_trace(const ui::Catalogue& tr) const;

    /// Prints the trace in words, or as JSON, and draws it where a picture is wanted. \throws UsageError for an order
    /// or a step that there is not, and a picture that cannot be written
    void show(const femoop::Model& model, femoop::SolverKind wanted, bool is_json, Console& console) const;

private:
    femoop::SolverTraceRequest request(const femoop::SolverTrace& trace, const ui::Catalogue& tr) const;
    void draw(const femoop::Model& model, const femoop::SolverTrace& trace, const femoop::SolverTraceRequest& request,
              Console& console) const;

    bool is_traced_ = false;
    std::optional<std::string> ordering_, step_, out_, size_, scale_, theme_;
};

} // namespace cli
