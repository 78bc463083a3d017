// carina_confined FOLDER MEMORY SECONDS PARENT DEED ARGUMENT: confines itself as the reader of
// surfaces does, writes "confined", does the deed and writes "denied" or "done". PARENT 0 stands
// for the process that started it.

#include "engine/io/files/confinement.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <map>
#include <string>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace
{

constexpr int kArguments = 7;
constexpr std::size_t kIoUringParameters = 120; ///< bytes of struct io_uring_params
constexpr std::size_t kCloneArguments = 8;      ///< words of the first struct clone_args

void say(const std::string& word)
{
    const std::string line = word + '\n';
    if (write(STDOUT_FILENO, line.data(), line.size()) < 0)
        std::_Exit(1);
}

bool opens(const char* file, int how) { return open(file, how, 0600) >= 0; }

/// Computes until it is ended.
[[noreturn]] void compute()
{
    for (std::atomic<unsigned> turns{0};;)
        ++turns;
}

/// Starts one that confines itself to this process as its parent and computes for ever, and waits.
bool haveAChild(const carina::Confinement& like)
{
    carina::Confinement confinement = like;
    confinement.parent = getpid();
    if (fork() == 0) {
        say(carina::confine(confinement) ? "child" : "not confined");
        compute();
    }
    close(STDOUT_FILENO);
    pause();
    return true;
}

bool opensMany(const char* file)
{
    constexpr int kMany = 64;
    for (int i = 0; i < kMany; ++i)
        if (!opens(file, O_RDONLY))
            return false;
    return true;
}

/// Whether a deed succeeds.
using Deed = std::function<bool(const char* argument)>;

const std::map<std::string, Deed>& deeds()
{
    static const std::map<std::string, Deed> kDeeds{
        {"nothing", [](const char*) { return true; }},
        {"socket", [](const char*) { return socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
        {"local-socket", [](const char*) { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
        {"io-uring",
         [](const char*) {
             std::array<std::byte, kIoUringParameters> none{};
             return syscall(SYS_io_uring_setup, 1, none.data()) >= 0;
         }},
        {"fork", [](const char*) { return fork() >= 0; }},
        {"clone3",
         [](const char*) {
             std::array<std::uint64_t, kCloneArguments> none{};
             return syscall(SYS_clone3, none.data(), sizeof none) >= 0;
         }},
        {"run", [](const char*) { return execl("/bin/true", "true", nullptr) == 0; }},
        {"kill", [](const char*) { return kill(getppid(), 0) == 0; }},
        {"trace", [](const char*) { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }},
        {"read", [](const char* file) { return opens(file, O_RDONLY); }},
        {"read-many", &opensMany},
        {"write", [](const char* file) { return opens(file, O_WRONLY); }},
        {"create", [](const char* file) { return opens(file, O_RDWR | O_CREAT); }},
        {"remove", [](const char* file) { return unlink(file) == 0; }},
        {"link", [](const char* file) { return symlink("/etc", file) == 0; }},
        {"permissions", [](const char* file) { return chmod(file, 0777) == 0; }},
        {"inherited",
         [](const char* number) {
             std::array<char, 1> byte{};
             return read(std::atoi(number), byte.data(), byte.size()) >= 0;
         }},
        {"code",
         [](const char*) {
             return mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                    != MAP_FAILED;
         }},
        {"memory",
         [](const char* bytes) {
             void* const memory = std::malloc(std::strtoull(bytes, nullptr, 10));
             const bool given = memory != nullptr;
             std::free(memory);
             return given;
         }},
        {"more-memory",
         [](const char*) {
             const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
             return setrlimit(RLIMIT_AS, &none) == 0;
         }},
        {"compute", [](const char*) -> bool { compute(); }},
        {"abort", [](const char*) -> bool { std::abort(); }},
    };
    return kDeeds;
}

} // namespace

int main(int count, char** words)
{
    if (count != kArguments)
        return 2;
    const int parent = std::atoi(words[4]);
    const carina::Confinement confinement{parent == 0 ? getppid() : parent, words[1],
                                          std::strtoull(words[2], nullptr, 10),
                                          std::chrono::seconds{std::atoi(words[3])}};
    if (std::string{words[5]} == "child")
        return haveAChild(confinement) ? 0 : 1;
    const auto deed = deeds().find(words[5]);
    if (deed == deeds().end())
        return 2;
    if (const auto confined = carina::confine(confinement); !confined) {
        say(confined.error().detail);
        return 3;
    }
    say("confined");
    say(deed->second(words[6]) ? "done" : "denied");
    return 0;
}
