#include "engine/tracking/record/pose_recorder.h"

#include "engine/tracking/record/pose_record.h"

#include <utility>

namespace carina
{
namespace
{

constexpr Duration kBetweenWrites = std::chrono::milliseconds{50};

} // namespace

Result<std::unique_ptr<PoseRecorder>> PoseRecorder::begin(const std::filesystem::path& file,
                                                          ReadSessionClock clock)
{
    std::unique_ptr<PoseRecorder> recorder{new PoseRecorder{file, std::move(clock)}};
    recorder->m_output << pose_record::beginning() << std::flush;
    if (!recorder->m_output)
        return fail(Errc::FileUnwritable, file.string());
    return recorder->m_thread.start().map([&] { return std::move(recorder); });
}

PoseRecorder::PoseRecorder(std::filesystem::path file, ReadSessionClock clock)
    : m_file{std::move(file)},
      m_output{m_file, std::ios::binary | std::ios::trunc},
      m_thread{std::move(clock), [this](SessionTime now) -> std::optional<SessionTime> {
                   write();
                   return now + kBetweenWrites;
               }}
{
}

PoseRecorder::~PoseRecorder()
{
    m_thread.stop();
    write();
}

void PoseRecorder::follow(const std::vector<TrackedTool>& tools, std::shared_ptr<const void> owner)
{
    write(); // the last of the tools before
    const std::lock_guard lock{m_mutex};
    m_followed.clear();
    for (const TrackedTool& tool : tools) {
        const auto newest = tool.history->newest();
        m_followed.push_back(
            {tool, tool.history->end(), newest ? std::optional{newest->time} : std::nullopt});
    }
    m_owner = std::move(owner);
}

void PoseRecorder::write()
{
    const std::lock_guard lock{m_mutex};
    if (m_hasFailed)
        return;
    for (Followed& followed : m_followed) {
        const RecordedTool named{followed.tool.name, followed.tool.role};
        const PoseHistory::Added added = followed.tool.history->since(followed.cursor);
        followed.cursor = added.cursor;
        for (const PoseSample& sample : added.samples) {
            if (followed.last && sample.time <= *followed.last)
                continue; // came late: a record goes on in time
            m_output << pose_record::line(named, sample);
            followed.last = sample.time;
            ++m_count;
        }
    }
    m_output.flush();
    m_hasFailed = !m_output;
}

} // namespace carina
