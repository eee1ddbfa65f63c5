#include "femoop/io/reader/place.h"

namespace femoop {

std::string Place::path() const
{
    if (outer_ == nullptr) return "";
    std::string text = outer_->path();
    if (index_) return text + '[' + std::to_string(*index_) + ']';
    return text + (text.empty() ? "" : ".") + std::string(key_);
}

std::string Place::text() const
{
    if (outer_ == nullptr) return "file";
    return path() + (id_.empty() ? "" : " \"" + std::string(id_) + '"');
}

std::string Place::text(std::string_view inner) const { return inner.empty() ? text() : key(inner).path(); }

} // namespace femoop
