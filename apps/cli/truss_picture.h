#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/option_parser.h"
#include "apps/cli/picture.h"
#include "apps/drawing/truss/truss_picture.h"
#include "femoop/model/model.h"

namespace cli {

/// What options of `render` ask for of a truss: how it is worked out by hand.
class TrussPicture {
public:
    void declare(OptionParser& options, const ui::Catalogue& tr);
    bool is_asked() const { return is_cremona_ || method_; }
    /// \throws UsageError for options that do not go together
    void require_sensible(const ui::Catalogue& tr) const;

    /// Draws the truss beside its diagram, or beside the joint of a stage, as far as it is asked for.
    /// \param shows_own  the order says itself what is shown
    /// \throws UsageError if there is none
    ExitStatus draw(const femoop::Model& model, const std::string& file, PictureOrder order, bool shows_own,
                    const Console& console) const;

private:
    drawing::TrussMethod method(const ui::Catalogue& tr) const;

    bool is_cremona_ = false;
    std::optional<std::string> method_, stage_;
};

} // namespace cli
