#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/quantity.h"
#include "femoop/plane/model/field.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace plane {

/// A number that the user may change: a coordinate, a thickness, the value of a load.
struct Number {
    std::string id;    ///< known by it in scenarios: "x", "thickness", "qy"
    ui::Message label; ///< without its unit
    ui::Measure measure = ui::Measure::Plain;
    std::optional<femoop::Quantity> value; ///< absent where the file says nothing
    bool is_optional = false;              ///< it can be taken away
    /// Changes it; nothing takes it away. \returns why it cannot be so
    std::function<std::optional<ui::Message>(Document&, const std::optional<femoop::Quantity>&)> set;
    /// Where a field may stand: gives it. Empty elsewhere.
    std::function<void(Document&, const femoop::plane::Field&)> set_field{};
    std::optional<femoop::plane::Field> field{}; ///< in place of the value: one that varies otherwise
    bool differs = false;                        ///< of several parts, which have not the same
};

/// "polynomial, terms: 2": how a field varies, to be translated.
ui::Message form_of(const femoop::plane::Field& field);

/// All the numbers of a point or a curve, in the order in which a person would ask for them, with the settlements of a
/// support and the forces of a load case; of a combination without them. \pre the part is there
std::vector<Number> numbers(const PlaneModel& model, NodeId point, std::size_t load_case);
std::vector<Number> numbers(const PlaneModel& model, CurveId curve, std::size_t load_case);
std::vector<Number> numbers(const PlaneModel& model, RegionId region);
std::vector<Number> numbers(const PlaneModel& model, MaterialId material);
/// Of a load on a curve or a region, the first of which is 0.
std::vector<Number> numbers(const PlaneModel& model, std::size_t load_case, std::size_t nth, CurveId curve);
std::vector<Number> numbers(const PlaneModel& model, std::size_t load_case, std::size_t nth, RegionId region);

/// The numbers that several parts have all, to be changed in all of them at once.
std::vector<Number> numbers_of_all(const std::vector<std::vector<Number>>& of_parts);

} // namespace plane
