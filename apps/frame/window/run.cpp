#include "apps/frame/window/run.h"

#include <iostream>
#include <string>

#include "apps/frame/session/session.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/window/application.h"
#include "apps/frame/window/stage.h"
#include "ui/app/run_app.h"
#include "ui/text/printable.h"

namespace frame {

namespace {

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
    session.view.unit_choices = options.settings.unit_choices.value_or(ui::UnitChoices());
    if (!options.files.empty()) tell_units(session);
    return session;
}

// Puts the case of the options into the session, unless its file could not be opened; false, with a sentence on stderr,
// if there is none of that name.
bool choose_case(Session& session, const Options& options)
{
    if (!options.load_case || (session.notice && ends_headless(session))) return true;
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

} // namespace

int run(Options options)
{
    constexpr int bad_input = 2;
    const auto folder = ui::draft_folder("frame", ".json");
    ui::complete(options, folder);
    Session session = begin(options);
    if (!choose_case(session, options)) return bad_input;
    return ui::run_app<Application, OffscreenStage>(options, "frame", session,
                                                    ui::remembering_app_with<Application>(session, options, folder));
}

} // namespace frame
