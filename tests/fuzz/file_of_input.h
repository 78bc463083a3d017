#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace carina::fuzz
{

/// A folder of this run's own, which goes with it.
class OwnFolder
{
public:
    OwnFolder()
        : m_path{std::filesystem::temp_directory_path()
                 / ("carina-fuzz-" + std::to_string(::getpid()))}
    {
        std::filesystem::create_directories(m_path);
    }
    ~OwnFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    /// A file in it with these bytes.
    [[nodiscard]] std::filesystem::path holding(const char* name, const void* bytes,
                                                std::size_t size) const
    {
        const std::filesystem::path file = m_path / name;
        std::ofstream{file, std::ios::binary}.write(static_cast<const char*>(bytes),
                                                    std::streamsize(size));
        return file;
    }

private:
    std::filesystem::path m_path;
};

} // namespace carina::fuzz
