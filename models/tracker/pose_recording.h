#pragma once

#include "engine/tracking/record/pose_recorder.h"
#include "models/tracker/background_work.h"

#include <QObject>
#include <QString>

#include <memory>

namespace carina
{

/// Records the poses of a program's tracker from one moment to another. While it lasts everything
/// goes to Carina's own record (pose_record), which is whole up to the last tenth of a second
/// whatever happens to the program; at its end it is written in the form that was asked for, too,
/// on a thread of its own.
class PoseRecording : public QObject
{
    Q_OBJECT

public:
    /// @param clock of the tracker's samples
    explicit PoseRecording(ReadSessionClock clock);
    /// Ends it, and waits until it is written.
    ~PoseRecording() override;

    /// The tools to be recorded from now on, also in a recording that is under way.
    /// @param owner of their histories
    void follow(std::vector<TrackedTool> tools, std::shared_ptr<const void> owner);
    [[nodiscard]] bool hasTools() const { return !m_tools.empty(); }

    /// Begins a recording. @pre none is being written. The record is this file, which is replaced,
    /// where its extension is .csv; else a new file beside it with .csv behind the name.
    /// @returns UnknownFormat for an extension that no recording has; FileUnwritable;
    /// TrackerFailed.
    [[nodiscard]] Result<void> begin(const QString& file);
    /// Ends it. Where another form was asked for than the record, that is written from now on.
    void end();
    /// Ends the writing of the other form, which is then not there; the record is kept.
    void cancel() { m_writing.cancel(); }

    [[nodiscard]] bool isUnderWay() const { return m_recorder != nullptr; }
    [[nodiscard]] bool isBeingWritten() const { return m_writing.isUnderWay(); }
    /// What kept the last one from being written in the other form; Cancelled where that was asked.
    [[nodiscard]] const std::optional<Error>& problem() const { return m_problem; }
    /// What is recorded or written, as a sentence: how much, and where; empty while nothing is.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] static Result<void> write(const std::filesystem::path& record,
                                            const std::filesystem::path& file,
                                            const Progress& goesOn);
    [[nodiscard]] QString writingText() const;

    ReadSessionClock m_clock;
    std::vector<TrackedTool> m_tools;
    std::shared_ptr<const void> m_owner;
    std::filesystem::path m_file; ///< that was asked for
    std::unique_ptr<PoseRecorder> m_recorder;
    std::optional<Error> m_problem; ///< of the writing, whose thread sets it
    BackgroundWork m_writing;       ///< last: ends before what it uses
};

} // namespace carina
