#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "femoop/result/curve.h"
#include "femoop/result/results.h"

namespace femoop {

namespace detail {
class AnyReader;
}

/// What the forces and displacements of a member that a constraint ties are made of; they add up.
enum class CurvePart : std::uint8_t {
    Motion,    ///< of its ends, against its elastic stiffness
    Loads,     ///< between held ends, with its own stiffness along what the constraint takes too
    Constraint ///< forces that tie the ends
};

/// Reads the curves of many members of one case, one after the other, without allocating for each.
/// Two readers of one case may work at the same time, each in a thread of its own.
class CurveReader {
public:
    explicit CurveReader(const CaseResult& result);
    ~CurveReader();
    CurveReader(const CurveReader&) = delete;
    CurveReader& operator=(const CurveReader&) = delete;

    const Curve& read(MemberId member); ///< valid until the next read

    /// How its own two ends move, and what its nodes do to them, in its own axes.
    std::array<NodeVector, 2> end_displacements(MemberId member);
    std::array<NodeVector, 2> end_forces(MemberId member);

    /// A part of them. \pre a constraint ties the member
    const Curve& read(MemberId member, CurvePart part); ///< valid until the next read
    std::array<NodeVector, 2> end_forces(MemberId member, CurvePart part);

private:
    std::shared_ptr<const detail::Solution> solution_;
    std::unique_ptr<detail::AnyReader> reader_;
    Curve curve_;
};

} // namespace femoop
