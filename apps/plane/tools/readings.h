#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "apps/plane/document/part.h"

namespace plane {

/// What can be taken hold of to read results: a probe, or an end of a cut.
struct ReadingPart {
    enum class Kind : std::uint8_t { Probe, CutStart, CutEnd };
    Kind kind = Kind::Probe;
    std::size_t index = 0; ///< of the probe or the cut

    friend bool operator==(const ReadingPart&, const ReadingPart&) = default;
};

/// Where results are read: places and straight cuts through the body, by its undeformed places. No part of what is
/// saved.
struct Readings {
    std::vector<FlatPoint> probes;
    std::vector<std::array<FlatPoint, 2>> cuts; ///< from the first to the second end
    std::optional<ReadingPart> last{};          ///< that the hand had hold of
    bool is_selected = false;                   ///< the last one: Delete takes it away

    friend bool operator==(const Readings&, const Readings&) = default;

    bool are_none() const { return probes.empty() && cuts.empty(); }
    /// The probe whose values are told at length: the last one.
    std::optional<std::size_t> told_probe() const;

    void select(const ReadingPart& part);
    void add_probe(const FlatPoint& at);
    void add_cut(const FlatPoint& start, const FlatPoint& end); ///< \pre they are apart
    FlatPoint place(const ReadingPart& part) const;             ///< \pre it is there
    /// Moves it; an end of a cut not onto the other one.
    void move(const ReadingPart& part, const FlatPoint& to);
    void remove(const ReadingPart& part); ///< an end takes its cut along
    /// The nearest part within reach.
    std::optional<ReadingPart> at(const FlatPoint& place, double reach) const;
};

} // namespace plane
