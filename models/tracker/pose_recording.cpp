#include "models/tracker/pose_recording.h"

#include "engine/core/expects.h"
#include "engine/io/files/unused_name.h"
#include "engine/net/devices/any_recording.h"

#include <QFileInfo>

namespace carina
{

constexpr double kReadingShare = 0.7; ///< of the writing in another form: the record is read first

PoseRecording::PoseRecording(ReadSessionClock clock) : m_clock{std::move(clock)}
{
    connect(&m_writing, &BackgroundWork::progressed, this, &PoseRecording::changed);
    connect(&m_writing, &BackgroundWork::finished, this, &PoseRecording::changed);
}

PoseRecording::~PoseRecording()
{
    end();
    m_writing.wait();
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
    CARINA_EXPECTS(!isBeingWritten());
    m_problem.reset();
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

void PoseRecording::end()
{
    if (!m_recorder)
        return;
    const std::filesystem::path record = m_recorder->file();
    m_recorder.reset(); // which writes the rest
    if (record != m_file)
        m_writing.start([this, record, file = m_file](const Progress& goesOn) {
            if (const auto written = write(record, file, goesOn); !written)
                m_problem = written.error();
        });
    Q_EMIT changed();
}

/// Writes a record in another form.
Result<void> PoseRecording::write(const std::filesystem::path& record,
                                  const std::filesystem::path& file, const Progress& goesOn)
{
    const auto sequence =
        readAnyRecording(record, [&goesOn](double share) { return goesOn(kReadingShare * share); });
    if (sequence)
        return writeAnyRecording(file, *sequence, [&goesOn](double share) {
            return goesOn(kReadingShare + (1.0 - kReadingShare) * share);
        });
    if (sequence.error().code == Errc::FileEmpty)
        return {}; // there was nothing to record
    return tl::unexpected(sequence.error());
}

QString PoseRecording::writingText() const
{
    return tr("Writing %1: %2 %")
        .arg(QFileInfo{QString::fromStdString(m_file.string())}.fileName())
        .arg(m_writing.percent());
}

QString PoseRecording::text() const
{
    if (isBeingWritten())
        return writingText();
    if (!m_recorder)
        return {};
    const QString name = QFileInfo{QString::fromStdString(m_recorder->file().string())}.fileName();
    return m_recorder->hasFailed()
               ? tr("▲ Nothing more can be written to %1: see that its disk has space.").arg(name)
               : tr("● Recording to %1, poses so far: %2").arg(name).arg(m_recorder->count());
}

} // namespace carina
