#include "apps/plane/document/fault_words.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "apps/plane/discretize/fault_place.h"

namespace plane {

using discretize::entry_of;
using discretize::EntryPlace;
using femoop::Fault;
using femoop::FaultKind;

namespace {

/// A list of the file, and what the app calls an entry of it.
struct ListWord {
    std::string_view list, word;
};
constexpr std::array list_words{
    ListWord{"points", ui::translatable("Point {id}")},
    ListWord{"curves", ui::translatable("Curve {id}")},
    ListWord{"regions", ui::translatable("Region {id}")},
    ListWord{"materials", ui::translatable("Material {id}")},
    ListWord{"load_cases", ui::translatable("Load case {id}")},
};

std::optional<EntryPlace> entry_of_fault(const Fault& fault)
{
    return fault.arguments.empty() ? std::nullopt : entry_of(fault.arguments.front());
}

std::string name_of(const PlaneModel& model, const EntryPlace& entry)
{
    const auto name = [&](const auto& list) {
        return entry.index < list.size() ? list[entry.index].id : std::string();
    };
    if (entry.list == "points") return name(model.points);
    if (entry.list == "curves") return name(model.curves);
    if (entry.list == "regions") return name(model.regions);
    if (entry.list == "materials") return name(model.materials);
    return entry.list == "load_cases" ? name(model.load_cases) : std::string();
}

std::string spoken(const std::string& place, const PlaneModel& model, const ui::Catalogue& tr)
{
    const auto entry = entry_of(place);
    if (!entry) return place;
    for (const auto& [list, word] : list_words)
        if (const std::string name = name_of(model, *entry); list == entry->list && !name.empty())
            return tr(word, {{"id", name}});
    return place;
}

/// Whether an argument of a fault says a place in the file.
bool is_place(FaultKind kind, std::size_t argument)
{
    return argument == 0 || (kind == FaultKind::RegionPlaceTaken && argument == 2);
}

/// What is to be done in the window, where a reader of the file is told of its keys: {0} and so on are the arguments.
std::string_view own_words(FaultKind kind)
{
    switch (kind) {
    case FaultKind::NothingToMesh:
        return ui::translatable("no face of the drawing has material, so no mesh can be made; "
                                "close an outline, and click its face");
    case FaultKind::RegionWithoutThickness:
        return ui::translatable("{0}: has no thickness, which a plane stress needs; select a face of it and type one");
    case FaultKind::RegionWithoutDensity:
        return ui::translatable("{0}: needs the density of material {1}; select a face of region {2} and type it");
    case FaultKind::RegionWithoutExpansion:
        return ui::translatable(
            "{0}: needs the thermal expansion of material {1}; select a face of region {2} and type it");
    case FaultKind::LoadOnTwoThicknesses:
        return ui::translatable(
            "{0}: curve {1} parts regions of unlike thickness; its traction acts on that of region {2}, "
            "not of {3}; a force per length needs none");
    case FaultKind::MeshTooLarge:
        return ui::translatable("the mesh would have about {0} elements, {1} at most can be made; "
                                "type a larger element size or fewer divisions");
    default: return "";
    }
}

/// The empty face whose place the fault names, rounded.
std::optional<Part> empty_face(const Fault& fault, const discretize::Drawing& drawing)
{
    double x = 0.0, y = 0.0;
    const std::string& place = fault.arguments.front();
    if (std::sscanf(place.c_str(), "(%lf, %lf)", &x, &y) != 2) return std::nullopt;
    for (const auto& face : drawing.faces()) {
        const double error = 1e-5 * (std::abs(x) + std::abs(y)) + drawing.subdivision().snap();
        if (topology::distance(face.inside, {x, y}) <= error) return FacePlace{face.inside};
    }
    return std::nullopt;
}

std::optional<Part> face_of(RegionId region, const discretize::Drawing& drawing)
{
    for (const auto& face : drawing.faces())
        if (face.region == region) return FacePlace{face.inside};
    return std::nullopt;
}

} // namespace

std::string sentence(const Fault& fault, const PlaneModel& model, const ui::Catalogue& tr)
{
    Fault told = fault;
    for (std::size_t i = 0; i < told.arguments.size(); ++i)
        if (is_place(fault.kind, i)) told.arguments[i] = spoken(told.arguments[i], model, tr);
    const std::string_view pattern = femoop::pattern(fault.kind), own = own_words(fault.kind);
    return femoop::message(
        told, [&](std::string_view english) { return tr(english == pattern && !own.empty() ? own : english); });
}

std::optional<Part> part_of(const Fault& fault, const PlaneModel& model, const discretize::Drawing* drawing)
{
    if (fault.kind == FaultKind::FaceWithoutRegion && drawing != nullptr) return empty_face(fault, *drawing);
    const auto entry = entry_of_fault(fault);
    if (!entry) return std::nullopt;
    if (entry->list == "points" && entry->index < model.points.size()) return NodeId(entry->index);
    if (entry->list == "curves" && entry->index < model.curves.size()) return CurveId(entry->index);
    if (entry->list == "regions" && drawing != nullptr) return face_of(RegionId(entry->index), *drawing);
    return std::nullopt;
}

} // namespace plane
