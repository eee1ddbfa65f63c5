#include "apps/frame/document/fault/field.h"

#include <algorithm>
#include <array>

#include "apps/frame/document/fault/place.h"
#include "ui/text/catalogue.h"

namespace frame {

using femoop::Fault;
using femoop::FaultKind;
using ui::Message;
using ui::translatable;

namespace {

struct Entry {
    std::string_view list, key, label, heading;
};
constexpr std::array entries{
    Entry{"materials", "id", translatable("Name"), translatable("Material")},
    Entry{"materials", "E", translatable("Young's modulus E"), "E"},
    Entry{"materials", "nu", translatable("Poisson's ratio ν"), "ν"},
    Entry{"materials", "G", translatable("Shear modulus G"), "G"},
    Entry{"materials", "alpha", translatable("Thermal expansion α"), "α"},
    Entry{"materials", "density", translatable("Density ρ"), "ρ"},
    Entry{"materials", "fy", translatable("Yield stress fy"), "fy"},
    Entry{"sections", "id", translatable("Name"), translatable("Section")},
    Entry{"sections", "A", "A", "A"},
    Entry{"sections", "Iz", "Iz", "Iz"},
    Entry{"sections", "Iy", "Iy", "Iy"},
    Entry{"sections", "J", "J", "J"},
    Entry{"sections", "Asy", translatable("Shear area Asy"), "Asy"},
    Entry{"sections", "Asz", translatable("Shear area Asz"), "Asz"},
    Entry{"sections", "h", translatable("Depth h"), translatable("Depth h")},
    Entry{"sections", "yc", translatable("Centroid yc"), "yc"},
    Entry{"sections", "profile", translatable("Profile"), translatable("Profile")},
    Entry{"sections", "shape", translatable("Shape"), translatable("Shape")},
    Entry{"sections", "b", "b", "b"},
    Entry{"sections", "d", "d", "d"},
    Entry{"sections", "t", "t", "t"},
    Entry{"sections", "bf", "bf", "bf"},
    Entry{"sections", "tf", "tf", "tf"},
    Entry{"sections", "tw", "tw", "tw"},
    Entry{"sections", "turned", translatable("Turned on its side"), translatable("Turned")},
    Entry{"nodes", "id", translatable("Name"), translatable("Node")},
    Entry{"nodes", "x", "x", "x"},
    Entry{"nodes", "y", "y", "y"},
    Entry{"nodes", "z", "z", "z"},
    Entry{"nodes", "support", translatable("Support"), translatable("Support")},
    Entry{"nodes", "angle", translatable("Angle of the support"), translatable("Angle")},
    Entry{"members", "id", translatable("Name"), translatable("Member")},
    Entry{"members", "nodes", translatable("End"), translatable("End")},
    Entry{"members", "material", translatable("Material"), translatable("Material")},
    Entry{"members", "section", translatable("Section"), translatable("Section")},
    Entry{"members", "depths", translatable("Depth h, start"), translatable("Depth h, start")},
    Entry{"members", "foundation", translatable("Elastic foundation"), translatable("Elastic foundation")},
    Entry{"members", "bar", translatable("Bar"), translatable("Bar")},
    Entry{"load_cases", "id", translatable("Name"), translatable("Load case")},
    Entry{"load_cases", "self_weight", translatable("Factor of self-weight"), translatable("Self-weight ×")},
    Entry{"combinations", "id", translatable("Name"), translatable("Combination")},
    Entry{"loads", "node", translatable("Node"), translatable("Node")},
    Entry{"loads", "member", translatable("Member"), translatable("Member")},
    Entry{"loads", "axes", translatable("Axes"), translatable("Axes")},
    Entry{"loads", "from", translatable("From"), translatable("From")},
    Entry{"loads", "to", translatable("To"), translatable("To")},
    Entry{"loads", "at", translatable("Distance from the start"), translatable("Distance from the start")},
    Entry{"loads", "top", translatable("Rise at the top"), translatable("Rise at the top")},
    Entry{"loads", "bottom", translatable("Rise at the bottom"), translatable("Rise at the bottom")},
    Entry{"loads", "elongation", translatable("Elongation"), translatable("Elongation")},
};

/// A key that ends with the name of a direction: "start spring rz".
struct Family {
    std::string_view list, beginning, label, heading, place;
};
constexpr std::array families{
    Family{"nodes", "spring ", translatable("Spring {dof}"), translatable("Spring {dof}"), "dof"},
    Family{"members", "start spring ", translatable("Spring {dof}, start"), translatable("Spring {dof}, start"), "dof"},
    Family{"members", "end spring ", translatable("Spring {dof}, end"), translatable("Spring {dof}, end"), "dof"},
    Family{"members", "start release ", translatable("Released at start"), translatable("Released at start"), "dof"},
    Family{"members", "end release ", translatable("Released at end"), translatable("Released at end"), "dof"},
    Family{"loads", "start_", translatable("{force}, start"), translatable("{force}, start"), "force"},
    Family{"loads", "end_", translatable("{force}, end"), translatable("{force}, end"), "force"},
    Family{"loads", "q", "{q}", translatable("{q}, start"), "q"},
};

std::optional<Field> family_field(const Remedy& remedy)
{
    for (const Family& family : families) {
        if (remedy.list != family.list || !remedy.key.starts_with(family.beginning)) continue;
        const std::string which = family.place == "q" ? remedy.key : remedy.key.substr(family.beginning.size());
        const Message::Argument argument(std::string(family.place), which);
        return Field{{family.label, {argument}}, {family.heading, {argument}}};
    }
    return std::nullopt;
}

constexpr std::array lists{
    std::pair<std::string_view, std::string_view>{"materials", translatable("Materials")},
    std::pair<std::string_view, std::string_view>{"sections", translatable("Sections")},
    std::pair<std::string_view, std::string_view>{"nodes", translatable("Nodes")},
    std::pair<std::string_view, std::string_view>{"members", translatable("Members")},
    std::pair<std::string_view, std::string_view>{"load_cases", translatable("Load cases")},
    std::pair<std::string_view, std::string_view>{"combinations", translatable("Combinations")},
    std::pair<std::string_view, std::string_view>{"loads", translatable("Loads")},
};

/// The field, in the words of the file; "" where the fault is about the part as a whole.
std::string key_of(const Fault& fault)
{
    const auto argument = [&](std::size_t i) {
        return i < fault.arguments.size() ? fault.arguments[i] : std::string();
    };
    switch (fault.kind) {
    case FaultKind::NotFinite:
    case FaultKind::OutOfReach:
    case FaultKind::NotPositive:
    case FaultKind::Negative:
    case FaultKind::ZeroStiffness:
    case FaultKind::ZeroEndSpring:
    case FaultKind::RepeatedComponent:
    case FaultKind::ShapeTooThick:
    case FaultKind::MissingProperty:
    case FaultKind::MissingKey:
    case FaultKind::SizeWithoutShape:
    case FaultKind::LoadDofLacking:
    case FaultKind::SettlementOfFreeDof:
    case FaultKind::PositionBeforeStart:
    case FaultKind::PositionBeyondEnd:
    case FaultKind::ProjectedMoment: return argument(1);
    case FaultKind::ShapeSizeUnwanted:
    case FaultKind::ExpectedKeyMissing: return argument(2);
    case FaultKind::ShapeSizeMissing: return argument(3);
    case FaultKind::SpringDofLacking:
    case FaultKind::SpringOnFixedDof: return "spring " + argument(1);
    case FaultKind::ReleaseDofLacking: return argument(2) + " release " + argument(1);
    case FaultKind::EndSpringDofLacking:
    case FaultKind::ReleaseAndSpring:
    case FaultKind::HingeAndSpring: return argument(2) + " spring " + argument(1);
    case FaultKind::EmptyId:
    case FaultKind::ControlCharacterInId:
    case FaultKind::RepeatedId: return "id";
    case FaultKind::PoissonOutOfRange: return "nu";
    case FaultKind::CentroidOutside: return "yc";
    case FaultKind::TurnedNumbers: return "turned";
    case FaultKind::ShapeAndProfile:
    case FaultKind::UnknownProfile:
    case FaultKind::UnknownProfileNear: return "profile";
    case FaultKind::RollerNotPlane:
    case FaultKind::FixedDofLacking: return "support";
    case FaultKind::AngleNotPlane: return "angle";
    case FaultKind::MemberWithoutMaterial: return "material";
    case FaultKind::MemberWithoutSection: return "section";
    case FaultKind::SameNodeTwice: return "nodes";
    case FaultKind::FoundationOfBar:
    case FaultKind::FoundationTooStiff: return "foundation";
    case FaultKind::DepthCount:
    case FaultKind::DepthsOutsidePlaneFrame:
    case FaultKind::DepthsBeside:
    case FaultKind::DepthsOfSection:
    case FaultKind::DepthTooSmall:
    case FaultKind::DepthsTooDifferent: return "depths";
    case FaultKind::LoadEndsBeforeStart: return "from";
    case FaultKind::ProjectedLocalLoad: return "axes";
    case FaultKind::TemperatureOfRigid:
    case FaultKind::TorqueOnBar: return "member";
    case FaultKind::LoadedNodeWithoutMembers: return "node";
    default: return "";
    }
}

} // namespace

Remedy remedy_of(const Fault& fault)
{
    const auto other = [&](std::string list, std::string key) {
        return Remedy{std::move(list), fault.arguments.size() > 1 ? fault.arguments[1] : "", std::move(key)};
    };
    switch (fault.kind) {
    case FaultKind::MissingDensity: return other("materials", "density");
    case FaultKind::MissingExpansion: return other("materials", "alpha");
    case FaultKind::MissingDepth: return other("sections", "h");
    case FaultKind::MissingAreaForWeight: return other("sections", "A");
    default: break;
    }
    const std::optional<FaultPlace> place = place_of(fault);
    if (!place) return {};
    return {place->is_load() ? "loads" : place->steps.front().key, {}, key_of(fault)};
}

std::optional<Field> field_of(const Remedy& remedy)
{
    const auto is_it = [&](const Entry& entry) { return entry.list == remedy.list && entry.key == remedy.key; };
    const auto* const found = std::ranges::find_if(entries, is_it);
    if (found != entries.end()) return Field{found->label, found->heading};
    if (remedy.list == "combinations" && !remedy.key.empty())
        return Field{{translatable("Factor of {case}"), {{"case", remedy.key}}}, {"{case} ×", {{"case", remedy.key}}}};
    if (const auto field = family_field(remedy)) return field;
    const bool is_component = remedy.list == "loads" && remedy.key.size() == 2; // fx, mz, and ux of a settlement
    return is_component ? std::optional(Field{Message(remedy.key, {}), Message(remedy.key, {})}) : std::nullopt;
}

Message label_of(const Remedy& remedy)
{
    const std::optional<Field> field = field_of(remedy);
    return field ? field->label : Message(remedy.key, {});
}

std::string_view title_of_list(std::string_view list)
{
    const auto* const found = std::ranges::find(lists, list, &std::pair<std::string_view, std::string_view>::first);
    return found != lists.end() ? found->second : list;
}

} // namespace frame
