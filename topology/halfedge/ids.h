#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>

namespace topology {

/// The name of an entity of a solid: its place in the solid's dense array of that kind, from 0.
/// The handles of two kinds are two types, so that a vertex is never passed for a face. A handle stays the name of its
/// entity while other entities come and go, and a copied solid knows its entities by the same handles.
template <class Kind> struct Handle {
    std::uint32_t index = 0;

    friend auto operator<=>(Handle, Handle) = default;
};

using SolidId = Handle<struct SolidKind>;
using ShellId = Handle<struct ShellKind>;
using FaceId = Handle<struct FaceKind>;
using LoopId = Handle<struct LoopKind>;
using EdgeId = Handle<struct EdgeKind>;
using HalfEdgeId = Handle<struct HalfEdgeKind>;
using VertexId = Handle<struct VertexKind>;

/// As messages and tables name it, counting from 1: "v7" for the seventh vertex, "he7" for a half-edge, "e" "l" "f"
/// "sh" "s" for the others.
std::ostream& operator<<(std::ostream& out, SolidId id);
std::ostream& operator<<(std::ostream& out, ShellId id);
std::ostream& operator<<(std::ostream& out, FaceId id);
std::ostream& operator<<(std::ostream& out, LoopId id);
std::ostream& operator<<(std::ostream& out, EdgeId id);
std::ostream& operator<<(std::ostream& out, HalfEdgeId id);
std::ostream& operator<<(std::ostream& out, VertexId id);

enum class EntityKind : std::uint8_t { Face, Loop, Edge, HalfEdge, Vertex };

/// A handle of any kind, where several kinds stand in one list.
struct Entity {
    EntityKind kind = EntityKind::Vertex;
    std::uint32_t index = 0;

    Entity() = default;
    Entity(FaceId id) : kind(EntityKind::Face), index(id.index) {}
    Entity(LoopId id) : kind(EntityKind::Loop), index(id.index) {}
    Entity(EdgeId id) : kind(EntityKind::Edge), index(id.index) {}
    Entity(HalfEdgeId id) : kind(EntityKind::HalfEdge), index(id.index) {}
    Entity(VertexId id) : kind(EntityKind::Vertex), index(id.index) {}

    friend auto operator<=>(const Entity&, const Entity&) = default;
};
std::ostream& operator<<(std::ostream& out, Entity entity); ///< as its handle

} // namespace topology

/// Handles are keys of unordered containers.
template <class Kind> struct std::hash<topology::Handle<Kind>> {
    std::size_t operator()(topology::Handle<Kind> handle) const noexcept { return handle.index; }
};
