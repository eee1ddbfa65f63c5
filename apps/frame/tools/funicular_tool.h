#pragma once

#include <optional>

#include "apps/drawing/results/funicular_picture.h"
#include "apps/frame/funicular/asked_funicular.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Drags the closing line of a funicular by its ends, and its rise: to the ends and the crown of the chain where they
/// are near, else to round heights. Without a button it reads the place that it points at; a click on a member asks for
/// the funicular over that, with Shift over one more.
class FunicularTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override; ///< a drag: the funicular is as it was when the button went down
    bool snaps() const override { return false; }

private:
    static std::optional<drawing::FunicularHandle> handle_at(const drawing::FunicularPicture& picture, const Aim& at);
    static double height_for(const drawing::FunicularPicture& picture, drawing::FunicularHandle handle, const Aim& at);
    static std::optional<double> place_read(const drawing::FunicularPicture& picture, const Aim& at);

    std::optional<Aim> press_;
    std::optional<drawing::FunicularHandle> held_;
    AskedFunicular* pressed_ = nullptr; ///< while the button is held
    AskedFunicular before_;             ///< it as that went down
};

} // namespace frame
