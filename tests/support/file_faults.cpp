// A library for LD_PRELOAD that makes one call of a program fail as a failing disk does: the
// CARINA_FAULT_AT-th, from 1, of those that write or sync a file below the folder CARINA_FAULT_IN.
// CARINA_FAULT_KIND says how: "once" with ENOSPC or EIO, "lasting" with every later call too,
// "short" with half of what was to be written, "killed" with SIGKILL in place of the call. What was
// struck is told on stderr as "fault: NAME".

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <unistd.h>

namespace
{

std::string variable(const char* name)
{
    const char* value = getenv(name);
    return value ? value : "";
}

struct Fault {
    std::string folder = variable("CARINA_FAULT_IN");
    std::string kind = variable("CARINA_FAULT_KIND");
    int at = std::atoi(variable("CARINA_FAULT_AT").c_str());
    std::atomic<int> calls{0};

    /// Whether this call on a file is struck.
    bool strikes(std::string_view file, const char* call)
    {
        if (folder.empty() || !file.starts_with(folder))
            return false;
        const int number = ++calls;
        if (number != at && !(kind == "lasting" && number > at))
            return false;
        std::fprintf(stderr, "fault: %s\n", call);
        if (kind == "killed")
            raise(SIGKILL);
        return true;
    }
    bool strikes(int file, const char* call)
    {
        std::array<char, 32> link{};
        std::array<char, 4096> path{};
        std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
        const ssize_t length = readlink(link.data(), path.data(), path.size());
        return length > 0 && strikes({path.data(), std::size_t(length)}, call);
    }
};

Fault& fault()
{
    static Fault only;
    return only;
}

template <class Function> Function* next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int failing(int code)
{
    errno = code;
    return -1;
}

template <class... Place>
ssize_t faultyWrite(const char* name, int file, const void* bytes, std::size_t count,
                    Place... place)
{
    const auto call = next<ssize_t(int, const void*, std::size_t, Place...)>(name);
    if (file <= STDERR_FILENO || !fault().strikes(file, name))
        return call(file, bytes, count, place...);
    if (fault().kind == "short")
        return call(file, bytes, std::max(count / 2, std::size_t{1}), place...);
    return failing(ENOSPC);
}

int faultySync(const char* name, int file)
{
    if (fault().strikes(file, name))
        return failing(EIO);
    return next<int(int)>(name)(file);
}

int faultyTruncate(const char* name, int file, off_t size)
{
    if (fault().strikes(file, name))
        return failing(EIO);
    return next<int(int, off_t)>(name)(file, size);
}

} // namespace

extern "C" {

ssize_t write(int file, const void* bytes, std::size_t count)
{
    return faultyWrite("write", file, bytes, count);
}
ssize_t pwrite(int file, const void* bytes, std::size_t count, off_t at)
{
    return faultyWrite("pwrite", file, bytes, count, at);
}
ssize_t pwrite64(int file, const void* bytes, std::size_t count, off_t at)
{
    return faultyWrite("pwrite64", file, bytes, count, at);
}
int fsync(int file) { return faultySync("fsync", file); }
int fdatasync(int file) { return faultySync("fdatasync", file); }
int ftruncate(int file, off_t size) noexcept { return faultyTruncate("ftruncate", file, size); }
int ftruncate64(int file, off_t size) noexcept { return faultyTruncate("ftruncate64", file, size); }
int rename(const char* from, const char* to) noexcept
{
    if (fault().strikes(to, "rename"))
        return failing(EIO);
    return next<int(const char*, const char*)>("rename")(from, to);
}
}
