#pragma once

#include "models/tracker/pose_recording.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace carina
{

/// A button that begins and ends a recording of the tracker's poses, and cancels the writing of it
/// in another form; and beside it what is being recorded or written.
class RecordButton : public QWidget
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 500;

    /// @pre the recording outlives this.
    explicit RecordButton(PoseRecording& recording, QWidget* parent = nullptr);

    /// Begins a recording to this file. What goes wrong is said beside the button.
    void beginTo(const QString& file);

private:
    void press();
    void refresh();

    PoseRecording& m_recording;
    QPushButton* m_button;
    QLabel* m_text;
    QString m_problem;
};

} // namespace carina
