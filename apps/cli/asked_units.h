#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "apps/drawing/draw.h"
#include "femoop/io/influence/influence_json.h"
#include "femoop/io/results/result_units.h"
#include "femoop/model/model.h"
#include "femoop/plane/model/plane_model.h"
#include "ui/text/display_units.h"

namespace cli {

/// `--unit`: units of single quantities, in place of those that follow from the file's.
class AskedUnits {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);
    bool are_given() const { return !words_.empty(); }
    /// \throws UsageError for what is no quantity or no unit of it
    ui::UnitChoices choices(const ui::Catalogue& tr) const;
    femoop::ResultUnits of_results(const femoop::Model& model, const ui::Catalogue& tr) const;
    femoop::ResultUnits of_results(const femoop::plane::PlaneModel& model, const ui::Catalogue& tr) const;
    /// Per unit load, for the ordinates of an influence line.
    femoop::influence::LineUnits of_line(const femoop::Model& model, const femoop::InfluenceLineDefinition& line,
                                         const ui::Catalogue& tr) const;
    /// What is drawn, or told as it is drawn.
    drawing::DrawOptions of_pictures(drawing::DrawOptions options) const;
    /// For a calculation, which has one unit of length and one of force: the model counted in those from which all
    /// that were chosen follow, in its own where none was. \throws UsageError where there are none
    femoop::Model in_one_system(const femoop::Model& model, std::string_view option, const ui::Catalogue& tr) const;

private:
    std::vector<std::string> words_;
};

/// A length or a list of them as they were typed, bare numbers with a unit: "2.5" is "2.5 m", "50%" and "4 cm" stay.
/// Of words such as "cut=BC@2,beside=A" what stands behind the sign, "@" or "at=".
std::string with_unit(std::string_view words, std::string_view unit, std::string_view sign = {});

/// Of an output that always counts in the units of the file.
UsageError units_of_file(std::string_view option, const ui::Catalogue& tr);

/// "Units of the tables: m, kN, kN·cm", each once.
std::string units_line(const std::vector<femoop::PrintedUnit>& units, const ui::Catalogue& tr);

} // namespace cli
