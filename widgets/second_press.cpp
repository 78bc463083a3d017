#include "widgets/second_press.h"

#include <QApplication>

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::chrono::milliseconds kAskedFor{4000};

/// Somebody may have set their double click to be slow.
std::chrono::milliseconds pauseBetweenPresses()
{
    const std::chrono::milliseconds doubleClick{QApplication::doubleClickInterval()};
    return std::max(SecondPress::kLeastPause, doubleClick);
}

} // namespace

SecondPress::SecondPress(QObject* parent) : QObject{parent}
{
    m_asked.setSingleShot(true);
    m_asked.setInterval(kAskedFor);
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseBetweenPresses());
    connect(&m_asked, &QTimer::timeout, this, &SecondPress::changed);
}

void SecondPress::press()
{
    const bool counts = !m_pause.isActive();
    m_pause.start(); // anew: a key that is held goes on pressing
    if (!counts)
        return;
    if (isAsked()) {
        forget();
        Q_EMIT confirmed();
    } else {
        m_asked.start();
        Q_EMIT changed();
    }
}

void SecondPress::forget()
{
    m_asked.stop();
    Q_EMIT changed();
}

} // namespace carina
