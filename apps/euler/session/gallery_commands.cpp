#include "apps/euler/session/gallery_commands.h"

#include <string>
#include <vector>

#include "apps/euler/document/gallery/gallery.h"

namespace euler {

using ui::translatable;

namespace {

std::vector<std::string> made_ids()
{
    std::vector<std::string> ids;
    for (const GalleryItem& item : gallery()) ids.push_back("gallery." + std::string(item.name));
    return ids;
}

} // namespace

std::span<const std::string> gallery_command_ids()
{
    static const std::vector<std::string> ids = made_ids(); // commands refer to them
    return ids;
}

void add_gallery_commands(CommandTable& table)
{
    ui::MenuBuilder<Workspace> menu(table, translatable("Gallery"));
    const std::vector<GalleryItem> items = gallery();
    for (std::size_t i = 0; i < items.size(); ++i)
        menu.step({gallery_command_ids()[i], items[i].title}, [script = items[i].script](Workspace& workspace) {
            workspace.leave_document([script](Workspace& left) {
                left.session.show(Stepper(script));
                left.topic = Topic::Script;
            });
        });
}

} // namespace euler
