#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "femoop/model/model.h"

namespace CLI {
class App;
}

namespace cli {

/// The options --member M --at X --component C | --node N --component C: the one effect that is asked for.
struct AskedEffect {
    std::optional<std::string> member, at, component, node;

    void declare(CLI::App& app, const ui::Catalogue& tr);
    bool is_given() const { return member || at || component || node; }

    /// A section force, a displacement or a reaction; of a member without a place an Extreme. \throws UsageError
    femoop::MovingEffect effect(const femoop::Model& model, const ui::Catalogue& tr) const;

private:
    femoop::MovingEffect of_member(const femoop::Model& model, const ui::Catalogue& tr) const;
    femoop::MovingEffect of_node(const femoop::Model& model, const ui::Catalogue& tr) const;
};

} // namespace cli
