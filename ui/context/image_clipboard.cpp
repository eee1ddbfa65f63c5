#include "ui/context/image_clipboard.h"

#include <array>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "ui/text/catalogue.h"

namespace ui {

namespace {

/// Reads from the file, and writes and complains to nobody: xclip stays behind to hand the picture out.
class Surroundings {
public:
    explicit Surroundings(const std::filesystem::path& input)
    {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, input.c_str(), O_RDONLY, 0);
        for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
            posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_WRONLY, 0);
    }
    ~Surroundings() { posix_spawn_file_actions_destroy(&actions_); }
    Surroundings(const Surroundings&) = delete;
    Surroundings& operator=(const Surroundings&) = delete;

    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

} // namespace

std::optional<Message> copy_png(const std::filesystem::path& png)
{
    std::array<std::string, 6> words{"xclip", "-selection", "clipboard", "-t", "image/png", "-i"};
    std::array<char*, 7> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
    const Surroundings surroundings(png);
    pid_t child = 0;
    if (posix_spawnp(&child, arguments[0], surroundings.get(), nullptr, arguments.data(), environ) != 0)
        return Message(translatable("the picture was not copied: the program xclip is missing; install it"));
    int status = 0;
    if (waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
    return Message(translatable("the picture was not copied: there is no clipboard to be reached"));
}

} // namespace ui
