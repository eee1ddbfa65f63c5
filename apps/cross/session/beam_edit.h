#pragma once

#include <optional>

#include "apps/cross/session/edit.h"

namespace cross {

// What a hand changes of the spans of a beam; of a frame where its members lie level.

/// The outermost node of a side where a level member ends alone: a foot is no end of a span.
std::optional<femoop::NodeId> end_of_spans(const femoop::Model& model, Side side);

/// The end is pinned, then fixed, then free; an inner node is held by a roller, then fixed, then free. \pre a node of
/// the model
femoop::Model with_next_support(const femoop::Model& model, femoop::NodeId node);

/// A roller under a member that lies level, so far from its first end; nothing too near an end.
std::optional<femoop::Model> with_support_between(const femoop::Model& model, femoop::MemberId member, double x);
/// Without the support of a node; where two equal members then go on straight they become one.
femoop::Model with_support_taken(const femoop::Model& model, femoop::NodeId node);

/// A span more at a side, loaded as the last one there and as long, unless its length is given; its end is held as the
/// end was. Nothing where several members meet there, or the foot of a column stands there.
std::optional<femoop::Model> with_span_added(const femoop::Model& model, Side side = Side::Right,
                                             std::optional<double> length = std::nullopt);
/// A span less at a side; nothing where it is the only one.
std::optional<femoop::Model> with_span_removed(const femoop::Model& model, Side side = Side::Right);

/// A point load at another place of its member, which lies between its ends; nothing where it is no point load.
std::optional<femoop::Model> with_point_load_moved(const femoop::Model& model, const frame::Part& load, double by);

} // namespace cross
