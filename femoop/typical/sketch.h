#pragma once

#include <string>
#include <string_view>

#include "femoop/model/model.h"

namespace femoop {

/// Puts a typical structure together: one material, one section, one load case.
class Sketch {
public:
    Sketch(std::string title, AnalysisKind kind);

    NodeId node(std::string id, double x, double y, double z = 0.0);
    MemberId member(NodeId start, NodeId end); ///< named after its nodes
    void support(NodeId node, SupportKind kind);
    void support(NodeId node, DofSet blocked);
    void hinge(NodeId node) { model_.nodes[node.index].hinge = true; }
    void load(NodeId node, Dof dof, double value);                    ///< none for a value of 0
    void load(MemberId member, double qy, bool is_projected = false); ///< global, none for a value of 0
    void load_down(MemberId member, double qz);                       ///< in space, global, none for a value of 0

    Model model() && { return std::move(model_); }

private:
    Model model_;
};

/// "A" ... "Z", "A1" ... for 0, 1, ...
std::string letter_name(int i);

/// \throws std::invalid_argument naming the number, what it is and what it may be
void require_within(std::string_view name, double value, double least, double most);
void require_positive(std::string_view name, double value);

} // namespace femoop
