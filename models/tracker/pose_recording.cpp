#include "models/tracker/pose_recording.h"

#include "engine/io/files/unused_name.h"
#include "engine/net/devices/any_recording.h"

#include <QFileInfo>

namespace carina
{

PoseRecording::PoseRecording(ReadSessionClock clock) : m_clock{std::move(clock)} {}

PoseRecording::~PoseRecording()
{
    static_cast<void>(end()); // the record itself is written, whatever becomes of another form
}

void PoseRecording::follow(std::vector<TrackedTool> tools, std::shared_ptr<const void> owner)
{
    if (m_recorder)
        m_recorder->follow(tools, owner);
    m_tools = std::move(tools);
    m_owner = std::move(owner);
    Q_EMIT changed();
}

Result<void> PoseRecording::begin(const QString& file)
{
    const std::filesystem::path asked = file.toStdString();
    if (!canWriteRecording(asked))
        return fail(Errc::UnknownFormat, asked.string());
    std::filesystem::path record = asked;
    if (asked.extension() != ".csv")
        record = unusedName(record += ".csv"); // nobody was asked for this name
    auto begun = PoseRecorder::begin(record, m_clock);
    if (!begun)
        return tl::unexpected(begun.error());
    m_file = asked;
    m_recorder = *std::move(begun);
    m_recorder->follow(m_tools, m_owner);
    Q_EMIT changed();
    return {};
}

Result<void> PoseRecording::end()
{
    if (!m_recorder)
        return {};
    const std::filesystem::path record = m_recorder->file();
    m_recorder.reset(); // which writes the rest
    Q_EMIT changed();
    if (record == m_file)
        return {};
    const auto sequence = readAnyRecording(record);
    if (sequence)
        return writeAnyRecording(m_file, *sequence);
    if (sequence.error().code == Errc::FileEmpty)
        return {}; // there was nothing to record
    return tl::unexpected(sequence.error());
}

QString PoseRecording::text() const
{
    if (!m_recorder)
        return {};
    const QString name = QFileInfo{QString::fromStdString(m_recorder->file().string())}.fileName();
    return m_recorder->hasFailed()
               ? tr("▲ Nothing more can be written to %1: see that its disk has space.").arg(name)
               : tr("● Recording to %1, poses so far: %2").arg(name).arg(m_recorder->count());
}

} // namespace carina
