#include "apps/cross/window/run.h"

#include "apps/cross/session/report.h"
#include "apps/cross/window/application.h"
#include "apps/cross/window/stage.h"
#include "ui/app/run_app.h"

namespace cross {

int run(const ui::AppOptions& options)
{
    return ui::run_with<Application, OffscreenStage, Session>(options, "cross", ui::draft_folder("cross", ".json"));
}

} // namespace cross
