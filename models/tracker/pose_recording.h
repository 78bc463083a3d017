#pragma once

#include "engine/tracking/record/pose_recorder.h"

#include <QObject>
#include <QString>

#include <memory>

namespace carina
{

/// Records the poses of a program's tracker from one moment to another. While it lasts everything
/// goes to Carina's own record (pose_record), which is whole up to the last tenth of a second
/// whatever happens to the program; at its end it is written in the form that was asked for, too.
class PoseRecording : public QObject
{
    Q_OBJECT

public:
    /// @param clock of the tracker's samples
    explicit PoseRecording(ReadSessionClock clock);
    ~PoseRecording() override;

    /// The tools to be recorded from now on, also in a recording that is under way.
    /// @param owner of their histories
    void follow(std::vector<TrackedTool> tools, std::shared_ptr<const void> owner);
    [[nodiscard]] bool hasTools() const { return !m_tools.empty(); }

    /// Begins a recording. The record is this file, which is replaced, where its extension is .csv;
    /// else a new file beside it with .csv behind the name.
    /// @returns UnknownFormat for an extension that no recording has; FileUnwritable;
    /// TrackerFailed.
    [[nodiscard]] Result<void> begin(const QString& file);
    /// Ends it. @returns the errors of writing it in another form; the record is kept.
    [[nodiscard]] Result<void> end();

    [[nodiscard]] bool isUnderWay() const { return m_recorder != nullptr; }
    /// What is recorded, as a sentence: how much, and where; empty while nothing is.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    void changed();

private:
    ReadSessionClock m_clock;
    std::vector<TrackedTool> m_tools;
    std::shared_ptr<const void> m_owner;
    std::filesystem::path m_file; ///< that was asked for
    std::unique_ptr<PoseRecorder> m_recorder;
};

} // namespace carina
