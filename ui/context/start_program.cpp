#include "ui/context/start_program.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

#include "ui/text/catalogue.h"

namespace ui {

namespace {

struct Closing {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closing>;

/// A file without a name that holds the text; null where the system gives none.
File nameless_file(const std::string& text)
{
    File file(std::tmpfile());
    if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() || std::fflush(file.get()) != 0)
        return nullptr;
    std::rewind(file.get());
    return file;
}

/// A session of its own, so that it outlives the terminal of this program; reads from the file.
class SpawnSettings {
public:
    explicit SpawnSettings(int input)
    {
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
        if (input != STDIN_FILENO) posix_spawn_file_actions_addclose(&actions, input);
    }
    ~SpawnSettings()
    {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;

    posix_spawnattr_t attributes{};
    posix_spawn_file_actions_t actions{};
};

Message not_started(const std::string& program, int error)
{
    return {translatable("{program} was not started: {reason}"),
            {{"program", program}, {"reason", std::generic_category().message(error)}}};
}

/// As the programs of the suite are called on disk, where names as common as `frame` are others' too.
std::filesystem::path file_of(const std::string& program, const std::filesystem::path& folder)
{
    return folder / ("cremona-" + program);
}

Message not_there(const std::filesystem::path& file, const std::filesystem::path& folder)
{
    return {translatable("the program {program} is not in {folder}, where this one is; install it there"),
            {{"program", file.filename().string()}, {"folder", folder.string()}}};
}

/// As C takes them: pointers into the words, which must outlive them.
std::vector<char*> pointers_to(std::vector<std::string>& words)
{
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

} // namespace

std::filesystem::path folder_of_programs()
{
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

std::optional<Message> start_program(const ExportToApp& exported, const std::filesystem::path& folder)
{
    const std::filesystem::path program = file_of(exported.program, folder);
    if (access(program.c_str(), X_OK) != 0) return not_there(program, folder);
    const File document = nameless_file(exported.document);
    if (!document) return not_started(exported.program, errno);
    std::vector<std::string> words{program.string(), "-"};
    words.insert(words.end(), exported.options.begin(), exported.options.end());
    const std::vector<char*> arguments = pointers_to(words);
    const SpawnSettings settings(fileno(document.get()));
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), &settings.actions, &settings.attributes, arguments.data(),
                                  environ);
    if (error != 0) return not_started(exported.program, error);
    std::thread([child] { waitpid(child, nullptr, 0); }).detach(); // else it stays in the table when it has ended
    return std::nullopt;
}

std::optional<Message> become_program(const std::string& program, const std::vector<std::string>& arguments,
                                      const std::filesystem::path& folder)
{
    const std::filesystem::path file = file_of(program, folder);
    if (access(file.c_str(), X_OK) != 0) return not_there(file, folder);
    std::vector<std::string> words{file.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    execv(file.c_str(), pointers_to(words).data());
    return not_started(program, errno);
}

} // namespace ui
