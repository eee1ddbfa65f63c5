#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/document/part.h"
#include "femoop/model/fault/fault.h"
#include "ui/text/message.h"

namespace frame {

/// What was copied out of a document, to be put into it or another one: nodes and members with their supports, loads,
/// materials and sections and the dimension lines between them, and where they are all of the structure all load cases
/// and combinations too; or loads alone, whose bearers then come along only to carry them.
struct Clipping {
    enum class Holds : std::uint8_t { Structure, Loads };

    femoop::Model model;
    std::vector<DimensionLine> dimensions{}; ///< between nodes of the model
    Holds holds = Holds::Structure;
};

/// Nodes, members and loads; materials and sections come with what has them.
bool can_be_clipped(const Part& part);

/// Nothing where none of the parts can be copied. A member takes its nodes along, a load alone nothing else.
std::optional<Clipping> clipping_of(const Document& document, std::span<const Part> parts);

/// Why the clipping cannot go into the model, where these parts are selected; nothing where it can.
std::optional<ui::Message> why_not_paste(const femoop::Model& model, std::span<const Part> selected,
                                         const Clipping& clipping);

/// The materials without density that would have to bear their own weight once the structure were pasted: load cases
/// come along, and those of one name are one.
std::vector<femoop::Fault> weightless(const femoop::Model& model, const Clipping& clipping);

/// The node by which a hand holds it: the one of least x, of several the one of least y, then z [the model's unit of
/// length].
Eigen::Vector3d grip_of(const Clipping& clipping, const femoop::Units& units);

/// Puts the structure so that its grip comes to the place. What meets is not joined yet. Equal materials and sections
/// become one, and load cases of one name.
void paste(Document& document, const Clipping& clipping, const Eigen::Vector3d& place);

/// Puts the loads on every one of the parts that can bear them: those of nodes on nodes, those of members on members.
void paste_loads(Document& document, const Clipping& clipping, std::span<const Part> bearers);

} // namespace frame
