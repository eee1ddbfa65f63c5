#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/plane/mesh/cut.h"
#include "ui/text/catalogue.h"

namespace cli {

/// Numbers with commas between them, as many as wanted. \throws UsageError
std::vector<double> numbers_of(const std::string& option, const std::string& text, std::size_t n,
                               const ui::Catalogue& tr);

/// The values of --at and of --cut: places in the material of a mesh, and cuts that meet it. \throws UsageError
std::vector<Eigen::Vector2d> places_in(const femoop::plane::Locator& locator, const std::vector<std::string>& texts,
                                       const ui::Catalogue& tr);
std::vector<femoop::plane::Cut> cuts_through(const femoop::plane::PlaneModel& mesh,
                                             const femoop::plane::Locator& locator,
                                             const std::vector<std::string>& texts, const ui::Catalogue& tr);

} // namespace cli
