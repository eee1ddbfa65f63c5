#include "topology/halfedge/ids.h"

#include <concepts>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_set>

#include <doctest/doctest.h>

namespace {

using topology::EdgeId;
using topology::FaceId;
using topology::HalfEdgeId;
using topology::VertexId;

template <class Id> std::string text(Id id)
{
    std::ostringstream out;
    out << id;
    return out.str();
}

TEST_CASE("A handle of one kind is not taken for another, nor made of a bare number unasked")
{
    CHECK_FALSE(std::is_convertible_v<VertexId, FaceId>);
    CHECK_FALSE(std::equality_comparable_with<EdgeId, HalfEdgeId>);
    CHECK_FALSE(std::is_convertible_v<unsigned, VertexId>);
}

TEST_CASE("A handle is written with the letter of its kind, counting from 1, so that e4 and he4 are told apart")
{
    CHECK(text(EdgeId{3}) == "e4");
    CHECK(text(HalfEdgeId{3}) == "he4");
    CHECK(text(topology::ShellId{12}) == "sh13");
    CHECK(text(topology::SolidId{12}) == "s13");
}

TEST_CASE("Handles order by index and are keys of a set")
{
    CHECK(VertexId{2} < VertexId{5});
    const std::unordered_set<VertexId> visited{VertexId{5}, VertexId{2}, VertexId{5}};
    CHECK(visited.size() == 2);
}

} // namespace
