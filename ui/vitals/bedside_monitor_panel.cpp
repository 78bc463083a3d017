#include "ui/vitals/bedside_monitor_panel.h"

#include "models/vitals/vital_words.h"
#include "ui/vitals/sound_controls.h"
#include "widgets/plain_label.h"
#include "widgets/vitals/bedside_monitor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

BedsideMonitor::Urgency urgencyOf(AlarmPriority priority)
{
    switch (priority) {
    case AlarmPriority::High:
        return BedsideMonitor::Urgency::High;
    case AlarmPriority::Medium:
        return BedsideMonitor::Urgency::Medium;
    case AlarmPriority::Low:
        break;
    }
    return BedsideMonitor::Urgency::Low;
}

} // namespace

BedsideMonitorPanel::BedsideMonitorPanel(QWidget* parent)
    : QWidget{parent},
      m_monitor{new BedsideMonitor},
      m_silence{new QPushButton},
      m_mute{new QToolButton},
      m_volumes{new QToolButton},
      m_heard{new PlainLabel},
      m_obstacle{new PlainLabel},
      m_sounds{new SoundControls}
{
    auto* column = new QVBoxLayout{this};
    column->addWidget(m_monitor, 1);
    addControls();
    auto* row = new QHBoxLayout;
    row->addWidget(m_silence);
    row->addWidget(m_mute);
    row->addWidget(m_volumes);
    row->addStretch();
    column->addWidget(m_heard);
    column->addLayout(row);
    column->addWidget(m_sounds);
    column->addWidget(m_obstacle);
}

void BedsideMonitorPanel::addControls()
{
    m_silence->setObjectName(QStringLiteral("silence"));
    m_silence->setProperty("isLow", true);
    m_silence->setText(tr("Silence alarms"));
    m_silence->setAccessibleName(tr("Silence the alarms for two minutes"));
    m_silence->setToolTip(tr("For two minutes, or until another alarm begins or one becomes more "
                             "urgent; they stay on the screen"));
    m_mute->setObjectName(QStringLiteral("mute"));
    m_mute->setText(tr("Mute"));
    m_mute->setCheckable(true);
    m_mute->setAccessibleName(tr("Mute all sounds of this program"));
    m_mute->setToolTip(tr("Mutes all sounds of this program, until it is pressed again; their "
                          "marks stay on the screen"));
    m_volumes->setObjectName(QStringLiteral("volumes"));
    m_volumes->setText(tr("Volumes"));
    m_volumes->setCheckable(true);
    m_volumes->setAccessibleName(tr("Show the volume of each sound"));
    m_volumes->setToolTip(tr("Which sounds are played, and how loud"));
    m_heard->setObjectName(QStringLiteral("heard"));
    m_heard->setAccessibleName(tr("What the stethoscope hears"));
    m_heard->setToolTip(tr("Hold the stylus's tip to the chest, over a lung, the heart, the "
                           "stomach, or the trachea"));
    m_heard->setWordWrap(true);
    m_obstacle->setObjectName(QStringLiteral("noSound"));
    m_obstacle->setAccessibleName(tr("Why no sound is played"));
    m_obstacle->setWordWrap(true);
    m_obstacle->hide();
    m_sounds->hide();
    connect(m_volumes, &QToolButton::toggled, m_sounds, &QWidget::setVisible);
    connect(m_mute, &QToolButton::toggled, this, &BedsideMonitorPanel::muteAll);
    connect(m_silence, &QPushButton::clicked, this, [this] { m_model->silenceAlarms(); });
}

void BedsideMonitorPanel::setModel(VitalsModel& model, const SoundOutput& output)
{
    m_model = &model;
    m_output = &output;
    m_sounds->setModel(model);
    connect(&model, &VitalsModel::sampled, this, &BedsideMonitorPanel::draw);
    connect(&model, &VitalsModel::startedAfresh, m_monitor, &BedsideMonitor::clear);
    connect(&model, &VitalsModel::changed, this, &BedsideMonitorPanel::refresh);
    connect(&output, &SoundOutput::changed, this, &BedsideMonitorPanel::refresh);
    refresh();
}

void BedsideMonitorPanel::draw(const VitalsModel::Sample& sample)
{
    m_monitor->add(
        {sample.time_s, sample.electrocardiogram_mV, sample.pulse, sample.exhaledCO2_mmHg});
}

void BedsideMonitorPanel::refresh()
{
    showNumbers();
    showAlarms();
    showSound();
}

void BedsideMonitorPanel::showNumbers()
{
    const VitalsModel::Numbers& numbers = m_model->numbers();
    BedsideMonitor::Numbers shown{numbers.heartRate_perMin, numbers.saturation_percent,
                                  numbers.endTidalCO2_mmHg, numbers.respiratoryRate_perMin};
    if (numbers.pressure)
        shown.pressure = BedsideMonitor::BloodPressure{numbers.pressure->systolic_mmHg,
                                                       numbers.pressure->diastolic_mmHg,
                                                       numbers.pressure->mean_mmHg};
    m_monitor->setNumbers(shown);
    m_monitor->setPulse(m_model->pulse());
}

void BedsideMonitorPanel::showAlarms()
{
    std::vector<BedsideMonitor::Alarm> alarms;
    for (const VitalAlarms::Active& alarm : m_model->alarms())
        alarms.push_back({urgencyOf(alarm.priority), alarmText(alarm, m_model->limits()),
                          priorityText(alarm.priority)});
    m_silence->setEnabled(!alarms.empty() && !m_model->isSilenced());
    m_monitor->setAlarms(std::move(alarms));
}

void BedsideMonitorPanel::showSound()
{
    const QSignalBlocker blocker{m_mute};
    const bool isMuted = isAllMuted();
    m_mute->setChecked(isMuted);
    m_mute->setText(isMuted ? tr("■ Muted") : tr("Mute"));
    m_monitor->setSoundNote(soundNote());
    const QString heard = heardText(m_model->heard());
    m_heard->setText(heard.isEmpty() ? tr("○ Stethoscope: not on the chest")
                                     : tr("● Stethoscope: %1").arg(heard));
    m_obstacle->setText(m_output->obstacle());
    m_obstacle->setVisible(!m_output->obstacle().isEmpty());
}

QString BedsideMonitorPanel::soundNote() const
{
    if (!m_output->obstacle().isEmpty())
        return tr("■ No sound");
    if (isAllMuted())
        return tr("■ Muted");
    if (m_model->isSilenced() && !m_model->alarms().empty())
        return tr("■ Alarms silent");
    return m_model->loudness(SoundKind::Alarm).isMuted ? tr("■ Alarms muted") : QString{};
}

bool BedsideMonitorPanel::isAllMuted() const
{
    return std::all_of(kSoundKinds.begin(), kSoundKinds.end(),
                       [this](SoundKind kind) { return m_model->loudness(kind).isMuted; });
}

void BedsideMonitorPanel::muteAll(bool mute)
{
    for (const SoundKind kind : kSoundKinds)
        m_model->setLoudness(kind, {m_model->loudness(kind).volume_percent, mute});
}

} // namespace carina
