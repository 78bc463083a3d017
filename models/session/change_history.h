#pragma once

#include <QObject>
#include <QStringList>

#include <functional>
#include <vector>

namespace carina
{

/// The changes that this person made in the session, over all panels, in their order: what one undo
/// takes back, the last first.
class ChangeHistory : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// Adds a change. @param owner whose change it is, for retitle and forget
    /// @param text what it was: "Tidal volume → 400 ml"
    /// @param topic which of the owner's things it is about, for forget
    void add(const QObject& owner, const QString& text, std::function<void()> takeBack,
             int topic = 0);
    /// The owner's last change goes on, as a slider that is dragged: it is called so from now on.
    void retitle(const QObject& owner, const QString& text);
    /// Whether the last change of all is the owner's and about this thing; it is called so then.
    bool goOn(const QObject& owner, const QString& text, int topic);
    /// Removes the changes of an owner, which can no longer be taken back.
    void forget(const QObject& owner);
    /// Likewise those about one thing.
    void forget(const QObject& owner, int topic);

    [[nodiscard]] bool isEmpty() const { return m_changes.empty(); }
    /// What each change was, the last first.
    [[nodiscard]] QStringList texts() const;
    /// Takes back the last changes, so many of them.
    void undo(int count = 1);
    /// By whoever takes a change back: it stays, and why.
    void refuse(const QString& why) { Q_EMIT refused(why); }

    static constexpr std::size_t kMost = 200; ///< older ones are forgotten

Q_SIGNALS:
    void changed();
    /// What was to be taken back stays: a sentence with the reason.
    void refused(const QString& why);

private:
    struct Change {
        const QObject* owner = nullptr;
        QString text;
        std::function<void()> takeBack;
        int topic = 0;
    };

    std::vector<Change> m_changes;
};

} // namespace carina
