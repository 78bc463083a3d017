#include "ui/tracker/record_button.h"

#include "models/errors/error_text.h"
#include "widgets/plain_label.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTimer>

namespace carina
{

RecordButton::RecordButton(PoseRecording& recording, QWidget* parent)
    : QWidget{parent}, m_recording{recording}, m_button{new QPushButton}, m_text{new PlainLabel}
{
    m_button->setObjectName(QStringLiteral("record"));
    m_button->setAutoDefault(false);
    m_text->setObjectName(QStringLiteral("recording"));
    m_text->setAccessibleName(tr("What is being recorded"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    setFocusProxy(m_button);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins({});
    row->addWidget(m_button);
    row->addWidget(m_text, 1);
    connect(m_button, &QPushButton::clicked, this, &RecordButton::press);
    connect(&m_recording, &PoseRecording::changed, this, &RecordButton::refresh);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &RecordButton::refresh);
    timer->start(kInterval_ms);
    refresh();
}

void RecordButton::press()
{
    if (m_recording.isBeingWritten())
        return m_recording.cancel();
    if (m_recording.isUnderWay())
        return m_recording.end();
    const QString file = QFileDialog::getSaveFileName(
        this, tr("Record the poses of the tracker's tools"), QStringLiteral("poses.csv"),
        tr("Carina's record (*.csv);;Sequence of Plus and 3D Slicer (*.igs.mha);;"
           "Trajectories in TUM form (*.tum)"));
    if (!file.isEmpty())
        beginTo(file);
}

void RecordButton::beginTo(const QString& file)
{
    const auto begun = m_recording.begin(file);
    m_problem = begun ? QString{} : errorText(begun.error());
    refresh();
}

void RecordButton::refresh()
{
    const bool isWriting = m_recording.isBeingWritten();
    m_button->setText(isWriting                  ? tr("&Cancel the writing")
                      : m_recording.isUnderWay() ? tr("End the re&cording")
                                                 : tr("Re&cord the poses…"));
    m_button->setEnabled(isWriting || m_recording.isUnderWay() || m_recording.hasTools());
    if (isWriting || m_recording.isUnderWay() || !m_problem.isEmpty())
        return m_text->setText(m_problem.isEmpty() ? m_recording.text() : m_problem);
    m_text->setText(m_recording.problem() ? errorText(*m_recording.problem()) : QString{});
}

} // namespace carina
