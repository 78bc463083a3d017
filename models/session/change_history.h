#pragma once

#include "engine/core/ids.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <map>
#include <vector>

namespace carina
{

/// The changes that this person made in the session, over all panels, in their order: what one undo
/// takes back, the last first, at whichever station each was made.
class ChangeHistory : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Adds a change. @param owner whose change it is, for retitle and forget
    /// @param text what it was: "Tidal volume → 400 ml"
    /// @param topic which of the owner's things it is about, for forget
    /// @param station where it was made; kNoStation for what is of none, or of several
    void add(const QObject& owner, const QString& text, std::function<void()> takeBack,
             int topic = 0, StationId station = kNoStation);

    /// What makes several changes one: they have one text, and one undo takes them all back, the
    /// last first. What can no longer be taken back of them leaves the others.
    struct Joint {
        int number = 0; ///< 0: a change by itself
        QString text;   ///< "Everything put back"
    };
    [[nodiscard]] Joint newJoint(const QString& text) { return {++m_joints, text}; }
    /// While it lives, what is added belongs to a joint change, also where others followed that.
    class Joining
    {
    public:
        /// @param history may be null. @pre it outlives this.
        Joining(ChangeHistory* history, Joint joint);
        ~Joining();
        Joining(const Joining&) = delete;
        Joining& operator=(const Joining&) = delete;

    private:
        ChangeHistory* m_history;
        Joint m_before;
    };

    /// Tells which stations are open, by their names, and which of them is shown. From now on what
    /// was changed at another one is called after it; what was changed at one that is not open is
    /// forgotten.
    void setStations(StationId shown, std::map<StationId, QString> open);
    /// The owner's last change goes on, as a slider that is dragged: it is called so from now on.
    void retitle(const QObject& owner, const QString& text);
    /// Whether the last change of all is the owner's and about this thing; it is called so then.
    bool goOn(const QObject& owner, const QString& text, int topic);
    /// Removes the changes of an owner about one thing, which can no longer be taken back.
    void forget(const QObject& owner, int topic);

    [[nodiscard]] bool isEmpty() const { return m_changes.empty(); }
    /// What each change was, the last first: "Room 5: Tidal volume → 400 ml".
    [[nodiscard]] QStringList texts() const;
    /// Takes back the last changes, so many of them: a joint one counts as one.
    void undo(int count = 1);
    /// By whoever takes a change back: it stays, and why.
    void refuse(const QString& why);

    static constexpr std::size_t kMost = 200; ///< older ones are forgotten

Q_SIGNALS:
    void changed();
    /// What was to be taken back stays: a sentence with the reason, for each part of a joint
    /// change.
    void refused(const QString& why);

private:
    struct Change {
        const QObject* owner = nullptr;
        QString text;
        std::function<void()> takeBack;
        int topic = 0;
        StationId station = kNoStation;
        Joint joint{}; ///< its parts stand side by side
    };

    [[nodiscard]] static bool isJoint(const Change& a, const Change& b)
    {
        return a.joint.number != 0 && a.joint.number == b.joint.number;
    }
    [[nodiscard]] QString textOf(const Change& change) const;
    void forgetFirst();
    void undoLast();

    std::vector<Change> m_changes;
    int m_joints = 0; ///< so many were made
    Joint m_joining;  ///< to which what is added belongs
    bool m_isUndoing = false;
    QStringList m_reasons; ///< why parts of what is being undone stay
    StationId m_shown = kNoStation;
    std::map<StationId, QString> m_open;
};

} // namespace carina
