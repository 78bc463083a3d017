#include "engine/io/files/folder_rule.h"

#include "engine/io/files/confinement.h"

#include <array>
#include <cstddef>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace carina
{
namespace
{

constexpr std::uint64_t kReading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

/// How many of the rights of landlock(7), in their order, a version of it knows.
std::uint64_t rightsOf(long version)
{
    constexpr std::array kCounts{13, 14, 15, 15, 16}; // versions 1 to 5
    const auto known = std::size_t(std::min(version, long{kCounts.size()}));
    return (std::uint64_t{1} << kCounts[known - 1]) - 1;
}

long landlockVersion()
{
    return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

/// Closes a descriptor on destruction.
class Descriptor
{
public:
    explicit Descriptor(long number) : m_number{static_cast<int>(number)} {}
    ~Descriptor()
    {
        if (m_number >= 0)
            close(m_number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return m_number; }

private:
    int m_number;
};

} // namespace

bool hasLandlock() { return landlockVersion() > 0; }

bool keepToFolder(const std::filesystem::path& folder)
{
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = rightsOf(landlockVersion());
    const Descriptor rules{syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0)};
    const Descriptor opened{open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)};
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = kReading;
    beneath.parent_fd = opened.number();
    return rules.number() >= 0 && opened.number() >= 0
           && syscall(SYS_landlock_add_rule, rules.number(), LANDLOCK_RULE_PATH_BENEATH, &beneath,
                      0)
                  == 0
           && syscall(SYS_landlock_restrict_self, rules.number(), 0) == 0;
}

} // namespace carina
