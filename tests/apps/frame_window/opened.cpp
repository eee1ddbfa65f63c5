#include "tests/apps/frame_window/opened.h"
#include "tests/source_folder.h"

using namespace frame;

Session opened(const std::string& file)
{
    Session session(starting_document());
    session.view.layout = Layout::Overlay;
    session.view.show = shown_by_default | ShowSet{Show::M};
    session.open(source_folder() + "/" + file);
    return session;
}
