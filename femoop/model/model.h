#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/model/expected.h"
#include "femoop/model/ids.h"
#include "femoop/model/load.h"
#include "femoop/model/member.h"
#include "femoop/model/moving_load.h"
#include "femoop/model/node.h"
#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

enum class MassKind : std::uint8_t { Consistent, Lumped };

/// A block of the file that another program part reads (`cross`, `influence`, `train`), kept as its JSON text.
struct ExtraBlock {
    std::string key;
    std::string json;

    friend bool operator==(const ExtraBlock&, const ExtraBlock&) = default;
};

/// A structure, its loads and what is expected of it: a plain value that is copied, compared, edited and saved.
/// `check` (femoop/model/check/check.h) says what is wrong with it, `analyse` (femoop/analysis/linear_static.h) solves
/// it.
///
/// Signs  2D: x right, y up, counter-clockwise positive. 3D: right-handed, z up.
/// Units  every Quantity is in `units`; see femoop/model/quantity/units.h
struct Model {
    std::string title;
    std::string notes;
    AnalysisKind analysis = AnalysisKind::Frame2d;
    Units units;
    std::optional<MassKind> mass; ///< modal analysis only
    std::vector<Material> materials;
    std::vector<Section> sections;
    std::vector<Node> nodes;
    std::vector<Member> members;
    std::vector<LoadCase> load_cases;
    std::vector<Combination> combinations;
    MovingLoads moving_loads;
    std::vector<Expected> expected;
    std::vector<ExtraBlock> extra;

    MaterialId add(Material material);
    SectionId add(Section section);
    NodeId add(Node node);
    MemberId add(Member member);
    CaseId add(LoadCase load_case); ///< \pre no combinations yet: their ids follow those of the load cases

    const Node& operator[](NodeId id) const { return nodes[id.index]; }
    const Member& operator[](MemberId id) const { return members[id.index]; }
    const Material& operator[](MaterialId id) const { return materials[id.index]; }
    const Section& operator[](SectionId id) const { return sections[id.index]; }

    std::size_t n_cases() const { return load_cases.size() + combinations.size(); }
    const std::string& case_name(CaseId id) const;
    std::optional<NodeId> find_node(std::string_view id) const;     ///< linear search, for interfaces
    std::optional<MemberId> find_member(std::string_view id) const; ///< linear search, for interfaces
    std::optional<CaseId> find_case(std::string_view id) const;     ///< load cases, then combinations

    friend bool operator==(const Model&, const Model&) = default;
};

} // namespace femoop
