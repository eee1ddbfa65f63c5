#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/context/context.h"
#include "ui/context/imgui_session.h"
#include "ui/context/input.h"
#include "ui/workspace/export_to_app.h"

namespace ui {

/// An app of the suite, as its window, its screenshots and its scenarios see it.
class App {
public:
    virtual ~App() = default;
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    virtual void frame(const Input& input) = 0;
    /// Something moves by itself, so frames must follow one another.
    virtual bool is_moving() const = 0;
    /// The window's close button was pressed: closes, or asks first what to do with unsaved changes.
    virtual void ask_to_quit() = 0;
    virtual bool wants_to_quit() const = 0;
    virtual std::string window_title() const = 0;
    /// The document as it stands and how it is looked at, for another window of this app.
    virtual ExportToApp copy_of_document() const = 0;
    /// Document and results in words; the results as JSON, empty where the app has none.
    virtual std::string document_in_words() const = 0;
    virtual std::string results_text() const { return {}; }
    /// The document is that of a file from now on, as a copy without a file. \returns why it cannot be read
    virtual std::optional<std::string> replace_document(const std::filesystem::path& path) = 0;
    /// As a scenario runs it, with an argument or (empty) without. \returns what hinders it, in English
    virtual std::optional<std::string> run_command(const std::string& id, const std::string& argument) = 0;
    virtual ImGuiSession& gui() = 0;
    virtual const ImGuiSession& gui() const = 0;

protected:
    App() = default;
};

/// Makes the app once there is something to draw on; both outlive it.
using MakeApp = std::function<std::unique_ptr<App>(Context&, const Fonts&)>;

} // namespace ui
