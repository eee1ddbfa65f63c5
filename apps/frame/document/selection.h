#pragma once

#include <optional>
#include <span>
#include <vector>

#include "apps/frame/document/part.h"

namespace frame {

/// Parts that are chosen together, each once, in the order in which they were.
class Selection {
public:
    Selection() = default;
    Selection(const Part& part) : parts_{part} {} // one part is a selection

    std::span<const Part> parts() const { return parts_; }
    bool is_empty() const { return parts_.empty(); }
    std::size_t size() const { return parts_.size(); }
    bool contains(const Part& part) const;
    /// The part, where it is the only one.
    std::optional<Part> only() const;

    void clear() { parts_.clear(); }
    void add(const Part& part);
    /// Adds what it lacks, drops what it has.
    void toggle(const Part& part);
    /// Goes on from one state of a model to the next: nodes, members and properties are known by their names, loads by
    /// their places; what is gone is dropped. Dimension lines are known by their nodes.
    void follow(const Document& before, const Document& after);

    friend bool operator==(const Selection&, const Selection&) = default;

private:
    std::vector<Part> parts_;
};

/// All nodes and members of the model.
Selection everything(const femoop::Model& model);

/// The members of one material, section and kind with a selected one; the nodes of one kind of support and joint.
Selection similar(const femoop::Model& model, const Selection& selection);

} // namespace frame
