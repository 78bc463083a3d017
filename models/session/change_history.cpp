#include "models/session/change_history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{

void ChangeHistory::add(const QObject& owner, const QString& text, std::function<void()> takeBack,
                        int topic, StationId station)
{
    if (m_changes.size() == kMost)
        forgetFirst();
    Change change{&owner, text, std::move(takeBack), topic, station, m_joining};
    const auto joint =
        std::find_if(m_changes.rbegin(), m_changes.rend(),
                     [&change](const Change& each) { return isJoint(each, change); });
    m_changes.insert(joint == m_changes.rend() ? m_changes.end() : joint.base(), std::move(change));
    Q_EMIT changed();
}

ChangeHistory::Joining::Joining(ChangeHistory* history, Joint joint) : m_history{history}
{
    if (m_history)
        m_before = std::exchange(m_history->m_joining, std::move(joint));
}

ChangeHistory::Joining::~Joining()
{
    if (m_history)
        m_history->m_joining = std::move(m_before);
}

/// A joint change whole.
void ChangeHistory::forgetFirst()
{
    const auto end =
        std::find_if_not(m_changes.begin() + 1, m_changes.end(), [this](const Change& change) {
            return isJoint(change, m_changes.front());
        });
    m_changes.erase(m_changes.begin(), end);
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
    if (m_changes.empty() || m_changes.back().owner != &owner || m_changes.back().topic != topic
        || m_changes.back().joint.number != 0)
        return false;
    m_changes.back().text = text;
    Q_EMIT changed();
    return true;
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
        if (change == m_changes.rbegin() || !isJoint(*change, *std::prev(change)))
            texts << textOf(*change);
    return texts;
}

QString ChangeHistory::textOf(const Change& change) const
{
    const QString& text = change.joint.number == 0 ? change.text : change.joint.text;
    const auto station = m_open.find(change.station);
    if (change.station == m_shown || station == m_open.end())
        return text;
    return tr("%1: %2", "a station; what was changed there").arg(station->second, text);
}

void ChangeHistory::undo(int count)
{
    for (; count > 0 && !m_changes.empty(); --count)
        undoLast();
    Q_EMIT changed();
}

/// Why parts of it stay is said once all of them were tried.
void ChangeHistory::undoLast()
{
    m_isUndoing = true;
    for (bool goesOn = true; goesOn;) {
        const Change last = std::move(m_changes.back());
        m_changes.pop_back();
        last.takeBack();
        goesOn = !m_changes.empty() && isJoint(last, m_changes.back());
    }
    m_isUndoing = false;
    if (const QStringList reasons = std::exchange(m_reasons, {}); !reasons.isEmpty())
        Q_EMIT refused(reasons.join(QLatin1Char{' '}));
}

void ChangeHistory::refuse(const QString& why)
{
    if (m_isUndoing)
        m_reasons << why;
    else
        Q_EMIT refused(why);
}

} // namespace carina
