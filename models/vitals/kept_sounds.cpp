#include "models/vitals/kept_sounds.h"

#include "engine/core/expects.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace carina
{
namespace
{

const QString kAllMuted = QStringLiteral("all/muted");

QString nameOfKept(SoundKind kind)
{
    switch (kind) {
    case SoundKind::Oximeter:
        return QStringLiteral("oximeter");
    case SoundKind::Alarm:
        return QStringLiteral("alarm");
    case SoundKind::Breath:
        return QStringLiteral("breath");
    case SoundKind::Heart:
        break;
    }
    return QStringLiteral("heart");
}

QString volumeKey(SoundKind kind) { return nameOfKept(kind) + QStringLiteral("/volume"); }
QString mutedKey(SoundKind kind) { return nameOfKept(kind) + QStringLiteral("/muted"); }

} // namespace

KeptSounds::KeptSounds(const QString& folder, const QString& program)
    : m_file{folder.isEmpty() ? QString{}
                              : QDir{folder}.filePath(QStringLiteral("sounds-%1.ini").arg(program))}
{
    if (m_file.isEmpty())
        return;
    const QString shared = QDir{folder}.filePath(QStringLiteral("sounds.ini"));
    const bool isNew = !QFileInfo::exists(m_file) && QFileInfo::exists(shared);
    read(isNew ? shared : m_file);
    if (isNew)
        for (const SoundKind kind : kSoundKinds)
            keep(kind, of(kind));
}

void KeptSounds::read(const QString& file)
{
    const QSettings settings{file, QSettings::IniFormat};
    for (const SoundKind kind : kSoundKinds) {
        Loudness& sound = m_sounds[std::size_t(kind)];
        bool isNumber = false;
        const int volume = settings.value(volumeKey(kind)).toInt(&isNumber);
        if (isNumber)
            sound.volume_percent = std::clamp(volume, 0, 100);
        sound.isMuted = settings.value(mutedKey(kind), false).toBool();
    }
    m_isMuted = settings.value(kAllMuted, false).toBool();
}

KeptSounds::Loudness KeptSounds::of(SoundKind kind) const { return m_sounds[std::size_t(kind)]; }

void KeptSounds::keep(SoundKind kind, const Loudness& loudness)
{
    CARINA_EXPECTS(loudness.volume_percent >= 0 && loudness.volume_percent <= 100);
    m_sounds[std::size_t(kind)] = loudness;
    if (m_file.isEmpty())
        return;
    QSettings settings{m_file, QSettings::IniFormat};
    settings.setValue(volumeKey(kind), loudness.volume_percent);
    settings.setValue(mutedKey(kind), loudness.isMuted);
}

void KeptSounds::keepMuted(bool isMuted)
{
    m_isMuted = isMuted;
    if (!m_file.isEmpty())
        QSettings{m_file, QSettings::IniFormat}.setValue(kAllMuted, isMuted);
}

} // namespace carina
