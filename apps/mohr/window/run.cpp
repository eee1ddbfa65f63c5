#include "apps/mohr/window/run.h"

#include "apps/mohr/session/report.h"
#include "apps/mohr/window/application.h"
#include "apps/mohr/window/stage.h"
#include "ui/app/run_app.h"

namespace mohr {

int run(const ui::AppOptions& options)
{
    return ui::run_with<Application, OffscreenStage, Session>(options, "mohr", ui::draft_folder("mohr", ".mohr"));
}

} // namespace mohr
