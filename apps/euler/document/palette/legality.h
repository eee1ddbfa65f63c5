#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/euler/document/palette/operator_form.h"
#include "topology/script/script_runner.h"
#include "ui/text/message.h"

namespace euler {

/// Judges entities as arguments of operators on one solid, which it copies once.
class Legality {
public:
    explicit Legality(const topology::NamedSolid& in) : in_(in), copy_(in.solid) {}

    /// Why the last of the picked entities cannot stand after the others: it is of another kind than `wanted`, dead, or
    /// the operator would refuse it. None if it can.   \pre the others were legal, there is at least one
    std::optional<ui::Message> why_not(Verb verb, ArgumentKind wanted, const std::vector<topology::Entity>& picked);

private:
    const topology::NamedSolid& in_;
    topology::Solid copy_; ///< operators are asked of a solid that they could change
};

/// The operator's words after the solid's name, as far as they are said by pointing: " f1 v1 v4" of MEF.
std::string pointed_text(const topology::NamedSolid& in, Verb verb, const std::vector<topology::Entity>& picked);

} // namespace euler
