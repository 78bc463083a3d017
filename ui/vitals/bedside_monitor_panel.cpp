#include "ui/vitals/bedside_monitor_panel.h"

#include "models/text/shown_as_is.h"
#include "models/vitals/vital_words.h"
#include "ui/vitals/sound_controls.h"
#include "widgets/plain_label.h"
#include "widgets/vitals/bedside_monitor.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kMarginOfMonitor = 4; ///< pixels, above and beneath: the panel may be low

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
      m_mute{new QAction{this}},
      m_muteButton{new QToolButton},
      m_volumes{new QToolButton},
      m_heard{new PlainLabel},
      m_sounds{new QWidget},
      m_obstacle{new PlainLabel},
      m_controls{new SoundControls}
{
    makeMute();
    addControls();
    addSounds();
    auto* row = new QHBoxLayout;
    row->addWidget(m_silence);
    row->addWidget(m_muteButton);
    row->addWidget(m_volumes);
    row->addStretch();
    auto* column = new QVBoxLayout{this};
    QMargins margins = column->contentsMargins();
    margins.setTop(kMarginOfMonitor);
    margins.setBottom(kMarginOfMonitor);
    column->setContentsMargins(margins);
    column->addWidget(m_monitor, 1);
    column->addWidget(m_heard);
    column->addLayout(row);
    column->addWidget(m_sounds);
    setFocusProxy(m_monitor);
}

void BedsideMonitorPanel::makeMute()
{
    m_mute->setObjectName(QStringLiteral("muteSounds"));
    m_mute->setCheckable(true);
    m_mute->setText(tr("Mute all sounds"));
    m_mute->setIconText(tr("Mute sounds")); // beside what is muted of people
    m_mute->setShortcut(Qt::Key_F10);
    m_mute->setShortcutContext(Qt::ApplicationShortcut); // also while a scene has the keyboard
    m_mute->setAutoRepeat(false);
    m_mute->setToolTip(tr("Mutes all sounds of this program, until it is pressed again (F10). They "
                          "are played while the bedside monitor is in sight; their marks stay on "
                          "the screen"));
    m_mute->setEnabled(false);
}

void BedsideMonitorPanel::addControls()
{
    m_silence->setObjectName(QStringLiteral("silence"));
    m_silence->setProperty("isLow", true);
    m_silence->setText(tr("Silence alarms"));
    m_silence->setAccessibleName(tr("Silence the alarms for two minutes"));
    m_silence->setToolTip(tr("For two minutes, or until another alarm begins or one becomes more "
                             "urgent; they stay on the screen"));
    m_muteButton->setObjectName(QStringLiteral("soundsButton"));
    m_muteButton->setDefaultAction(m_mute);
    m_muteButton->setAccessibleName(tr("Mute all sounds of this program"));
    m_muteButton->setFocusPolicy(Qt::StrongFocus);
    m_volumes->setObjectName(QStringLiteral("volumes"));
    m_volumes->setCheckable(true);
    m_volumes->setFocusPolicy(Qt::StrongFocus);
    m_volumes->setAccessibleName(tr("Show the volume of each sound"));
    m_heard->setObjectName(QStringLiteral("heard"));
    m_heard->setAccessibleName(tr("What the stethoscope hears"));
    m_heard->setToolTip(tr("Hold the stylus's tip to the chest, over a lung, the heart, the "
                           "stomach, or the trachea"));
    m_heard->setWordWrap(true);
    connect(m_volumes, &QToolButton::toggled, m_sounds, &QWidget::setVisible);
    connect(m_silence, &QPushButton::clicked, this, [this] { m_model->silenceAlarms(); });
}

void BedsideMonitorPanel::addSounds()
{
    m_obstacle->setObjectName(QStringLiteral("noSound"));
    m_obstacle->setAccessibleName(tr("Why no sound is played"));
    m_obstacle->setWordWrap(true);
    m_obstacle->hide();
    auto* column = new QVBoxLayout{m_sounds};
    column->setContentsMargins({});
    column->addWidget(m_obstacle);
    column->addWidget(m_controls);
    m_sounds->hide();
}

void BedsideMonitorPanel::setModel(VitalsModel& model, const SoundOutput& output)
{
    m_model = &model;
    m_output = &output;
    m_controls->setModel(model);
    m_mute->setEnabled(true);
    connect(m_mute, &QAction::triggered, &model, &VitalsModel::setMuted);
    connect(&model, &VitalsModel::sampled, this, &BedsideMonitorPanel::draw);
    connect(&model, &VitalsModel::startedAfresh, m_monitor, &BedsideMonitor::clear);
    connect(&model, &VitalsModel::changed, this, &BedsideMonitorPanel::refresh);
    connect(&output, &SoundOutput::changed, this, &BedsideMonitorPanel::refresh);
    tellSight();
    refresh();
}

void BedsideMonitorPanel::tellSight()
{
    if (m_model)
        m_model->setInSight(isVisible() && isEnabled() && !window()->isMinimized());
}

void BedsideMonitorPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    tellSight();
}

void BedsideMonitorPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    if (m_model) // a window that is made an icon stays visible to Qt
        m_model->setInSight(false);
}

void BedsideMonitorPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::EnabledChange)
        tellSight();
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
    m_mute->setChecked(m_model->isMuted());
    m_mute->setIconText(m_model->isMuted() ? tr("■ Sounds muted") : tr("Mute sounds"));
    m_monitor->setSoundNote(soundNote());
    const QString heard = heardText(m_model->heard());
    m_heard->setText(heard.isEmpty() ? tr("○ Stethoscope: not on the chest")
                                     : tr("● Stethoscope: %1").arg(heard));
    const QString obstacle = m_output->obstacle();
    m_obstacle->setText(obstacle);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_volumes->setText(obstacle.isEmpty() ? tr("Volumes") : tr("■ No sound"));
    m_volumes->setToolTip(
        shownAsIs(obstacle.isEmpty() ? tr("Which sounds are played, and how loud") : obstacle));
}

QString BedsideMonitorPanel::soundNote() const
{
    if (!m_output->obstacle().isEmpty())
        return tr("■ No sound");
    if (isNothingPlayed())
        return tr("■ Muted");
    if (m_model->isSilenced() && !m_model->alarms().empty())
        return tr("■ Alarms silent");
    return m_model->loudness(SoundKind::Alarm).isMuted ? tr("■ Alarms muted") : QString{};
}

bool BedsideMonitorPanel::isNothingPlayed() const
{
    return m_model->isMuted()
           || std::all_of(kSoundKinds.begin(), kSoundKinds.end(),
                          [this](SoundKind kind) { return m_model->loudness(kind).isMuted; });
}

} // namespace carina
