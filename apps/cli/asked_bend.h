#pragma once

#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/option_parser.h"
#include "femoop/model/model.h"

namespace cli {

/// `--bend`: members that become arcs or parabolas.
class AskedBend {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);
    bool is_asked() const { return !bends_.empty(); }
    /// Bends them, one option after the other, and says on stderr what each became. \throws UsageError
    void apply(femoop::Model& model, const Console& console) const;

private:
    std::vector<std::string> bends_;
};

} // namespace cli
