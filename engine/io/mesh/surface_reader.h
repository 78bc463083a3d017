#pragma once

#include "engine/core/result.h"
#include "engine/io/mesh/mesh_file.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

class QProcess;

namespace carina
{

/// Reads files of surfaces in a process of their own, carina-surface-reader, which may take 4 GiB
/// and write nothing. A file that brings the process down, or holds it longer than the limit, is an
/// error that names the file; the next file gets a new process.
///
/// Belongs to the thread it is made in, which must be Qt's (QThread or the main thread).
class SurfaceReader
{
public:
    explicit SurfaceReader(std::chrono::milliseconds limitPerFile = std::chrono::seconds{60});
    ~SurfaceReader();

    /// As readMeshFile. Also FileMalformed when the process died of the file or took too long, and
    /// FileUnreadable when there is no such process to start.
    [[nodiscard]] Result<MeshFile> read(const std::filesystem::path& file);

private:
    Result<void> start();
    Result<std::vector<std::byte>> answerTo(const std::filesystem::path& file);
    void stop();

    std::chrono::milliseconds m_limitPerFile;
    std::unique_ptr<QProcess> m_process;
};

} // namespace carina
