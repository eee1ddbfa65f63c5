#include "femoop/io/any_model.h"

#include <utility>

#include "femoop/io/file_text.h"
#include "femoop/io/json/json_document.h"

namespace femoop {

AnyReading examine_any(std::string_view text)
{
    JsonReading json = parse_json(text);
    if (json.document && plane::is_plane_model(json.document->root()))
        return plane::examine_plane_model(json.document->root(), std::move(json.faults));
    return examine_model(std::move(json));
}

AnyReading examine_any_file(const std::filesystem::path& path)
{
    FileText file = file_text(path);
    if (file.fault) return ModelReading{{}, {*std::move(file.fault)}};
    return examine_any(file.text);
}

} // namespace femoop
