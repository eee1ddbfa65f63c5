#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "ui/workspace/export_to_app.h"

namespace ui {

/// What the page around an app asks of it. Reasons are sentences; nothing: it was done.
struct AppCalls {
    std::function<ExportToApp()> copy; ///< the document and how it is looked at, for a link that holds both
    std::function<std::string()> description, results; ///< in words; as JSON, empty where there are none
    std::function<std::optional<std::string>(const std::filesystem::path& file)>
        replace; ///< the document by that of a file
    /// A command by its name, with an argument or (empty) without.
    std::function<std::optional<std::string>(const std::string& id, const std::string& argument)> run_command;
};

/// Lets the page around an app have these (ui/app/web/page.js). On a desktop nobody asks.
class OfferedApp {
public:
    explicit OfferedApp(AppCalls calls);
    ~OfferedApp();
    OfferedApp(const OfferedApp&) = delete;
    OfferedApp& operator=(const OfferedApp&) = delete;

    const AppCalls& calls() const { return calls_; }

private:
    AppCalls calls_;
};

} // namespace ui
