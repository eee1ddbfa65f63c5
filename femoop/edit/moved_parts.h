#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>

#include "femoop/model/model.h"

namespace femoop {

/// Which parts of a model were moved or made since it was `before`; parts are known by their names.
/// Holds on to `before`, which must outlive it.
class MovedParts {
public:
    explicit MovedParts(const Model& before);

    const Model& before() const { return before_; }
    /// The part as it was; nothing where it was made since.
    std::optional<NodeId> former(const Node& node) const;
    std::optional<MemberId> former(const Member& member) const;

    /// Has another place, or had none.
    bool is_moved(const Model& model, NodeId node) const;
    /// An end has another place, or had none.
    bool is_moved(const Model& model, MemberId member) const;

private:
    const Model& before_;
    std::unordered_map<std::string_view, NodeId> nodes_;
    std::unordered_map<std::string_view, MemberId> members_;
};

} // namespace femoop
