// carina-surface-reader: reads files of surfaces for a SurfaceReader, one after the other, so that
// a file which brings a format library down, or takes it over, has no more than this process.
//
//     carina-surface-reader FOLDER MEMORY SECONDS PARENT
//
// FOLDER is the only one it may read files of, MEMORY how many bytes of address space it may take,
// SECONDS how much processor time, PARENT the process that started it and that it ends with.
//
// stdin and stdout hold messages: 64-bit little-endian length, then that many bytes. A message in
// is the path of a file, the message out is what encodeMeshFile makes of it. Ends with its stdin,
// and with one of the codes in surface_reader_exit.h.

#include "engine/core/byte_buffer.h"
#include "engine/io/files/confinement.h"
#include "engine/io/mesh/mesh_file.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/io/mesh/surface_reader_exit.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <string_view>

namespace
{

constexpr std::uint64_t kLongestPath = 4096;
constexpr int kArguments = 5;

/// Of the C++ library whenever memory runs out. Libraries would catch an exception and call the
/// file damaged.
[[noreturn]] void endWithoutMemory() { std::_Exit(carina::reader_exit::kOutOfMemory); }

template <class Number> std::optional<Number> numberIn(std::string_view text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

std::optional<carina::Confinement> confinementIn(int count, char** words)
{
    if (count != kArguments)
        return std::nullopt;
    const auto memory = numberIn<std::uint64_t>(words[2]);
    const auto seconds = numberIn<int>(words[3]);
    const auto parent = numberIn<int>(words[4]);
    if (!memory || !seconds || !parent)
        return std::nullopt;
    return carina::Confinement{*parent, words[1], *memory, std::chrono::seconds{*seconds}};
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

int main(int count, char** words)
{
    std::set_new_handler(&endWithoutMemory);
    const auto confinement = confinementIn(count, words);
    if (!confinement)
        return carina::reader_exit::kWrongArguments;
    if (!carina::confine(*confinement))
        return carina::reader_exit::kNotConfined;
    while (const auto path = nextPath())
        answer(carina::encodeMeshFile(carina::readMeshFile(*path)));
    return 0;
}
