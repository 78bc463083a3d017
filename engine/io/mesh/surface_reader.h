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

/// Reads surface files in a separate process, carina-surface-reader, which is limited to 4 GiB of
/// memory and cannot write files. A file that crashes the process or exceeds the time limit gives
/// an error that names the file; the next file gets a new process.
///
/// To be used in the thread that created it, which must be Qt's (QThread or the main thread).
class SurfaceReader
{
public:
    explicit SurfaceReader(std::chrono::milliseconds limitPerFile = std::chrono::seconds{60});
    ~SurfaceReader();

    /// As readMeshFile. Also FileMalformed where the process crashed or took too long, and
    /// FileUnreadable where the process cannot be started.
    [[nodiscard]] Result<MeshFile> read(const std::filesystem::path& file);

private:
    Result<void> start();
    Result<std::vector<std::byte>> answerTo(const std::filesystem::path& file);
    void stop();

    std::chrono::milliseconds m_limitPerFile;
    std::unique_ptr<QProcess> m_process;
};

} // namespace carina
