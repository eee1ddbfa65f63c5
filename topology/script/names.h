#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "topology/halfedge/operators/refusal.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// The user's names for vertices or faces of one solid. A name belongs to one living entity of its kind at most; the
/// dead keep theirs, so that undo and redo bring the name back with the entity.
template <class Id> class NameList {
public:
    void give(Id id, std::string name)
    {
        if (names_.size() <= id.index) names_.resize(id.index + 1);
        bearers_[name].push_back(id);
        names_[id.index] = std::move(name);
    }
    std::optional<Id> find(std::string_view name, const Solid& solid) const
    {
        const auto found = bearers_.find(std::string(name));
        if (found == bearers_.end()) return std::nullopt;
        for (const Id id : found->second)
            if (solid.has(id) && names_[id.index] == name) return id;
        return std::nullopt;
    }
    bool is_given(std::string_view name) const
    {
        return bearers_.contains(std::string(name));
    } ///< to any, living or dead

    /// "v7" of an entity that got no name.
    std::string of(Id id) const
    {
        const bool is_named = id.index < names_.size() && !names_[id.index].empty();
        return is_named ? names_[id.index] : table_name(id);
    }
    /// `wanted`, with as many ' after it as make it a name of nothing that lives.
    std::string unused(std::string wanted, const Solid& solid) const
    {
        while (find(wanted, solid)) wanted += '\'';
        return wanted;
    }

private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, std::vector<Id>> bearers_;
};

struct Names {
    NameList<VertexId> vertices;
    NameList<FaceId> faces;

    /// As a message or a script writes it: the user's name, "v1>v2 (%7)" of a half-edge, "v1-v2" of an edge.
    std::string of(Entity entity, const Solid& solid) const;
};

} // namespace topology
