#pragma once

#include "apps/frame/tools/settings.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Puts the chosen support at a node that is clicked; takes it away where it is there already.
class SupportTool : public Tool {
public:
    explicit SupportTool(const ToolSettings& settings) : settings_(settings) {}
    std::optional<Change> press(const Work& work, const Aim& at) override;

private:
    const ToolSettings& settings_;
};

/// Hinges a node that is clicked, or the nearer end of a member; makes it rigid where it is hinged.
class HingeTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
};

/// Takes out what is clicked.
class DeleteTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
};

} // namespace frame
