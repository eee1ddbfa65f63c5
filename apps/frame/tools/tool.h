#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/tools/snap.h"
#include "ui/text/phrase.h"

namespace frame {

/// One step of the history that a tool asks for.
struct Change {
    ui::Phrase label;
    std::function<void(Document&)> command;
};

/// What a tool shows before it changes anything: lines in the plane of the model.
struct Preview {
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
};

/// What the left button does in the picture, from press to release and on to the next press. A tool never changes a
/// document itself; it hands back the change.
class Tool {
public:
    virtual ~Tool() = default;

    virtual std::optional<Change> press(const Snap& at) = 0;
    virtual void move(const Snap& to) = 0; ///< with or without the button held down
    virtual std::optional<Change> release(const Snap& at) = 0;
    /// A place that was typed, as if it had been clicked.
    virtual std::optional<Change> type(const Eigen::Vector2d& place) = 0;
    /// Gives up what was begun; false where nothing was, so that the tool itself is left.
    virtual bool escape() = 0;

    virtual std::optional<Eigen::Vector2d> from() const { return std::nullopt; } ///< where drawing began
    virtual Preview preview() const { return {}; }

protected:
    Tool() = default;
    Tool(const Tool&) = default;
    Tool& operator=(const Tool&) = default;
};

} // namespace frame
