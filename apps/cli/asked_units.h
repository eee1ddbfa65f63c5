#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "femoop/io/results/result_units.h"
#include "femoop/model/model.h"
#include "ui/text/display_units.h"

namespace cli {

/// `--unit`: units of single quantities, in place of those that follow from the file's.
class AskedUnits {
public:
    void declare(CLI::App& app, const ui::Catalogue& tr);
    bool are_given() const { return !words_.empty(); }
    /// \throws UsageError for what is no quantity or no unit of it
    ui::UnitChoices choices(const ui::Catalogue& tr) const;
    femoop::ResultUnits of_results(const femoop::Model& model, const ui::Catalogue& tr) const;

private:
    std::vector<std::string> words_;
};

/// Of an output that always counts in the units of the file.
UsageError units_of_file(std::string_view option, const ui::Catalogue& tr);

} // namespace cli
