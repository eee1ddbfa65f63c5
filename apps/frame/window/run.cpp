#include "apps/frame/window/run.h"

#include <iostream>
#include <memory>

#include "apps/frame/session/session.h"
#include "apps/frame/window/application.h"
#include "apps/frame/window/stage.h"
#include "femoop/files/whole_file.h"
#include "ui/app/run_app.h"
#include "ui/app/window_loop.h"
#include "ui/context/start_program.h"
#include "ui/context/window.h"
#include "ui/text/printable.h"

namespace frame {

namespace {

enum ExitStatus : int { Done = 0, BadInput = 2 };

// What the options ask for is in the session; a file that cannot be opened leaves a notice in it.
Session begin(const Options& options)
{
    Session session(starting_document());
    session.set_language(*options.settings.language);
    session.view.theme = *options.settings.theme;
    session.view.layout = Layout::Overlay;
    if (!options.files.empty() && options.files.front() == "-") session.recover("/dev/stdin", std::nullopt);
    else if (!options.files.empty()) session.open(options.files.front());
    const bool is_truss = femoop::is_truss(session.model().analysis); // M says nothing there
    session.view.show = options.show.value_or(shown_by_default | ShowSet{is_truss ? Show::N : Show::M});
    session.view.units = options.settings.units;
    return session;
}

void print(const Notice& notice, const ui::Catalogue& tr)
{
    std::cerr << "frame: " << ui::printable(tr(notice.sentence)) << '\n';
    for (const femoop::Fault& fault : notice.faults) std::cerr << ui::printable(femoop::message(fault, tr)) << '\n';
}

// Puts the case of the options into the session; false, with a sentence on stderr, if there is none of that name.
bool choose_case(Session& session, const Options& options)
{
    if (!options.load_case) return true;
    if (const auto id = session.model().find_case(*options.load_case)) {
        session.view.load_case = *id;
        return true;
    }
    std::string names;
    for (std::size_t i = 0; i < session.model().n_cases(); ++i)
        names += (i > 0 ? ", " : "") + session.model().case_name(femoop::CaseId(i));
    std::cerr << "frame: "
              << ui::printable(session.view.tr("no load case or combination \"{case}\"; there are: {names}",
                                               {{"case", *options.load_case}, {"names", names}}))
              << '\n';
    return false;
}

// An app that remembers files and unsaved work from one time to the next.
ui::MakeApp remembering_app_with(const Session& session, const Options& options,
                                 const std::optional<ui::DraftFolder>& folder)
{
    return [session, options, folder](ui::Context& context, const ui::Fonts& fonts) {
        auto application = std::make_unique<Application>(context, fonts, session);
        application->start_programs_by([](const ui::ExportToApp& exported) { return ui::start_program(exported); });
        ui::remember(*application, options, folder);
        return application;
    };
}

} // namespace

int run(Options options)
{
    const auto folder = ui::draft_folder("frame", ".json", files::write_whole_file);
    ui::complete(options, folder);
    Session session = begin(options);
    if (options.is_headless() && session.notice) {
        print(*session.notice, session.view.tr);
        if (!session.path()) return BadInput; // else it is about what stands beside the model
    }
    if (!choose_case(session, options)) return BadInput;
    if (options.describe) {
        std::cout << ui::printable(session.description());
        return Done;
    }
    if (options.play) return ui::play_through<Application, OffscreenStage>(options, "frame", session, session.view.tr);
    if (options.screenshot) {
        ui::take_screenshot(options, ui::app_with<Application>(session));
        return Done;
    }
    if (!ui::Window::has_display()) {
        std::cerr << "frame: "
                  << session.view.tr("there is no display to open a window on; "
                                     "--screenshot OUT.png draws without one, and so does cremona render")
                  << '\n';
        return BadInput;
    }
    ui::show_in_window(options, remembering_app_with(session, options, folder));
    return Done;
}

} // namespace frame
