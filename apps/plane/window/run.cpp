#include "apps/plane/window/run.h"

#include <filesystem>

#include "apps/plane/backdrop/backdrop.h"
#include "apps/plane/outline/outline.h"
#include "apps/plane/window/application.h"
#include "apps/plane/window/stage.h"
#include "ui/app/run_app.h"

namespace plane {

// Both are found by `run_with`, in place of its own.

/// An outline or an image joins the empty drawing.
static void open_first(Session& session, const std::filesystem::path& file)
{
    if (outline::is_outline_file(file)) session.insert_outline(file);
    else if (is_image_file(file)) session.insert_backdrop(file);
    else ui::open_first(session, file);
}

/// Not what was left out of an outline that was taken, nor a view file beside what was opened.
[[maybe_unused]] static bool ends_headless(const Session& session)
{
    return !session.path() && !session.history().can_undo();
}

int run(const ui::AppOptions& options)
{
    const auto prepare = [](Application& application) {
        application.workspace().session.patience = Patience::of_a_window();
    };
    return ui::run_with<Application, OffscreenStage, Session>(options, "plane", ui::draft_folder("plane", ".json"),
                                                              prepare);
}

} // namespace plane
