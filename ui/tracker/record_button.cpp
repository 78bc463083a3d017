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
    if (m_recording.isUnderWay())
        return end();
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

void RecordButton::end()
{
    const auto ended = m_recording.end();
    m_problem = ended ? QString{} : errorText(ended.error());
    refresh();
}

void RecordButton::refresh()
{
    m_button->setText(m_recording.isUnderWay() ? tr("End the r&ecording")
                                               : tr("R&ecord the poses…"));
    m_button->setEnabled(m_recording.isUnderWay() || m_recording.hasTools());
    m_text->setText(m_problem.isEmpty() ? m_recording.text() : m_problem);
}

} // namespace carina
