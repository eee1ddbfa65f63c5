#pragma once

#include "apps/euler/view/subject.h"
#include "topology/script/script_runner.h"

#include <string>
#include <string_view>
#include <vector>

namespace view_test {

/// The solids that a script makes, kept alive for a picture.
class Made {
public:
    explicit Made(std::string_view script);

    const topology::NamedSolid& operator[](std::size_t i) const { return runner_.solids()[i]; }
    const topology::Solid& solid() const { return runner_.solids().front().solid; }
    /// All solids, the first one with these marks.
    std::vector<euler::Subject> subjects(const euler::Marks& marks = {}) const;
    topology::VertexId vertex(std::string_view name) const;
    topology::FaceId face(std::string_view name) const;
    /// What the last operator of the first solid did.
    topology::Change last_change() const;

private:
    topology::ScriptRunner runner_;
};

/// A script of examples/, all of it or its first operators.
std::string example(std::string_view name, std::size_t n_operators = static_cast<std::size_t>(-1));

} // namespace view_test
