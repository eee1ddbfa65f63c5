#pragma once

#include <optional>
#include <string>
#include <variant>

#include "apps/cli/console.h"
#include "apps/drawing/draw_input.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace cli {

/// What results are compared with: those of another file, or of the same one.
struct AskedReference {
    std::optional<std::string> file;      ///< absent: the same file
    std::optional<std::string> load_case; ///< absent: each case with its namesake
    std::string_view case_option;         ///< how the option is called that asks for the case
};

/// Solves the other file, its numbers counted in the units of the present model. What is wrong goes to stderr.
/// \throws UsageError where the two cannot be compared
std::variant<drawing::ReferenceResults, ExitStatus> reference_of(const AskedReference& asked,
                                                                 const femoop::Model& present,
                                                                 const femoop::Results& results,
                                                                 const Console& console);

} // namespace cli
