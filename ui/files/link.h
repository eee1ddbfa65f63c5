#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "ui/files/folder_lock.h"

namespace ui {

/// Two programs tell each other what their documents have, through a folder that is theirs alone:
///
///     giver   tells its document, makes the folder and takes it away at its end       FOLDER/giver
///     taker   was started with a copy of it                                           FOLDER/taker
///
/// What an end tells replaces what it told before, whole; the other finds it when it looks. An end that is killed
/// leaves nothing half-written, and the folder of a giver that was killed is taken away by the next one.
class Link {
public:
    enum class End : std::uint8_t { Giver, Taker };

    /// The giver's end, with a folder that only this user reads. \returns nothing where no folder can be made
    static std::optional<Link> made();
    /// The taker's end of a link whose folder the giver has made.
    explicit Link(std::filesystem::path folder) : Link(std::move(folder), End::Taker) {}
    Link(Link&& other) noexcept;
    Link& operator=(Link&& other) noexcept;
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;
    ~Link(); ///< a giver takes the folder away, a taker what it has told

    const std::filesystem::path& folder() const { return folder_; }
    /// Says what this end has. \returns what hindered it
    std::error_code notify(std::string_view text);
    /// What the other end has told since the last call; nothing where it told nothing new.
    std::optional<std::string> heard();
    bool is_withdrawn() const; ///< the other end has told something, and has ended since
    bool is_cut() const;       ///< the folder has gone: the other end will hear nothing

private:
    /// A file that is replaced whole is another one.
    struct Mark {
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        friend bool operator==(const Mark&, const Mark&) = default;
    };
    Link(std::filesystem::path folder, End end) : folder_(std::move(folder)), end_(end) {}
    void close();
    std::filesystem::path file_of_other() const;

    std::filesystem::path folder_;
    End end_;
    FolderLock lock_{}; ///< of a giver's folder
    std::optional<Mark> seen_;
    std::optional<std::string> last_; ///< that was heard
};

} // namespace ui
