// carina-surface-reader: reads files of surfaces for a SurfaceReader, one after the other, so that
// a file which brings a format library down takes no more than this process with it.
//
// stdin and stdout hold messages: 64-bit little-endian length, then that many bytes. A message in
// is the path of a file, the message out is what encodeMeshFile makes of it. Ends with its stdin.

#include "engine/io/mesh/mesh_file.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/sync/wire/byte_buffer.h"

#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>

namespace
{

constexpr std::uint64_t kLongestPath = 4096;
constexpr rlim_t kMostMemory = rlim_t{4} << 30;

template <class Resource> void limit(Resource resource, rlim_t most)
{
    const rlimit limits{most, most};
    setrlimit(resource, &limits);
}

void limitThisProcess()
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    limit(RLIMIT_AS, kMostMemory);
#endif
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CORE, 0);
}

std::optional<std::string> nextPath()
{
    std::array<std::byte, sizeof(std::uint64_t)> header{};
    if (std::fread(header.data(), 1, header.size(), stdin) != header.size())
        return std::nullopt;
    const auto length = carina::ByteReader{header}.number<std::uint64_t>();
    if (length > kLongestPath)
        return std::nullopt;
    std::string path(length, '\0');
    if (std::fread(path.data(), 1, path.size(), stdin) != path.size())
        return std::nullopt;
    return path;
}

void answer(const std::vector<std::byte>& message)
{
    std::vector<std::byte> header;
    carina::ByteWriter{header}.number(static_cast<std::uint64_t>(message.size()));
    std::fwrite(header.data(), 1, header.size(), stdout);
    std::fwrite(message.data(), 1, message.size(), stdout);
    std::fflush(stdout);
}

} // namespace

int main()
{
    limitThisProcess();
    while (const auto path = nextPath())
        answer(carina::encodeMeshFile(carina::readMeshFile(*path)));
    return 0;
}
