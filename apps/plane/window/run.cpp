#include "apps/plane/window/run.h"

#include "apps/plane/window/application.h"
#include "apps/plane/window/stage.h"
#include "ui/app/run_app.h"

namespace plane {

int run(const ui::AppOptions& options)
{
    return ui::run_with<Application, OffscreenStage, Session>(options, "plane", ui::draft_folder("plane", ".json"));
}

} // namespace plane
