#pragma once

#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/tracker.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>

namespace carina
{

/// Writes every sample of a tracker's tools to a record (pose_record) while it runs, on a thread of
/// its own. What has come is with the system twenty times a second: a program that is killed loses
/// less than a tenth of a second.
class PoseRecorder
{
public:
    /// A file that is there already is replaced.
    /// @param clock of the samples
    /// @returns FileUnwritable; TrackerFailed where there is no thread.
    [[nodiscard]] static Result<std::unique_ptr<PoseRecorder>>
    begin(const std::filesystem::path& file, ReadSessionClock clock);
    ~PoseRecorder();

    /// Records these tools from now on, from their next samples.
    /// @param owner of their histories, which is kept while they are recorded
    void follow(const std::vector<TrackedTool>& tools, std::shared_ptr<const void> owner);

    /// Samples written.
    [[nodiscard]] std::size_t count() const { return m_count; }
    /// Whether something could not be written, as on a full disk. Nothing more is written then.
    [[nodiscard]] bool hasFailed() const { return m_hasFailed; }
    [[nodiscard]] const std::filesystem::path& file() const { return m_file; }

private:
    struct Followed {
        TrackedTool tool;
        std::uint64_t cursor = 0;          ///< behind what is written
        std::optional<SessionTime> last{}; ///< written
    };

    PoseRecorder(std::filesystem::path file, ReadSessionClock clock);
    void write();

    std::filesystem::path m_file;
    std::mutex m_mutex;
    std::ofstream m_output;
    std::vector<Followed> m_followed;
    std::shared_ptr<const void> m_owner;
    std::atomic<std::size_t> m_count = 0;
    std::atomic<bool> m_hasFailed = false;
    DeliveryThread m_thread; // last: ends before what it uses
};

} // namespace carina
