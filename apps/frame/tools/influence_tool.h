#pragma once

#include <optional>

#include "apps/frame/influence/asked_line.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Asks for influence lines: press at a section, a support or a node; while the button is held the section goes along.
/// A train that stands on the line is taken hold of at its arrows, and runs along its path.
class InfluenceTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override; ///< a drag: the line is as it was when the button went down
    bool takes_hold(const Work& work, const Aim& at) const override;
    bool snaps() const override { return false; }

private:
    /// From the place of its path under the hand to its leading axle.
    struct Pull {
        double ahead = 0.0;
    };
    static std::optional<Pull> pull_of(const AskedLine& line, const Aim& at);
    void ask(const Work& work, const Aim& at);
    static void stand_governing(const Work& work);
    static void pull_train(AskedLine& line, const Pull& pull, const Aim& to);

    std::optional<femoop::MemberId> held_; ///< whose section the hand moves
    std::optional<Pull> pull_;             ///< of the train that it moves
    AskedLine* pressed_ = nullptr;         ///< while the button is held
    AskedLine before_;                     ///< it as that went down
};

} // namespace frame
