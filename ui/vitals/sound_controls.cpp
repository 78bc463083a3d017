#include "ui/vitals/sound_controls.h"

#include "models/text/shown_as_is.h"
#include "models/vitals/vital_words.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QSlider>

namespace carina
{

SoundControls::SoundControls(QWidget* parent) : QWidget{parent}
{
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins({});
    grid->setColumnStretch(1, 1);
    for (const SoundKind kind : kSoundKinds)
        addKind(kind);
}

void SoundControls::addKind(SoundKind kind)
{
    Controls& controls = m_controls[std::size_t(kind)];
    const QString name = soundText(kind);
    controls.isPlayed = new QCheckBox{name};
    controls.isPlayed->setObjectName(QStringLiteral("played%1").arg(int(kind)));
    controls.isPlayed->setAccessibleName(tr("%1: played").arg(name));
    controls.isPlayed->setToolTip(tr("Without the tick it is mute; its mark on the screen stays"));
    controls.volume = new QSlider{Qt::Horizontal};
    controls.volume->setObjectName(QStringLiteral("volume%1").arg(int(kind)));
    controls.volume->setAccessibleName(tr("%1: volume, per cent").arg(name));
    controls.volume->setRange(0, 100);
    controls.volume->setPageStep(10);
    auto* grid = qobject_cast<QGridLayout*>(layout());
    grid->addWidget(controls.isPlayed, int(kind), 0);
    grid->addWidget(controls.volume, int(kind), 1);
    connect(controls.isPlayed, &QCheckBox::toggled, this, [this, kind] { set(kind); });
    connect(controls.volume, &QSlider::valueChanged, this, [this, kind] { set(kind); });
}

void SoundControls::setModel(VitalsModel& model)
{
    m_model = &model;
    connect(&model, &VitalsModel::changed, this, &SoundControls::refresh);
    refresh();
}

void SoundControls::set(SoundKind kind)
{
    const Controls& controls = m_controls[std::size_t(kind)];
    if (m_model)
        m_model->setLoudness(kind, {controls.volume->value(), !controls.isPlayed->isChecked()});
}

void SoundControls::refresh()
{
    for (const SoundKind kind : kSoundKinds) {
        const Controls& controls = m_controls[std::size_t(kind)];
        const KeptSounds::Loudness loudness = m_model->loudness(kind);
        const QSignalBlocker isPlayed{controls.isPlayed};
        const QSignalBlocker volume{controls.volume};
        controls.isPlayed->setChecked(!loudness.isMuted);
        controls.volume->setValue(loudness.volume_percent);
        controls.volume->setToolTip(
            shownAsIs(tr("Volume: %1\u00a0%").arg(loudness.volume_percent)));
    }
}

} // namespace carina
