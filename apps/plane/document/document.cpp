#include "apps/plane/document/document.h"

#include <algorithm>

namespace plane {

Document new_document()
{
    Document document;
    document.model.is_drawn = true;
    document.model.units = {femoop::LengthUnit::mm, femoop::ForceUnit::N};
    return document;
}

double usual_width(const PlaneModel& model)
{
    constexpr double of_a_part = 0.25, of_a_wall = 25.0; // [m], where a file counts in mm or cm, and where in m
    const double metres = femoop::metres(model.units.length);
    return metres < 0.02 ? of_a_part / metres : of_a_wall;
}

std::size_t memory_footprint(const Document& document)
{
    const PlaneModel& model = document.model;
    std::size_t bytes = sizeof(Document) + model.points.size() * sizeof(model.points[0]) +
                        model.elements.size() * (sizeof(model.elements[0]) + 32);
    for (const auto& curve : model.curves)
        bytes += sizeof curve + (curve.shape ? curve.shape->places.size() * sizeof(curve.shape->places[0]) : 0);
    for (const auto& region : model.regions) bytes += sizeof region + region.at.size() * sizeof(region.at[0]);
    for (const auto& load_case : model.load_cases)
        bytes += sizeof load_case + load_case.curves.size() * sizeof(femoop::plane::CurveLoad) +
                 load_case.points.size() * sizeof(femoop::NodeLoad);
    if (document.cycle) bytes += document.cycle->memory();
    return bytes;
}

std::string fresh_point_id(const PlaneModel& model)
{
    for (std::size_t round = 0;; ++round)
        for (char letter = 'A'; letter <= 'Z'; ++letter) {
            const std::string name = letter + (round > 0 ? std::to_string(round) : std::string());
            if (std::ranges::find(model.points, name, &femoop::plane::PlanePoint::id) == model.points.end())
                return name;
        }
}

} // namespace plane
