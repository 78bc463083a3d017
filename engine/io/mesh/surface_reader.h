#pragma once

#include "engine/core/result.h"
#include "engine/io/mesh/mesh_file.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <span>

class QDeadlineTimer;
class QProcess;

namespace carina
{

/// Reads surface files in a separate process, carina-surface-reader, which is confined (confine) to
/// the folder of the file and to a share of ReaderMemory. A file for which the share is too little
/// is read again with all of that memory. A file that crashes the process or exceeds a limit gives
/// an error that names the file; the next file gets a new process, as does a file of another
/// folder.
///
/// To be used in the thread that created it, which must be Qt's (QThread or the main thread).
class SurfaceReader
{
public:
    static constexpr std::chrono::seconds kLimitPerFile{60};

    explicit SurfaceReader(std::chrono::milliseconds limitPerFile = kLimitPerFile);
    /// One process for all files in and below a folder, which it may read all of: starting one for
    /// each of many folders takes longer than reading them.
    explicit SurfaceReader(std::filesystem::path folder,
                           std::chrono::milliseconds limitPerFile = kLimitPerFile);
    ~SurfaceReader();

    /// As readMeshFile. Also FileTooLarge where reading takes too much memory, FileMalformed where
    /// the process crashed, took too long or was ended because it asked for what a reader may not
    /// do; FileUnreadable where the process cannot be started, NotConfined where the system cannot
    /// confine it.
    [[nodiscard]] Result<MeshFile> read(const std::filesystem::path& file);

private:
    /// What the process said.
    struct AnswerBytes {
        std::unique_ptr<std::byte[]> bytes;
        std::size_t size = 0;
    };
    /// What came of one attempt.
    using Answer = Result<AnswerBytes>;

    Answer attempt(const std::filesystem::path& file, unsigned shares);
    Result<void> start(const std::filesystem::path& folder, unsigned shares);
    Answer answerTo(const std::filesystem::path& file);
    /// Waits until the process has said as much.
    Result<void> hear(std::span<std::byte> whole, const QDeadlineTimer& deadline);
    [[nodiscard]] Error whyItEnded() const;
    void stop();

    std::chrono::milliseconds m_limitPerFile;
    std::unique_ptr<QProcess> m_process;
    std::filesystem::path m_common;      ///< of all files; empty: that of each file
    std::filesystem::path m_folder;      ///< the process may read
    unsigned m_shares = 0;               ///< of ReaderMemory that the process has
    std::chrono::milliseconds m_spent{}; ///< in the process, with files before
};

} // namespace carina
