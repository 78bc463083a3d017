#include "models/tracker/kept_sound.h"

#include <QDir>
#include <QSettings>

namespace carina
{
namespace
{

const QString kSoundWhenLost = QStringLiteral("soundWhenLost");

} // namespace

KeptSound::KeptSound(const QString& folder)
    : m_file{folder.isEmpty() ? QString{} : QDir{folder}.filePath(QStringLiteral("tracking.ini"))}
{
    if (!m_file.isEmpty())
        m_isOn = QSettings{m_file, QSettings::IniFormat}.value(kSoundWhenLost, true).toBool();
}

void KeptSound::keep(bool isOn)
{
    m_isOn = isOn;
    if (!m_file.isEmpty())
        QSettings{m_file, QSettings::IniFormat}.setValue(kSoundWhenLost, isOn);
}

} // namespace carina
