#include "tests/apps/frame_window/played.h"

#include "apps/frame/window/stage.h"
#include "tests/golden/scene.h"
#include "ui/paint/surface/golden_text.h"

#include <string_view>
#include <utility>

using namespace frame;

Session opened(const std::string& file)
{
    Session session(starting_document());
    session.view.layout = Layout::Overlay;
    session.view.show = shown_by_default | ShowSet{Show::M};
    session.open(CREMONA_SOURCE_DIR "/" + file);
    return session;
}

void check_window(const std::string& name, Session session, const std::string& script)
{
    const ui::Fonts fonts;
    std::string text;
    const auto pixels = golden::if_drawn(
        [&] {
            ui::Offscreen context({.size = {1280, 800}});
            Application application(context, fonts, std::move(session));
            ui::Pixels kept;
            play(script + "\npicture end\n", context, application,
                 [&](std::string_view, const ui::Pixels& seen, Application& app) {
                     kept = seen;
                     text = ui::golden_text(*app.canvas().picture());
                 });
            return kept;
        },
        golden::this_machine());
    if (pixels) golden::check_picture(name, *pixels, text);
}
