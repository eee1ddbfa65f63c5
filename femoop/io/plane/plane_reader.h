#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/io/plane/field_reader.h"
#include "femoop/plane/check/plane_check.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// Reads a plane model in the order in which its parts refer to each other, as `ModelReader` does one of members: what
/// cannot be understood is noted and reading goes on. \pre the file is an object
class PlaneReader : private FieldReader {
public:
    PlaneReader(JsonValue file, std::vector<Fault> faults);

    PlaneModel model;
    std::vector<Fault> faults() { return reader_.collect_faults(); }
    const Unreadable& unreadable() const { return unreadable_; }

private:
    // plane_reader.cpp
    void read_header(JsonValue cremona, JsonValue analysis, JsonValue units);
    Material own_material(JsonValue value, const Place& place) { return material(value, place); }
    Combination own_combination(JsonValue value, const Place& place);
    PlanePoint point(JsonValue value, const Place& place);
    PlaneCurve curve(JsonValue value, const Place& place);
    PlaneCurve mesh_curve(JsonValue value, const Place& place);
    PlaneRegion region(JsonValue value, const Place& place);
    PlaneElement element(JsonValue value, const Place& place);
    MeshOptions mesh_options(JsonValue value, const Place& place);
    enum class Holder : std::uint8_t { Point, Curve };
    std::optional<PlaneSupport> support(JsonValue value, Holder holder, const Place& place);
    template <class Id> std::vector<Id> references(JsonValue value, NameTable& names, const Place& place);
    /// What a load or a settlement is of: one, or a list of some, each once.
    template <class Id> std::vector<Id> loaded(JsonValue value, NameTable& names, const Place& place);

    void repeated_reference(const Place& place);
    void empty_list(const Place& place);

    // drawing_reader.cpp
    PlaneCurve drawn_curve(JsonValue value, const Place& place);
    void read_shape(PlaneCurve& curve, JsonValue value, const Place& place);
    std::vector<DrawnPlace> drawn_places(JsonValue value, const Place& place);
    DrawnPlace drawn_place(JsonValue value, const Place& here);
    void read_axes(DrawnShape& shape, JsonValue value, const Place& place);
    void read_divide(DrawnShape& shape, JsonValue value, const Place& place);
    std::optional<Division> division(JsonValue value, const Place& here);
    PlaneRegion drawn_region(JsonValue value, const Place& place);
    void read_places_of_region(PlaneRegion& region, JsonValue value, const Place& place);

    // plane_load_reader.cpp
    PlaneLoadCase load_case(JsonValue value, const Place& place);
    NodeLoad point_load(JsonValue value, const Place& place);
    CurveLoad curve_load(JsonValue value, const Place& place);
    RegionLoad region_load(JsonValue value, const Place& place);
    Quantity rotation_speed(JsonValue value, const Place& place);
    PlaneSettlement settlement(JsonValue value, const Place& place);

    // plane_expected_reader.cpp
    PlaneExpected expected(JsonValue value, const Place& place);
    void read_component(PlaneExpected& check, JsonValue component, const Place& place);
    void read_which(PlaneExpected& check, JsonValue which, const Place& place);
    std::vector<Quantity> cut(JsonValue value, const Place& place);

    Unreadable unreadable_;
    NameTable points_{FaultKind::NoSuchPoint, FaultKind::NoSuchPointNear};
    NameTable curves_{FaultKind::NoSuchCurve, FaultKind::NoSuchCurveNear};
    NameTable regions_{FaultKind::NoSuchRegion, FaultKind::NoSuchRegionNear};
};

template <class Id> std::vector<Id> PlaneReader::references(JsonValue value, NameTable& names, const Place& place)
{
    std::vector<Id> found;
    if (!value.is_present()) return found;
    if (!value.is(JsonKind::Array)) return {Id(reference(value, names, place))};
    const Place here = place.key(value.key());
    for (std::size_t i = 0; const JsonValue entry : value)
        found.push_back(Id(reference(entry, names, here.entry(i++))));
    return found;
}

template <class Id> std::vector<Id> PlaneReader::loaded(JsonValue value, NameTable& names, const Place& place)
{
    const std::vector<Id> found = references<Id>(value, names, place);
    if (!value.is(JsonKind::Array)) return found;
    const Place here = place.key(value.key());
    if (found.empty()) empty_list(here);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto known = found.begin() + static_cast<std::ptrdiff_t>(i);
        if (found[i] != Id(nowhere) && std::find(found.begin(), known, found[i]) != known)
            repeated_reference(here.entry(i));
    }
    return found;
}

} // namespace femoop::plane
