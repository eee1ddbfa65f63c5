#include "apps/cli/reference.h"

#include <utility>

#include "apps/cli/analysis_run.h"
#include "apps/cli/argument.h"
#include "apps/cli/model_input.h"
#include "femoop/io/results/difference_text.h"
#include "femoop/result/structure_words.h"

namespace cli {

namespace {

void require_same_kind(const femoop::Model& other, const std::string& file, const femoop::Model& present,
                       const ui::Catalogue& tr)
{
    if (other.analysis == present.analysis) return;
    throw UsageError(
        tr("{file}: found a {found}; wanted a {wanted}, the kind of what it is compared with",
           {{"file", file}, {"found", kind_text(other.analysis, tr)}, {"wanted", kind_text(present.analysis, tr)}}));
}

} // namespace

std::variant<drawing::ReferenceResults, ExitStatus> reference_of(const AskedReference& asked,
                                                                 const femoop::Model& present,
                                                                 const femoop::Results& results, const Console& console)
{
    const ui::Catalogue& tr = console.tr();
    const auto chosen = [&](const femoop::Model& model) {
        return asked.load_case ? std::optional(find_case(asked.case_option, model, *asked.load_case, tr))
                               : std::nullopt;
    };
    if (!asked.file) {
        const auto load_case = chosen(present);
        return drawing::ReferenceResults{
            .model = present, .results = results, .load_case = load_case, .name = asked.load_case.value_or("")};
    }
    const std::string file = display_name(*asked.file, tr);
    std::optional<femoop::Model> read = load_model(*asked.file, console);
    if (!read) return ExitStatus::BadInput;
    require_same_kind(*read, file, present, tr);
    femoop::Model other = femoop::comparable(*std::move(read), present.units);
    auto solved = solve_model(other, file, {}, console);
    if (const auto* status = std::get_if<ExitStatus>(&solved)) return *status;
    femoop::Results& found = std::get<Solved>(solved).results;
    console.report(file, found.warnings());
    const auto load_case = chosen(other);
    return drawing::ReferenceResults{.model = std::move(other),
                                     .results = std::move(found),
                                     .load_case = load_case,
                                     .name = asked.load_case ? file + ": " + *asked.load_case : file};
}

} // namespace cli
