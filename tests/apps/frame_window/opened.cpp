#include "tests/apps/frame_window/opened.h"

using namespace frame;

Session opened(const std::string& file)
{
    Session session(starting_document());
    session.view.layout = Layout::Overlay;
    session.view.show = shown_by_default | ShowSet{Show::M};
    session.open(CREMONA_SOURCE_DIR "/" + file);
    return session;
}
