#include "models/session/change_history.h"

#include <algorithm>
#include <utility>

namespace carina
{

void ChangeHistory::add(const QObject& owner, const QString& text, std::function<void()> takeBack,
                        int topic, StationId station)
{
    if (m_changes.size() == kMost)
        m_changes.erase(m_changes.begin());
    m_changes.push_back({&owner, text, std::move(takeBack), topic, station});
    Q_EMIT changed();
}

void ChangeHistory::setStations(StationId shown, std::map<StationId, QString> open)
{
    m_shown = shown;
    m_open = std::move(open);
    std::erase_if(m_changes, [this](const Change& change) {
        return change.station != kNoStation && !m_open.contains(change.station);
    });
    Q_EMIT changed();
}

void ChangeHistory::retitle(const QObject& owner, const QString& text)
{
    const auto last = std::find_if(m_changes.rbegin(), m_changes.rend(),
                                   [&owner](const Change& c) { return c.owner == &owner; });
    if (last == m_changes.rend() || last->text == text)
        return;
    last->text = text;
    Q_EMIT changed();
}

bool ChangeHistory::goOn(const QObject& owner, const QString& text, int topic)
{
    if (m_changes.empty() || m_changes.back().owner != &owner || m_changes.back().topic != topic)
        return false;
    m_changes.back().text = text;
    Q_EMIT changed();
    return true;
}

void ChangeHistory::forget(const QObject& owner)
{
    if (std::erase_if(m_changes, [&owner](const Change& c) { return c.owner == &owner; }) > 0)
        Q_EMIT changed();
}

void ChangeHistory::forget(const QObject& owner, int topic)
{
    const auto isMeant = [&](const Change& c) { return c.owner == &owner && c.topic == topic; };
    if (std::erase_if(m_changes, isMeant) > 0)
        Q_EMIT changed();
}

QStringList ChangeHistory::texts() const
{
    QStringList texts;
    for (auto change = m_changes.rbegin(); change != m_changes.rend(); ++change)
        texts << textOf(*change);
    return texts;
}

QString ChangeHistory::textOf(const Change& change) const
{
    const auto station = m_open.find(change.station);
    if (change.station == m_shown || station == m_open.end())
        return change.text;
    return tr("%1: %2", "a station; what was changed there").arg(station->second, change.text);
}

void ChangeHistory::undo(int count)
{
    for (; count > 0 && !m_changes.empty(); --count) {
        const Change last = std::move(m_changes.back());
        m_changes.pop_back();
        last.takeBack();
    }
    Q_EMIT changed();
}

} // namespace carina
