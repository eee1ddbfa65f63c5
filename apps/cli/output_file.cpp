#include "apps/cli/output_file.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "apps/cli/console.h"

namespace cli {

namespace {

namespace fs = std::filesystem;

UsageError cannot_write(const fs::path& path, const std::string& reason, const ui::Catalogue& tr)
{
    return UsageError(tr("cannot write {file}: {reason}", {{"file", path.string()}, {"reason", reason}}));
}

std::string last_reason(const ui::Catalogue& tr) { return tr(std::generic_category().message(errno)); }

} // namespace

void require_writable(const fs::path& path, const ui::Catalogue& tr)
{
    std::error_code error;
    if (path.empty() || !path.has_filename()) throw cannot_write(path, tr("it names no file"), tr);
    if (fs::is_directory(path, error)) throw cannot_write(path, tr("it is a folder; add a file name"), tr);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        throw cannot_write(path, tr("there is no folder {folder}; make it first", {{"folder", folder.string()}}), tr);
}

void write_file(const fs::path& path, std::string_view text, const ui::Catalogue& tr)
{
    require_writable(path, tr);
    std::error_code error;
    const bool is_special = fs::exists(path, error) && !fs::is_regular_file(path, error); // /dev/stdout, a pipe
    const fs::path written = is_special ? path : fs::path(path.string() + ".part");
    errno = 0;
    std::ofstream out(written, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) {
        const std::string reason = last_reason(tr);
        if (!is_special) fs::remove(written, error);
        throw cannot_write(path, reason, tr);
    }
    if (is_special) return;
    fs::rename(written, path, error);
    if (!error) return;
    const std::string reason = tr(error.message());
    fs::remove(written, error);
    throw cannot_write(path, reason, tr);
}

void make_folder(const fs::path& folder, const ui::Catalogue& tr)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
        throw UsageError(
            tr("cannot make the folder {folder}: a file of that name stands there, or there is no permission",
               {{"folder", folder.string()}}));
}

} // namespace cli
