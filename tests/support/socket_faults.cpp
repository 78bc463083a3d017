#include "tests/support/socket_faults.h"

#include <atomic>
#include <cerrno>
#include <dlfcn.h>
#include <sys/socket.h>
#include <unistd.h>

namespace carina::test::socket_faults
{
namespace
{

std::atomic<Of> s_of{Of::Datagrams};
std::atomic<int> s_first{0};
std::atomic<int> s_last{0};
std::atomic<int> s_error{0};
std::atomic<int> s_calls{0};
std::atomic<int> s_struck{0};

bool counts(int file)
{
    int type = 0;
    int domain = 0;
    socklen_t length = sizeof type;
    if (getsockopt(file, SOL_SOCKET, SO_TYPE, &type, &length) != 0
        || getsockopt(file, SOL_SOCKET, SO_DOMAIN, &domain, &length) != 0)
        return false; // a file, or a pipe
    return (domain == AF_INET || domain == AF_INET6)
           && type == (s_of == Of::Datagrams ? SOCK_DGRAM : SOCK_STREAM);
}

bool strikes(int file)
{
    const int before = errno;
    const bool isOne = counts(file);
    errno = before;
    if (!isOne)
        return false;
    const int number = ++s_calls;
    if (number < s_first || number > s_last)
        return false;
    ++s_struck;
    errno = s_error;
    return true;
}

template <class Function> Function* next(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

void begin(const Plan& plan)
{
    s_of = plan.of;
    s_first = plan.first == 0 ? 1 : plan.first;
    s_last = plan.first == 0 ? 0 : plan.first + plan.calls - 1;
    s_error = plan.error;
    s_calls = 0;
    s_struck = 0;
}

int calls() { return s_calls; }
int struck() { return s_struck; }

} // namespace carina::test::socket_faults

extern "C" {

ssize_t sendmsg(int socket, const msghdr* message, int flags)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, const msghdr*, int)>("sendmsg");
    return carina::test::socket_faults::strikes(socket) ? -1 : call(socket, message, flags);
}

ssize_t recvmsg(int socket, msghdr* message, int flags)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, msghdr*, int)>("recvmsg");
    return carina::test::socket_faults::strikes(socket) ? -1 : call(socket, message, flags);
}

ssize_t write(int file, const void* bytes, std::size_t count)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, const void*, std::size_t)>("write");
    return carina::test::socket_faults::strikes(file) ? -1 : call(file, bytes, count);
}

ssize_t read(int file, void* bytes, std::size_t count)
{
    static const auto call =
        carina::test::socket_faults::next<ssize_t(int, void*, std::size_t)>("read");
    return carina::test::socket_faults::strikes(file) ? -1 : call(file, bytes, count);
}
}
